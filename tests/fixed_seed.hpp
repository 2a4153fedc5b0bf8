// SPDX-License-Identifier: GPL-3.0-or-later
//
// RapidCheck with a fixed seed, which it prints, and as often as GONOGO_TRIALS says; RC_PARAMS
// counts before both.
#pragma once

#include <cstdlib>
#include <string>

namespace gonogo {

// Before the first check of a program: RapidCheck looks only once.
inline bool fix_seed(const char* usual_trials) {
  const auto or_else = [](const char* name, const char* usual) {
    const char* const text = std::getenv(name);
    return std::string(text == nullptr ? usual : text);
  };
  const std::string parameters = "seed=" + or_else("GONOGO_SEED", "20261122") +
                                 " max_success=" + or_else("GONOGO_TRIALS", usual_trials) +
                                 " max_discard_ratio=100";
  return setenv("RC_PARAMS", parameters.c_str(), 0) == 0;
}

}  // namespace gonogo
