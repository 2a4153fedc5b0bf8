// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/certify_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "campaign/results_reader.hpp"
#include "campaign/results_writer.hpp"
#include "campaign/selection.hpp"
#include "campaign/trace_file.hpp"
#include "capture/capture_tally.hpp"
#include "cli/causes.hpp"
#include "cli/certify_selection.hpp"
#include "cli/fresh_run.hpp"
#include "cli/known_failures_file.hpp"
#include "cli/named_files.hpp"
#include "cli/output.hpp"
#include "cli/progress_line.hpp"
#include "cli/run_end.hpp"
#include "cli/run_limits.hpp"
#include "cli/subjects.hpp"
#include "cli/terminal.hpp"
#include "cli/verdict_text.hpp"

namespace gonogo::cli {
namespace {

// Every NO-GO is run twice.
constexpr std::uint64_t kConfirming = 2;

void open_results(const CertifyOptions& options, const std::string& path,
                  const oracle::ResultsHeader& header,
                  std::optional<oracle::ResultsWriter>& results) {
  const std::string journal = oracle::ResultsWriter::journal_of(path);
  if (options.resume) need_same_limits(journal, options.limits);
  if (!options.resume && std::filesystem::exists(journal)) {
    complain(
        "gonogo: {} of an unfinished run is overwritten; --resume would have gone on from it.\n",
        journal);
  }
  using Start = oracle::ResultsWriter::Start;
  results.emplace(path, header, options.resume ? Start::resume : Start::anew);
}

// A journal that goes on holds cases of this run alone.
void need_selected(const oracle::Corpus& corpus, oracle::CampaignOptions campaign,
                   const oracle::ResultsWriter& results) {
  if (results.resumed() == 0) return;
  std::size_t selected = 0;
  campaign.is_done = [&](std::string_view id) {
    if (results.has(id)) ++selected;
    return false;
  };
  oracle::count_cases(corpus, campaign);
  if (selected == results.resumed()) return;
  throw oracle::ResultsRefused(fmt::format(
      "The journal holds {} cases, and the run selects {} of them. Leave --resume out to begin "
      "anew.",
      results.resumed(), selected));
}

// Runs the cases into the journal.
oracle::CampaignEnd run_cases(const oracle::Corpus& corpus, oracle::CampaignOptions campaign,
                              const oracle::SubjectMaker& maker, const std::string& subject,
                              oracle::ResultsWriter& results) {
  campaign.is_done = [&](std::string_view id) { return results.has(id); };
  ProgressLine progress(subject);
  if (progress.is_on()) campaign.expected = oracle::count_cases(corpus, campaign);
  return oracle::run_campaign(
      corpus, campaign, maker, [&](const oracle::CaseResult& result) { results.add(result); },
      [&](std::size_t done, std::size_t all, std::size_t no_go) {
        progress.show(done, all, no_go);
      });
}

// Sorts the journal into the results.
CampaignSummary close_results(const oracle::CampaignOptions& campaign,
                              const oracle::CampaignEnd& end, const oracle::FreshCounts& fresh,
                              oracle::ResultsWriter& results, oracle::CaptureTally* captured,
                              KnownFailuresFile* known) {
  CampaignSummary summary;
  summary.complete = end.complete;
  oracle::ResultsWriter::Ending ending;
  ending.left_out = end.left_out;
  ending.stale = end.stale;
  ending.is_shard = campaign.shards > 1;
  ending.fresh = fresh;
  ending.is_complete = end.complete;
  if (campaign.alarm_map && campaign.is_whole()) ending.alarms = campaign.alarm_map->natives();
  summary.footer = results.close(ending, [&](const std::string& line, oracle::VerdictKind kind) {
    if (captured != nullptr) captured->take(line);
    const oracle::CaseFacts facts = oracle::facts_of(line);
    const oracle::Finding* finding = summary.findings.add(facts.head, kind);
    if (known != nullptr && !oracle::is_fresh(facts.head.id)) known->add(facts, kind, finding);
    if (facts.head.attempts > kConfirming) {
      ++summary.run_again;
      summary.further_runs += facts.head.attempts - kConfirming;
    }
    if (finding != nullptr && summary.findings.is_smallest()) {
      summary.smallest[finding->number] =
          oracle::evidence::case_row(nlohmann::ordered_json::parse(line));
    }
  });
  return summary;
}

// What the corpus says of the smallest cases, and the command that runs each again.
void describe_smallest(const oracle::Corpus& corpus, const oracle::ResultsHeader& header,
                       CampaignSummary& summary) {
  const auto run = nlohmann::ordered_json::parse(header_line(header));
  std::map<std::string, oracle::evidence::CaseRow*> wanted;
  for (auto& [number, row] : summary.smallest) {
    row.in_force = in_force_of(row);
    row.next = again_command(run, row);
    wanted[row.id] = &row;
  }
  oracle::CaseReader reader(corpus, oracle::Detail::to_run, oracle::asked_in(run).dialects);
  while (!wanted.empty()) {
    const auto test = reader.next();
    if (!test) break;
    const auto found = wanted.find(test->id);
    if (found == wanted.end()) continue;
    found->second->comment = test->comment;
    wanted.erase(found);
  }
}

// What recorded output says beside its verdicts.
std::string captured_text(const CertifyOptions& options, const std::string& subject,
                          const oracle::Corpus& corpus, const oracle::CaptureTally& tally) {
  const std::string folder = oracle::parse_subject_spec(subject)->rest;
  return tally.text() + tally.files_text(folder, options.limits.manifest, [&] {
    std::set<std::string> ids;
    corpus.for_each([&](const oracle::Case& test) { ids.insert(test.id); });
    return ids;
  });
}

// Nothing has been judged yet: another folder is what helps.
void begin_trace_folder(const std::string& folder, const oracle::SubjectInfo& info) try {
  if (!folder.empty()) oracle::begin_traces(folder, info);
} catch (const oracle::ResultsUnwritable& error) {
  throw UsageError(fmt::format("--traces: {}.", error.what()));
}

// Why no cause is looked for; empty: it is.
std::string_view why_no_cause(const oracle::CampaignOptions& campaign, const std::string& subject) {
  if (subject.starts_with("capture:")) return "recorded output runs no further program";
  if (campaign.shards > 1) return "this is one shard of a run";
  return campaign.fail_fast ? "the run stopped at its first finding" : "";
}

void name_causes(const CertifyOptions& options, const oracle::Corpus& corpus,
                 const oracle::CampaignOptions& campaign, const oracle::SubjectMaker& maker,
                 const std::string& subject, const std::string& report, CampaignSummary& summary) {
  oracle::evidence::Causes causes;
  if (options.causes > 0 && !summary.findings.empty()) {
    summary.no_cause_because = why_no_cause(campaign, subject);
    if (summary.no_cause_because.empty()) {
      causes =
          find_causes(summary, corpus, campaign, maker, static_cast<std::size_t>(options.causes));
    }
  }
  summary.causes_asked = causes.asked;
  for (const auto& [key, cause] : causes.of) summary.findings.set_cause(key, cause);
  oracle::evidence::write_causes(report, causes);
}

// The results of a whole campaign are not replaced by those of a part of it.
void keep_campaign(const oracle::CampaignOptions& campaign, const std::string& results_path) {
  if (!campaign.is_part() || !std::filesystem::exists(results_path)) return;
  try {
    const nlohmann::ordered_json header = oracle::ResultsReader(results_path).header();
    if (!header.contains("selection") || oracle::asked_in(header).is_part()) return;
  } catch (const oracle::ResultsError&) {
    return;  // no results: nothing is lost
  }
  throw UsageError(
      fmt::format("{} is of a whole campaign, and a run of a part of it would replace it. Name "
                  "another folder with --report.",
                  results_path));
}

struct Ended {
  oracle::CampaignEnd end;
  oracle::FreshCounts fresh;
};

// The cases of the corpus, and programs that are in none.
Ended run_all(const CertifyOptions& options, const oracle::Corpus& corpus,
              const oracle::CampaignOptions& campaign, const oracle::SubjectMaker& maker,
              const std::string& subject, const std::string& report,
              oracle::ResultsWriter& results) {
  const auto begin = std::chrono::steady_clock::now();
  Ended ended{run_cases(corpus, campaign, maker, subject, results), {}};
  const auto took = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::steady_clock::now() - begin);
  ended.fresh =
      ask_fresh_programs(options, {corpus, campaign, maker, subject, took}, report, results);
  return ended;
}

// A shard may have none, and not all that are named.
void need_cases(const CampaignSummary& summary, const oracle::CampaignOptions& campaign,
                const oracle::Corpus& corpus) {
  if (campaign.shards > 1) return;
  const std::size_t cases = summary.footer.answer.cases;
  if (cases < campaign.cases.size()) check_cases(campaign.cases, corpus);
  if (cases == 0) throw UsageError(none_selected(corpus));
}

// J-RUN-14: a run that names neither a dialect nor a case is of the dialects that the subject
// declares.
void take_declared_dialects(CertifyOptions& options, oracle::CampaignOptions& campaign,
                            const oracle::SubjectInfo& info) {
  if (!options.dialects.empty() || !options.cases.empty()) return;
  for (const auto& [dialect, features] : info.dialects) options.dialects.push_back(dialect);
  campaign.dialects = options.dialects;
}

}  // namespace

