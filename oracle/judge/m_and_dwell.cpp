// SPDX-License-Identifier: GPL-3.0-or-later
//
// ProgramJudge's part for what is no motion: dwells, and the M functions passed on.
#include <algorithm>

#include "oracle/judge/evidence.hpp"
#include "oracle/judge/program_judge.hpp"

namespace gonogo::oracle {

using reference::PocketLevel;

namespace {

// Of what the reference or the subject has there; null: nothing, of at most one of them.
Verdict m_verdict(const Record* want, const Record* got, std::string message) {
  Verdict verdict;
  verdict.kind = VerdictKind::fail_order;
  verdict.block = want != nullptr ? want->block : got->block;
  if (want != nullptr) verdict.clause = want->clause;
  if (want != nullptr) verdict.want = record_text(*want);
  if (got != nullptr) verdict.got = record_text(*got);
  verdict.word = 'M';
  verdict.message = std::move(message);
  return verdict;
}

// Whether a text that begins behind an M is this number, or something to be calculated.
bool may_be_number(std::string_view text, std::int32_t number) {
  constexpr std::string_view kCalculated = "[#=R(";
  constexpr std::int64_t kMost = 1'000'000;
  std::int64_t value = -1;
  for (const char c : text) {
    if (c == ' ' || c == '\t' || (c == '+' && value < 0)) continue;
    if (value < 0 && kCalculated.find(c) != std::string_view::npos) return true;
    if (c < '0' || c > '9' || value > kMost) break;
    value = std::max<std::int64_t>(value, 0) * 10 + (c - '0');
  }
  return value == number;
}

// Whether the line of an alarm names the M function. By its text: the alarm keeps the reference
// from saying what the block means.
bool names_m_function(std::string_view line, std::int32_t number) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool is_m = line[i] == 'M' || line[i] == 'm';
    if (is_m && may_be_number(line.substr(i + 1), number)) return true;
  }
  return false;
}

}  // namespace

// J-CMP-06.
void ProgramJudge::take_dwell(const Record& record) {
  while (!verdict_) {
    const ReferenceStep& step = reference_.current();
    if (auto* level = std::get_if<PocketLevel>(&step)) {
      finish_level(*level, position_);
      continue;
    }
    if (end_open_path(position_)) continue;
    if (auto* renaming = std::get_if<reference::Renaming>(&step)) {
      rename(*renaming);
      continue;
    }
    const Record* want = std::get_if<Record>(&step);
    if (const Record* due = placed_m_function(step))
      return m_function_is_due(*due, &record, records_ - 1);
    if (want != nullptr && want->kind == RecordKind::m) {
      take_m_functions();
      continue;
    }
    // A motion too small to see, which the subject has passed without one of its own.
    auto* motion = std::get_if<Motion>(&step);
    if (motion != nullptr && reached(*motion, position_)) {
      match_.reset();
      reference_.advance();
      continue;
    }
    if (auto* outside = std::get_if<reference::NotCovered>(&step)) {
      decide_not_covered(*outside);
      return;
    }
    if (after_alarm_ || std::holds_alternative<reference::AlarmReport>(step)) {
      if (!after_alarm_) after_alarm_ = motion_from(position_, record, records_ - 1);
      return;
    }
    const bool expected = want != nullptr && want->kind == RecordKind::dwell;
    const bool block = expected && (!terms_.compare_blocks || want->block == record.block);
    const Number difference = expected ? abs(want->seconds - record.seconds) : Number(0);
    const bool same = difference.sign() == 0 ||
                      (terms_.binary64 && difference <= want->seconds * Number::binary(1, -51)) ||
                      (terms_.resolution && difference * 2 <= *terms_.resolution);
    if (block && same) {
      reference_.advance();
      return;
    }
    Verdict verdict;
    verdict.kind = expected ? VerdictKind::fail_geometry : VerdictKind::fail_order;
    verdict.record = records_ - 1;
    verdict.block = record.block;
    verdict.got = record_text(record);
    verdict.want = step_text(step);
    verdict.clause = clause_of(step);
    verdict.message = expected ? "The dwell differs." : "The subject dwells where no dwell is due.";
    if (motion != nullptr && piece_before() != nullptr) verdict = dwell_behind(std::move(verdict));
    decide(std::move(verdict));
  }
}

// J-PATH-13: a dwell is due behind the motion that the subject has left unfinished.
Verdict ProgramJudge::dwell_behind(Verdict verdict) {
  reference_.advance();
  const auto* due = std::get_if<Record>(&reference_.behind_m_functions());
  if (due == nullptr || due->kind != RecordKind::dwell) return verdict;
  return short_of(*want_, *piece_before());
}

void ProgramJudge::take_m_functions() {
  want_m_.push_back(std::get<Record>(reference_.current()));
  reference_.advance();
  settle_m_functions(false);
}

