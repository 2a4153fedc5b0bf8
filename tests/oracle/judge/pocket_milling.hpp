// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pockets of LCYC75 as somebody may mill them, record by record, and their verdicts.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "oracle/judge/judge_session.hpp"

namespace gonogo::oracle {

using ReadingsOf = std::initializer_list<std::pair<std::string_view, std::string_view>>;

// The default profile of the 802S with the tools 1 (radius 10), 4 and 10 (both 5).
reference::Profile profile_802s(ReadingsOf readings = {});

struct Judged {
  bool blocks = true;  // the subject has line numbers
  reference::Profile profile = profile_802s();
};
Verdict judge_records(std::string_view program, const std::vector<Record>& records,
                      const Judged& judged = {});
// What `expand` shows of the program, judged as a subject's own. Throws on an alarm.
std::vector<Record> shown(std::string_view program, const reference::Profile& profile);
Verdict judge_shown(std::string_view program, const reference::Profile& profile = profile_802s());
std::vector<Record> without_blocks(std::vector<Record> records);

// A pocket of 60 by 40 about (60, 40) with corners of 8, from Z0, tool of radius 5, clockwise.
// Roughing leaves 0.75 in the plane and 0.5 in depth; 7.5 deep it takes two levels of 3.75.
struct Job {
  std::string frame = {};         // blocks that set one
  std::string_view depth = "-8";  // R104
  std::string_view sizes = "R118=60 R119=40 R120=8";
  std::string_view allowance = "R124=0.75 R125=0.5";
  std::string_view ways = "R126=2 R127=1";
  std::string_view infeed = "R121=4";
  std::string_view planes = "R101=5 R102=2 R103=0";
  std::string_view tool = "T4";
  std::string program() const;
  int block() const;  // of the cycle
};

// Writes motions in the pocket's own frame. Coordinates are rounded to 1e-6 mm.
class Miller {
 public:
  // The centre in base coordinates of G17, and how far the frame is turned.
  Miller(const Job& job, double centre_x = 60, double centre_y = 40, double degrees = 0);

  // To (60, 40, 5) of the base, then as LCYC75 begins: above the centre, at R101 and 2 mm above 0.
  Miller& approach();
  Miller& rapid(double u, double v);
  Miller& rapid_down(double z);
  Miller& lift(double z) { return rapid_down(z); }
  Miller& plunge(double z);          // by feed
  Miller& line(double u, double v);  // by feed
  Miller& ramp(double u, double v, double z);
  Miller& rapid_in_space(double u, double v, double z);
  Miller& arc(double u, double v, double centre_u, double centre_v, int rot);
  Miller& home() { return line(0, 0); }
  // Rapid to Z5 above the centre.
  Miller& end();
  Miller& feed_down(double feed);
  Miller& feed_in_plane(double feed);

  // Once round a rectangle with corners, from the middle of its right side.
  Miller& round(double half_length, double half_width, double corner, int sense = -1);
  // The border of where the tool goes in roughing the job's pocket (less its allowance).
  Miller& border(int sense = -1) { return round(24.25, 14.25, 2.25, sense); }
  // Three ways to clear that level, all of them with the border last and back to the centre.
  Miller& zigzag();
  Miller& contour_parallel();
  Miller& trochoidal();

  const std::vector<Record>& records() const { return records_; }

 private:
  std::pair<Number, Number> base(double u, double v) const;
  Record& put(RecordKind kind);

  std::vector<Record> records_;
  std::uint64_t block_;
  double centre_x_;
  double centre_y_;
  double cosine_;
  double sine_;
  double feed_down_ = 120;
  double feed_in_plane_ = 300;
  double u_ = 0;
  double v_ = 0;
};

// The whole job: approach, two levels cleared in one of the three ways, the end.
enum class Way { zigzag, contour_parallel, trochoidal };
std::vector<Record> rough(Way way, const Job& job = {}, double centre_x = 60, double centre_y = 40,
                          double degrees = 0);

}  // namespace gonogo::oracle
