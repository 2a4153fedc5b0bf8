// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checked-in corpus, and folders to write broken ones into.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "corpus/io/corpus.hpp"

namespace gonogo::testing {

// Raised with every change of the corpus (corpus/recipes/corpus.toml).
inline constexpr const char* kCorpusVersion = "2026.31.0";

// The corpus of the checkout.
std::string corpus_folder();

// Every case of the checked-in corpus, by id; read once.
const std::map<std::string, oracle::Case>& checked_in_cases();

// Expectation `number` of the case `id`. Reads only the file that has the case; throws
// std::out_of_range where the corpus has no such expectation.
oracle::Expectation checked_in_expectation(const std::string& id, std::size_t number = 0);

std::string bytes_of(const std::filesystem::path& file);

// A folder of its own below the system's temporary folder, removed at the end.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  // Writes a file, with the folders that it needs; returns its path.
  std::string write(const std::string& name, std::string_view text) const;

 private:
  std::filesystem::path path_;
};

// The message of the CorpusError that `act` throws; "" when it throws none.
template <typename Act>
std::string corpus_error(Act act) {
  try {
    act();
  } catch (const oracle::CorpusError& error) {
    return error.what();
  }
  return {};
}

}  // namespace gonogo::testing
