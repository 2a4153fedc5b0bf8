// SPDX-License-Identifier: GPL-3.0-or-later
//
// The end of a run that has been judged: what is printed, and what is written.
#pragma once

#include <string>

#include "corpus/io/corpus.hpp"
#include "publish/evidence/certificate.hpp"

namespace gonogo::cli {

struct FinishedRun {
  std::string summary;  // for people
  int exit_code;
  oracle::evidence::CertificateSources files;  // results, and what the run had
  std::string report;                          // folder
  std::string certificate;                     // folder; empty: none
  const oracle::Corpus* corpus = nullptr;      // for the programs of the passes; null: without
  std::string results_sha256;                  // of the results as they were put in place
};

// Tells the summary and writes report and certificate, of the results that were judged and no
// others. Throws what keeps one of them from being
// written, but does the others before: neither does a report that cannot be written keep the
// summary from being printed, nor a closed pipe the report from being written, nor either a NO-GO from
// the caller: then it is said only.
void tell_run(const FinishedRun& run);

}  // namespace gonogo::cli
