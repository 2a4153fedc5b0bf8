// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo-check verdicts: every verdict of a results file, derived again from the vector and from
// what the subject sent.
#pragma once

#include <cstdio>
#include <string>

namespace gonogo::checker {

struct VerdictOptions {
  std::string results;
  std::string corpus;
  std::string traces;  // folder of <id>.jsonl; empty: only what the results keep
};

// The exit code: 0 all agree, 1 something differs, 3 incomplete or nothing derived. Throws Fault
// for what cannot be read.
int check_verdicts(const VerdictOptions& options, std::FILE* out);

}  // namespace gonogo::checker
