// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the hunt share.
#pragma once

#include <string>

#include "expanders/registry.hpp"
#include "hunt/hunt.hpp"
#include "oracle/subject.hpp"

namespace gonogo::hunt::testing {

inline constexpr const char* kTaper = "G00 X100 Z5\nG94 X50 Z-10 R-2 F100\n";

inline reference::Profile defaults(const std::string& dialect) {
  return std::get<reference::Profile>(reference::default_profile(dialect));
}

inline generate::GeneratedProgram gsk(std::string text) {
  return {defaults("gsk988ta"), std::move(text)};
}

// Makes the built-in expander, with a planted fault if one is named.
inline SubjectMaker builtin(const char* name, const char* fault = "") {
  const gonogo_subject_v1* subject = expanders::find(name, fault);
  return [subject] { return oracle::make_interface_subject(*subject); };
}

inline HuntOptions hunting(const std::string& dialect, std::uint64_t seed = 1) {
  HuntOptions options;
  options.dialect = dialect;
  options.seed = seed;
  return options;
}

}  // namespace gonogo::hunt::testing
