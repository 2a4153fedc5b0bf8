// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/program_vector.hpp"

#include <set>

#include "corpus/io/recheck.hpp"
#include "fuzz/program/features.hpp"
#include "oracle/judge/judge_session.hpp"
#include "oracle/steps/program_input.hpp"
#include "reference/dialect.hpp"
#include "reference/expander.hpp"

namespace gonogo::hunt {
namespace {

// Those of its records and of its alarm.
std::vector<std::string> clauses_of(const generate::GeneratedProgram& program) {
  std::set<std::string> names;
  oracle::ProgramInput input(program.text);
  reference::Expander expander(program.profile, input.lines, reference::OpenPaths::shown);
  while (const reference::Item* item = expander.next()) {
    if (const auto* record = std::get_if<reference::Record>(item)) {
      names.emplace(reference::clause_name(record->clause));
    } else if (const auto* report = std::get_if<reference::AlarmReport>(item)) {
      names.emplace(reference::clause_name(report->alarms.front().clause));
    }
  }
  names.erase("");
  if (names.empty()) {
    names.emplace(reference::find_dialect(program.profile.dialect)->clauses.front().id);
  }
  return {names.begin(), names.end()};
}

std::vector<oracle::Expectation> expectations_of(const generate::GeneratedProgram& program) {
  const oracle::Assignments assignments = oracle::assignments_of(program.profile, program.text);
  if (assignments.choices.size() > oracle::kMostStated) {
    return {oracle::expectation_of(program.profile, program.text)};
  }
  std::vector<oracle::Expectation> expectations;
  for (const reference::ReadingChoice& choice : assignments.choices) {
    reference::Profile profile = program.profile;
    profile.readings = choice;
    oracle::Expectation expectation = oracle::expectation_of(profile, program.text);
    for (const reference::ReadingKey key : assignments.open) {
      // One that this assignment never came to stays open in it.
      if (choice.is(key, "any")) continue;
      expectation.when.emplace_back(reference::reading(key).name, choice.get(key));
    }
    expectations.push_back(std::move(expectation));
  }
  return expectations;
}

}  // namespace

oracle::Case vector_of(const generate::GeneratedProgram& program, std::string_view cycle) {
  oracle::Case test;
  test.dialect = program.profile.dialect;
  test.cycle = cycle;
  test.program = program.text;
  test.profile = program.profile;
  const std::set<std::string> features = program::features_needed({test.profile, test.program});
  test.features.assign(features.begin(), features.end());
  test.clauses = clauses_of(program);
  test.expect = expectations_of(program);
  return test;
}

}  // namespace gonogo::hunt
