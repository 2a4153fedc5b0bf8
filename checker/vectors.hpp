// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo-check vectors: the form and the coherence of a corpus.
#pragma once

#include <cstdio>
#include <string>

namespace gonogo::checker {

// The exit code: 0 all holds, 1 something does not, 3 there is nothing. Throws Fault for what
// cannot be read.
int check_vectors(const std::string& folder, std::FILE* out);

}  // namespace gonogo::checker
