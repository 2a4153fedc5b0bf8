// SPDX-License-Identifier: GPL-3.0-or-later
//
// ProgramJudge's part for one motion of the subject against the steps of the reference, one after
// the other until the motion is used up.
#include "oracle/judge/evidence.hpp"
#include "oracle/judge/program_judge.hpp"
#include "oracle/judge/standing.hpp"

namespace gonogo::oracle {

using reference::HelixPocket;
using reference::PocketLevel;
using reference::PocketMilling;
using reference::ThreadMilling;

void ProgramJudge::process(Motion motion) {
  while (!verdict_ && !process_step(motion)) {
  }
}

bool ProgramJudge::process_step(Motion& motion) {
  if (after_alarm_) return true;
  const ReferenceStep& step = reference_.current();
  if (auto* want = std::get_if<Motion>(&step)) return match_motion(motion, *want);
  if (auto* level = std::get_if<PocketLevel>(&step)) {
    if (collect(motion, *level)) return true;
    if (!verdict_) finish_level(*level, motion.from);
    return false;
  }
  if (auto* thread = std::get_if<ThreadMilling>(&step)) {
    const OpenPathAnswer answer = thread_judge(*thread).take(motion);
    return follow_open_path(answer, motion);
  }
  if (auto* pocket = std::get_if<HelixPocket>(&step)) {
    const OpenPathAnswer answer = helix_pocket_judge(*pocket).take(motion);
    return follow_open_path(answer, motion);
  }
  if (auto* pocket = std::get_if<PocketMilling>(&step)) {
    const OpenPathAnswer answer = pocket_judge(*pocket).take(motion);
    if (pocket_judge(*pocket).is_limited() && is_cut(motion.record.kind)) budget_.forgive();
    return follow_open_path(answer, motion);
  }
  const bool nothing = means_nothing(motion, step);
  if (std::holds_alternative<reference::AlarmReport>(step)) {
    if (nothing) return true;
    after_alarm_ = motion;
    return true;
  }
  if (auto* outside = std::get_if<reference::NotCovered>(&step)) {
    decide_gap(outside->message);
    return true;
  }
  if (std::holds_alternative<reference::Renaming>(step)) {
    if (nothing) return true;
    decide_gap("A motion of the subject spans a renaming of the position.");
    return true;
  }
  const auto& record = std::get<Record>(step);
  if (record.kind == RecordKind::m) {
    take_m_functions();
    return false;
  }
  if (nothing) return true;
  Verdict verdict;
  verdict.kind = VerdictKind::fail_overrun;
  verdict.message = "The subject moves after the end of the program.";
  verdict.block = motion.record.block;
  verdict.clause = record.clause;
  verdict.record = motion.number;
  verdict.want = record_text(record);
  verdict.got = record_text(motion.record);
  verdict.witness = point_text(motion.to(), moved_axes(motion, 0));
  if (record.kind == RecordKind::dwell) {
    verdict.message = "The subject moves where a dwell is due.";
    // Goes on in the reference: `record` is gone after it.
    verdict.kind = fits_later(motion) ? VerdictKind::fail_order : VerdictKind::fail_geometry;
  }
  decide(std::move(verdict));
  return true;
}

bool ProgramJudge::match_motion(Motion& motion, const Motion& want) {
  if (!match_ && is_same_motion(motion, want)) {
    reference_.advance();
    return true;
  }
  if (!match_) {
    want_ = want;
    match_.emplace(*want_, terms_);
  }
  const MatchResult result = match_->match(motion);
  if (result.departure == Departure::none) {
    const bool is_chord = is_round(want_->record.kind) && motion.record.kind == RecordKind::feed;
    if (is_chord) budget_.forgive();
    if (result.done) {
      note_match(motion, *want_);
      match_.reset();
      reference_.advance();
    }
    return true;
  }
  // Motions too small to see may be kept on one side and dropped on the other.
  if (reached(*want_, motion.from)) {
    match_.reset();
    reference_.advance();
    return false;
  }
  if (means_nothing(motion, want_->from, want_->stood.value_or(want_->from),
                    dropped_arcs_of(*want_))) {
    return true;
  }
  if (dives_into_pocket(motion)) return false;
  if (!goes_on_outside(motion)) report_departure(result, motion, *want_);
  return true;
}

// Without line numbers a motion may be joined to those of a block that is not covered: then its end
// says nothing. Goes on in the reference where it may be so.
bool ProgramJudge::goes_on_outside(const Motion& motion) {
  if (terms_.compare_blocks || !match_->goes_beyond(motion)) return false;
  reference_.advance();
  auto* outside = std::get_if<reference::NotCovered>(&reference_.current());
  if (outside != nullptr) decide_gap(outside->message);
  return outside != nullptr;
}

// Whether a motion of the reference is done where the subject stands.
bool ProgramJudge::reached(const Motion& want, const Position& at) const {
  return same_place(at, want.to(), terms_) && !goes_round(want, terms_.tolerance);
}

bool ProgramJudge::means_nothing(const Motion& motion, const Position& here, const Position& stood,
                                 std::span<const Record> dropped_arcs) const {
  const auto stays = [&](const Position& point) {
    return same_place(point, here, terms_) || same_place(point, stood, terms_);
  };
  if (!stays(motion.from) || !stays(motion.to())) return false;
  if (motion.record.kind == RecordKind::arc3 && !stays(via_of(motion))) return false;
  return may_mean_none(motion, terms_.tolerance, dropped_arcs);
}

bool ProgramJudge::means_nothing(const Motion& motion, const ReferenceStep& step) const {
  Position here = reference_.position();
  Position stood = reference_.anchor();
  if (auto* renaming = std::get_if<reference::Renaming>(&step)) {
    for (Axis axis : reference::kAllAxes) {  // the subject has not followed it yet
      here[axis] -= renaming->shift[axis];
      stood[axis] -= renaming->shift[axis];
    }
  }
  return means_nothing(motion, here, stood, reference_.dropped_arcs());
}

}  // namespace gonogo::oracle
