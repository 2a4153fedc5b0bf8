// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo compare: what has changed between two runs.
#include <string>

#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "cli/results_file.hpp"
#include "oracle/evidence/compare.hpp"

namespace gonogo::cli {
namespace {

using oracle::evidence::CompareFormat;

struct CompareOptions {
  std::string before;
  std::string after;
  std::string format = "text";
};

CompareFormat format_of(const std::string& word) {
  if (word == "json") return CompareFormat::json;
  return word == "markdown" ? CompareFormat::markdown : CompareFormat::text;
}

int compare(const CompareOptions& options) {
  namespace evidence = oracle::evidence;
  evidence::Comparison comparison;
  try {
    comparison = evidence::compare_results(results_in(options.before), results_in(options.after));
  } catch (const oracle::ResultsError& error) {
    throw UsageError(error.what());
  }
  Output output;
  output.text() = evidence::comparison_text(comparison, format_of(options.format));
  output.flush();
  return comparison.count(evidence::Change::regression) > 0 ? kNoGo : kGo;
}

}  // namespace

void add_compare(Command& program) {
  auto options = std::make_shared<CompareOptions>();
  Command command = program.add_command(
      "compare", "Show what has changed between two runs; exit 1 when a case that was GO is NO-GO");
  command.argument("old", options->before, "results.jsonl of the run before, or its folder");
  command.argument("new", options->after, "results.jsonl of the run now, or its folder");
  command.choice("--format", options->format, {"text", "json", "markdown"},
                 "text, json or markdown (text)");
  command.run([options] { return compare(*options); });
}

}  // namespace gonogo::cli
