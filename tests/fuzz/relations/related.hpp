// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the relations share.
#pragma once

#include "oracle/differential/reference_run.hpp"
#include "fuzz/relations/trace.hpp"

namespace gonogo::relations::testing {

inline generate::GeneratedProgram program_of(std::string_view dialect, std::string text) {
  return {std::get<reference::Profile>(reference::default_profile(dialect)), std::move(text)};
}

inline Trace trace_of(const oracle::ReferenceRun& run) {
  return {run.records, run.end};
}

}  // namespace gonogo::relations::testing
