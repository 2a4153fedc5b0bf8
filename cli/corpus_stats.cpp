// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/corpus_stats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "reference/dialect.hpp"
#include "reference/reading.hpp"

namespace gonogo::cli {

std::string_view basis_name(const oracle::Expectation& expectation) {
  return expectation.basis ? reference::name(*expectation.basis) : "not said";
}

void CoveringArrays::take(const oracle::Case& test) {
  const std::optional<cover::Making> making = cover::making_of(test);
  if (!making) return;
  Array& array = arrays_[making->stem()];
  if (array.rows.empty()) {
    array.making = *making;
    array.parameters = cover::parse_parameters(making->model->parameters);
  }
  array.rows.push_back(cover::row_of(array.parameters, test));
}

void CorpusStats::take(const oracle::Case& test) {
  Cycle& cycle = cycles_[test.dialect + " " + test.cycle];
  ++cycle.cases;
  ++cases_;
  dialects_.insert(test.dialect);
  std::set<std::string> alarms;
  for (const oracle::Expectation& expectation : test.expect) {
    ++bases_[fmt::format("{}, {}", basis_name(expectation),
                         expectation.alarms.empty() ? "no alarm" : "alarm")];
    for (const auto& alarm : expectation.alarms) alarms.emplace(name(alarm.alarm));
    for (const auto& record : expectation.records) {
      if (record.clause != reference::kNoClause) {
        clauses_.emplace(reference::clause_name(record.clause));
      }
      if (record.kind == reference::RecordKind::arc) {
        ++planes_[fmt::format("G{}", reference::plane_code(record.plane))];
      }
    }
  }
  if (!alarms.empty()) ++cycle.alarms, ++alarming_;
  for (const std::string& alarm : alarms) ++alarms_[alarm];
  if (!test.tags_sign.empty()) ++signs_;
  listed_.insert(test.clauses.begin(), test.clauses.end());
  for (const reference::Reading& reading : reference::readings()) {
    const std::string_view value = test.profile.readings.get(reading.key);
    if (reading.belongs_to(test.dialect) && value != reading.fallback) {
      ++readings_[fmt::format("{}={}", reading.name, value)];
    }
  }
  arrays_.take(test);
}

// For the dialects that the cases have; a clause may belong to two of them.
std::size_t CorpusStats::count_clauses() const {
  std::set<std::string_view> ids;
  for (const std::string& dialect : dialects_) {
    for (const reference::Clause& clause : reference::find_dialect(dialect)->clauses) {
      ids.insert(clause.id);
    }
  }
  return ids.size();
}

std::string CorpusStats::list(const char* what, const Count& count) {
  std::string text = fmt::format("{}\n", what);
  for (const auto& [name, times] : count) text += fmt::format("  {:<40} {:>6}\n", name, times);
  return text;
}

std::string CorpusStats::text() const {
  std::string text = fmt::format(
      "{} cases, {} with an alarm ({:.1f} in a hundred), {} at a limit\n", cases_, alarming_,
      100.0 * static_cast<double>(alarming_) /
          static_cast<double>(std::max<std::size_t>(cases_, 1)),
      signs_);
  for (const auto& [name, cycle] : cycles_) {
    text +=
        fmt::format("{:<24} {:>6} cases, {:>5} with an alarm\n", name, cycle.cases, cycle.alarms);
  }
  text += fmt::format("clauses: {} of {} stand in groups, {} in records\n", listed_.size(),
                      count_clauses(), clauses_.size());
  text += list("basis, expectations", bases_) + list("alarm, cases that may raise it", alarms_) +
          list("plane of arcs, records", planes_) +
          list("reading other than the default, cases", readings_) + "covering arrays\n";
  arrays_.for_each([&](const std::string& stem, const cover::TupleCount& count) {
    text += fmt::format("  {:<28} {:>6} tuples, {:>6} covered, {:>5} excluded\n", stem,
                        count.allowed, count.covered, count.excluded);
  });
  return text;
}

}  // namespace gonogo::cli
