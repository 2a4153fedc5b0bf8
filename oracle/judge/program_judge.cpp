// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/program_judge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "oracle/judge/mismatch.hpp"
#include "oracle/judge/places.hpp"
#include "oracle/judge/step_text.hpp"

namespace gonogo::oracle {

ProgramJudge::ProgramJudge(const reference::Profile& profile, const ProgramText& program,
                           const JudgeTerms& terms)
    : profile_(profile),
      terms_(terms),
      program_(program),
      reference_(profile_, program_, terms_),
      alignment_(reference_, profile_.initial.at, terms_, memory_),
      m_functions_(terms_, reference_),
      budget_(profile_, program) {}

void ProgramJudge::decide(Verdict verdict) {
  if (!verdict_) verdict_ = std::move(verdict);
}

void ProgramJudge::decide(std::optional<Verdict> verdict) {
  if (verdict) decide(*std::move(verdict));
}

void ProgramJudge::decide_undecided(const exact::Undecided& undecided) {
  decide(undecided_verdict(undecided));
}

void ProgramJudge::decide_departure() {
  if (alignment_.gap()) return decide(*alignment_.gap());
  std::size_t departed_at = 0;
  Verdict verdict = explain(alignment_.refutation(), reference_, terms_, departed_at);
  departed_at_ = departed_at;
  decide(std::move(verdict));
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

// J-CMP-01, J-CMP-07.
void ProgramJudge::take_record(const Record& record) {
  if (end_record_) {
    Verdict verdict;
    verdict.kind = VerdictKind::fail_overrun;
    verdict.record = records_ - 1;
    verdict.block = record.block;
    verdict.got = record_text(record);
    verdict.message = "A record follows the end of the trace.";
    return decide(std::move(verdict));
  }
  switch (record.kind) {
    case RecordKind::m:
      if (terms_.compare_m) take_m_function(record);
      return;
    case RecordKind::dwell:
      if (record.seconds.sign() != 0) take_dwell(record);
      return;
    case RecordKind::end:
      end_record_ = record;
      return;
    default:
      return take_motion(record);
  }
}

// Those before step `step` have been passed, and nothing looks back.
void ProgramJudge::note_m_functions(std::size_t step) {
  for (; noted_ <= step && !verdict_; ++noted_) {
    for (const Record& record : reference_.at(noted_).m_functions) {
      if (!verdict_) decide(m_functions_.want(record));
    }
  }
}

void ProgramJudge::take_motion(const Record& record) {
  // J-CMP-10.
  if (terms_.compare_blocks && record.block == 0) {
    Verdict verdict;
    verdict.kind = VerdictKind::protocol;
    verdict.record = records_ - 1;
    verdict.got = record_text(record);
    verdict.message = "The subject declares the feature `blocks`, but this record has no `b`.";
    return decide(std::move(verdict));
  }
  note_m_functions(alignment_.first_step());
  const bool is_low = budget_.runs_low(records_, reference_.items_and_passes());
  if (!verdict_ && (terms_.compare_m || is_low)) {
    const Hypothesis& first = alignment_.hypotheses().front();
    const Motion motion = motion_from(first.at, record, records_ - 1);
    if (!stays_at(first.anchor, motion, terms_)) {
      decide(m_functions_.take_event(record, records_ - 1));
      if (record.kind != RecordKind::rapid) m_functions_.note_cut(record.block);
    }
    if (!verdict_ && is_low && makes_progress(motion)) budget_.forgive();
  }
  if (verdict_) return;
  moved_ = true;
  if (!alignment_.take_motion(record, records_ - 1)) return decide_departure();
  const Forgiven forgiven = alignment_.take_forgiven();
  budget_.forgive(forgiven.records);
  budget_.count_level_cuts(forgiven.level_cuts);
  forget_passed();
}

// Equal motions between two of them do not come this far: it is for each record that goes the whole
// way to forget, or a program of motions and dwells in turn would be kept whole.
void ProgramJudge::forget_passed() {
  if (verdict_) return;  // there may be no hypothesis left
  reference_.forget_before(std::min(noted_, alignment_.first_step()));
}

// J-CMP-05.
void ProgramJudge::take_m_function(const Record& record) {
  note_m_functions(alignment_.first_step());
  forget_passed();
  if (verdict_) return;
  if (!m_functions_.is_none_due()) return decide(m_functions_.take(record, records_ - 1));
  switch (alignment_.take_m_function(record, records_ - 1, noted_)) {
    case Alignment::MFunction::taken:
      return decide(m_functions_.take_place(record, records_ - 1));
    case Alignment::MFunction::free:
      note_m_functions(alignment_.first_step());
      if (verdict_) return;
      return decide(m_functions_.take(record, records_ - 1));
    case Alignment::MFunction::departs:
      return decide_departure();
  }
}

void ProgramJudge::take_dwell(const Record& record) {
  note_m_functions(alignment_.first_step());
  if (!verdict_) decide(m_functions_.take_event(record, records_ - 1));
  if (!verdict_ && !alignment_.take_dwell(record, records_ - 1)) decide_departure();
  forget_passed();
}

// J-CYC-02: a straight piece that comes nearer to the end of the reference's motion; of an arc or
// an open path a place where the tool has not been.
bool ProgramJudge::makes_progress(const Motion& motion) {
  const ReferenceSteps::Step& step = reference_.at(alignment_.hypotheses().front().step);
  const RecordKind kind = motion.record.kind;
  const bool is_straight =
      kind == RecordKind::feed || kind == RecordKind::rapid || kind == RecordKind::thread;
  if (const auto* want = std::get_if<Motion>(&step.what)) {
    if (!is_round(want->record.kind)) {
      return is_straight && comes_nearer(motion, want->to(), terms_.tolerance);
    }
  } else if (const auto* level = std::get_if<reference::PocketLevel>(&step.what)) {
    if (!ends_in_pocket(motion, *level)) return false;
  } else if (!is_open_step(step.what)) {
    return false;
  }
  return visited_.is_new(step.item, motion.to(), terms_.tolerance);
}

}  // namespace gonogo::oracle
