// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/recipes/corpus_text.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "corpus/recipes/cover_recipe.hpp"
#include "corpus/recipes/recipe.hpp"
#include "corpus/io/folder_writer.hpp"
#include "corpus/io/toml_file.hpp"

namespace gonogo::recipes {

namespace {

namespace fs = std::filesystem;
using oracle::Case;
using oracle::CorpusError;

// Version and retired ids.
void read_settings(const std::string& path, CorpusText& corpus) {
  const toml::table table = oracle::read_toml_file(path);
  corpus.version = table["version"].value_or<std::string>("");
  if (const toml::array* retired = table["retired"].as_array()) {
    for (const toml::node& id : *retired) corpus.retired.push_back(id.value_or<std::string>(""));
  }
  if (corpus.version.empty()) throw CorpusError(path + ": the version is missing.");
}

std::set<fs::path> recipe_files(const std::string& folder) {
  std::set<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path below = fs::relative(entry.path(), folder);
    if (below.extension() == ".toml" && below.has_parent_path()) files.insert(below);
  }
  return files;
}

std::vector<Case> cases_of(const std::string& path) {
  if (is_cover_recipe(path)) return cover_recipe_cases(path);
  std::vector<Case> cases;
  for (const RecipeCase& entry : read_recipe(path)) cases.push_back(prepare(entry));
  return cases;
}

}  // namespace

CorpusText corpus_from_recipes(const std::string& folder) {
  CorpusText corpus;
  read_settings(folder + "/corpus.toml", corpus);
  std::set<std::string> ids(corpus.retired.begin(), corpus.retired.end());
  oracle::CorpusFolder folder_of{
      corpus.version, {corpus.retired.begin(), corpus.retired.end()}, {}};
  for (const fs::path& recipe : recipe_files(folder)) {
    const std::string path = (fs::path(folder) / recipe).string();
    const std::vector<Case> cases = cases_of(path);
    for (const Case& test : cases) {
      if (!ids.insert(test.id).second) {
        throw CorpusError(fmt::format("{}: the id {} was used before.", path, test.id));
      }
    }
    const std::string name = "vectors/" + fs::path(recipe).replace_extension(".json").string();
    corpus.files[name] = oracle::vector_file_text(corpus.version, cases);
    folder_of.files[name];
  }
  corpus.files["manifest.json"] = oracle::manifest_text(folder_of);
  return corpus;
}

}  // namespace gonogo::recipes
