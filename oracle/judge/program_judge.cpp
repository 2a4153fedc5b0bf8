// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/program_judge.hpp"

#include <fmt/format.h>

#include "oracle/judge/advice.hpp"
#include "oracle/judge/evidence.hpp"
#include "oracle/judge/standing.hpp"

namespace gonogo::oracle {

ProgramJudge::ProgramJudge(const reference::Profile& profile, const ProgramText& program,
                           const JudgeTerms& terms)
    : profile_(profile),
      terms_(terms),
      program_(program),
      input_(program),
      reference_(profile_, input_.lines, terms_),
      budget_(profile_, program),
      position_(profile_.initial.at),
      anchor_(position_) {}

void ProgramJudge::decide(Verdict verdict) {
  if (!verdict_) verdict_ = advised(std::move(verdict), terms_);
}

void ProgramJudge::decide_gap(std::string message) {
  Verdict verdict;
  verdict.kind = VerdictKind::oracle_gap;
  verdict.message = std::move(message);
  decide(std::move(verdict));
}

void ProgramJudge::decide_not_covered(const reference::NotCovered& outside) {
  Verdict verdict;
  verdict.kind = VerdictKind::oracle_gap;
  verdict.block = outside.block;
  verdict.message = outside.message;
  decide(std::move(verdict));
}

// J-CONST-01.
void ProgramJudge::decide_undecided(const exact::Undecided& undecided) {
  decide_gap(fmt::format("A comparison could not be decided: {}.", undecided.what()));
}

bool ProgramJudge::record(const Record& record) {
  if (verdict_) return false;
  ++records_;
  try {
    if (!budget_.allows(records_, reference_.items_and_passes())) {
      decide_too_many(record);
    } else if (!equal_record(record)) {
      take_record(record);
    }
  } catch (const exact::Undecided& undecided) {
    decide_undecided(undecided);
  }
  return !verdict_;
}

void ProgramJudge::decide_too_many(const Record& record) {
  Verdict verdict;
  verdict.kind = VerdictKind::fail_overrun;
  verdict.block = record.block;
  verdict.record = records_ - 1;
  verdict.got = record_text(record);
  verdict.message = fmt::format(
      "The subject sent {} records: of those that make no progress more than ten times the records "
      "of the reference and 1,000.",
      records_);
  decide(std::move(verdict));
}

// J-CYC-02: a straight piece that comes nearer to the end of the reference's motion; of an arc or
// an open path a place where the tool has not been.
bool ProgramJudge::makes_progress(const Motion& motion) {
  const ReferenceStep& step = reference_.behind_m_functions();
  const RecordKind kind = motion.record.kind;
  const bool is_straight =
      kind == RecordKind::feed || kind == RecordKind::rapid || kind == RecordKind::thread;
  if (const auto* want = std::get_if<Motion>(&step)) {
    if (!is_round(want->record.kind)) {
      return is_straight && comes_nearer(motion, want->to(), terms_.tolerance);
    }
  } else if (const auto* level = std::get_if<reference::PocketLevel>(&step)) {
    if (!ends_in_pocket(motion, *level)) return false;
  } else if (!std::holds_alternative<reference::ThreadMilling>(step) &&
             !std::holds_alternative<reference::HelixPocket>(step) &&
             !std::holds_alternative<reference::PocketMilling>(step)) {
    return false;
  }
  return visited_.is_new(reference_.items(), motion.to(), terms_.tolerance);
}

// J-CMP-01, J-CMP-07.
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
      take_m_function(record);
      break;
    case RecordKind::dwell:
      if (record.seconds.sign() == 0) break;
      flush_pending();
      if (!verdict_) note_block(record);
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
  Motion motion = motion_from(position_, record, records_ - 1);
  if (record.kind == RecordKind::arc3) motion = straightened(std::move(motion));
  // J-CMP-10.
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
  const bool stays = stays_at(anchor_, motion, terms_);
  if (!stays) note_block(record);
  if (verdict_) return;
  const std::size_t live = reference_.items_and_passes();
  if (budget_.runs_low(records_, live) && makes_progress(motion)) budget_.forgive();
  position_ = motion.to();
  moved_ = true;
  if (!stays && record.kind != RecordKind::rapid) cut_block_ = record.block;
  if (pending_ && !ends_here(*pending_, motion) && join(*pending_, motion)) {
    anchor_ = position_;
    return;
  }
  // J-CMP-03. Dropped: within the tolerance of where the last kept motion ended, so that many small
  // motions cannot add up unseen. Arcs stay: they may mean a full turn.
  const bool is_nil = record.kind != RecordKind::arc && stays;
  if (is_nil && !mills_pocket(motion)) {
    if (!verdict_ && is_due(motion)) anchor_ = position_;
    return;
  }
  if (verdict_) return;
  anchor_ = position_;
  flush_pending();
  if (!verdict_) pending_ = std::move(motion);
}

// J-CMP-04: whether the two are not to be joined, for the motion is where the reference's ends:
// what follows belongs to the next one, though it goes on in the same way.
bool ProgramJudge::ends_here(const Motion& motion, const Motion& next) {
  const RecordKind kind = motion.record.kind;
  if (is_round(kind) || kind != next.record.kind || motion.record.block != next.record.block) {
    return false;
  }
  const ReferenceStep& step = reference_.behind_m_functions();
  auto* want = std::get_if<Motion>(&step);
  return want != nullptr && want->record.kind == kind &&
         same_place(motion.to(), want->to(), terms_);
}

void ProgramJudge::flush_pending() {
  if (!pending_) return;
  Motion motion = *std::move(pending_);
  pending_.reset();
  process(std::move(motion));
}

}  // namespace gonogo::oracle
