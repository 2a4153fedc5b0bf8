// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/steps/m_functions.hpp"

#include <algorithm>
#include <initializer_list>
#include <limits>

#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {

using reference::Record;

namespace {

// Whether a text that begins behind an M is this number, or something to be calculated. With
// decimals it may count as the whole number above, too (ngc.whole).
bool may_be_number(std::string_view text, std::int32_t number) {
  constexpr std::string_view kCalculated = "[#=R(";
  constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
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

bool is_one_of(std::int32_t number, std::initializer_list<std::int32_t> numbers) {
  return std::ranges::find(numbers, number) != numbers.end();
}

// `due`: what the reference has there; null: nothing. `got` likewise.
Verdict m_verdict(VerdictKind kind, const Record* due, const Record* got, std::size_t number,
                  std::string message) {
  Verdict verdict;
  verdict.kind = kind;
  verdict.rule = RelationRule::event;
  verdict.block = due != nullptr ? due->block : got->block;
  if (due != nullptr) verdict.clause = due->clause;
  if (due != nullptr) verdict.want = record_text(*due);
  if (got != nullptr) verdict.got = record_text(*got);
  verdict.record = number;
  verdict.word = 'M';
  verdict.message = std::move(message);
  return verdict;
}

}  // namespace

bool ends_program(const Record& m_function) {
  return is_one_of(m_function.m, {2, 17, 30});
}

bool starts_something(const Record& m_function) {
  return m_function.before_cut || is_one_of(m_function.m, {3, 4, 6, 7, 8});
}

std::size_t times_named(std::string_view line, std::int32_t number) {
  std::size_t times = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool is_m = line[i] == 'M' || line[i] == 'm';
    if (is_m && may_be_number(line.substr(i + 1), number)) ++times;
  }
  return times;
}

Verdict m_function_missing(const Record& due, std::string got, std::size_t number) {
  Verdict verdict =
      m_verdict(VerdictKind::fail_geometry, &due, nullptr, number,
                got == "end" ? "The trace ends before this M function."
                             : "An M function is due here, and something else comes.");
  verdict.got = std::move(got);
  return verdict;
}

Verdict other_m_function(const Record& due, const Record& got, std::size_t number) {
  return m_verdict(VerdictKind::fail_geometry, &due, &got, number,
                   due.m == got.m ? "The M function belongs to another block."
                                  : "The M functions passed on differ.");
}

Verdict m_function_within(const Record& due, const Record& got, std::size_t number) {
  return m_verdict(VerdictKind::fail_order, &due, &got, number,
                   "An M function stands within a cycle or a cut that has none there.");
}

Verdict m_function_too_early(const Record& got, std::size_t number, std::string due) {
  Verdict verdict =
      m_verdict(VerdictKind::fail_order, nullptr, &got, number, std::string(kComesEarly));
  verdict.want = std::move(due);
  return verdict;
}

Verdict m_function_too_many(const Record& got, std::size_t number, std::string due) {
  Verdict verdict = m_verdict(VerdictKind::fail_geometry, nullptr, &got, number,
                              "An M function is passed on where none is due.");
  verdict.want = std::move(due);
  return verdict;
}

}  // namespace gonogo::oracle
