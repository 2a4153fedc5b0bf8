// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo report: report folder and certificate of a results file.
#include <fmt/format.h>

#include <exception>
#include <optional>

#include "cli/commands.hpp"
#include "cli/named_files.hpp"
#include "cli/output.hpp"
#include "cli/pdf.hpp"
#include "cli/program_file.hpp"
#include "publish/evidence/certificate.hpp"
#include "publish/evidence/evidence.hpp"

namespace gonogo::cli {
namespace {

struct ReportOptions {
  std::string out;
  std::string certificate;
  std::string corpus;
  std::string pdf;
  oracle::evidence::CertificateSources sources;
};

// That has the programs of the passes. Without one, or with another one than that of the run, the
// page lacks them and is a report all the same.
std::optional<oracle::Corpus> corpus_of_run(const ReportOptions& options) {
  try {
    return std::optional<oracle::Corpus>(std::in_place, corpus_folder(options.corpus));
  } catch (const std::exception&) {
    if (!options.corpus.empty()) throw;
    return std::nullopt;
  }
}

int report(ReportOptions options) {
  std::string& results = options.sources.results;
  results = results_in(results);
  Output output;
  // The report, unless only the certificate was asked for.
  if (!options.out.empty() || !options.pdf.empty() || options.certificate.empty()) {
    const std::string out = options.out.empty() ? "report" : options.out;
    const std::optional<oracle::Corpus> corpus = corpus_of_run(options);
    if (auto error = oracle::evidence::write_evidence(results, out, corpus ? &*corpus : nullptr)) {
      throw UsageError(*error);
    }
    output.text() += fmt::format("{}/index.html\n", out);
    if (!options.pdf.empty()) {
      print_pdf(out + "/index.html", options.pdf);
      output.text() += options.pdf + "\n";
    }
  }
  if (!options.certificate.empty()) {
    if (auto error = oracle::evidence::write_certificate(options.sources, options.certificate)) {
      throw UsageError(*error);
    }
    output.text() += fmt::format("{}/STATEMENT.md\n", options.certificate);
  }
  output.tell();
  return kGo;
}

}  // namespace

void add_report(Command& program) {
  auto options = std::make_shared<ReportOptions>();
  oracle::evidence::CertificateSources& sources = options->sources;
  Command command =
      program.add_command("report", "Write the report folder or the certificate of a results file");
  command.needed("results", sources.results, "results.jsonl of a run, or its folder");
  command.option("--out", options->out,
                 "folder for HTML, JUnit, SARIF, badge, summary and programs (report)");
  command.option("--pdf", options->pdf,
                 "the report on paper as well, into this file, by an installed Chromium");
  command.option("--corpus", options->corpus,
                 "corpus of the run, for the programs of its passes (the checked-in one)");
  command.option("--certificate", options->certificate, "folder for a certificate");
  command.option("--known-failures", sources.known_failures,
                 "known-failures file of the run, for the certificate");
  command.option("--alarm-map", sources.alarm_map, "alarm map of the run, for the certificate");
  command.option("--profile", sources.profile, "profile of the run, for the certificate");
  command.option("--traces", sources.traces, "traces of the run, for the certificate");
  command.run([options] { return report(*options); });
}

}  // namespace gonogo::cli
