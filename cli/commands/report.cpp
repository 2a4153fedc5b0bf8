// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo report: the HTML report of a results file.
#include <fmt/format.h>

#include <filesystem>

#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "oracle/report/html.hpp"

namespace gonogo::cli {
namespace {

struct ReportOptions {
  std::string results;
  std::string out = "report";
};

int report(const ReportOptions& options) {
  std::filesystem::create_directories(options.out);
  const auto error = oracle::report::write_html_report(options.results, options.out);
  if (error) throw UsageError(error->message);
  Output output;
  output.text() = fmt::format("{}/index.html\n", options.out);
  output.flush();
  return kGo;
}

}  // namespace

void add_report(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command = app.add_subcommand("report", "Write the HTML report of a results file");
  command->add_option("results", options->results, "results.jsonl of a run")->required();
  command->add_option("--out", options->out, "folder for the report");
  command->callback([options, &exit_code] { exit_code = report(*options); });
}

}  // namespace gonogo::cli
