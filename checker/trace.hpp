// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a subject sent, from a file of its own or out of a line of the results.
#pragma once

#include <optional>
#include <string>

#include "checker/match.hpp"

namespace gonogo::checker {

// Throws Fault.
Tolerances tolerances_of(const Json& header, std::string_view dialect, const Json& profile);
// <id>.jsonl: a record a line, an alarm last. Nothing when there is no such file; throws Fault.
std::optional<Trace> read_trace_file(const std::string& path);
// Reads a case line that is not GO: its records, which end nobody knows how, and the alarm where
// the line says it. Throws Fault.
Trace trace_of_line(const Json& line);

}  // namespace gonogo::checker
