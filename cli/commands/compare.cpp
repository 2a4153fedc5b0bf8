// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo compare: what has changed between two runs.
#include <map>

#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "oracle/evidence/compare.hpp"

namespace gonogo::cli {
namespace {

using oracle::evidence::CompareFormat;

struct CompareOptions {
  std::string before;
  std::string after;
  CompareFormat format = CompareFormat::text;
};

int compare(const CompareOptions& options) {
  namespace evidence = oracle::evidence;
  evidence::Comparison comparison;
  try {
    comparison = evidence::compare_results(options.before, options.after);
  } catch (const oracle::ResultsError& error) {
    throw UsageError(error.what());
  }
  Output output;
  output.text() = evidence::comparison_text(comparison, options.format);
  output.flush();
  return comparison.count(evidence::Change::regression) > 0 ? kNoGo : kGo;
}

}  // namespace

void add_compare(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CompareOptions>();
  const std::map<std::string, CompareFormat> formats = {{"text", CompareFormat::text},
                                                        {"json", CompareFormat::json},
                                                        {"markdown", CompareFormat::markdown}};
  CLI::App* command = app.add_subcommand(
      "compare", "Show what has changed between two runs; exit 1 when a case that was GO is NO-GO");
  command->add_option("old", options->before, "results.jsonl of the run before")->required();
  command->add_option("new", options->after, "results.jsonl of the run now")->required();
  command->add_option("--format", options->format, "text, json or markdown (text)")
      ->transform(CLI::CheckedTransformer(formats));
  command->callback([options, &exit_code] { exit_code = compare(*options); });
}

}  // namespace gonogo::cli
