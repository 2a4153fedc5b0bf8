// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge of sampled axis positions. What is GO:
//
// Tube. The tolerance of an axis is tau (the smaller of the profile's resolution and the subject's)
//   plus what the certifier granted with --tolerance.
// Containment. Every sample lies within the tube of the exact path: on a line, an arc, a helix, a
//   circle in space; of a traverse anywhere in the box of its ends.
// Order. There are points of the path, one within the tube of each sample, that never go back. (A
//   machine that stands still with noise within the tolerance does not go back.) A traverse is
//   monotone like that on each axis.
// Blending (J-RUN-11). Where the certifier grants an allowance (--blend), a machine may cut
//   corners: samples that are farther from the path than the tolerance, but not by more than the
//   allowance as well, are GO within twenty times the allowance, along the path, of the corner of
//   two motions. A motion no longer than that may be rounded over as a whole.
// Completeness. From one sample to the next the path goes on by no more than the programmed feeds
//   allow in the time between them, the granted part of the feed and the resolution of the clock
//   included; traverses, threads and feeds per revolution by no more than `fastest`. So each corner
//   and extreme point has been visited within the tolerance and what one interval allows. Samples
//   begin at the start position (after the approach of an exported program's own header) and end at
//   the end of the path.
//   A motion that lies whole between two samples, or whose end is unseen, may go unchecked by one
//   of the ways that the samples leave open: then the answer is oracle-gap, never a pass.
// Dwell. The machine may not have stood still for as long as programmed: less time lies between the
//   last sample before and the first one after. How long it stood before the first sample is not
//   known: where that decides, oracle-gap. So it is where the machine stands at the place of dwells
//   for longer than these by more than kLongestStand. Stands elsewhere are not compared.
// Feed. Bounds only, see feed_bounds.hpp. Feeds per revolution and threads are not compared.
// Holes (J-RUN-11). Where more time passes between two samples than in their rhythm, the
//   machine may have been anywhere: what would be GO is oracle-gap. What the rhythm itself does not
//   show is reported.
// Open paths. Pocket levels, threads and helical pockets whose path the manual leaves open are not
//   decided from samples: judged up to there, then oracle-gap.
// Alarms. As for records: class, line, and that the motion before it is complete.
//
// Decided exactly: containment in lines, traverses and flat arcs, order along lines and traverses.
// Where along an arc a sample lies, and the height of a helix, is known to 1e-6 mm: when an answer
// depends on that, it is oracle-gap.
#pragma once

#include <map>
#include <set>

#include "capture/feed_bounds.hpp"
#include "capture/sample_rhythm.hpp"
#include "capture/sampled_path.hpp"

namespace gonogo::oracle {

struct SampledTolerances {
  Number feed_tolerance = Number(1) / Number(20);  // part of the feed
  Number fastest = 1000;                           // mm/s, of what has no feed of its own
  std::uint64_t header_lines = 0;                  // of the program that was run, before the case's
  int time_decimals = 0;                           // of the file
  Number blend = 0;                                // mm, granted; 0: corners are not cut
  SampleColumns columns;                           // of the file
  Number x_scale = 1;                              // tried: X as a diameter
  std::size_t samples = 0;                         // of the file
  double noise = 0;                                // ... mm, estimated (noise_watch.hpp)
  double usual_interval = 0;                       // ... s (sample_rhythm.hpp)
  double longest_interval = 0;                     // ... s; a longer one is a hole
};

// How far the samples were from the path at most, rounded up.
struct WorstSample {
  Number deviation = 0;  // mm, in steps of 1e-4
  std::string sample;    // empty: none was off the path at all
  std::uint64_t block = 0;
};

// The samples of one program against the reference under one combination of readings.
class SampledRun {
 public:
  // `way_factor`: how many times the way that the feeds allow lies between two samples at most.
  SampledRun(const reference::Profile& profile, const ProgramText& program,
             const Tolerances& tolerances, const SampledTolerances& sampled,
             reference::AxisSet seen, bool strict, double way_factor);

  // The next sample; false when nothing can change the answer.
  bool take(const Sample& sample);
  // After the last sample; `in_hole`: others without a time follow it.
  void finish(bool in_hole);

  const std::optional<Verdict>& departure() const { return departure_; }  // place, order, dwell
  const std::optional<Verdict>& feed_fault() const { return feed_fault_; }
  const std::optional<Verdict>& open() const { return open_; }  // why the end is not decided
  bool at_end() const { return at_end_; }                       // of the path
  bool left_end() const { return left_end_; }                   // moved on after it
  bool moved() const { return moved_; }                         // from the start
  const Position& last() const { return last_at_; }
  std::size_t progress() const { return progress_; }  // pieces that are done for certain
  std::string summary() const;                        // what was checked and what not
  const WorstSample& worst() const { return worst_; }
  // How far the last sample is from the path where the machine may be, about; mm.
  double off() const { return off_; }
  // Why it cannot be GO: the samples do not show all.
  GapReason not_shown() const {
    if (holes_.any()) return GapReason::samples_hole;
    if (!long_stands_.empty()) return GapReason::samples_stand;
    return unseen_.empty() ? GapReason::none : GapReason::samples_rate;
  }
  const HoleWatch& holes() const { return holes_; }

