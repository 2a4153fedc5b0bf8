// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracle/judge/generated_outcomes.hpp"

#include <fmt/format.h>

#include "expanders/registry.hpp"
#include "oracle/records/trace_reader.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::oracle {

using reference::Axis;
using reference::kAllAxes;

std::string line_of(const Record& record) {
  std::string line;
  append_json(record, line);
  return line;
}

std::string text_of(const SessionVerdict& said) {
  const Verdict& verdict = said.verdict;
  return fmt::format(
      "{} ({}) {} {} {} '{}' want {} got {} by {} {} at {}: {}; {} explain; {}", name(verdict.kind),
      verdict.property_motions, reference::clause_name(verdict.clause), verdict.block,
      verdict.record.value_or(0), verdict.word.text(), verdict.want, verdict.got,
      verdict.deviation_exact, verdict.deviation_mm, verdict.witness, verdict.message,
      said.explaining.size(), verdict.coordinates ? verdict.coordinates->text() : "");
}

SessionVerdict judged(const reference::Profile& profile, const std::string& program,
                      const Outcome& outcome, const Tolerances& tolerances) {
  return judge_outcome(profile, program, tolerances, outcome.records, outcome.end);
}

SessionVerdict judged_by_lines(const reference::Profile& profile, const std::string& program,
                               const Outcome& outcome, const Tolerances& tolerances,
                               std::size_t& known) {
  JudgeSession session(profile, program, tolerances);
  TraceReader reader;
  bool goes_on = true;
  for (const Record& record : outcome.records) {
    const std::string line = line_of(record);
    if (session.line(line)) {
      ++known;
      continue;
    }
    const TraceLine read = reader.read(line);
    if (goes_on) goes_on = session.record(std::get<Record>(read));
  }
  return session.finish(outcome.end);
}

namespace {

// Fewer than kMostParts: behind that many the judge looks through the whole program, which of a
// pocket of a million levels takes a quarter of a minute.
// OpenReadings.AreSettledBehindAnyNumberOfRecords tries it.
constexpr std::size_t kMostRecords = 4'000;

Outcome run(const gonogo_subject_v1& table, const reference::Profile& profile,
            const std::string& program) {
  const auto subject = make_interface_subject(table);
  Outcome outcome;
  subject->configure(profile);
  outcome.end = subject->run("generated", program, [&](const Record& record) {
    outcome.records.push_back(record);
    return outcome.records.size() < kMostRecords;
  });
  return outcome;
}

// One record other than it was, or one more or less.
void spoil(Outcome& outcome, generate::Choices& choices) {
  if (outcome.records.empty()) return;
  const std::size_t at = choices.below(static_cast<std::uint32_t>(outcome.records.size()));
  const auto place = outcome.records.begin() + static_cast<std::ptrdiff_t>(at);
  const Number step =
      Number::millionths(choices.pick<std::int64_t>({1, -1, 900, 1'100, -1'000'000}));
  switch (choices.below(8)) {
    case 0:
      outcome.records.erase(place);
      return;
    case 1:
      outcome.records.insert(place, Record(*place));
      return;
    case 2:
      place->feed += step;
      return;
    case 3:
      place->kind = place->kind == RecordKind::rapid ? RecordKind::feed : RecordKind::rapid;
      return;
    case 4:
      ++place->block;
      return;
    case 5:
      place->clause = reference::kNoClause;
      return;
    default: {
      const Axis axis = choices.pick(kAllAxes);
      place->axes.add(axis);
      place->to[axis] += step;
    }
  }
}

const gonogo_subject_v1& any_expander(const generate::Generator& generator,
                                      generate::Choices& choices) {
  const auto faults = expanders::faults(generator.expander);
  std::string_view fault;
  if (choices.one_in(2)) fault = choices.pick(faults).name;
  return *expanders::find(generator.expander, fault);
}

void run_and_note_terms(const gonogo_subject_v1& table, GeneratedOutcome& made) {
  const reference::Profile& profile = made.program.profile;
  made.outcome = run(table, profile, made.program.text);
  made.tolerances = make_tolerances(make_interface_subject(table)->info(), profile);
}

}  // namespace

GeneratedOutcome right_outcome(const generate::Generator& generator,
                               const generate::GeneratorSettings& settings,
                               generate::Choices& choices) {
  GeneratedOutcome made{generator.generate(choices, settings, nullptr), {}, {}};
  run_and_note_terms(*expanders::find(generator.expander, ""), made);
  return made;
}

GeneratedOutcome generated_outcome(const generate::Generator& generator,
                                   const std::vector<reference::ReadingKey>& opened,
                                   generate::Choices& choices) {
  generate::GeneratorSettings settings;
  settings.kinds = {.valid = 0, .near_invalid = 2, .boundary = 0, .raw = 0, .tiny = 1};
  GeneratedOutcome made{generator.generate(choices, settings, nullptr), {}, {}};
  reference::Profile& profile = made.program.profile;
  for (const reference::ReadingKey key : opened) profile.readings.set(key, "any");
  run_and_note_terms(any_expander(generator, choices), made);
  if (choices.one_in(2)) spoil(made.outcome, choices);
  return made;
}

}  // namespace gonogo::oracle
