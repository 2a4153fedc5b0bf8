// SPDX-License-Identifier: GPL-3.0-or-later
//
// Alignment's part for steps whose path is open, and for what is omitted where the subject
// stands.
#include "oracle/judge/alignment.hpp"

#include "oracle/judge/mismatch.hpp"
#include "oracle/motion/places.hpp"
#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {

using reference::Renaming;

void Alignment::begin_free_step(Hypothesis& from) {
  from.open = make_free_step(step_of(from), tolerances_, memory_);
}

void Alignment::meet_free_step(Hypothesis from, Motion motion, Stage& stage) {
  const ReferenceSteps::Step& step = step_of(from);
  if (tolerances_.compare_blocks && motion.record.block > block_of(step.what)) {
    return meet_behind_free_step(std::move(from), motion, stage);
  }
  if (from.waiting && join(*from.waiting, motion)) {
    from.at = from.anchor = motion.to();
    return keep(std::move(from), stage.reached);
  }
  const bool is_begun = from.open != nullptr;
  if (!is_begun) begin_free_step(from);
  const bool is_earlier = tolerances_.compare_blocks && motion.record.block < block_of(step.what);
  const bool stays =
      stays_at(from.anchor, motion, tolerances_) || (!is_begun && ends_left(from, motion));
  const bool is_small = motion.record.kind != RecordKind::arc && stays && !from.open->sees(motion);
  const bool is_before =
      (is_earlier || from.open->is_before(motion)) && stays_at(step.place, motion, tolerances_);
  const bool may_be_behind = is_small && from.open->may_be_left_by(motion);
  if ((is_small || is_before) && !may_be_behind) {
    if (!is_begun) from.open.reset();
    return stay(std::move(from), motion, stage);
  }
  if (from.waiting) {
    std::vector<Hypothesis> beyond;
    if (!take_waiting(from, beyond)) {
      for (Hypothesis& each : beyond) walk(std::move(each), motion, stage);
      return;
    }
  }
  if (may_be_behind) {
    if (Hypothesis behind = from; pass(behind).passed) walk(std::move(behind), motion, stage);
    return stay(std::move(from), motion, stage);
  }
  from.at = from.anchor = motion.to();
  from.waiting = std::move(motion);
  keep(std::move(from), stage.reached);
}

// With a motion of a later block the path has ended where the subject stands.
void Alignment::meet_behind_free_step(Hypothesis from, const Motion& motion, Stage& stage) {
  std::vector<Hypothesis> reached;
  if (!from.waiting || take_waiting(from, reached)) {
    const Passing passing = pass(from);
    if (!passing.passed) {
      const bool is_nil = motion.record.kind != RecordKind::arc &&
                          stays_at(from.anchor, motion, tolerances_) &&
                          !from.open->is_judged_when_left();
      if (is_nil) return stay(std::move(from), motion, stage);
      if (passing.why_not) refute(from, *passing.why_not);
      return;
    }
    reached.push_back(std::move(from));
  }
  for (Hypothesis& each : reached) walk(std::move(each), motion, stage);
}

bool Alignment::take_waiting(Hypothesis& from, std::vector<Hypothesis>& reached) {
  Motion motion = *std::exchange(from.waiting, std::nullopt);
  // A flat `arc3` is an arc by another name.
  motion = as_arc(motion).value_or(motion);
  FreeStepAnswer answer = from.open->take(motion);
  if (answer.is_decided()) {
    if (!from.open->is_path_known()) answer.verdict.rule = RelationRule::free_step;
    refute(std::move(from), std::move(answer.verdict));
    return false;
  }
  const bool is_ended = answer.kind == FreeStepAnswer::Kind::ended;
  // J-CMP-09: a motion counts where a free step has taken it, or its first part.
  if (!is_ended || !agree(answer.here, motion.from, tolerances_.tolerance)) ++from.property_motions;
  if (!is_ended) {
    if (answer.cost == FreeStepAnswer::Cost::free) ++forgiven_.records;
    if (answer.cost == FreeStepAnswer::Cost::level_cut) ++forgiven_.level_cuts;
    return true;
  }
  if (!leave_free_step(from, answer.here)) return false;
  motion.from = answer.here;
  Stage stage;
  walk(std::move(from), std::move(motion), stage);
  reached = std::move(stage.reached);
  return false;
}

bool Alignment::leave_free_step(Hypothesis& from, const Position& here) {
  const FreeStep::Exit exit = from.open->exit(here);
  if (!steps_.go_on_from(from.step, exit.at, exit.moves_machine)) {
    leave_undecided(from.step,
                    gap_verdict(GapReason::two_readings,
                                "The motions of an open path may be meant in several ways."));
    return false;
  }
  from.open.reset();
  from.waiting.reset();
  from.at = from.anchor = here;
  ++from.step;
  return true;
}

Alignment::Passing Alignment::pass(Hypothesis& from) {
  const ReferenceSteps::Step& step = step_of(from);
  if (std::holds_alternative<Motion>(step.what)) {
    if (!can_pass(from, wanted(from, step))) return {};
    leave_motion(from);
    return {true};
  }
  if (auto* renaming = std::get_if<Renaming>(&step.what)) {
    shift(from.at, renaming->shift);
    shift(from.anchor, renaming->shift);
    ++from.step;
    return {true};
  }
  if (may_be_none(step.what)) {
    ++from.step;
    return {true};
  }
  FreeStep* open = free_step_of(from);
  if (open == nullptr) return {};
  if (std::optional<Verdict> why_not = open->end(from.at)) {
    if (!open->is_path_known()) why_not->rule = RelationRule::free_step;
    return {false, std::move(why_not)};
  }
  return {leave_free_step(from, from.at)};
}

FreeStep* Alignment::free_step_of(Hypothesis& from) {
  if (!from.open) begin_free_step(from);
  return from.open.get();
}

void Alignment::skip(Hypothesis& from) {
  from.step += from.joined + 1;
  from.joined = 0;
  from.curve.reset();
  from.piece.reset();
  from.open.reset();
}

}  // namespace gonogo::oracle
