// SPDX-License-Identifier: GPL-3.0-or-later
//
// Recipes of covering arrays: the model, its strength and the seed in place of programs.
#pragma once

#include <string>
#include <vector>

#include "corpus/io/corpus.hpp"

namespace gonogo::recipes {

// Whether the file is a recipe of a covering array: it has the table `cover`.
bool is_cover_recipe(const std::string& path);

// The cases with their expectations. Throws oracle::CorpusError where model and reference disagree
// about a case that is not left out, where the cases do not hold every tuple, or where the version
// of the model is another one.
std::vector<oracle::Case> cover_recipe_cases(const std::string& path);

}  // namespace gonogo::recipes
