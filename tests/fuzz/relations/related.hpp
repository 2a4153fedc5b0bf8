// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the relations share.
#pragma once

#include "fuzz/reference_run.hpp"
#include "fuzz/relations/trace.hpp"

namespace gonogo::fuzz::testing {

inline GeneratedProgram program_of(std::string_view dialect, std::string text) {
  return {std::get<reference::Profile>(reference::default_profile(dialect)), std::move(text)};
}

inline Trace trace_of(const ReferenceRun& run) {
  return {run.records, run.end};
}

}  // namespace gonogo::fuzz::testing
