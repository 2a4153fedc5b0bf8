// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/named_files.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "campaign/results_writer.hpp"
#include "cli/program_file.hpp"
#include "corpus/io/embedded.hpp"

namespace gonogo::cli {

namespace fs = std::filesystem;

std::string results_in(const std::string& path) {
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

std::string corpus_folder(const std::string& given) {
  const bool carries = !oracle::embedded_corpus().empty();
  std::error_code ignored;
  if (!given.empty()) {
    if (fs::is_directory(given, ignored)) return given;
    if (given == oracle::kEmbeddedFolder && carries) return given;
    throw UsageError(fmt::format("There is no folder {}. Name the folder of a corpus.", given));
  }
  if (const char* variable = std::getenv("GONOGO_CORPUS")) return corpus_folder(variable);
  if (carries) return std::string(oracle::kEmbeddedFolder);
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  for (fs::path at = program.parent_path(); at.has_relative_path(); at = at.parent_path()) {
    for (const fs::path& folder : {at / "corpus", at / "share/gonogo/corpus"}) {
      if (fs::exists(folder / "manifest.json", ignored)) return folder.string();
    }
  }
  throw UsageError("The corpus was not found beside the program. Name its folder with --corpus.");
}

std::string corpus_here(const std::string& given) {
  if (!given.empty()) return corpus_folder(given);
  try {
    return corpus_folder("");
  } catch (const UsageError&) {
    return {};
  }
}

}  // namespace gonogo::cli
