// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command line that runs one case of a results file again.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace gonogo::oracle::report {

// The values that an option has on a command line, given as two words or with '='.
std::vector<std::string> option_values(const nlohmann::ordered_json& argv, std::string_view option);

// Whether a command line sets a flag, by its last word of it: `--strict`, also `--strict=true`.
bool is_flag_set(const nlohmann::ordered_json& argv, std::string_view option);

// How the program is called from here: "./gonogo" or the launcher's path in a checkout, else
// "gonogo".
std::string program_word();

// "gonogo certify --subject S --profile F ... --case ", to which a case id (a shell word) is added:
// the subject and the options of the run that a verdict depends on. `header` is that of the
// results file. A fresh program is a case of the corpus that the run left beside its report.
enum class CaseOf { corpus, fresh };
std::string command_for_case(const nlohmann::ordered_json& header, CaseOf of = CaseOf::corpus);

}  // namespace gonogo::oracle::report
