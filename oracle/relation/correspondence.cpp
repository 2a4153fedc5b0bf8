// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/correspondence.hpp"
#include "oracle/relation/near.hpp"

#include <algorithm>
#include <cstdlib>

namespace gonogo::relation {

using oracle::VerdictKind;
using reference::Axis;
using reference::kAllAxes;
using reference::Record;
using reference::RecordKind;

namespace {

template <typename Intervals>
bool begins(const Intervals& parts) {
  return std::ranges::any_of(parts, [](const auto& part) { return part.low.sign() == 0; });
}

template <typename Intervals>
bool ends(const Intervals& parts) {
  return std::ranges::any_of(parts, [](const auto& part) { return part.high == Number(1); });
}

// The lowest of what is reached and near.
template <typename Intervals>
std::optional<Number> lowest(const Intervals& reached, const std::optional<Part01>& near) {
  std::optional<Number> low;
  if (!near) return low;
  for (const auto& part : reached) {
    const Number begin = max(part.low, near->low);
    if (begin > min(part.high, near->high)) continue;
    if (!low || begin < *low) low = begin;
  }
  return low;
}

// What is left of the parts.
template <typename Intervals>
Intervals common(const Intervals& parts, const std::optional<Part01>& near) {
  Intervals left;
  if (!near) return left;
  for (const auto& part : parts) {
    const Number low = max(part.low, near->low);
    const Number high = min(part.high, near->high);
    if (low <= high) left.push_back({low, high});
  }
  return left;
}

// Without a comparison of numbers that may have no end.
bool are_one(const Number& a, const Number& b) {
  return a.is_rational() && b.is_rational() && a == b;
}
bool are_one(const Position& a, const Position& b) {
  return std::ranges::all_of(kAllAxes, [&](Axis axis) { return are_one(a[axis], b[axis]); });
}

// Whether the curves are one by their numbers, and the pieces one and the same of it: then nothing
// lies between the sides, however far the curve may lie from its piece.
bool is_one_piece(const Event& want, const Event& got) {
  if (got.width.sign() == 0 || want.piece != got.piece) return false;
  const auto* const due = std::get_if<Record>(&*want.item);
  const Record& arc = got.source();
  if (due == nullptr || due->kind != arc.kind || !are_one(want.start, got.start)) return false;
  if (!are_one(end_of(*due, want.start), end_of(arc, got.start))) return false;
  if (arc.kind != RecordKind::arc) {
    const auto is_one_via = [&](Axis axis) {
      return !arc.via_axes.has(axis) || are_one(due->via[axis], arc.via[axis]);
    };
    return arc.via_axes == due->via_axes && std::ranges::all_of(kAllAxes, is_one_via);
  }
  return due->plane == arc.plane && due->rot == arc.rot && are_one(due->centre[0], arc.centre[0]) &&
         are_one(due->centre[1], arc.centre[1]);
}

}  // namespace

Correspondence::Correspondence(const reference::Profile& profile, std::string_view program,
                               const Tolerances& tolerances, const Outcome& outcome,
                               const Manner& manner)
    : profile_(profile),
      program_(program),
      tolerances_(tolerances),
      outcome_(outcome),
      manner_(manner) {
  pairs_.push_back(
      {std::make_shared<ReferenceSide>(profile, program, tolerances, Settled(), manner.passes_end),
       std::make_shared<SubjectSide>(outcome.records, 0, profile.initial.at, tolerances,
                                     manner_.turned),
       0, profile.initial.at});
}

std::vector<reference::ReadingKey> Correspondence::touched() const {
  std::vector<reference::ReadingKey> keys;
  for (const Pair& pair : pairs_) {
    for (const reference::ReadingKey key : pair.reference->readings().touched()) {
      if (std::ranges::count(keys, key) == 0) keys.push_back(key);
    }
  }
  return keys;
}

Number Correspondence::tolerance(const Number& tau, const Number& width) {
  if (width.sign() == 0) return tau;
  has_width_ = true;
  // In whole millionths, so that most comparisons are of small numbers.
  constexpr int kMillion = 1'000'000;
  return manner_.bias == Bias::outer ? ((tau + width) * kMillion).ceil() / kMillion
                                     : ((tau - width) * kMillion).floor() / kMillion;
}

// R2: for two arcs 17/8 tau, by which rounding of centre, start and end may move the points
// between; for a granted chord what is granted.
Number Correspondence::cell_tolerance(const Place& place) {
  const Event& want = reference(place).at(place.i);
  const Event& got = subject(place).at(place.j);
  const Number width = want.width + got.width;
  const Label& arc = *want.label;
  if (is_granted_chord(arc, *got.label, tolerances_)) {
    return tolerance(tolerances_.tolerance + tolerances_.chord, width);
  }
  if (arc.kind != RecordKind::arc || got.label->kind != RecordKind::arc) {
    return tolerance(tolerances_.tolerance, width);
  }
  if (arc.finds_centre) finds_centres_ = true;
  const Number rounded = tolerances_.tolerance * 17 / 8;
  if (!arc.finds_centre || !manner_.excuses_centres) return tolerance(rounded, width);
  // R7: a centre of the control's own excuses no turn too many, and no other end.
  if (std::abs(got.source().rot) > std::abs(want.source().rot)) return tolerance(rounded, width);
  const bool ends =
      reference(place).at(place.i + 1).begins || subject(place).at(place.j + 1).begins;
  return tolerance(ends ? rounded : rounded * 2, width);
}

void Correspondence::reach(const Place& place, bool of_subject, Interval part) {
  Reached& reached = open_[place];
  Intervals& parts = of_subject ? reached.at_start_of_want : reached.at_start_of_got;
  for (Interval& other : parts) {
    if (part.low > other.high || other.low > part.high) continue;
    other.low = min(other.low, part.low);
    other.high = max(other.high, part.high);
    return;
  }
  parts.push_back(std::move(part));
}

Answer Correspondence::best() {
  if (is_alarm_at_load()) return *best_;
  reach_corner({});
  while (!open_.empty()) {
    const auto [place, reached] = std::move(*open_.begin());
    open_.erase(open_.begin());
    expand(place, reached);
    if (best_ && decision(best_->kind) == oracle::Decision::go) break;
  }
  return best_ ? *best_ : departure();
}

void Correspondence::expand(const Place& place, const Reached& reached) {
  ReferenceSide& sides = reference(place);
  const Event& want = sides.at(place.i);
  const Event& got = subject(place).at(place.j);
  const bool lacks_m = place.m < sides.m_functions(place.i) && sides.is_overdue(place.m, place.i);
  const std::size_t record = got.record;
  const bool is_corner = begins(reached.at_start_of_want) || begins(reached.at_start_of_got);
  if (record > farthest_record_ || (record == farthest_record_ && place >= farthest_)) {
    farthest_ = place;
    farthest_record_ = record;
    is_farthest_corner_ = is_corner && want.begins && got.begins;
    lacks_m_ = lacks_m;
  }
  if (lacks_m) return;
  Place next = place;
  ++next.j;
  if (got.is_motion() && ends(reached.at_start_of_want)) reach_corner(next);
  next = place;
  ++next.i;
  if (want.is_motion() && ends(reached.at_start_of_got)) reach_corner(next);

  if (want.part == Part::cut && got.part == Part::cut) match_cuts(place, reached);
  Intervals of_want = want.part == Part::cut ? reached.at_start_of_got : Intervals();
  Intervals of_got = got.is_motion() ? reached.at_start_of_want : Intervals();
  if (is_corner) of_want.push_back({0, 0});
  if (is_corner && !begins(of_got)) of_got.push_back({0, 0});
  pass_over_subject(place, std::move(of_want));
  if (want.part == Part::traverse) {
    for (const Interval& entry : of_got) traverse(place, entry);
  }
  pass_over_reference(place, std::move(of_got));
  // Without lines a motion may go on into what is not covered.
  const bool is_outside = want.part == Part::close && !tolerances_.compare_blocks &&
                          std::holds_alternative<reference::NotCovered>(*want.item);
  if (is_outside) return close(place);
  if (!is_corner) return;
  if (got.part == Part::stop) match_stop(place);
  if (want.part == Part::stop) leave_out_dwell(place);
  if (want.part == Part::stop && got.part == Part::close) leave_out_of_alarm(place);
  if (want.part == Part::renaming) rename(place);
  if (want.part == Part::free_step) take_free_step(place);
  if (want.part == Part::close || got.part == Part::close) close(place);
  if (best_ && decision(best_->kind) == oracle::Decision::go && pairs_[place.pair].is_unfit) {
    best_->kind = VerdictKind::oracle_gap;
    best_->gap = GapReason::reading_unfit;
    best_->message = "The run-out of the reading leads into the material by itself.";
  }
}

// Two pieces with one label: from the lowest place that is reached, everything beyond it.
void Correspondence::match_cuts(const Place& place, const Reached& reached) {
  const Event& want = reference(place).at(place.i);
  const Event& got = subject(place).at(place.j);
  if (compare(*want.label, *got.label, tolerances_) != Likeness::same) return;
  if (!may_be_turned(want, got)) return;
  const bool is_corner = begins(reached.at_start_of_want) || begins(reached.at_start_of_got);
  const bool is_turned = std::ranges::count(manner_.turned, got.record) > 0;
  if (is_corner && !is_turned && is_one_piece(want, got)) {
    reach_corner({place.pair, place.i + 1, place.j + 1, place.m});
  }
  const Number tau = cell_tolerance(place);
  const auto left = lowest(reached.at_start_of_want, near_part(got, want.from, tau));
  auto below = lowest(reached.at_start_of_got, near_part(want, got.from, tau));
  if (begins(reached.at_start_of_want) && left && left->sign() == 0) below = Number(0);
  if (!left && !below) return;
  Place next = place;
  ++next.i;
  if (const auto right = near_part(got, want.to, tau)) {
    const Number low = below ? right->low : max(right->low, *left);
    if (low <= right->high) reach(next, true, {low, right->high});
  }
  next = place;
  ++next.j;
  if (const auto above = near_part(want, got.to, tau)) {
    const bool from_left = left.has_value();
    const Number low = from_left ? above->low : max(above->low, *below);
    if (low <= above->high) reach(next, false, {low, above->high});
  }
}

// R2: an arc that has its other turn because rounding has moved its end is one of the reference's,
// each number rounded, and does not end where it starts there.
bool Correspondence::may_be_turned(const Event& want, const Event& got) const {
  if (!manner_.only_rounded || std::ranges::count(manner_.turned, got.record) == 0) return true;
  if (want.part != Part::cut || !std::holds_alternative<Record>(*want.item)) return false;
  const Record& due = want.source();
  const Record& arc = got.source();
  if (due.kind != RecordKind::arc || due.plane != arc.plane || due.rot != arc.rot) return false;
  const reference::PlaneAxes axes = reference::axes_of(arc.plane);
  const Position due_end = end_of(due, want.start);
  const Position end = end_of(arc, got.start);
  Number most;  // of the numbers, and how far they are off
  Number off;
  const auto look = [&](const Number& is, const Number& shown) {
    most = max(most, abs(rational_near(shown)));
    off = max(off, abs(rational_near(is - shown)));
  };
  bool closes = true;
  for (const auto& [axis, i] : {std::pair(axes.p, 0U), std::pair(axes.q, 1U)}) {
    look(want.start[axis], got.start[axis]);
    look(due_end[axis], end[axis]);
    look(due.centre[i], arc.centre[i]);
    closes = closes && rational_near(due_end[axis] - want.start[axis]).sign() == 0;
  }
  if (tolerances_.binary64 && !tolerances_.resolution) return off <= most * Number::binary(1, -51);
  return !closes && off * 2 <= tolerances_.resolution.value_or(tolerances_.increment);
}

// R3: a stretch of one label that stays near one place has none: the other side stands there.
void Correspondence::pass_over_subject(const Place& place, Intervals of_want) {
  SubjectSide& side = subject(place);
  const Event& want = reference(place).at(place.i);
  if (!side.at(place.j).is_motion()) return;
  if (place.j > 0 && goes_on(side.at(place.j - 1), side.at(place.j))) return;
  Place next = place;
  for (std::size_t j = place.j;; ++j) {
    const Event& got = side.at(j);
    if (!may_be_turned(want, got)) return;
    const Number tau = tolerance(tolerances_.tolerance, want.width + got.width);
    for (const Position* point : {&got.from, &got.to}) {
      if (want.part == Part::cut) {
        of_want = common(of_want, near_part(want, *point, tau));
      } else if (!is_near(want.from, *point, tau)) {
        return;
      }
    }
    if (of_want.empty()) return;
    if (goes_on(got, side.at(j + 1))) continue;
    next.j = j + 1;
    break;
  }
  for (Interval& part : of_want) reach(next, false, std::move(part));
}

void Correspondence::pass_over_reference(const Place& place, Intervals of_got) {
  ReferenceSide& side = reference(place);
  const Event& got = subject(place).at(place.j);
  if (!side.at(place.i).is_motion()) return;
  if (place.i > 0 && goes_on(side.at(place.i - 1), side.at(place.i))) return;
  Place next = place;
  for (std::size_t i = place.i;; ++i) {
    const Event& want = side.at(i);
    const Number tau = tolerance(tolerances_.tolerance, want.width + got.width);
    for (const Position* point : {&want.from, &want.to}) {
      if (got.is_motion()) {
        of_got = common(of_got, near_part(got, *point, tau));
      } else if (!is_near(got.from, *point, tau)) {
        return;
      }
    }
    if (of_got.empty()) return;
    if (goes_on(want, side.at(i + 1))) continue;
    next.i = i + 1;
    break;
  }
  for (Interval& part : of_got) reach(next, true, std::move(part));
}

std::size_t Correspondence::pair_for(const Pair& pair) {
  for (std::size_t number = 0; number < pairs_.size(); ++number) {
    const Pair& other = pairs_[number];
    if (other.reference == pair.reference && other.first_record == pair.first_record &&
        other.start == pair.start) {
      return number;
    }
  }
  pairs_.push_back(pair);
  pairs_.back().subject = std::make_shared<SubjectSide>(outcome_.records, pair.first_record,
                                                        pair.start, tolerances_, manner_.turned);
  return pairs_.size() - 1;
}

}  // namespace gonogo::relation
