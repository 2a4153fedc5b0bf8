// SPDX-License-Identifier: GPL-3.0-or-later
//
// Recipes: the authored side of the corpus, one TOML file a topic. A recipe states what a case is
// about, its program, and which alarm must come of it; the rest of the expectation is the
// reference's.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "corpus/io/corpus.hpp"

namespace gonogo::recipes {

// A reading whose alternatives a case states one by one.
struct StatedReading {
  std::string name;
  std::vector<std::string> values;
};

struct RecipeCase {
  oracle::Case test;                    // without its expectations
  std::vector<StatedReading> readings;  // none: the profile's alone
  // "class@line" for each alarm that must be admissible under the profile, and no other may be.
  std::vector<std::string> alarms;
  bool outside = false;  // the program has a code that the gauge does not read
};

// Throws oracle::CorpusError: file and what is wrong.
std::vector<RecipeCase> read_recipe(const std::string& path);

// The case with its expectations. Throws oracle::CorpusError when what comes of the program is not
// what the recipe says, or when a stated reading makes no difference.
oracle::Case prepare(const RecipeCase& recipe);

}  // namespace gonogo::recipes
