// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/evidence/evidence.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "oracle/campaign/results_reader.hpp"
#include "oracle/evidence/badge.hpp"
#include "oracle/evidence/causes.hpp"
#include "oracle/evidence/junit.hpp"
#include "oracle/evidence/markdown.hpp"
#include "oracle/evidence/programs.hpp"
#include "oracle/evidence/sarif.hpp"
#include "oracle/records/output_file.hpp"
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

// Passes and skips are said in full by the head of their line.
bool is_told_by_head(const CaseRow& row) {
  return row.kind == VerdictKind::skip ||
         (row.decision() == Decision::go && row.kind != VerdictKind::xfail);
}

// What the lines of a run are written to, in one pass over them.
class Writers {
 public:
  Writers(ResultsReader& reader, const fs::path& folder, const Causes& causes)
      : reader_(reader),
        folder_(folder),
        junit_(folder / "junit.xml", reader.header()),
        sarif_(folder / "results.sarif", reader.header()),
        markdown_(reader.header()),
        programs_(folder / "programs"),
        page_(folder, reader.header()) {
    for (const auto& [key, cause] : causes) summary_.set_cause(key, cause);
  }

  // All lines that the reader still has.
  void write_lines() {
    CaseHead head;
    while (reader_.next(head)) {
      finding_ = summary_.add(head);
      page_.add(head, finding_);
      const CaseRow row = case_row(head);
      if (is_told_by_head(row)) {
        junit_.add(row, nullptr);
      } else {
        write_whole(reader_.json());
      }
    }
  }
  // All but the page.
  void finish() {
    const Json* footer = reader_.footer() ? &*reader_.footer() : nullptr;
    const RunState state = run_state(summary_, reader_.header(), footer);
    programs_.finish();
    junit_.finish(state);
    sarif_.finish(state.unfinished);
    write_file(folder_ / "badge.json", badge_json(state));
    write_file(folder_ / "summary.md", markdown_.text(state));
  }
  std::optional<report::ReportError> finish_page() {
    const Json* footer = reader_.footer() ? &*reader_.footer() : nullptr;
    return page_.finish(summary_.finish(reader_.header(), footer, 0));
  }

 private:
  void write_whole(const Json& line) {
    const CaseRow row = case_row(line);
    junit_.add(row, finding_);
    sarif_.add(row, finding_);
    markdown_.add(row, finding_, summary_.findings().is_smallest());
    programs_.add(row);
    if (!is_told_by_head(row)) page_.add_detail(line);
  }

  ResultsReader& reader_;
  fs::path folder_;
  JunitWriter junit_;
  SarifWriter sarif_;
  MarkdownSummary markdown_;
  ProgramFolder programs_;
  report::HtmlPage page_;
  report::Summary summary_;
  const Finding* finding_ = nullptr;  // of the line read last
};

}  // namespace

std::optional<std::string> write_evidence(const std::string& results, const std::string& folder) {
  try {
    ResultsReader reader(results);
    fs::create_directories(folder);
    const Causes causes = read_causes(fs::path(results).parent_path());
    Writers writers(reader, folder, causes);
    writers.write_lines();
    writers.finish();
    copy_results(results, fs::path(folder) / "results.jsonl");
    write_causes(folder, causes);
    if (auto error = writers.finish_page()) {
      throw std::system_error(std::make_error_code(std::errc::io_error), error->message);
    }
    return std::nullopt;
  } catch (const ResultsError& error) {
    return error.what();
  }
}

}  // namespace gonogo::oracle::evidence
