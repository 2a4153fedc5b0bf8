// SPDX-License-Identifier: GPL-3.0-or-later
//
// Errata: vectors that were wrong, for those who certified with a corpus that had them.
#pragma once

#include <string>
#include <vector>

namespace gonogo::oracle {

struct Erratum {
  std::string id;       // of the case, or a pattern of ids
  std::string version;  // of the first corpus that had it wrong
  std::string what;     // was wrong: a sentence
  std::string since;    // the corpus that has it right, or no longer
};

// <folder>/errata.toml: [[erratum]] with these four keys. No file: none. Throws CorpusError.
std::vector<Erratum> read_errata(const std::string& folder);

// Whether the id is one of the pattern, in which `*` stands for any text: "ngc.*".
bool is_covered(const std::string& pattern, const std::string& id);

// "2026.10.0" is after "2026.9.1". REQUIRES: both are versions.
bool is_before(const std::string& version, const std::string& other);
bool is_version(const std::string& text);

}  // namespace gonogo::oracle
