// SPDX-License-Identifier: GPL-3.0-or-later
//
// Alignment's part for a motion of the reference: pieces, joins, ends, what departs.
#include "oracle/judge/alignment.hpp"

#include <algorithm>

#include "oracle/judge/grade.hpp"
#include "oracle/judge/mismatch.hpp"
#include "oracle/motion/arc_turns.hpp"
#include "oracle/motion/curve_follower.hpp"
#include "oracle/motion/places.hpp"
#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {

using reference::NotCovered;

namespace {

bool moves_nothing(const Motion& motion) {
  return agree(motion.from, motion.to(), 0) && !goes_round(motion, 0);
}

}  // namespace

bool Alignment::meet_motion(Hypothesis& from, const Motion& motion, Stage& stage) {
  const ReferenceSteps::Step& step = step_of(from);
  if (from.is_fresh() && is_same_motion(motion, wanted(from, step))) {
    from.coordinates.take_exact(coordinates_in(wanted(from, step)));
    leave_motion(from);
    from.at = from.anchor = motion.to();
    keep(std::move(from), stage.reached);
    return false;
  }
  const std::size_t before = stage.reached.size();
  const Hypothesis as_it_was = from;
  if (!from.curve) from.curve = steps_.curve_of(step);
  CurveAnswer answer = from.curve->follow(from.progress, motion);
  if (answer.departs()) extend(from, motion, answer);
  // R3. What may be negligible is no piece of a line.
  const bool is_arc = is_round(from.curve->motion().record.kind);
  const bool departs = answer.departs();
  const bool is_between_pieces =
      !as_it_was.is_fresh() && departs && stays_at(as_it_was.anchor, motion, tolerances_);
  const bool is_nil = is_between_pieces || ((as_it_was.is_fresh() || is_arc) &&
                                            is_negligible(as_it_was, motion, step.place));
  const bool is_done = std::ranges::any_of(answer.ways, [](const auto& way) { return way.done; });
  if (is_done || (!departs && (is_arc || !is_nil))) {
    if (take_ways(from, motion, answer, stage)) return false;
    if (is_done) take_longer_end(from, motion, stage);
  }
  if (is_nil && !is_done) stay(as_it_was, motion, stage);
  // A motion of an earlier block passes nothing of this one.
  const Motion& want = wanted(as_it_was, step);
  if (!is_of_earlier_block(motion.record, want.record.block) && can_pass(as_it_was, want)) {
    const bool is_own = tolerances_.compare_blocks && motion.record.block == want.record.block;
    if (is_own && !is_nil && departs && answer.departure != Departure::undecided) {
      Refutation own{std::move(from), motion, std::move(answer), std::nullopt};
      own.may_be_passed = true;
      refute(std::move(own));
    }
    from = as_it_was;
    leave_motion(from);
    return true;
  }
  if (stage.reached.size() == before && departs) depart(from, motion, std::move(answer), stage);
  return false;
}

// Not over an M function.
bool Alignment::join_step(Hypothesis& from) {
  return overdue_at(from.step + from.joined + 1) == nullptr && join_motion(from);
}

bool Alignment::join_motion(Hypothesis& from) {
  const auto* motion = std::get_if<Motion>(&step_behind(from).what);
  if (motion == nullptr) return false;
  if (!moves_nothing(*motion)) {
    Motion both = from.curve->motion();
    if (!join(both, *motion) && !join_chords(from, *motion, both)) return false;
    from.curve = std::make_shared<Curve>(std::move(both), tolerances_);
  }
  ++from.joined;
  return true;
}

// R3: arcs that agree with their chords are joined as these are.
bool Alignment::join_chords(Hypothesis& from, const Motion& next, Motion& both) {
  const std::optional<Motion> chord = from.curve->chord();
  if (chord) both = *chord;
  const bool is_chord = agrees_with_chord(next, tolerances_.tolerance);
  if (!chord && !is_chord) return false;
  if (!join(both, is_chord ? chord_of(next) : next)) return false;
  if (chord && from.piece) {
    const Axis axis = longest_axis(both);
    from.progress = {};
    from.progress.line = abs(from.piece->to()[axis] - both.from[axis]);
  }
  return true;
}

