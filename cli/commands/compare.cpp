// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo compare: what has changed between runs.
#include <string>
#include <vector>

#include "campaign/results_reader.hpp"
#include "cli/commands.hpp"
#include "cli/named_files.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "publish/evidence/compare.hpp"

namespace gonogo::cli {
namespace {

namespace evidence = oracle::evidence;

struct CompareOptions {
  std::vector<std::string> results;
  std::string format = "text";
};

evidence::CompareFormat format_of(const std::string& word) {
  if (word == "json") return evidence::CompareFormat::json;
  return word == "markdown" ? evidence::CompareFormat::markdown : evidence::CompareFormat::text;
}

// Runs of other corpora or selections say nothing of each other.
void need_common_cases(const evidence::Comparison& runs) {
  if (runs.same + runs.changed.size() > 0 || runs.added.count + runs.gone.count == 0) return;
  throw UsageError(
      "The runs have no case in common: there is nothing to compare. Name results of the same "
      "corpus and dialects.");
}

int compare(const CompareOptions& options) {
  if (options.results.size() < 2) {
    throw UsageError("A comparison needs two results or more: gonogo compare OLD NEW.");
  }
  std::vector<std::string> paths;
  for (const std::string& path : options.results) paths.push_back(results_in(path));
  evidence::Comparison comparison;
  try {
    comparison = evidence::compare_runs(paths);
  } catch (const oracle::ResultsError& error) {
    throw UsageError(error.what());
  }
  need_common_cases(comparison);
  Output output;
  output.text() = evidence::comparison_text(comparison, format_of(options.format));
  if (options.format == "text") {
    output.tell();
  } else {
    output.flush();
  }
  return comparison.count(evidence::Change::regression) > 0 ? kNoGo : kGo;
}

}  // namespace

void add_compare(Command& program) {
  auto options = std::make_shared<CompareOptions>();
  Command command = program.add_command(
      "compare", "Show what has changed between runs; exit 1 when a case that was GO is NO-GO now");
  command.arguments("results", options->results,
                    "results.jsonl of the runs before and, last, of the run now, or their folders");
  command.choice("--format", options->format, {"text", "json", "markdown"},
                 "text, json or markdown (text)");
  command.run([options] { return compare(*options); });
}

}  // namespace gonogo::cli
