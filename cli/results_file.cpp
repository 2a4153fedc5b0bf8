// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/results_file.hpp"

#include <filesystem>

#include "campaign/results_writer.hpp"

namespace gonogo::cli {

std::string results_in(const std::string& path) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(path)) return path;
  const std::string results = (fs::path(path) / "results.jsonl").string();
  const std::string journal = oracle::ResultsWriter::journal_of(results);
  return !fs::exists(results) && fs::exists(journal) ? journal : results;
}

}  // namespace gonogo::cli
