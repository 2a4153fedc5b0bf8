// SPDX-License-Identifier: GPL-3.0-or-later
//
// A corpus on disk from its recipes.
#pragma once

#include <string>

namespace gonogo::recipes {

struct BuiltCorpus {
  std::string version;
  std::size_t cases = 0;
  std::size_t files = 0;  // of vectors
};

// Writes the vector files and the manifest. A file takes the place of its predecessor only after
// its cases, read again from what was written, agree with the reference; a vector file that no
// recipe gives goes. Throws oracle::CorpusError: the recipe, the case and what is wrong.
BuiltCorpus build_corpus(const std::string& recipes, const std::string& folder);

}  // namespace gonogo::recipes
