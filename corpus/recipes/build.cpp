// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/recipes/build.hpp"

#include <filesystem>
#include <fstream>

#include "corpus/io/recheck.hpp"
#include "corpus/recipes/corpus_text.hpp"

namespace gonogo::recipes {
namespace {

namespace fs = std::filesystem;

// The number of cases; the manifest has none.
std::size_t replace(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  const fs::path fresh = file.string() + ".new";
  std::ofstream out(fresh, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw oracle::CorpusError(fresh.string() + " cannot be written.");
  const bool has_cases = file.filename() != "manifest.json";
  const std::size_t cases = has_cases ? oracle::recheck_file(fresh.string()) : 0;
  fs::rename(fresh, file);
  return cases;
}

}  // namespace

BuiltCorpus build_corpus(const std::string& recipes, const std::string& folder) {
  const CorpusText corpus = corpus_from_recipes(recipes);
  BuiltCorpus built{corpus.version, 0, corpus.files.size() - 1};
  for (const auto& [name, text] : corpus.files)
    built.cases += replace(fs::path(folder) / name, text);
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(folder) / "vectors")) {
    const std::string name = fs::relative(entry.path(), folder).generic_string();
    if (entry.is_regular_file() && !corpus.files.contains(name)) fs::remove(entry.path());
  }
  return built;
}

}  // namespace gonogo::recipes
