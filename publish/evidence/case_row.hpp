// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "oracle/records/case_head.hpp"
#include "oracle/records/finding_text.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::oracle::evidence {

using Json = nlohmann::ordered_json;

// A case line of a results file, for those who write it down elsewhere.
struct CaseRow : FindingFacts {
  std::string id;
  std::string dialect;
  std::string cycle;
  VerdictKind kind = VerdictKind::oracle_error;
  std::string against;  // of a fail.reading: the case that shows another alternative
  std::uint64_t microseconds = 0;
  bool expected = false;               // an oracle-gap that the corpus expects
  std::optional<std::string> program;  // bytes

  Decision decision() const { return oracle::decision(kind); }
  std::string_view verdict() const { return name(kind); }
  // An oracle-error, or an oracle-gap that the corpus does not expect.
  bool is_unexpected_gap() const { return decision() == Decision::undecided && !expected; }
};

// `line` has passed ResultsReader.
CaseRow case_row(const Json& line);
// What the head of a line says; of a pass or a skip there is no more to say.
CaseRow case_row(const CaseHead& line);

// What earlier blocks leave in force in the one that departs; empty: nothing, or the case is GO.
std::string in_force_of(const CaseRow& row);

// The command that shows the case again; `header` is that of its results.
std::string again_command(const Json& header, const CaseRow& facts);

}  // namespace gonogo::oracle::evidence