 private:
  // What samples show of a piece.
  struct Visit {
    bool start = false;
    bool inside = false;
    bool end = false;
    bool shows() const { return inside || (start && end); }
  };
  // A piece on which the machine may be, and where.
  struct State {
    Stretch place;            // low: the earliest place that the samples so far admit
    double since = 0;         // dwell: time of the last sample before it
    bool open_since = false;  // the machine may have stood there before the samples began
    Visit visit = {};         // of this piece, by every way that leads here
    // Pieces that one of these ways passes without a sample that shows them.
    std::set<std::size_t> unseen = {};
  };
  // Where it is: on the path, or cutting a corner: off the motion that it leaves, or off the next
  // one, to which it comes.
  enum class Phase : std::uint8_t { followed, leaving, arriving };
  struct Spot {
    std::size_t piece = 0;
    Phase phase = Phase::followed;
    auto operator<=>(const Spot&) const = default;
  };
  using States = std::map<Spot, State>;

  bool begin(const SamplePoint& point, double time);
  void step(const SamplePoint& point, double time, States& next);
  bool stay(Spot spot, const State& state, const std::vector<Stretch>& places, States& next);
  void go_on(Spot spot, State& state, const SamplePoint& point, double time, States& next);
  // Whether the way from a spot may lead to a later piece, and cut its corner.
  bool may_pass(Spot spot) const;
  bool near_corner(Spot spot, const Stretch& place) const;
  const std::vector<Stretch>& stretches(std::size_t i, const SamplePoint& point);
  // Within the allowance for blending; empty where corners are not cut.
  const std::vector<Stretch>& wide_stretches(std::size_t i, const SamplePoint& point);
  static void merge(States& states, Spot spot, State state);
  void enter(std::size_t from, const State& before, Spot spot, const Stretch& place, States& next);
  bool stands_on(std::size_t i) const;
  void note_worst(const Sample& sample, const SamplePoint& point);
  double stood(const State& state, double time) const;
  // How many times its feed a motion may have at most.
  double feed_factor() const { return (1 + granted_) * way_factor_; }
  double least_time(const PathPiece& piece) const;
  double least_time_to(const PathPiece& piece, const Stretch& place) const;
  void note_visits();
  void note_unseen(std::size_t before);
  void watch_feeds(double time);
  void watch_stands(const Position& at, double time);
  void close_pieces(std::size_t before);
  void depart(const Sample& sample, const SamplePoint& point);
  Verdict departure_at_start(const Sample& sample) const;
  Verdict departure_of(const Sample& sample, const SamplePoint& point);
  // The sample fits a piece that comes next or later, or one it stands on already.
  Verdict departure_towards(std::size_t later, const Sample& sample);
  Verdict departure_from_path(const Sample& sample);
  // The piece that a sample fits, though it may not be there yet, or no longer.
  std::optional<std::size_t> fits(const SamplePoint& point, std::size_t first, std::size_t count);
  Verdict verdict_at(VerdictKind kind, const PathPiece& piece, const std::string& message) const;
  Verdict feed_verdict(const PathPiece& piece, const FeedWatch::Fault& fault) const;
  void note_feed(std::size_t i, const std::optional<FeedWatch::Fault>& fault);

  const SampledTolerances& sampled_;
  SampledPath path_;
  Tube tube_;
  Position start_;
  reference::AxisSet seen_;
  double way_factor_;
  double granted_;
  double clock_;
  States states_;
  // For the present sample.
  std::map<std::size_t, std::vector<Stretch>> cache_;
  std::map<std::size_t, std::vector<Stretch>> wide_cache_;
  Tube wide_;
  double corner_;  // mm of path from a corner within which it may be cut
  WorstSample worst_;
  double off_ = 0;
  bool moved_ = false;
  std::map<std::size_t, FeedWatch> watches_;
  HoleWatch holes_;
  bool begun_ = false;
  bool header_seen_ = false;  // samples of the header's lines have come
  double last_time_ = 0;
  Position last_at_;
  std::size_t last_number_ = 0;
  std::optional<Sample> first_;
  std::optional<Verdict> departure_;
  std::optional<Verdict> feed_fault_;
  std::optional<Verdict> open_;
  bool at_end_ = false;
  bool left_end_ = false;
  std::size_t progress_ = 0;
  std::size_t motions_ = 0;
  std::size_t feeds_ = 0;       // motions whose feed was bounded from above and below
  std::size_t feeds_open_ = 0;  // ... was not
  // Where the machine stands, since when, and the dwells of that place.
  struct Stand {
    Position at;
    double since = 0;
    double until = 0;
    double due = 0;
    std::set<std::size_t> dwells = {};
    std::uint64_t block = 0;
    bool is_first = false;  // it may have stood there before the samples began
  };
  Stand stand_;
  std::vector<std::string> long_stands_;
  std::vector<std::string> unseen_;
  std::map<std::size_t, std::string> named_;  // pieces that some way passes unseen
};

// A sample as evidence: {"t":"0.004","x":"1"}.
std::string sample_text(const Sample& sample, reference::AxisSet seen);

}  // namespace gonogo::oracle
