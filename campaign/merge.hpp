// SPDX-License-Identifier: GPL-3.0-or-later
//
// The results of the shards of a run put together: the same file as that of a run without shards.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "campaign/results_writer.hpp"
#include "corpus/io/corpus.hpp"

namespace gonogo::oracle {

// Files that do not belong together: a sentence (wrong use).
class MergeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct MergeOptions {
  std::vector<std::string> results;  // files, complete ones or journals, in any order
  std::string out;                   // file
  std::vector<std::string> argv;
  // That of the run, which says what cases its shards must have; null: it is not here.
  const Corpus* corpus = nullptr;
  bool partial = false;  // write what is there, without a footer
};

struct MergeOutcome {
  std::vector<std::string> notes;    // a shard that was there twice, ...
  std::vector<std::string> missing;  // shards that are not there or not complete, and why
  bool has_corpus = false;           // of the run: whether the shards have all cases is checked
  bool written = false;
  ResultsFooter footer;  // when nothing is missing
};

// Throws MergeError, ResultsError for a file that is none, ResultsUnwritable.
MergeOutcome merge_results(const MergeOptions& options);

}  // namespace gonogo::oracle
