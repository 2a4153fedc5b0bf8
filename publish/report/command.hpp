// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command line that runs one case of a results file again.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gonogo::oracle::report {

using Json = nlohmann::ordered_json;

// The values that an option has on a command line, given as two words or with '='.
std::vector<std::string> option_values(const Json& argv, std::string_view option);

// The options that come to a list of the header's selection, with its key.
inline constexpr std::array<std::pair<std::string_view, const char*>, 5> kSelectionOptions = {
    {{"--dialect", "dialects"},
     {"--only", "only"},
     {"--case", "cases"},
     {"--cycle", "cycles"},
     {"--clause", "clauses"}}};
// Those that come to a number of the header.
inline constexpr std::array<std::string_view, 5> kNumberOptions = {
    "--tolerance", "--chord", "--feed-resolution", "--blend", "--feed-tolerance"};
// "feed_resolution" of --feed-resolution.
std::string header_key(std::string_view option);

// Whether a command line sets a flag; its last mention counts: `--strict`, also `--strict=true`.
bool is_flag_set(const Json& argv, std::string_view option);

// Where a run leaves its report unless --report names a folder; one of a few cases does not replace
// that of a campaign.
inline constexpr const char* kReportFolder = "report";
inline constexpr const char* kFewCasesFolder = "again";

// The command line of the run; of a merged one that of its first shard.
Json run_argv(const Json& header);
// "builtin-gsk" of builtin:gsk, for a folder; what cannot be kept of a command is left out.
std::string subject_folder(const std::string& subject);
// The folder of the report of the run, as its command line has it, for the subject of the header.
std::string report_folder(const Json& header);

// How the program is called from here: "./gonogo" or the launcher's path in a checkout, else
// "gonogo".
std::string program_word();

// "gonogo certify --subject S --profile F ... --case ", to which a case id (a shell word) is added:
// the subject and the options of the run that a verdict depends on. `header` is that of the
// results file. A fresh program is a case of the corpus that the run left beside its report.
enum class CaseOf { corpus, fresh };
std::string command_for_case(const Json& header, CaseOf of = CaseOf::corpus);
// The command that runs all cases again, one after the other in the order of the run: what a
// subject keeps from one program shows in a later one (state-leak).
std::string command_for_run(const Json& header);

}  // namespace gonogo::oracle::report
