// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus_testing.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace gonogo::testing {

namespace fs = std::filesystem;

std::string corpus_folder() {
  return std::string(GONOGO_SOURCE_DIR) + "/corpus";
}

const std::map<std::string, oracle::Case>& checked_in_cases() {
  static const auto kCases = [] {
    std::map<std::string, oracle::Case> cases;
    oracle::Corpus(corpus_folder()).for_each([&](const oracle::Case& test) {
      cases.emplace(test.id, test);
    });
    return cases;
  }();
  return kCases;
}

oracle::Expectation checked_in_expectation(const std::string& id, std::size_t number) {
  for (const auto& entry : fs::recursive_directory_iterator(corpus_folder() + "/vectors")) {
    if (!entry.is_regular_file()) continue;
    if (bytes_of(entry.path()).find('"' + id + '"') == std::string::npos) continue;
    for (const oracle::Case& test : oracle::read_vector_file(entry.path())) {
      if (test.id == id) return test.expect.at(number);
    }
  }
  throw std::out_of_range("the corpus has no case " + id);
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

ScratchFolder::ScratchFolder() {
  std::string name = (fs::temp_directory_path() / "gonogo-corpus-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string ScratchFolder::write(const std::string& name, std::string_view text) const {
  const fs::path file = path_ / name;
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
  return file.string();
}

}  // namespace gonogo::testing
