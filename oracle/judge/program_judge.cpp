// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/program_judge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "oracle/judge/evidence.hpp"

namespace gonogo::oracle {

using reference::HelixPocket;
using reference::PocketLevel;
using reference::PocketMilling;
using reference::ThreadMilling;

namespace {

// Whether a motion whose ends agree may be meant as none: all but an arc that goes round, unless
// the reference had an arc as small there.
bool may_mean_nil(const Motion& motion, const Number& tolerance, bool reference_dropped_arc) {
  return !goes_round(motion, tolerance) ||
         (reference_dropped_arc && std::abs(motion.record.rot) == 1);
}

}  // namespace

bool RecordBudget::allows(std::size_t records, std::size_t live) {
  constexpr std::size_t kFactor = 10;
  constexpr std::size_t kSlack = 1'000;
  while (records > kFactor * std::max(counted_, live) + kSlack) {
    if (complete_) return false;
    complete_ = expander_.next() == nullptr;
    if (!complete_) ++counted_;
  }
  return true;
}

ProgramJudge::ProgramJudge(reference::Profile profile, std::string_view program,
                           const JudgeTerms& terms)
    : profile_(std::move(profile)),
      terms_(terms),
      input_(program),
      reference_(profile_, input_.lines, terms_),
      budget_(profile_, program),
      position_(profile_.initial.at),
      anchor_(position_) {}

void ProgramJudge::decide(Verdict verdict) {
  if (!verdict_) verdict_ = std::move(verdict);
}

void ProgramJudge::decide_gap(std::string message) {
  Verdict verdict;
  verdict.kind = VerdictKind::oracle_gap;
  verdict.message = std::move(message);
  decide(std::move(verdict));
}

bool ProgramJudge::record(const Record& record) {
  if (verdict_) return false;
  ++records_;
  try {
    if (!budget_.allows(records_, reference_.items())) {
      Verdict verdict;
      verdict.kind = VerdictKind::fail_overrun;
      verdict.block = record.block;
      verdict.record = records_ - 1;
      verdict.got = record_text(record);
      verdict.message = fmt::format(
          "The subject sent {} records, more than ten times those of the reference and 1,000.",
          records_);
      decide(std::move(verdict));
    } else {
      take_record(record);
    }
  } catch (const exact::Undecided& undecided) {
    decide_gap(fmt::format("A comparison could not be decided: {}.", undecided.what()));
  }
  return !verdict_;
}

void ProgramJudge::take_record(const Record& record) {
  if (end_record_) {
    Verdict verdict;
    verdict.kind = VerdictKind::fail_overrun;
    verdict.record = records_ - 1;
    verdict.block = record.block;
    verdict.got = record_text(record);
    verdict.message = "A record follows the end of the trace.";
    decide(std::move(verdict));
    return;
  }
  switch (record.kind) {
    case RecordKind::m:
      if (terms_.compare_m) {
        got_m_.push_back({record, record.block != 0 && record.block == cut_block_});
      }
      settle_m_functions(false);
      break;
    case RecordKind::dwell:
      if (record.seconds.sign() == 0) break;
      flush_pending();
      if (!verdict_) take_dwell(record);
      break;
    case RecordKind::end:
      flush_pending();
      end_record_ = record;
      break;
    default:
      take_motion(record);
      break;
  }
}

void ProgramJudge::rename(const reference::Renaming& renaming) {
  shift(position_, renaming.shift);
  shift(anchor_, renaming.shift);
  reference_.advance();
}

void ProgramJudge::follow_renamings(std::uint64_t block) {
  end_open_path_before(block);
  while (!verdict_ && reference_.renaming_ahead()) {
    flush_pending();
    if (verdict_) return;
    const ReferenceStep& step = reference_.current();
    if (auto* renaming = std::get_if<reference::Renaming>(&step)) {
      if (block != 0 && block <= renaming->block) return;
      rename(*renaming);
      continue;
    }
    if (auto* record = std::get_if<Record>(&step);
        record != nullptr && record->kind == RecordKind::m) {
      take_m_functions();
      continue;
    }
    // A motion too small to see, which the subject has passed without one of its own.
    auto* want = std::get_if<Motion>(&step);
    const bool passed = want != nullptr && want->record.block < block;
    if (!passed || !reached(*want, position_)) return;
    match_.reset();
    reference_.advance();
  }
}

void ProgramJudge::take_motion(const Record& record) {
  follow_renamings(terms_.compare_blocks ? record.block : 0);
  if (verdict_) return;
  Motion motion = straightened(motion_from(position_, record, records_ - 1));
  if (!terms_.compare_blocks) {
    motion.record.block = 0;
  } else if (record.block == 0) {
    Verdict verdict;
    verdict.kind = VerdictKind::protocol;
    verdict.record = motion.number;
    verdict.got = record_text(record);
    verdict.message = "The subject declares the feature `blocks`, but this record has no `b`.";
    decide(std::move(verdict));
    return;
  }
  position_ = motion.to();
  moved_ = true;
  if (record.kind != RecordKind::rapid) cut_block_ = record.block;
  if (pending_ && join(*pending_, motion)) {
    anchor_ = position_;
    return;
  }
  // Dropped: within the tolerance of where the last kept motion ended, so that many small motions
  // cannot add up unseen. Arcs stay: they may mean a full turn.
  if (record.kind != RecordKind::arc && agree(motion.from, anchor_, terms_.tolerance) &&
      agree(motion.to(), anchor_, terms_.tolerance) && !goes_round(motion, terms_.tolerance)) {
    return;
  }
  anchor_ = position_;
  flush_pending();
  if (!verdict_) pending_ = std::move(motion);
}

void ProgramJudge::flush_pending() {
  if (!pending_) return;
  Motion motion = *std::move(pending_);
  pending_.reset();
  process(std::move(motion));
}

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
  const Record& record = std::get<Record>(step);
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
  if (!match_) {
    want_ = want;
    match_.emplace(*want_, terms_);
  }
  const MatchResult result = match_->match(motion);
  if (result.departure == Departure::none) {
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
  if (means_nothing(motion, want_->from, want_->stood.value_or(want_->from))) return true;
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
  return agree(at, want.to(), terms_.tolerance) && !goes_round(want, terms_.tolerance);
}

bool ProgramJudge::means_nothing(const Motion& motion, const Position& here,
                                 const Position& stood) const {
  const auto stays = [&](const Position& point) {
    return agree(point, here, terms_.tolerance) || agree(point, stood, terms_.tolerance);
  };
  if (!stays(motion.from) || !stays(motion.to())) return false;
  if (motion.record.kind == RecordKind::arc3 && !stays(via_of(motion))) return false;
  return may_mean_nil(motion, terms_.tolerance, reference_.dropped_arc());
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
  return means_nothing(motion, here, stood);
}

}  // namespace gonogo::oracle
