// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/results_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "campaign/results_writer.hpp"
#include "cli/program_file.hpp"

namespace gonogo::cli {

std::string results_in(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code fault;
  const fs::file_status status = fs::status(path, fault);
  if (!fs::exists(status)) {
    throw UsageError(
        fmt::format("{} cannot be opened: {}. Name results.jsonl of a run, or the folder of its "
                    "--report.",
                    path, fault.message()));
  }
  if (!fs::is_directory(status)) return path;
  const std::string results = (fs::path(path) / "results.jsonl").string();
  if (fs::exists(results)) return results;
  const std::string journal = oracle::ResultsWriter::journal_of(results);
  if (fs::exists(journal)) return journal;
  throw UsageError(
      fmt::format("The folder {} has no results.jsonl. Name the folder of the --report of a run, "
                  "or its results.",
                  path));
}

}  // namespace gonogo::cli
