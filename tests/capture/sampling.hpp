// SPDX-License-Identifier: GPL-3.0-or-later
//
// A machine whose axes are sampled, for tests: straight moves and arcs at a speed, with a ramp.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "capture/captured_samples.hpp"
#include "oracle/judge/judge_session.hpp"

namespace gonogo::oracle {

inline constexpr double kRapid = 6000;  // mm/min
inline constexpr double kFeed = 1200;

struct Point {
  double x = 0, y = 0, z = 0;
};

class SampledMachine {
 public:
  explicit SampledMachine(double interval = 0.004, Point start = {})
      : interval_(interval), at_(start) {}
  // mm/min; without acceleration (mm/s^2) the speed is there at once.
  SampledMachine& line(Point to, double feed, double acceleration = 0);
  // About a centre in the XY plane, so many degrees, + counterclockwise.
  SampledMachine& turn(Point centre, double degrees, double feed);
  SampledMachine& stand(double seconds);
  struct Row {
    double time;
    Point at;
  };
  // Every sample so far; the last one stands at the end.
  const std::vector<Row>& rows();
  // As CSV with the columns t, x, y, z, six decimals.
  std::string csv();

 private:
  void run(double seconds, const std::function<Point(double)>& place);
  double interval_;
  Point at_;
  double now_ = 0;
  double next_ = 0;
  bool closed_ = false;
  std::vector<Row> rows_;
};

std::string csv_of(const std::vector<SampledMachine::Row>& rows);

struct SampledCase {
  std::string program;
  std::string_view dialect = "gsk988ta";
  std::string tolerance = {};  // granted, mm
  std::uint64_t header_lines = 0;
  std::string feed_tolerance = "1/20";
  std::string blend = "0";
  std::string columns = {};
};
// What the session says of the samples.
Verdict judge_samples(const SampledCase& test, const std::string& csv);

// A file that goes away with the object.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::string_view text);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace gonogo::oracle
