// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo_corpus_build RECIPES CORPUS: writes the vector files and the manifest of a corpus from its
// recipes. A file takes the place of its predecessor only after its cases, read again from what was
// written, agree with the reference.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "corpus/recipes/corpus_text.hpp"
#include "oracle/corpus/corpus.hpp"

namespace fs = std::filesystem;
using namespace gonogo;

namespace {

// Returns the number of cases; the manifest has none.
std::size_t write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  const fs::path fresh = file.string() + ".new";
  std::ofstream out(fresh, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw oracle::CorpusError(fresh.string() + " cannot be written.");
  const bool vectors = file.filename() != "manifest.json";
  const std::size_t cases = vectors ? recipes::recheck(fresh.string()) : 0;
  fs::rename(fresh, file);
  return cases;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: {} RECIPES CORPUS\n", argv[0]);
    return 2;
  }
  try {
    const recipes::CorpusText corpus = recipes::corpus_from_recipes(argv[1]);
    std::size_t cases = 0;
    for (const auto& [name, text] : corpus.files) cases += write(fs::path(argv[2]) / name, text);
    // What no recipe gives any more must not stay behind.
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(fs::path(argv[2]) / "vectors")) {
      if (!entry.is_regular_file()) continue;
      const std::string name = fs::relative(entry.path(), argv[2]).generic_string();
      if (!corpus.files.contains(name)) fs::remove(entry.path());
    }
    fmt::print("{} cases in {} files, version {}\n", cases, corpus.files.size() - 1,
               corpus.version);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
