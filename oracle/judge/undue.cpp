// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of a motion or a dwell that comes where none is due, or another.
#include <algorithm>

#include "oracle/judge/mismatch.hpp"
#include "oracle/judge/unit_error.hpp"
#include "oracle/motion/labels.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/compared.hpp"

namespace gonogo::oracle {
namespace {

// What is said of a motion that is not due, with the farthest place that it leads to, and how far
// that is from where the tool has to stay.
Verdict undue(const Motion& motion, const ReferenceSteps::Step& step, const Tolerances& tolerances,
              std::string_view sentence) {
  Verdict verdict =
      verdict_on(VerdictKind::fail_geometry, motion.record, motion.number, std::string(sentence));
  verdict.want = step_text(step.what);
  verdict.witness = place_text(motion.to());
  Motion stay;
  stay.from = stay.record.to = step.place;
  stay.record.kind = RecordKind::feed;
  try {
    const Curve place(stay, tolerances);
    const Apart far = place.farthest(place.apart({}, motion), {}, motion);
    verdict.witness = place_text(far.at);
    tell_distance(verdict, far.distance, far.at, step.place, tolerances.tolerance);
  } catch (const exact::Undecided&) {
  }
  return verdict;
}

}  // namespace

Verdict before_renaming(const Motion& motion, const ReferenceSteps::Step& step,
                        const Tolerances& tolerances) {
  return undue(motion, step, tolerances,
               "The subject moves where the position gets another name, and no motion is due.");
}

Verdict motion_too_many(const Motion& motion, const ReferenceSteps::Step& step,
                        const Tolerances& tolerances) {
  const bool alarms = std::holds_alternative<reference::AlarmReport>(step.what);
  const bool dwells = dwell_of(step.what) != nullptr;
  Verdict verdict =
      undue(motion, step, tolerances,
            alarms   ? "The subject moves before the block that alarms, and no motion is due."
            : dwells ? "The subject moves where a dwell is due."
                     : "All motions of the program have come, and the subject makes another one.");
  verdict.clause = clause_of(step.what);
  if (dwells) {
    verdict.rule = RelationRule::event;
    // A motion of a later block comes for want of the dwell.
    verdict.block = std::min(verdict.block, block_of(step.what));
  }
  if (!alarms && !dwells) verdict.kind = VerdictKind::fail_overrun;
  return verdict;
}

Verdict motion_for_m_function(const DueMFunction& due, const Motion& motion,
                              const ReferenceSteps::Step& step, const Tolerances& tolerances) {
  Verdict verdict = undue(motion, step, tolerances,
                          "The subject moves where an M function is due, and no motion.");
  verdict.clause = due.record.clause;
  verdict.rule = RelationRule::event;
  verdict.want = record_text(due.record);
  return verdict;
}

Verdict m_function_for_dwell(const ReferenceStep& due, const Record& got, std::size_t number) {
  Verdict verdict = verdict_on(VerdictKind::fail_geometry, got, number,
                               "An M function comes where a dwell is due.");
  verdict.rule = RelationRule::event;
  verdict.clause = clause_of(due);
  verdict.block = block_of(due);
  verdict.want = step_text(due);
  return verdict;
}

bool is_dwell_due(const ReferenceStep& step, const Record& dwell, const Tolerances& tolerances) {
  const Record* want = dwell_of(step);
  if (want == nullptr || dwell.kind != RecordKind::dwell) return false;
  if (tolerances.compare_blocks && want->block != dwell.block) return false;
  return times_agree(*want, dwell, tolerances);
}

namespace {

// J-CMP-12, of one that is not due at step `number`.
VerdictKind kind_of_dwell(const Record& dwell, std::size_t number, ReferenceSteps& steps,
                          const Tolerances& tolerances) {
  for (std::size_t i = number; i < number + kLookAhead; ++i) {
    const ReferenceStep& step = steps.at(i).what;
    if (is_end(step)) break;
    if (is_dwell_due(step, dwell, tolerances)) return VerdictKind::fail_order;
  }
  const Record* want = dwell_of(steps.at(number).what);
  const bool is_of_block =
      want != nullptr && (!tolerances.compare_blocks || want->block == dwell.block);
  return is_of_block ? VerdictKind::fail_feed : VerdictKind::fail_geometry;
}

}  // namespace

// J-CMP-12: a dwell is due behind the motion that the subject has left unfinished.
Verdict wrong_dwell(const Record& dwell, std::size_t number, const Hypothesis& from,
                    ReferenceSteps& steps, const Tolerances& tolerances) {
  const ReferenceStep& step = steps.at(from.step).what;
  if (std::holds_alternative<Motion>(step) && from.piece) {
    const ReferenceStep& behind = steps.at(from.step + from.joined + 1).what;
    if (dwell_of(behind) != nullptr) return short_of(from, tolerances);
  }
  const Record* want = dwell_of(step);
  Verdict verdict =
      verdict_on(kind_of_dwell(dwell, from.step, steps, tolerances), dwell, number, {});
  if (verdict.kind != VerdictKind::fail_feed) verdict.rule = RelationRule::event;
  verdict.want = step_text(step);
  verdict.clause = clause_of(step);
  if (verdict.kind == VerdictKind::fail_order) {
    verdict.message = "A later dwell comes here: what is due before it is missing, or comes later.";
  } else if (want == nullptr) {
    verdict.message = "The subject dwells where no dwell is due.";
  } else if (verdict.kind != VerdictKind::fail_feed) {
    verdict.message = "The dwell belongs to another block.";
  } else {
    verdict.message = reference::with_values("The dwell differs. It is {} s in place of {}.",
                                             {dwell.seconds, want->seconds});
    const Number rounding = rounding_of_number(dwell.seconds, tolerances.resolution, tolerances);
    verdict.message += unit_error(Quantity::dwell, want->seconds, dwell.seconds, rounding);
  }
  return verdict;
}

}  // namespace gonogo::oracle
