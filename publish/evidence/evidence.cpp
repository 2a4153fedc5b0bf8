// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/evidence.hpp"

#include <filesystem>
#include <map>
#include <system_error>

#include "campaign/encoding.hpp"
#include "campaign/results_reader.hpp"
#include "campaign/results_writer.hpp"
#include "campaign/selection.hpp"
#include "oracle/records/output_file.hpp"
#include "oracle/records/text.hpp"
#include "publish/evidence/causes.hpp"
#include "publish/evidence/junit.hpp"
#include "publish/evidence/markdown.hpp"
#include "publish/evidence/programs.hpp"
#include "publish/evidence/sarif.hpp"
#include "publish/report/command.hpp"
#include "publish/report/html.hpp"
#include "publish/report/json_value.hpp"

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

// The programs of a corpus, as far as there is room for them.
std::map<std::string, report::CorpusCase> programs_of(const Corpus* corpus, const Json& header) {
  constexpr std::size_t kMostBytes = std::size_t{48} << 20;
  std::map<std::string, report::CorpusCase> programs;
  const Json about = header.value("corpus", Json::object());
  if (corpus == nullptr || report::text_of(about, "sha256") != corpus->sha256()) return programs;
  std::size_t bytes = 0;
  CaseReader reader(*corpus, Detail::to_run, asked_in(header).dialects);
  while (bytes < kMostBytes) {
    const auto test = reader.next();
    if (!test) break;
    bytes += test->program.size() + test->comment.size();
    programs[test->id] = {test->dialect, test->comment, Json::object(),
                          program_json(test->program)};
  }
  return programs;
}

// The JSON that a badge service of the shields kind reads. Green is a whole corpus under the
// subject's own numbers alone (J-RUN-01).
std::string badge_json(const RunState& state) {
  const Json& headline = state.summary["headline"];
  std::string colour = "yellow";
  if (state.decision == "GO") {
    colour = headline["whole"] == true ? "brightgreen" : "yellowgreen";
  } else if (state.decision == "NO-GO") {
    colour = "red";
  }
  return dump({{"schemaVersion", 1},
               {"label", "gonogo"},
               {"message", visible(report::text_of(headline, "short"))},
               {"color", colour}}) +
         "\n";
}

// What the lines of a run are written to, in one pass over them.
class Writers {
 public:
  Writers(ResultsReader& reader, const fs::path& folder, const Causes& causes,
          std::map<std::string, report::CorpusCase> programs)
      : reader_(reader),
        folder_(folder),
        junit_(folder / "junit.xml", reader.header()),
        sarif_(folder / "results.sarif", reader.header()),
        markdown_(reader.header()),
        programs_(folder / "programs"),
        page_(folder, reader.header()),
        summary_(reader.header()),
        corpus_(std::move(programs)) {
    for (const auto& [key, cause] : causes.of) summary_.set_cause(key, cause);
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
        if (row.kind != VerdictKind::skip && has_room_for_passes_) add_pass(head.id);
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
    for (const std::string& entry : state.stale) sarif_.add_stale(entry);
    sarif_.finish(state.unfinished);
    write_file(folder_ / "badge.json", badge_json(state));
    write_file(folder_ / "summary.md", markdown_.text(state));
  }
  std::optional<std::string> finish_page() {
    const Json* footer = reader_.footer() ? &*reader_.footer() : nullptr;
    return page_.finish(summary_.finish(reader_.header(), footer, 0));
  }

 private:
  // A line names the profile that its case was judged under, which a run's profile or reading may
  // have made another than the corpus's.
  void add_pass(const std::string& id) {
    const auto found = corpus_.find(id);
    if (found == corpus_.end()) return;
    found->second.profile = reader_.json().value("profile", Json::object());
    has_room_for_passes_ = page_.add_pass(found->second);
  }
  void write_whole(const Json& line) {
    CaseRow row = case_row(line);
    if (const auto found = corpus_.find(row.id); found != corpus_.end()) {
      row.comment = found->second.comment;
    }
    row.in_force = in_force_of(row);
    row.next = again_command(reader_.header(), row);
    const bool is_smallest = summary_.findings().is_smallest();
    markdown_.add(row, finding_, is_smallest);
    if (finding_ != nullptr) row.cause = finding_->cause.text();
    junit_.add(row, finding_);
    sarif_.add(row, finding_);
    programs_.add(row);
    if (is_told_by_head(row)) return;
    Json shown = line;
    if (!row.comment.empty()) shown["comment"] = row.comment;
    if (!row.in_force.empty()) shown["inForce"] = row.in_force;
    page_.add_detail(shown, is_smallest);
  }

  ResultsReader& reader_;
  fs::path folder_;
  JunitWriter junit_;
  SarifWriter sarif_;
  MarkdownSummary markdown_;
  ProgramFolder programs_;
  report::HtmlPage page_;
  report::Summary summary_;
  std::map<std::string, report::CorpusCase> corpus_;  // as far as there is room
  const Finding* finding_ = nullptr;                  // of the line read last
  bool has_room_for_passes_ = true;
};

}  // namespace

std::optional<std::string> write_evidence(const std::string& results, const std::string& folder,
                                          const Corpus* corpus) {
  try {
    ResultsReader reader(results);
    fs::create_directories(folder);
    const Causes causes = read_causes(fs::path(results).parent_path());
    Writers writers(reader, folder, causes, programs_of(corpus, reader.header()));
    writers.write_lines();
    remove_views(folder);
    copy_results(results, fs::path(folder) / kReportedResults);
    writers.finish();
    write_causes(folder, causes);
    if (auto error = writers.finish_page()) {
      throw std::system_error(std::make_error_code(std::errc::io_error), *error);
    }
    return std::nullopt;
  } catch (const ResultsError& error) {
    return error.what();
  }
}

}  // namespace gonogo::oracle::evidence
