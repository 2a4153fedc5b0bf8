// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cases of the corpus, and what planted faults depart by on them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
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

struct Planted {
  const char* expander;
  const char* fault;
  const char* departs_on;  // a case of the corpus
  const char* cause;       // that is named; "": none
};

inline void PrintTo(const Planted& planted, std::ostream* out) {
  *out << planted.expander << '+' << planted.fault;
}

inline std::string name_of(const ::testing::TestParamInfo<Planted>& planted) {
  std::string name = std::string(planted.param.expander) + "_" + planted.param.fault;
  std::ranges::replace(name, '-', '_');
  return name;
}

inline Attribution attribute_fault(const Planted& planted) {
  const auto subject = builtin(planted.expander, planted.fault);
  return attribute(*subject, checked_in_corpus(), case_of(planted.departs_on), {});
}

}  // namespace gonogo::identify::testing
