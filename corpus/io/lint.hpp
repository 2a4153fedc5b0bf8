// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a corpus promises about itself, checked.
#pragma once

#include <functional>
#include <string>

#include "corpus/io/corpus.hpp"

namespace gonogo::oracle {

struct LintOptions {
  // A part of a corpus: that its cases together hit every clause and reading is not asked.
  bool part = false;
};

// Says a sentence for each broken promise, and returns the number of cases. For a case: the id has
// its form, the reference confirms every expectation, a case at a limit breaks one rule at most and
// has its two neighbours. For the whole: every clause stands in a group, every alternative of a
// reading in a profile (or it is the default), 30 to 40 in a hundred cases end in an alarm. In the
// errata: their ids are of a case or retired, their versions not after the corpus. Throws
// CorpusError for what cannot be read, an id met twice and one that is retired.
std::size_t lint(const Corpus& corpus, const LintOptions& options,
                 const std::function<void(const std::string&)>& say);

}  // namespace gonogo::oracle
