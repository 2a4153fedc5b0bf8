// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo compare: what has changed between runs.
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "cli/results_file.hpp"
#include "publish/evidence/compare.hpp"
#include "publish/evidence/compare_runs.hpp"

namespace gonogo::cli {
namespace {

using oracle::evidence::CompareFormat;

struct CompareOptions {
  std::vector<std::string> results;
  std::string format = "text";
};

CompareFormat format_of(const std::string& word) {
  if (word == "json") return CompareFormat::json;
  return word == "markdown" ? CompareFormat::markdown : CompareFormat::text;
}

// Runs of other corpora or selections say nothing of each other.
void need_common_cases(const oracle::evidence::ComparedCases& cases, std::size_t changed) {
  if (cases.same + changed > 0 || cases.added + cases.gone == 0) return;
  throw UsageError(
      "The runs have no case in common: there is nothing to compare. Name results of the same "
      "corpus and dialects.");
}

// The text of the comparison, and whether there is a regression in it.
struct Compared {
  std::string text;
  bool regression = false;
};

Compared compared(const std::vector<std::string>& paths, CompareFormat format) {
  namespace evidence = oracle::evidence;
  if (paths.size() == 2) {
    const evidence::Comparison two = evidence::compare_results(paths[0], paths[1]);
    need_common_cases(two, two.changed.size());
    return {evidence::comparison_text(two, format), two.count(evidence::Change::regression) > 0};
  }
  const evidence::RunsComparison many = evidence::compare_runs(paths);
  need_common_cases(many, many.changed.size());
  return {evidence::runs_comparison_text(many, format),
          many.count(evidence::Change::regression) > 0};
}

int compare(const CompareOptions& options) {
  if (options.results.size() < 2) {
    throw UsageError("A comparison needs two results or more: gonogo compare OLD NEW.");
  }
  std::vector<std::string> paths;
  for (const std::string& path : options.results) paths.push_back(results_in(path));
  Compared comparison;
  try {
    comparison = compared(paths, format_of(options.format));
  } catch (const oracle::ResultsError& error) {
    throw UsageError(error.what());
  }
  Output output;
  output.text() = comparison.text;
  if (options.format == "text") {
    output.tell();
  } else {
    output.flush();
  }
  return comparison.regression ? kNoGo : kGo;
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