// Joins steps that go on as the motion does, as far as it goes.
bool Alignment::extend(Hypothesis& from, const Motion& motion, CurveAnswer& answer) {
  Hypothesis longer = from;
  while (longer.curve->goes_beyond(longer.progress, motion)) {
    if (!join_step(longer)) return false;
    CurveAnswer further = longer.curve->follow(longer.progress, motion);
    if (further.departs()) continue;
    from = std::move(longer);
    answer = std::move(further);
    return true;
  }
  return false;
}

// True where it is the end of the step to the last digit: then it is nothing else.
bool Alignment::take_ways(const Hypothesis& from, const Motion& motion, const CurveAnswer& answer,
                          Stage& stage) {
  const Motion& want = from.curve->motion();
  // Chords that are granted are bounded by the arc.
  const bool is_chord = is_round(want.record.kind) && motion.record.kind == RecordKind::feed;
  if (is_chord) ++forgiven_.records;
  bool is_exact = false;
  for (const CurveWay& way : answer.ways) {
    Hypothesis next = from;
    next.at = next.anchor = motion.to();
    if (way.done) {
      const Grade grade = grade_of(motion, want, tolerances_, &next.coordinates);
      next.exact = next.exact && grade.exact && !is_chord;
      next.rounded = next.rounded && grade.rounded && !is_chord;
      is_exact = is_exact || grade.exact;
      if (way.progress.undecided_because != nullptr && !next.instead) {
        next.instead = gap_verdict(way.progress.gap, way.progress.undecided_because);
      }
      leave_motion(next);
    } else {
      next.progress = way.progress;
      next.piece = motion;
      const bool is_graded = next.exact || next.rounded;
      if (is_graded && !is_exact_piece(motion, want)) next.exact = next.rounded = false;
    }
    keep(std::move(next), stage.reached);
  }
  return is_exact;
}

// A motion that ends a step may as well end the next one, which goes on from it by less than can be
// seen.
void Alignment::take_longer_end(const Hypothesis& from, const Motion& motion, Stage& stage) {
  const ReferenceStep& next = step_behind(from).what;
  const auto* end = std::get_if<Motion>(&next);
  if (end == nullptr || !same_place(end->to(), motion.to(), tolerances_)) return;
  Hypothesis longer = from;
  if (!join_step(longer)) return;
  CurveAnswer answer = longer.curve->follow(longer.progress, motion);
  if (answer.departs() || take_ways(longer, motion, answer, stage)) return;
  take_longer_end(longer, motion, stage);
}

void Alignment::depart(const Hypothesis& from, const Motion& motion, CurveAnswer answer,
                       Stage& stage) {
  if (leads_outside(from, motion)) return;
  if (leads_over_m_function(from, motion)) return;
  if (leads_into_free_step(from, motion, stage)) return;
  if (leads_past_corner(from, motion, stage)) return;
  if (takes_coarse_centre(from, motion, answer, stage)) return;
  refute(Refutation{from, motion, std::move(answer), std::nullopt});
}

// Without line numbers a motion may be joined to those of a block that is not covered: then its end
// says nothing.
bool Alignment::leads_outside(const Hypothesis& from, const Motion& motion) {
  if (tolerances_.compare_blocks) return false;
  Hypothesis longer = from;
  while (longer.curve->goes_beyond(longer.progress, motion)) {
    const ReferenceStep& next = step_behind(longer).what;
    if (auto* outside = std::get_if<NotCovered>(&next)) {
      leave_undecided(longer.step + longer.joined + 1, not_covered_verdict(*outside));
      return true;
    }
    if (!join_step(longer)) return false;
  }
  return false;
}

