// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report folder of a run: everything that people and other programs read of it.
#pragma once

#include <optional>
#include <string>

#include "corpus/io/corpus.hpp"

namespace gonogo::oracle::evidence {

// Reads a results file and writes into `folder`, which is made when it is missing:
//   results.jsonl     the file itself, unless it lies there already
//   causes.json       what the findings are likely to come from, when it is known
//   index.html        the report for people
//   junit.xml         a test suite a dialect, a test case a case
//   results.sarif     SARIF 2.1.0: what is not GO, at the lines of programs/<id>.nc
//   badge.json        the shields endpoint schema
//   summary.md        for the step summary of a CI run
//   programs/<id>.nc  the programs of the cases that are not GO
// Each file is put in place only when it is whole. Memory does not grow with the cases that are
// GO. A file without footer is written up as incomplete; one that is faulty is not written up.
// Returns why not, a sentence. Throws std::system_error where something cannot be written.
// With the corpus of the run the page also shows program and path of the cases that are GO. Null,
// or another corpus than the header names: it does not.
std::optional<std::string> write_evidence(const std::string& results, const std::string& folder,
                                          const Corpus* corpus = nullptr);

}  // namespace gonogo::oracle::evidence
