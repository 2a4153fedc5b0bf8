// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/m_functions.hpp"

#include <algorithm>

#include "oracle/judge/step_text.hpp"

namespace gonogo::oracle {

using reference::Record;

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

// Whether a text that begins behind an M is this number, or something to be calculated. With
// decimals it may count as the whole number above, too (ngc.whole).
bool may_be_number(std::string_view text, std::int32_t number) {
  constexpr std::string_view kCalculated = "[#=R(";
  constexpr std::int64_t kMost = 1'000'000;
  std::int64_t value = -1;
  for (const char c : text) {
    if (c == ' ' || c == '\t' || (c == '+' && value < 0)) continue;
    if (value < 0 && kCalculated.find(c) != std::string_view::npos) return true;
    if (c == '.' && std::max<std::int64_t>(value, 0) + 1 == number) return true;
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

// An M function stands before or after the motions of its block, not among those of another.
Verdict out_of_place(const Record& record, std::size_t number) {
  Verdict verdict =
      m_verdict(nullptr, &record, "An M function is passed on among the motions of another block.");
  verdict.record = number;
  return verdict;
}

Verdict differing(const Record* want, const Record* got) {
  return m_verdict(want, got, "The M functions passed on differ.");
}

}  // namespace

Verdict m_function_missing(const Record& want, std::string got, std::size_t number) {
  Verdict verdict = m_verdict(
      &want, nullptr, "An M function of the cycle is due here, between its motions and dwells.");
  verdict.got = std::move(got);
  verdict.record = number;
  return verdict;
}

std::optional<Verdict> MFunctions::want(const Record& record) {
  want_.push_back(record);
  return settle();
}

std::optional<Verdict> MFunctions::take_place(const Record& record, std::size_t number) {
  if (tells_order() && record.block < motion_block_) return out_of_place(record, number);
  m_block_ = record.block;
  return std::nullopt;
}

std::optional<Verdict> MFunctions::take(const Record& record, std::size_t number) {
  if (std::optional<Verdict> verdict = take_place(record, number)) return verdict;
  got_.push_back({record, record.block != 0 && record.block == cut_block_});
  return settle();
}

std::optional<Verdict> MFunctions::take_event(const Record& record, std::size_t number) {
  motion_block_ = record.block;
  if (!tells_order() || record.block >= m_block_) return std::nullopt;
  return out_of_place(record, number);
}

// They are compared in their order, wherever among the motions of their block they stand, but for
// those that have to come before the tool cuts.
std::optional<Verdict> MFunctions::settle() {
  while (!want_.empty() && !got_.empty()) {
    const Record& want = want_.front();
    const Record& got = got_.front().record;
    const bool same = want.m == got.m && (!terms_.compare_blocks || want.block == got.block);
    const bool late = terms_.compare_blocks && want.before_cut && got_.front().after_cut;
    if (!same || late) return differing(&want, &got);
    want_.pop_front();
    got_.pop_front();
  }
  return std::nullopt;
}

std::optional<Verdict> MFunctions::end() {
  if (!terms_.compare_m) return std::nullopt;
  if (std::optional<Verdict> verdict = settle()) return verdict;
  if (!want_.empty()) return differing(&want_.front(), nullptr);
  if (!got_.empty()) return differing(nullptr, &got_.front().record);
  return std::nullopt;
}

std::optional<Verdict> MFunctions::end_before_alarm(std::uint64_t block, std::string_view line,
                                                    bool at_load) {
  got_.erase_if([&](const Got& got) {
    return (!terms_.compare_blocks || got.record.block == block) &&
           names_m_function(line, got.record.m);
  });
  if (std::optional<Verdict> verdict = settle()) return verdict;
  if (at_load) want_.clear();
  return end();
}

std::optional<Verdict> MFunctions::end_of_earlier(std::uint64_t block) {
  if (!terms_.compare_blocks) return std::nullopt;
  got_.erase_if([&](const Got& got) { return got.record.block >= block; });
  want_.erase_if([&](const Record& want) { return want.block >= block; });
  return end();
}

}  // namespace gonogo::oracle
