// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings as files: a folder that is a corpus itself, so that `gonogo certify --corpus` runs it
// again, with each finding's program, machine, trace and verdict beside its vector.
//   DIR/manifest.json, DIR/vectors/DIALECT/ID.json
//   DIR/findings/ID/program.nc, profile.json, trace.jsonl, verdict.txt, sheet.svg,
//   before-1.nc, before-1.json, ...
#pragma once

#include "fuzz/hunt/hunt.hpp"
#include "corpus/io/corpus.hpp"

namespace gonogo::hunt {

// Where a finding comes from, a sentence for the vector: subject, seed, program, versions.
struct Provenance {
  std::string gonogo;   // "gonogo 0.1.0"
  std::string subject;  // as it was named
  std::uint64_t seed = 0;
  std::string_view room = "hunt";  // where the ids of its cases begin, and their cycle
};

// The finding as a case "ROOM.DIALECT.HASH.000001" with what the reference expects.
oracle::Case case_of(const Finding& finding, const oracle::SubjectInfo& subject,
                     const Provenance& provenance);

// Writes it below `folder`, which need not be there, and returns the case's id. A finding of the
// same signature and another program gets the next number. Throws std::system_error or
// oracle::CorpusError.
std::string write_finding(const std::string& folder, const Finding& finding,
                          const JudgedRun& judged, const oracle::SubjectInfo& subject,
                          const Provenance& provenance);

// What write_finding wrote into DIR/findings/ID. Throws std::runtime_error where it cannot be read.
Reproducer read_reproducer(const std::string& folder, const std::string& dialect);

}  // namespace gonogo::hunt