// An M function of the subject's.
void ProgramJudge::take_m_function(const Record& record) {
  if (!terms_.compare_m) return;
  if (terms_.compare_blocks && record.block < motion_block_) {
    flush_pending();
    if (!verdict_) m_out_of_place(record);
    return;
  }
  m_block_ = record.block;
  if (take_placed_m_function(record)) return;
  got_m_.push_back({record, record.block != 0 && record.block == cut_block_});
  settle_m_functions(false);
}

// J-CMP-05: where a cycle has one among its motions. False where none is due now: then the M
// function is one of those that stand anywhere, or comes too early for one that does not.
bool ProgramJudge::take_placed_m_function(const Record& record) {
  if (!reference_.placed_m_function_ahead()) return false;
  flush_pending();
  while (!verdict_) {
    const ReferenceStep& step = reference_.current();
    // A motion too small to see, which the subject has passed without one of its own.
    auto* motion = std::get_if<Motion>(&step);
    if (motion != nullptr && reached(*motion, position_)) {
      match_.reset();
      reference_.advance();
      continue;
    }
    if (!is_m_function(step)) return false;
    const Record* want = placed_m_function(step);
    if (want == nullptr) {
      take_m_functions();
      continue;
    }
    if (!want_m_.empty() || !got_m_.empty()) return false;  // those come first
    const bool same_block = !terms_.compare_blocks || want->block == record.block;
    if (want->m == record.m && same_block) {
      reference_.advance();
      return true;
    }
    m_function_is_due(*want, &record, records_ - 1);
  }
  return true;
}

// J-CMP-05: the subject goes on by something else, or ends. `number`: its record.
void ProgramJudge::m_function_is_due(const Record& want, const Record* got, std::size_t number) {
  Verdict verdict = m_verdict(
      &want, got, "An M function of the cycle is due here, between its motions and dwells.");
  verdict.record = number;
  decide(std::move(verdict));
}

// A motion or a dwell of the subject's that is to be seen.
void ProgramJudge::note_block(const Record& record) {
  motion_block_ = record.block;
  if (!terms_.compare_blocks || record.block >= m_block_) return;
  flush_pending();
  if (!verdict_) m_out_of_place(record);
}

// An M function stands before or after the motions of its block, not among those of another.
void ProgramJudge::m_out_of_place(const Record& record) {
  Verdict verdict =
      m_verdict(nullptr, &record, "An M function is passed on among the motions of another block.");
  verdict.record = records_ - 1;
  decide(std::move(verdict));
}

// J-CMP-05: M functions are compared in their order, wherever among the motions of their block they
// stand, but for those that have to come before the tool cuts.
void ProgramJudge::settle_m_functions(bool at_end) {
  if (!terms_.compare_m) return;
  auto differs = [&](const Record* want, const Record* got) {
    decide(m_verdict(want, got, "The M functions passed on differ."));
  };
  while (!want_m_.empty() && !got_m_.empty() && !verdict_) {
    const Record& want = want_m_.front();
    const Record& got = got_m_.front().record;
    const bool same = want.m == got.m && (!terms_.compare_blocks || want.block == got.block);
    const bool late = terms_.compare_blocks && want.before_cut && got_m_.front().after_cut;
    if (!same || late) {
      differs(&want, &got);
      return;
    }
    want_m_.pop_front();
    got_m_.pop_front();
  }
  if (!at_end || verdict_) return;
  if (!want_m_.empty()) {
    differs(&want_m_.front(), nullptr);
  } else if (!got_m_.empty()) {
    differs(nullptr, &got_m_.front().record);
  }
}

// Those of earlier blocks must have come as motion must; of its own block no text says whether any
// do that alarms. Without lines a subject's last ones may be that block's. A control that checks at
// load need not pass any, and passes no others either.
void ProgramJudge::settle_m_functions_before(std::size_t alarm_block, bool at_load) {
  const std::string_view line = reference_.failed_line();
  got_m_.erase_if([&](const GotM& got) {
    return (!terms_.compare_blocks || got.record.block == alarm_block) &&
           names_m_function(line, got.record.m);
  });
  settle_m_functions(false);
  if (at_load) want_m_.clear();
  settle_m_functions(true);
}

// Before what no text states: those of that block and behind it are not judged (J-ALM-04). Without
// line numbers nobody can tell them from the others.
void ProgramJudge::settle_m_functions_of_earlier(std::uint64_t block) {
  if (!terms_.compare_blocks) return;
  got_m_.erase_if([&](const GotM& got) { return got.record.block >= block; });
  want_m_.erase_if([&](const Record& want) { return want.block >= block; });
  settle_m_functions(true);
}

}  // namespace gonogo::oracle
