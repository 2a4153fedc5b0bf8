// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_end.hpp"

#include <fmt/format.h>

#include <exception>

#include "cli/exit_code.hpp"
#include "cli/output.hpp"
#include "oracle/records/text.hpp"
#include "publish/evidence/certificate_files.hpp"
#include "publish/evidence/evidence.hpp"
#include "publish/evidence/statement.hpp"

namespace gonogo::cli {
namespace {

void need_own_results(const FinishedRun& run, const std::string& path) {
  if (oracle::evidence::file_sha256(path) == run.results_sha256) return;
  throw OutputError(
      fmt::format("{} is not what this run wrote: somebody else has written to it. Believe none of "
                  "what stands beside it.",
                  path),
      false);
}

// What was written where, line by line.
void write_report(const FinishedRun& run, std::string& written) {
  auto failed = oracle::evidence::write_evidence(run.files.results, run.report, run.corpus);
  if (failed) throw OutputError(*failed, false);
  need_own_results(run, run.files.results);
  written += fmt::format("report:  {}/index.html\n", oracle::visible(run.report));
  if (run.certificate.empty()) return;
  failed = oracle::evidence::write_certificate(run.files, run.certificate);
  if (failed) throw OutputError(*failed, false);
  need_own_results(run, run.certificate + "/" + oracle::evidence::kResultsFile);
  written += fmt::format("certificate: {}/STATEMENT.md\n", oracle::visible(run.certificate));
}

}  // namespace

void tell_run(const FinishedRun& run) try {
  Output output;
  output.text() = run.summary + fmt::format("results: {}\n", oracle::visible(run.files.results));
  std::exception_ptr unwritten;
  try {
    write_report(run, output.text());
  } catch (const std::exception&) {
    unwritten = std::current_exception();
  }
  output.tell();
  if (unwritten) std::rethrow_exception(unwritten);
} catch (const std::exception& error) {
  if (run.exit_code != kNoGo) throw;
  const auto* of_output = dynamic_cast<const OutputError*>(&error);
  if (of_output == nullptr || !of_output->quiet()) complain("gonogo: {}\n", error.what());
}

}  // namespace gonogo::cli
