// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/evidence/evidence.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "oracle/campaign/results_reader.hpp"
#include "oracle/evidence/badge.hpp"
#include "oracle/evidence/junit.hpp"
#include "oracle/evidence/markdown.hpp"
#include "oracle/evidence/output_file.hpp"
#include "oracle/evidence/programs.hpp"
#include "oracle/evidence/sarif.hpp"
#include "oracle/report/html.hpp"

namespace gonogo::oracle::evidence {
namespace {

namespace fs = std::filesystem;

void copy_results(const std::string& results, const fs::path& target) {
  if (fs::exists(target) && fs::equivalent(results, target)) return;
  const fs::path part = target.string() + ".part";
  fs::copy_file(results, part, fs::copy_options::overwrite_existing);
  fs::rename(part, target);
}

// All but the HTML report, which reads the file for itself.
void write_all(ResultsReader& reader, const fs::path& folder) {
  JunitWriter junit(folder / "junit.xml", reader.header());
  SarifWriter sarif(folder / "results.sarif", reader.header());
  MarkdownSummary markdown(reader.header());
  ProgramFolder programs(folder / "programs");
  report::Summary summary;
  Json line;
  while (reader.next(line)) {
    const CaseRow facts = case_row(line);
    summary.add(line);
    junit.add(facts);
    sarif.add(facts);
    markdown.add(facts);
    programs.add(facts);
  }
  const RunState state =
      run_state(summary, reader.header(), reader.footer() ? &*reader.footer() : nullptr);
  programs.finish();
  junit.finish(state.unfinished);
  sarif.finish(state.unfinished);
  write_file(folder / "badge.json", badge_json(state));
  write_file(folder / "summary.md", markdown.text(state));
}

}  // namespace

std::optional<std::string> write_evidence(const std::string& results, const std::string& folder) {
  try {
    ResultsReader reader(results);
    fs::create_directories(folder);
    write_all(reader, folder);
    copy_results(results, fs::path(folder) / "results.jsonl");
    if (auto error = report::write_html_report(results, folder)) return error->message;
    return std::nullopt;
  } catch (const ResultsError& error) {
    return error.what();
  } catch (const std::system_error& error) {  // and std::filesystem::filesystem_error
    return fmt::format("{}.", error.what());
  }
}

}  // namespace gonogo::oracle::evidence
