// SPDX-License-Identifier: GPL-3.0-or-later
//
// R1: every order-preserving correspondence between the two sides, as the set of pairs that can be
// reached: a place of the reference (an event, and how far along it) beside a place of the subject.
// Two lines are near each other on a convex part of the square of their parameters, so that the
// reachable part of a side of the square is an interval with exact ends.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "oracle/relation/reference_side.hpp"
#include "oracle/relation/subject_side.hpp"

namespace gonogo::relation {

// Curves are cut into lines, each within a known width of the curve: `inner` subtracts the width
// from the tolerance, `outer` adds it. What inner reaches is reached; what outer does not is not.
enum class Bias : std::uint8_t { inner, outer };

struct Manner {
  Bias bias = Bias::outer;
  bool excuses_centres = false;          // R7: for arcs, as no text says how finely to compute them
  bool passes_end = false;               // R7: over an end that no text states
  std::vector<std::size_t> turned = {};  // R9: records of arcs that have their other turn
  bool only_rounded = false;  // R2: and each of them is an arc of the reference's, rounded
};

class Correspondence {
 public:
  // What it is given must outlive it.
  Correspondence(const reference::Profile& profile, std::string_view program,
                 const Tolerances& tolerances, const Outcome& outcome, const Manner& manner);
  // The best answer of any correspondence; where all depart, the departure of the one that comes
  // farthest.
  Answer best();

  // After that: whether a width was added or taken off, and the readings that were asked for.
  bool has_width() const { return has_width_; }
  bool finds_centres() const { return finds_centres_; }
  // Whether the subject went on behind an end that no text states.
  bool is_beyond_end() const { return is_beyond_end_; }
  std::vector<reference::ReadingKey> touched() const;

 private:
  struct Interval {
    Number low;
    Number high;
  };
  using Intervals = std::vector<Interval>;
  // The two sides; behind a renaming and a free step another pair.
  struct Pair {
    std::shared_ptr<ReferenceSide> reference;
    std::shared_ptr<SubjectSide> subject;
    std::size_t first_record = 0;  // with which the subject's side begins
    Position start;
    bool is_unfit = false;  // R9: by a run-out that leads into the material by itself
  };
  struct Place {
    std::size_t pair = 0;
    std::size_t i = 0;  // the reference's event
    std::size_t j = 0;  // the subject's
    std::size_t m = 0;  // M functions that have come
    auto operator<=>(const Place&) const = default;
  };
  // What is reached at one place: parts of the subject's event, with the reference at the beginning
  // of its own; parts of the reference's event, with the subject at the beginning of its own.
  struct Reached {
    Intervals at_start_of_want;
    Intervals at_start_of_got;
  };

  void expand(const Place& place, const Reached& reached);
  void match_cuts(const Place& place, const Reached& reached);
  void pass_over_subject(const Place& place, Intervals of_want);
  void pass_over_reference(const Place& place, Intervals of_got);
  void traverse(const Place& place, const Interval& entry);
  bool is_partner(const Event& want, const Event& got) const;
  bool may_be_turned(const Event& want, const Event& got) const;
  std::optional<std::size_t> fitting_m(const Place& place, bool is_within);
  std::optional<Place> behind_m(const Place& place, bool is_within);
  std::shared_ptr<ReferenceSide> another_reference(const Place& place, Settled settled);
  void match_stop(const Place& place);
  void leave_out_dwell(const Place& place);
  void rename(const Place& place);
  void take_free_step(const Place& place);
  void settle(const Place& place, std::vector<reference::Record> path, const Place& next,
              bool is_unfit);
  void close(const Place& place);
  void close_at_end(const Place& place, const reference::Record& end);
  void close_at_alarm(const Place& place, const reference::AlarmReport& report);
  bool is_of_alarm(const Place& place, const reference::AlarmReport& report);
  void leave_out_of_alarm(const Place& place);
  bool is_due_of_block(const Place& place, std::uint64_t block);
  void close_by_alarm(const Place& place);
  bool is_alarm_at_load();

  std::optional<std::size_t> end_of_small_run(SubjectSide& side, std::size_t begin,
                                              const Position& place, const Number& width);
  Number tolerance(const Number& tau, const Number& width);
  Number cell_tolerance(const Place& place);
  void reach(const Place& place, bool of_subject, Interval part);
  void reach_corner(const Place& place) { reach(place, true, {0, 0}); }
  void offer(Answer answer);
  Answer departure();
  Answer at_place(const Place& place, oracle::VerdictKind kind, Rule rule, std::string message);
  std::size_t pair_for(const Pair& pair);
  ReferenceSide& reference(const Place& place) { return *pairs_[place.pair].reference; }
  SubjectSide& subject(const Place& place) { return *pairs_[place.pair].subject; }

  const reference::Profile& profile_;
  std::string_view program_;
  const Tolerances& tolerances_;
  const Outcome& outcome_;
  Manner manner_;
  std::vector<Pair> pairs_;
  std::map<Place, Reached> open_;
  std::optional<Answer> best_;
  Place farthest_;
  std::size_t farthest_record_ = 0;
  bool is_farthest_corner_ = true;  // no motion is on its way there
  bool lacks_m_ = false;            // an M function should have come before
  std::string_view broken_;         // what breaks a condition of a free step last
  std::size_t broken_record_ = 0;
  Place broken_at_;
  bool has_width_ = false;
  bool finds_centres_ = false;
  bool is_beyond_end_ = false;
};

}  // namespace gonogo::relation
