// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/known_failures_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <sstream>
#include <system_error>

#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "cli/subjects.hpp"
#include "oracle/records/output_file.hpp"
#include "oracle/records/text.hpp"

namespace gonogo::cli {
namespace {

// The lines of comment before anything else.
std::string head_of(const std::string& text) {
  std::istringstream lines(text);
  std::string head;
  for (std::string line; std::getline(lines, line) && line.starts_with('#');) head += line + "\n";
  return head;
}

// A folder may be there and take no file, as /proc does.
bool takes_a_file(const std::string& path) try {
  if (std::filesystem::is_directory(path)) return false;
  const oracle::OutputFile trial(path);
  return true;
} catch (const std::system_error&) {
  return false;
}

}  // namespace

KnownFailuresFile::KnownFailuresFile(std::string path, const std::string& known)
    : path_(std::move(path)),
      update_(known.empty() ? std::vector<oracle::KnownCause>() : load_known_causes(known)) {
  std::error_code ignored;
  const bool is_known = !known.empty() && std::filesystem::equivalent(path_, known, ignored);
  if (!is_known && std::filesystem::is_regular_file(path_)) {
    throw UsageError(
        fmt::format("{0} is there already. To bring it up to date, name it with --known-failures "
                    "{0} as well.",
                    path_));
  }
  if (!takes_a_file(path_)) {
    throw UsageError(fmt::format("{} cannot be written. Name a file in a folder that can.", path_));
  }
  if (!known.empty()) head_ = head_of(read_file(known, "a file of known failures"));
}

std::string KnownFailuresFile::write(const oracle::Corpus& corpus,
                                     const CampaignSummary& summary) const {
  std::map<std::string, std::size_t> wanted;  // findings by the case of their smallest program
  for (const auto& [number, smallest] : summary.smallest) wanted[smallest.id] = number;
  std::vector<std::string> ids;
  std::map<std::size_t, std::string> programs;
  corpus.for_each([&](const oracle::Case& test) {
    ids.push_back(test.id);
    const auto finding = wanted.find(test.id);
    if (finding != wanted.end()) programs[finding->second] = test.program;
  });
  const oracle::KnownFailuresUpdate::Result result = update_.result(ids, programs);
  try {
    oracle::write_file(
        path_, head_ + (head_.empty() ? "" : "\n") + oracle::known_causes_text(result.causes));
  } catch (const std::system_error& error) {
    throw OutputError(error.what(), false);
  }
  std::string text = fmt::format("known failures: {}, {} cases added, {} pruned\n",
                                 oracle::visible(path_), result.added, result.pruned);
  if (result.unsteady > 0) {
    text += fmt::format(
        "  {} cases answered differently from run to run and are not written: `flaky` is for "
        "them.\n",
        result.unsteady);
  }
  return text;
}

}  // namespace gonogo::cli
