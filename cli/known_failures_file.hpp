// SPDX-License-Identifier: GPL-3.0-or-later
//
// certify --write-known-failures: the subject's file of known failures, brought up to what a run
// shows.
#pragma once

#include <string>

#include "cli/verdict_text.hpp"
#include "campaign/known_failures_update.hpp"
#include "corpus/io/corpus.hpp"

namespace gonogo::cli {

class KnownFailuresFile {
 public:
  // `known`: the file that the run goes by; empty: none. Throws UsageError where `path` is another
  // file that is there already.
  KnownFailuresFile(std::string path, const std::string& known);

  void add(const oracle::CaseFacts& facts, oracle::VerdictKind kind,
           const oracle::Finding* finding) {
    update_.add(facts, kind, finding);
  }
  // Writes the file, whole or not at all, and says what changed, some lines. Throws OutputError.
  std::string write(const oracle::Corpus& corpus, const CampaignSummary& summary) const;

 private:
  std::string path_;
  std::string head_;  // the comment at the head of the file before
  oracle::KnownFailuresUpdate update_;
};

}  // namespace gonogo::cli