int certify_one(CertifyOptions options, const std::string& subject, const std::string& report) {
  // A pass is proven by its trace alone.
  if (!options.certificate.empty() && options.traces.empty()) options.traces = report + "/traces";
  oracle::CampaignOptions campaign = campaign_options(options);
  const oracle::Corpus corpus(corpus_folder(options.corpus));
  campaign.limits = sandboxed(std::move(campaign.limits), options.limits.sandbox, subject,
                              {corpus.folder(), report, options.traces, options.certificate});
  oracle::SubjectMaker make = subject_maker(subject, campaign.limits);
  std::unique_ptr<oracle::Subject> first = make();
  const oracle::SubjectInfo info = first->info();
  const oracle::SubjectMaker maker = beginning_with(std::move(first), std::move(make));
  take_declared_dialects(options, campaign, info);
  check_cycles(options, corpus);
  std::optional<KnownFailuresFile> known;
  if (!options.write_known_failures.empty()) {
    known.emplace(options.write_known_failures, options.known_failures);
  }
  const std::string results_path = report + "/results.jsonl";
  keep_campaign(campaign, results_path);
  std::filesystem::create_directories(report);
  if (!options.certificate.empty()) std::filesystem::create_directories(options.certificate);
  begin_trace_folder(options.traces, info);
  CampaignSummary summary;
  oracle::CaptureTally captured;
  std::optional<oracle::ResultsWriter> results;  // holds the folder to the end
  try {
    const oracle::ResultsHeader header = results_header(options, subject, corpus, campaign, info);
    open_results(options, results_path, header, results);
    need_selected(corpus, campaign, *results);
    const Ended ended = run_all(options, corpus, campaign, maker, subject, report, *results);
    summary = close_results(campaign, ended.end, ended.fresh, *results,
                            info.recorded ? &captured : nullptr, known ? &*known : nullptr);
    if (options.order == "cycle") summary.order = oracle::Findings::Order::cycle;
    describe_smallest(corpus, header, summary);
    name_causes(options, corpus, campaign, maker, subject, report, summary);
  } catch (const oracle::ResultsUnwritable& error) {
    // All that was judged is in the journal.
    throw OutputError(fmt::format("{}. What was judged so far is kept: make room and run the same "
                                  "command with --resume.",
                                  error.what()),
                      false);
  }
  need_cases(summary, campaign, corpus);
  std::string beside =
      info.recorded ? captured_text(options, subject, corpus, captured) : std::string();
  if (known) beside += known->write(corpus, summary);
  tell_run(
      {summary_text(summary, subject, wants_colour(STDOUT_FILENO)) + beside,
       summary.footer.answer.exit_code,
       {results_path, options.known_failures, options.alarm_map, options.profile, options.traces},
       report,
       options.certificate,
       &corpus,
       results->file_sha256()});
  return summary.footer.answer.exit_code;
}

}  // namespace gonogo::cli
