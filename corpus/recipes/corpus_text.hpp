// SPDX-License-Identifier: GPL-3.0-or-later
//
// The whole corpus from its recipes, as the texts of its files.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace gonogo::recipes {

struct CorpusText {
  std::string version;
  std::vector<std::string> retired;
  std::map<std::string, std::string> files;  // name below the corpus -> bytes; manifest.json too
};

// Reads <folder>/corpus.toml and the recipes <folder>/<dialect>/*.toml; each gives the vector file
// vectors/<dialect>/<its name>.json. Throws oracle::CorpusError.
CorpusText corpus_from_recipes(const std::string& folder);

}  // namespace gonogo::recipes
