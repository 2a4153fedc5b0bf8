// SPDX-License-Identifier: GPL-3.0-or-later
//
// ProgramJudge's part for an alarm of the subject (R6, R7): where the program comes to what answers
// it, and what was due before it.
#include "oracle/judge/changed_program.hpp"
#include "oracle/judge/mismatch.hpp"
#include "oracle/judge/program_ending.hpp"
#include "oracle/motion/round_curve.hpp"
#include "oracle/region/constants.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/silent_end.hpp"

namespace gonogo::oracle {

using reference::AlarmReport;
using reference::NotCovered;

// At the reference's alarm or its end. R7: what departs in motion, or in M functions, before
// an alarm that no text states goes first.
ProgramJudge::Ending ProgramJudge::at_alarm(Hypothesis& from, const Alarming& alarming) {
  using MFunctions = Ending::MFunctions;
  const auto& unfinished = alarming.unfinished;
  const ReferenceSteps::Step& here = reference_.at(from.step);
  const auto* report = std::get_if<AlarmReport>(&here.what);
  std::optional<Verdict> departure = report != nullptr ? compare_alarm(from, alarming, *report)
                                                       : alarm_without_line(alarming.alarm);
  if (report == nullptr && !departure) {
    departure = spurious_alarm(alarming, "The subject alarms, and the program has no fault.");
  }
  if (report == nullptr && unfinished && tolerances_.compare_blocks &&
      departure->kind == VerdictKind::fail_alarm_spurious) {
    const auto behind = own_alarm();
    if (behind && behind->block > alarming.alarm.block) {
      departure->message = "The alarm comes in a block before the right one.";
      departure->want = alarms_text(*behind);
    }
  }
  if (departure && departure->want.empty() && unfinished) {
    departure->want = step_text(unfinished->step.what);
  }
  const bool is_early = report == nullptr || (tolerances_.compare_blocks && departure &&
                                              alarming.alarm.block < report->block);
  // Without line numbers the block that the subject names says nothing.
  const std::uint64_t alarmed = tolerances_.compare_blocks ? alarming.alarm.block : 0;
  const std::uint64_t block = is_early ? alarmed : report->block;
  const std::size_t item = unfinished ? unfinished->step.item : 0;
  if (departure && departure->kind != VerdictKind::advice) {
    return {from, std::move(departure), MFunctions::none, 0, 0, false, item};
  }
  if (unfinished && (!departure || block_of(unfinished->step.what) < block)) {
    Verdict verdict = ends_early(unfinished->from, unfinished->step.what, records_,
                                 alarm_text(alarming.alarm), tolerances_);
    if (!unfinished->from.piece) verdict.rule = RelationRule::alarm;  // R6: before what is due
    return {unfinished->from, std::move(verdict), MFunctions::none, 0, 0, false, item};
  }
  // Past what is undone no M function has been come to.
  const std::size_t due = unfinished ? unfinished->step.m_functions : here.m_functions;
  if (!departure) return {from, {}, MFunctions::before_alarm, due, block, alarming.at_load};
  return {from, std::move(departure), alarming.at_load ? MFunctions::none : MFunctions::of_earlier,
          due, block};
}

bool ProgramJudge::is_left_at_alarm(Hypothesis& from) {
  FreeStep* open = alignment_.free_step_of(from);
  if (open == nullptr) return false;
  return !open->is_judged_when_left() || open->is_judged_at_alarm(from.at);
}

// R7: an alarm behind an end that no text states, which is no answer to where it stands.
bool ProgramJudge::is_alarm_behind_end(Hypothesis& from, const Alarming& alarming) {
  if (!is_silent_end(reference_.at(from.step).what) || alarming.unfinished) return false;
  if (alarm_without_line(alarming.alarm)) return false;
  Verdict verdict = spurious_alarm(alarming, "The subject goes on behind the end of the program.");
  if (verdict.kind == VerdictKind::advice) return false;
  verdict.clause = clause_of(reference_.at(from.step).what);
  return alignment_.go_on_behind_end(from, std::move(verdict));
}

// Whether a step is due behind the block of the subject's alarm, before which others are undone:
// then no alarm of the program makes it right.
bool ProgramJudge::is_behind_alarm(const Alarming& alarming, const ReferenceStep& step) const {
  if (!alarming.unfinished || !tolerances_.compare_blocks) return false;
  const std::uint64_t alarmed = alarming.alarm.block;
  const std::uint64_t block = block_of(step);
  return block_of(alarming.unfinished->step.what) >= alarmed && block != 0 && block != alarmed;
}

// The program's own alarm, which the message names where a subject's alarm comes before it.
std::optional<AlarmReport> ProgramJudge::own_alarm() const try {
  return alarm_of(profile_, program_);
} catch (const exact::Undecided&) {
  return std::nullopt;
}

std::optional<ProgramJudge::Ending> ProgramJudge::excused_at(Hypothesis from,
                                                             const Alarming& alarming) {
  Ending ending = at_alarm(from, alarming);
  const bool is_excused = ending.verdict && ending.verdict->kind == VerdictKind::advice;
  return is_excused ? std::optional(std::move(ending)) : std::nullopt;
}

ProgramJudge::Ending ProgramJudge::alarm_end(Hypothesis& from, const SubjectAlarm& alarm) {
  // A controller that checks at load has put out nothing.
  const bool at_load = profile_.alarm_timing == reference::AlarmTiming::program && !has_acted_;
  Alarming alarming{alarm, at_load, reference_.at(from.step).item, !from.is_fresh()};
  auto& unfinished = alarming.unfinished;
  bool may_be_earlier = !at_load && tolerances_.compare_blocks;
  std::optional<Ending> earlier;
  const auto best = [&](Ending ending) {
    const bool is_go = !ending.verdict || ending.verdict->kind == VerdictKind::advice;
    return is_go || !earlier ? std::move(ending) : *std::move(earlier);
  };
  for (std::size_t passed = 0; passed < kMostItems; ++passed) {
    if (!earlier) forget_behind(from, at_load || unfinished);
    const ReferenceSteps::Step& here = reference_.at(from.step);
    const ReferenceStep& step = here.what;
    auto* const outside = std::get_if<NotCovered>(&step);
    if (outside != nullptr && (at_load || !unfinished)) {
      return {from, not_covered_verdict(*outside)};
    }
    const bool is_close = std::holds_alternative<AlarmReport>(step) || is_record_end(step);
    if (is_close && is_alarm_behind_end(from, alarming)) continue;
    if (is_close || outside != nullptr || is_behind_alarm(alarming, step)) {
      return best(at_alarm(from, alarming));
    }
    auto* motion = std::get_if<Motion>(&step);
    const bool may_pass = motion != nullptr ? !unfinished
                                            : std::holds_alternative<reference::Renaming>(step) ||
                                                  alignment_.may_be_none(step) ||
                                                  (!at_load && is_left_at_alarm(from));
    if (may_pass) {
      const bool may_alarm_here =
          may_be_earlier && motion != nullptr && motion->record.block == alarm.block;
      std::optional<Hypothesis> stands;
      if (may_alarm_here) stands = from;
      const Alarming alarming_here{alarm, false, here.item, !from.is_fresh()};
      Alignment::Passing passing = alignment_.pass(from);
      // R7: before a motion too small to see, to whose block a loop leads back.
      if (passing.passed && stands) {
        may_be_earlier = false;
        earlier = excused_at(*std::move(stands), alarming_here);
      }
      if (passing.passed) continue;
      if (passing.why_not && from.open->is_judged_when_left()) {
        return open_end(from, *std::move(passing.why_not));
      }
    }
    // Past motion that is missing, only the alarm of the program is of interest.
    if (!at_load && !unfinished) {
      const bool is_of_block =
          motion != nullptr && (!tolerances_.compare_blocks || alarm.block == motion->record.block);
      if (is_of_block && hangs_on_rounding(*motion, tolerances_.tolerance)) {
        return {from, gap_verdict(GapReason::rounding, kPointsNearlyInLine)};
      }
      unfinished.emplace(Alarming::Unfinished{from, here});
    }
    alignment_.skip(from);
  }
  if (unfinished) return best(at_alarm(from, alarming));
  throw exact::Undecided("the program goes on for too long behind the alarm");
}

}  // namespace gonogo::oracle
