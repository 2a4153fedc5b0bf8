// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the reference says of a program, as an expectation of the corpus.
#include <algorithm>

#include "grammar/line_source.hpp"
#include "corpus/io/corpus.hpp"
#include "corpus/io/open_parts.hpp"
#include "oracle/steps/different_assignments.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle {

using reference::AlarmReport;
using reference::Basis;
using reference::ClauseId;
using reference::NotCovered;
using reference::Record;

namespace {

Basis basis_of(ClauseId clause) {
  return clause == reference::kNoClause ? Basis::text : reference::clause(clause).basis();
}

}  // namespace

Expectation expectation_of(const reference::Profile& profile, std::string_view program) {
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::shown);
  Expectation expectation;
  Basis weakest = Basis::text;
  const auto stand_on = [&](ClauseId clause) { weakest = std::max(weakest, basis_of(clause)); };
  expander.on_acceptance([&](std::uint64_t, ClauseId clause) { stand_on(clause); });
  while (const reference::Item* item = expander.next()) {
    if (auto* record = std::get_if<Record>(item)) {
      expectation.records.push_back(*record);
      stand_on(record->clause);
    } else if (auto* report = std::get_if<AlarmReport>(item)) {
      for (const reference::AdmittedClass& one : reference::admitted_classes(*report)) {
        const bool is_other = one.alarm != one.of->alarm;
        (is_other ? expectation.other_classes : expectation.alarms)
            .push_back({one.alarm, report->block, one.of->word});
      }
      weakest = basis_of(best_supported(*report).clause);
    } else if (std::holds_alternative<NotCovered>(*item)) {
      expectation.not_covered = true;
    }
  }
  expectation.basis = weakest;
  expectation.open = open_parts(profile, program, expectation.records);
  expectation.has_others = has_other_outcomes(profile, program, expander.readings());
  return expectation;
}

}  // namespace gonogo::oracle
