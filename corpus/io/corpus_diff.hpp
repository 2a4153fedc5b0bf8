// SPDX-License-Identifier: GPL-3.0-or-later
//
// What differs between two corpora, case by case.
#pragma once

#include <string>
#include <vector>

#include "corpus/io/corpus.hpp"

namespace gonogo::oracle {

struct CorpusDiff {
  std::vector<std::string> added;
  std::vector<std::string> removed;
  std::vector<std::string> not_retired;   // of the removed: those that the new one does not retire
  std::vector<std::string> reused;        // another program or profile under the same id
  std::vector<std::string> changed;       // the same program, another expectation
  std::vector<std::string> changed_ends;  // of the changed: "ID: feed-missing@2, now none"
  bool same() const {
    return added.empty() && removed.empty() && reused.empty() && changed.empty();
  }
};

// Throws CorpusError.
CorpusDiff diff(const Corpus& old_corpus, const Corpus& new_corpus);

}  // namespace gonogo::oracle