// A motion that goes on where an M function is due.
bool Alignment::leads_over_m_function(const Hypothesis& from, const Motion& motion) {
  Hypothesis longer = from;
  std::optional<DueMFunction> due;
  while (longer.curve->goes_beyond(longer.progress, motion)) {
    const DueMFunction* here = overdue_at(longer.step + longer.joined + 1);
    if (!due && here != nullptr) due = *here;
    if (!join_motion(longer)) return false;
    if (!due || longer.curve->follow(longer.progress, motion).departs()) continue;
    refute_missing(from, *due, record_text(motion.record), motion.number);
    return true;
  }
  return false;
}

// A motion that leads to an open path and on into it: from there on its rest.
bool Alignment::leads_into_free_step(const Hypothesis& from, const Motion& motion, Stage& stage) {
  const Motion& want = from.curve->motion();
  if (!from.curve->goes_beyond(from.progress, motion)) return false;
  Hypothesis beyond = from;
  leave_motion(beyond);
  const ReferenceSteps::Step& next = steps_.at(beyond.step);
  if (!make_free_step(next, tolerances_, memory_) || block_of(next.what) != want.record.block ||
      overdue(beyond) != nullptr) {
    return false;
  }
  begin_free_step(beyond);
  Motion rest = motion;
  for (const Axis axis : reference::kLinearAxes) {
    if (moved_axes(motion, 0).has(axis)) rest.from[axis] = want.to()[axis];
  }
  if (!beyond.open->may_begin_within(rest)) return false;
  beyond.at = beyond.anchor = rest.from;
  meet_free_step(std::move(beyond), std::move(rest), stage);
  return true;
}

// R4. A traverse of one axis may be split anywhere, also where one of several axes ends and the
// next begins.
bool Alignment::leads_past_corner(const Hypothesis& from, const Motion& motion, Stage& stage) {
  const Motion& want = from.curve->motion();
  const bool are_traverses =
      want.record.kind == RecordKind::rapid && motion.record.kind == RecordKind::rapid;
  const AxisSet moved = moved_axes(motion, 0);
  const auto axis =
      std::ranges::find_if(reference::kAllAxes, [&](Axis one) { return moved.has(one); });
  if (!are_traverses || axis == reference::kAllAxes.end() || moved != AxisSet{*axis}) return false;
  const Number& corner = want.to()[*axis];
  if (((corner - motion.from[*axis]) * (motion.to()[*axis] - corner)).sign() <= 0) return false;
  Motion first = motion;
  Motion rest = motion;
  first.record.to[*axis] = rest.from[*axis] = corner;
  const CurveAnswer answer = from.curve->follow(from.progress, first);
  if (std::ranges::none_of(answer.ways, [](const CurveWay& way) { return way.done; })) return false;
  Hypothesis beyond = from;
  beyond.at = beyond.anchor = rest.from;
  leave_motion(beyond);
  const auto due = [&] { return std::get_if<Motion>(&step_of(beyond).what); };
  while (due() != nullptr && can_pass(beyond, *due()) && overdue(beyond) == nullptr) {
    leave_motion(beyond);
  }
  if (due() == nullptr || due()->record.kind != RecordKind::rapid) return false;
  const bool goes_on = !steps_.curve_of(step_of(beyond))->follow(beyond.progress, rest).departs();
  if (!goes_on || overdue(beyond) != nullptr) return false;
  beyond.exact = false;
  walk(std::move(beyond), std::move(rest), stage);
  return true;
}

// R7. The centre that a control computes itself, within twice the tolerance of the right
// one: what follows is judged, for the arc ends where it should.
bool Alignment::takes_coarse_centre(const Hypothesis& from, const Motion& motion,
                                    const CurveAnswer& answer, Stage& stage) {
  std::optional<Verdict> advice =
      coarse_centre_advice(answer, motion, from.curve->motion(), tolerances_);
  if (!advice) return false;
  Hypothesis next = from;
  if (!next.instead) next.instead = std::move(advice);
  next.at = next.anchor = motion.to();
  leave_motion(next);
  keep(std::move(next), stage.reached);
  return true;
}

}  // namespace gonogo::oracle
