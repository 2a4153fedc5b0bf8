// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checked-in corpus and, of each dialect, the programs that distinguish its readings: made once.
#pragma once

#include <map>
#include <string>

#include "fuzz/identify/probe.hpp"

namespace gonogo::identify::testing {

inline const oracle::Corpus& checked_in_corpus() {
  static const oracle::Corpus corpus(std::string(GONOGO_SOURCE_DIR) + "/corpus");
  return corpus;
}

inline const ProbePool& pool_of(const std::string& dialect) {
  static std::map<std::string, ProbePool> pools;
  auto found = pools.find(dialect);
  if (found == pools.end()) {
    found = pools.emplace(dialect, make_pool(checked_in_corpus(), dialect, {})).first;
  }
  return found->second;
}

}  // namespace gonogo::identify::testing
