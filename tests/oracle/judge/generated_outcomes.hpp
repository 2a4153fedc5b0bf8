// SPDX-License-Identifier: GPL-3.0-or-later
//
// What expanders do with generated programs: rightly, with a planted fault, or spoilt afterwards.
#pragma once

#include <string>
#include <vector>

#include "fuzz/generate/generator.hpp"
#include "oracle/judge/judge_session.hpp"
#include "oracle/records/subject_outcome.hpp"

namespace gonogo::oracle {

struct Outcome {
  std::vector<Record> records;  // cut off, as endless ones would be by a limit of time
  RunEnd end;
};

struct GeneratedOutcome {
  generate::GeneratedProgram program;
  Outcome outcome;
  Tolerances tolerances;
};

// What an expander does rightly with a program of the settings.
GeneratedOutcome right_outcome(const generate::Generator& generator,
                               const generate::GeneratorSettings& settings,
                               generate::Choices& choices);

// `opened`: readings that the profile leaves open.
GeneratedOutcome generated_outcome(const generate::Generator& generator,
                                   const std::vector<reference::ReadingKey>& opened,
                                   generate::Choices& choices);

std::string line_of(const Record& record);

// Everything that the judge says, as one text.
std::string text_of(const SessionVerdict& said);

// Judged record by record.
SessionVerdict judged(const reference::Profile& profile, const std::string& program,
                      const Outcome& outcome, const Tolerances& tolerances);

// Judged line by line; `known` counts those that were not read.
SessionVerdict judged_by_lines(const reference::Profile& profile, const std::string& program,
                               const Outcome& outcome, const Tolerances& tolerances,
                               std::size_t& known);

}  // namespace gonogo::oracle
