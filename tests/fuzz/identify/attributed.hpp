// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cases of the corpus, and what planted faults depart by on them.
#pragma once

#include <stdexcept>
#include <string>

#include "fuzz/identify/attribution.hpp"
#include "pools.hpp"
#include "secret_subject.hpp"

namespace gonogo::identify::testing {

inline ProgramAsked case_of(const std::string& id) {
  oracle::CaseReader reader(checked_in_corpus(), oracle::Detail::to_run);
  while (const auto test = reader.next()) {
    if (test->id == id) return {test->id, test->program, test->profile};
  }
  throw std::runtime_error("There is no case " + id + ".");
}

inline Attribution attribute_fault(const char* expander, const char* fault, const std::string& id) {
  const auto subject = builtin(expander, fault);
  return attribute(*subject, checked_in_corpus(), case_of(id), {});
}

}  // namespace gonogo::identify::testing
