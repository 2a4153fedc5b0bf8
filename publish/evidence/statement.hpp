// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a certificate states, for people and for programs: a function of the results, the reasons of
// the known failures and the names of the files alone, so that it can be made again and compared.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "campaign/results_reader.hpp"
#include "publish/evidence/case_row.hpp"

namespace gonogo::oracle::evidence {

// The files of a certificate besides the statement.
inline constexpr const char* kResultsFile = "results.jsonl";
inline constexpr const char* kWaiversFile = "waivers.toml";
inline constexpr const char* kAlarmMapFile = "alarm-map.toml";
inline constexpr const char* kProfileFile = "profile.toml";
inline constexpr const char* kProfileJson = "profile.json";
inline constexpr const char* kStatementJson = "statement.json";
inline constexpr const char* kStatementText = "STATEMENT.md";
inline constexpr const char* kSums = "SHA256SUMS";
// A folder: what the subject sent for each case.
inline constexpr const char* kTraces = "traces";

// The dialect of a profile that names none: the only one for which the run was asked, else "".
std::string unnamed_dialect(const Json& header);

// The traces of a certificate: how many, and the SHA-256 of their lines in SHA256SUMS.
struct TraceFiles {
  std::size_t files = 0;
  std::string sha256;
};

struct Statement {
  std::string json;
  std::string markdown;
};

// `reasons`: of the known failures; `files`: those that lie beside it. Throws ResultsError for a
// file that is faulty or incomplete, and for a known failure without its reason.
Statement make_statement(const std::string& results, const std::vector<std::string>& reasons,
                         const std::vector<std::string>& files, const TraceFiles& traces);

}  // namespace gonogo::oracle::evidence
