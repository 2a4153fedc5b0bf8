// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo certify: a subject against the corpus. Without a subject, the main job: the built-in
// expanders, the checked-in corpus, a report.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <system_error>

#include "campaign/results_reader.hpp"
#include "campaign/results_writer.hpp"
#include "campaign/selection.hpp"
#include "campaign/trace_file.hpp"
#include "capture/capture_tally.hpp"
#include "cli/arguments.hpp"
#include "cli/causes.hpp"
#include "cli/certify_options.hpp"
#include "cli/colour.hpp"
#include "cli/commands.hpp"
#include "cli/corpus_folder.hpp"
#include "cli/exit_code.hpp"
#include "cli/first_subject.hpp"
#include "cli/fresh_run.hpp"
#include "cli/gauge.hpp"
#include "cli/known_failures_file.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/progress_line.hpp"
#include "cli/results_file.hpp"
#include "cli/run_end.hpp"
#include "cli/run_limits.hpp"
#include "cli/sandbox_options.hpp"
#include "cli/subject_files.hpp"
#include "cli/subjects.hpp"
#include "cli/verdict_text.hpp"
#include "cli/version.hpp"
#include "corpus/io/sha256.hpp"
#include "expanders/registry.hpp"
#include "publish/report/clauses.hpp"
#include "publish/report/command.hpp"
#include "publish/report/json_value.hpp"
#include "reference/dialect.hpp"
#include "reference/nearest_word.hpp"
#include "reference/reading.hpp"

namespace gonogo::cli {
namespace {

// An unknown reading is refused in the same words by every dialect.
constexpr std::string_view kAnyDialect = "gsk988ta";
// Every NO-GO is run twice.
constexpr std::uint64_t kConfirming = 2;

// What the files of the subject say of it.
void read_subject_files(const CertifyOptions& options, oracle::CampaignOptions& campaign) {
  if (!options.known_failures.empty()) {
    campaign.known_failures = load_known_failures(options.known_failures);
  }
  campaign.alarm_map = load_alarm_map(options.alarm_map);
}

// Every reading must exist, admit its value, and belong to a dialect that is judged.
void check_readings(const CertifyOptions& options) {
  check_readings_once(options.readings);
  for (const std::string& choice : options.readings) {
    const std::string name = choice.substr(0, choice.find('='));
    const reference::Reading* known = reference::find_reading(name);
    load_profile({std::string(known != nullptr ? known->dialect : kAnyDialect), "", {choice}});
    if (!options.dialects.empty() && std::ranges::none_of(options.dialects, [&](auto& dialect) {
          return known->belongs_to(dialect);
        })) {
      throw UsageError(
          fmt::format("{} is a reading of {}, which --dialect leaves out.", name, known->dialect));
    }
  }
}

oracle::CampaignOptions campaign_options(const CertifyOptions& options) {
  oracle::CampaignOptions campaign;
  for (const std::string& dialect : options.dialects) load_profile({dialect, "", {}});
  campaign.dialects = options.dialects;
  campaign.only = options.only;
  campaign.cases = options.cases;
  campaign.cycles = options.cycles;
  campaign.clauses = options.clauses;
  campaign.traces = options.traces;
  campaign.readings = options.readings;
  if (!options.profile.empty()) {
    // One that names no dialect is of the only one asked for.
    const bool one = options.dialects.size() == 1;
    load_machine(campaign, one ? options.dialects.front() : "", options.profile);
  }
  campaign.grants = options.limits.grants();
  campaign.jobs = options.jobs > 0
                      ? static_cast<int>(options.jobs)
                      : static_cast<int>(std::max(1L, ::sysconf(_SC_NPROCESSORS_ONLN)));
  campaign.fail_fast = options.fail_fast;
  campaign.limits = options.limits.limits();
  campaign.limits.stated = {campaign.profile, campaign.readings};
  const Shard shard = shard_option(options.shard);
  campaign.shard = shard.number;
  campaign.shards = shard.of;
  campaign.seed = static_cast<std::uint64_t>(options.seed);
  read_subject_files(options, campaign);
  return campaign;
}

// The hash of a file; nothing without one.
std::string sha256_of(const std::string& path) {
  if (path.empty()) return {};
  oracle::Sha256 hash;
  hash.update(read_file(path, "a file"));
  return hash.hex();
}

// What the subject declares and the machine of each dialect, as it is without the profiles of the
// cases, does not admit.
std::vector<std::pair<std::string, oracle::Capped>> capped_declarations(
    const oracle::CampaignOptions& campaign, const oracle::SubjectInfo& info) {
  std::vector<std::pair<std::string, oracle::Capped>> found;
  for (const reference::Dialect& dialect : reference::dialects()) {
    const std::string name(dialect.name);
    const bool asked = campaign.dialects.empty() ||
                       std::ranges::find(campaign.dialects, name) != campaign.dialects.end();
    if (!asked || !info.declares(name, "")) continue;
    const bool is_set = campaign.profile && campaign.profile->dialect == name;
    const auto machine =
        is_set ? *campaign.profile : std::get<reference::Profile>(reference::default_profile(name));
    for (oracle::Capped& one : oracle::capped(info, machine, campaign.grants)) {
      found.emplace_back(name, std::move(one));
    }
  }
  return found;
}

oracle::ResultsHeader results_header(const CertifyOptions& options, const std::string& subject,
                                     const oracle::Corpus& corpus,
                                     const oracle::CampaignOptions& campaign,
                                     const oracle::SubjectInfo& info) {
  oracle::ResultsHeader header;
  header.version = kVersion;
  header.commit = gauge_commit();
  header.program_sha256 = gauge_sha256();
  header.corpus_version = corpus.version();
  header.corpus_sha256 = corpus.sha256();
  header.subject_spec = subject;
  header.subject = info;
  if (campaign.profile) {
    header.profile = reference::profile_json(*campaign.profile);
    header.machine = campaign.profile->dialect;
    header.machine_keys = campaign.profile_keys;
  }
  header.readings = options.readings;
  header.dialects = options.dialects;
  header.only = options.only;
  header.cases = options.cases;
  header.cycles = options.cycles;
  header.clauses = options.clauses;
  header.known_failures_sha256 = sha256_of(options.known_failures);
  header.alarm_map_sha256 = sha256_of(options.alarm_map);
  const oracle::Grants& grants = campaign.grants;
  if (grants.tolerance) header.tolerance = grants.tolerance->text();
  if (grants.chord) header.chord = grants.chord->text();
  if (grants.feed_resolution) header.feed_resolution = grants.feed_resolution->text();
  header.strict = grants.strict;
  header.sandbox = sandbox_name(campaign.limits, subject);
  if (campaign.limits.capture.blend) header.blend = campaign.limits.capture.blend->text();
  header.seed = campaign.seed;
  header.capped = capped_declarations(campaign, info);
  header.shard = options.shard;
  header.argv = options.argv;
  return header;
}

void open_results(const CertifyOptions& options, const std::string& path,
                  const oracle::ResultsHeader& header,
                  std::optional<oracle::ResultsWriter>& results) {
  const std::string journal = oracle::ResultsWriter::journal_of(path);
  if (options.resume) need_same_limits(journal, options.limits);
  if (!options.resume && std::filesystem::exists(journal)) {
    complain(
        "gonogo: {} of an unfinished run is overwritten; --resume would have gone on from "
        "it.\n",
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
  summary.answer =
      results.close(ending, summary.footer, [&](const std::string& line, oracle::VerdictKind kind) {
        if (captured != nullptr) captured->take(line);
        const oracle::CaseFacts facts = oracle::facts_of(line);
        const oracle::Finding* finding = summary.findings.add(facts.head, kind);
        if (known != nullptr && !oracle::is_fresh(facts.id)) known->add(facts, kind, finding);
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
    corpus.for_each([&](const oracle::Case& test) {
      ids.insert(test.id);
      return true;
    });
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

// A few cases do not go where a campaign is, unless they are sent there.
std::string report_folder(const CertifyOptions& options) {
  if (!options.report.empty()) return options.report;
  return options.cases.empty() ? "report" : "again";
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

// Nobody is judged by a vector that is wrong. The checked-in corpus is tested with the gauge
// itself.
void check_vectors(const CertifyOptions& options) {
  if (options.corpus.empty()) return;
  const oracle::Corpus corpus(corpus_folder(options.corpus));
  const std::string own = corpus_here("");
  if (!own.empty() && oracle::Corpus(own).sha256() == corpus.sha256()) return;
  if (const auto fault = oracle::first_wrong_vector(corpus, campaign_options(options))) {
    throw OutputError(
        fmt::format("The corpus {} is at fault, not the subject: {}", corpus.folder(), *fault),
        false);
  }
}

// Of the dialects that are judged.
std::set<std::string> cycles_of(const CertifyOptions& options, const oracle::Corpus& corpus) {
  std::set<std::string> known;
  oracle::CaseReader reader(corpus, oracle::Detail::to_run);
  while (const auto test = reader.next()) {
    if (options.dialects.empty() || std::ranges::count(options.dialects, test->dialect) > 0)
      known.insert(test->cycle);
  }
  return known;
}

// A cycle that the corpus has not selects nothing, and says so before anything runs.
void check_cycles(const CertifyOptions& options, const oracle::Corpus& corpus) {
  if (options.cycles.empty()) return;
  const std::set<std::string> known = cycles_of(options, corpus);
  for (const std::string& name : options.cycles) {
    if (known.contains(name)) continue;
    const std::string near = reference::nearest_word(name, {known.begin(), known.end()});
    throw UsageError(fmt::format(
        "The corpus has no cycle {}{}. {}It has {}.", name,
        options.dialects.empty() ? "" : fmt::format(" of {}", fmt::join(options.dialects, ", ")),
        reference::did_you_mean(near), fmt::join(known, ", ")));
  }
}

// "gsk.g94.000001" of "gsk.g94.1": the numbers of cases have six digits.
std::string with_whole_number(const std::string& id) {
  constexpr std::size_t kDigits = 6;
  const std::size_t number = id.rfind('.') + 1;
  const std::size_t digits = id.size() - number;
  return digits < kDigits ? std::string(id).insert(number, kDigits - digits, '0') : id;
}

// The same of cases, which are looked up only where fewer ran than were named.
void check_cases(const std::vector<std::string>& cases, const oracle::Corpus& corpus) {
  std::set<std::string> known;
  oracle::CaseReader reader(corpus, oracle::Detail::to_run);
  while (const auto test = reader.next()) known.insert(test->id);
  for (const std::string& id : cases) {
    if (known.contains(id)) continue;
    std::string near = with_whole_number(id);
    if (!known.contains(near)) near = reference::nearest_word(id, {known.begin(), known.end()});
    throw UsageError(fmt::format("The corpus has no case {}. {}`gonogo corpus list` names them.",
                                 id, reference::did_you_mean(near)));
  }
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

std::string none_selected(const oracle::Corpus& corpus) {
  return fmt::format("No case of the corpus {} is selected. `gonogo corpus list` names the cases.",
                     corpus.folder());
}

// A shard may have none, and not all that are named.
void need_cases(const CampaignSummary& summary, const oracle::CampaignOptions& campaign,
                const oracle::Corpus& corpus) {
  if (campaign.shards > 1) return;
  if (summary.answer.cases < campaign.cases.size()) check_cases(campaign.cases, corpus);
  if (summary.answer.cases == 0) throw UsageError(none_selected(corpus));
}

// J-RUN-14: a run that names neither a dialect nor a case is of the dialects that the subject
// declares.
void take_declared_dialects(CertifyOptions& options, oracle::CampaignOptions& campaign,
                            const oracle::SubjectInfo& info) {
  if (!options.dialects.empty() || !options.cases.empty()) return;
  for (const auto& [dialect, features] : info.dialects) options.dialects.push_back(dialect);
  campaign.dialects = options.dialects;
}

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
  } catch (const oracle::CorpusError& error) {
    throw UsageError(error.what());
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
       summary.answer.exit_code,
       {results_path, options.known_failures, options.alarm_map, options.profile, options.traces},
       report,
       options.certificate,
       &corpus,
       results->file_sha256()});
  return summary.answer.exit_code;
}

// The options, narrowed to the dialects that a built-in expander has; nothing when none is left.
std::optional<CertifyOptions> with_own_dialects(const CertifyOptions& options,
                                                const std::string& subject) {
  CertifyOptions own = options;
  own.dialects.clear();
  for (const std::string& dialect : declared_dialects(subject_maker(subject, {}))) {
    const bool asked = options.dialects.empty() ||
                       std::ranges::find(options.dialects, dialect) != options.dialects.end();
    if (asked) own.dialects.push_back(dialect);
  }
  if (own.dialects.empty()) return std::nullopt;
  return own;
}

// Each below a folder of its own.
CertifyOptions below(const CertifyOptions& options, const std::string& name) {
  CertifyOptions own = options;
  if (!own.certificate.empty()) own.certificate += "/" + name;
  if (!own.traces.empty()) own.traces += "/" + name;
  return own;
}

// "builtin-gsk" of builtin:gsk, for a folder; what cannot be kept of a command is left out.
std::string folder_name(const std::string& subject) {
  constexpr std::size_t kLongest = 60;
  std::string name;
  for (const char c : subject) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       c == '.' || c == '_' || c == '+';
    if (plain && !(c == '.' && name.empty())) {
      name += c;
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
    if (name.size() == kLongest) break;
  }
  while (name.ends_with('-')) name.pop_back();
  return name.empty() ? "subject" : name;
}

// Several subjects one after the other: the answer is the gravest.
int certify_each(const CertifyOptions& options, const std::string& report) {
  int exit_code = kGo;
  std::set<std::string> names;
  for (const std::string& subject : options.subjects) {
    std::string name = folder_name(subject);
    while (!names.insert(name).second) name += "-again";
    const int one = certify_one(below(options, name), subject, fmt::format("{}/{}", report, name));
    if (one == kNoGo || exit_code == kGo) exit_code = one;
  }
  return exit_code;
}

// Whether a run of one built-in expander has a case; a cycle that it lacks is not asked of it.
bool take_own_cases(CertifyOptions& own, const oracle::Corpus& corpus) {
  if (own.shard != "1/1") return true;
  if (!own.cycles.empty()) {
    const std::set<std::string> known = cycles_of(own, corpus);
    std::erase_if(own.cycles, [&](const std::string& name) { return !known.contains(name); });
    if (own.cycles.empty()) return false;
  }
  const oracle::CampaignOptions campaign = campaign_options(own);
  oracle::CaseReader reader(corpus, oracle::Detail::to_run, campaign.dialects);
  while (auto test = reader.next()) {
    if (is_selected(campaign, *test) && under(campaign, *std::move(test))) return true;
  }
  return false;
}

// The main job: every built-in expander that has a case, each with its own report.
int certify_built_in(const CertifyOptions& options, const std::string& report) {
  const oracle::Corpus corpus(corpus_folder(options.corpus));
  check_cycles(options, corpus);
  std::optional<int> exit_code;
  for (std::string_view name : expanders::names()) {
    const std::string subject = fmt::format("builtin:{}", name);
    std::optional<CertifyOptions> own = with_own_dialects(options, subject);
    if (!own || !take_own_cases(*own, corpus)) continue;
    own = below(*own, std::string(name));
    const int one = certify_one(*own, subject, fmt::format("{}/{}", report, name));
    if (one == kNoGo || exit_code.value_or(kGo) == kGo) exit_code = one;
  }
  if (exit_code) return *exit_code;
  check_cases(options.cases, corpus);
  throw UsageError(none_selected(corpus));
}

// What was found of a subject is asked of it again; a command or a library that only a file names
// is never run.
std::string subject_of(const oracle::ResultsReader& results, const std::string& path) {
  const auto subject = results.header().value("subject", nlohmann::ordered_json::object());
  const std::string spec = oracle::report::text_of(subject, "spec");
  if (spec.empty() || spec.starts_with("builtin:")) return spec;
  throw UsageError(
      fmt::format("{} names the subject, and what a file names is not run. If it is yours: gonogo "
                  "certify --subject {} --failed-of {}",
                  path, oracle::shell_quoted(spec), oracle::shell_quoted(path)));
}

// What was found in a run before is run again in any case.
CertifyOptions with_failed_cases(CertifyOptions options) {
  if (options.failed_of.empty()) return options;
  const std::string path = results_in(options.failed_of);
  oracle::Findings findings;
  std::set<std::string> cases;  // what contradicts another case is seen beside it
  try {
    oracle::ResultsReader results(path);
    if (options.subjects.empty()) {
      const std::string spec = subject_of(results, path);
      if (!spec.empty()) options.subjects.push_back(spec);
    }
    for (oracle::CaseHead head; results.next(head);) {
      if (oracle::is_fresh(head.id)) continue;  // is in no corpus
      const auto kind =
          oracle::verdict_kind(head.verdict).value_or(oracle::VerdictKind::oracle_error);
      if (findings.add(head, kind) == nullptr) continue;
      cases.insert(head.id);
      if (!head.against.empty()) cases.insert(head.against);
    }
  } catch (const oracle::ResultsError& error) {
    throw UsageError(error.what());
  }
  options.cases.insert(options.cases.end(), cases.begin(), cases.end());
  if (findings.empty()) {
    throw UsageError(fmt::format("No case of {} failed: there is nothing to run again.", path));
  }
  return options;
}

// Short enough to be typed again. GONOGO_SEED in the environment stands for a drawn one where a run
// has to be the same again, as in tests; results then say `--seed`, as if it had been typed.
void draw_seed(CertifyOptions& options) {
  constexpr unsigned kMost = 1'000'000'000;
  const char* const named = std::getenv("GONOGO_SEED");
  if (named == nullptr || *named == '\0') {
    options.seed = static_cast<long>(std::random_device()() % (kMost - 1)) + 1;
    return;
  }
  const std::string_view text = named;
  const auto [end, error] = std::from_chars(text.begin(), text.end(), options.seed);
  if (error != std::errc{} || end != text.end() || options.seed < 0) {
    throw UsageError(fmt::format("GONOGO_SEED is \"{}\" and not a whole number.", text));
  }
  options.argv.insert(options.argv.end(), {"--seed", std::to_string(options.seed)});
}

void check_clauses(const CertifyOptions& options) {
  for (const std::string& id : options.clauses) {
    if (oracle::report::find_clause(id) != nullptr) continue;
    std::vector<std::string> known;
    for (const reference::Clause& clause : reference::clauses()) known.emplace_back(clause.id);
    throw UsageError(fmt::format("There is no clause {}. {}`gonogo spec` prints them all.", id,
                                 reference::did_you_mean(reference::nearest_word(id, known))));
  }
}

}  // namespace

int certify(const CertifyOptions& asked) {
  CertifyOptions options = with_failed_cases(asked);
  if (options.seed < 0) draw_seed(options);
  check_clauses(options);
  check_readings(options);
  if (options.fail_fast && !options.certificate.empty()) {
    throw UsageError("A certificate is of a whole run: leave --fail-fast or --certificate out.");
  }
  if (!options.write_known_failures.empty() && options.subjects.size() != 1) {
    throw UsageError("--write-known-failures is of one subject: name it with --subject.");
  }
  if (!options.write_known_failures.empty() && (options.shard != "1/1" || options.fail_fast)) {
    throw UsageError(
        "--write-known-failures takes a run that ends: leave --shard and --fail-fast out.");
  }
  check_vectors(options);
  const std::string report = report_folder(options);
  if (options.subjects.size() == 1) return certify_one(options, options.subjects.front(), report);
  if (!options.subjects.empty()) return certify_each(options, report);
  return certify_built_in(options, report);
}

void add_certify(Command& program) {
  auto options = std::make_shared<CertifyOptions>();
  Command command = program.add_command("certify", "Judge a subject with the corpus");
  command.repeated_option(
      "--subject", options->subjects,
      "builtin:NAME[+FAULT], pipe:COMMAND, oneshot:COMMAND, lib:PATH.so or capture:DIR");
  command.repeated_option("--dialect", options->dialects, "only this dialect");
  command.option("--corpus", options->corpus, "folder of the corpus (the checked-in one)");
  command.option("--report", options->report,
                 "folder for results and report (report; of a few cases: again)");
  command.option("--certificate", options->certificate, "folder for a certificate as well");
  command.option("--traces", options->traces,
                 "folder for what the subject sends for each case, as capture:DIR reads it");
  command.option("--profile", options->profile, "the machine's profile");
  command.repeated_option("--reading", options->readings, "one reading as key=value");
  command.repeated_option("--only", options->only, "only ids that match the glob");
  command.repeated_option("--case", options->cases, "only this case");
  command.option("--failed-of", options->failed_of,
                 "only the cases that are findings of these results, a file or its folder; without "
                 "--subject of its built-in subject");
  command.repeated_option("--cycle", options->cycles, "only cases of this cycle, as g94");
  command.repeated_option("--clause", options->clauses, "only cases that test this clause");
  command.option("--shard", options->shard, "part i of n: i/n");
  command.number(
      "--seed", options->seed, 0, std::numeric_limits<long>::max(),
      "of the order of the cases (drawn anew) and of the fresh programs; 0: cases in the "
      "order of the corpus");
  command.number("--fresh", options->fresh, 0, 100'000'000,
                 "programs of each dialect that are in no corpus (as many as cases were judged)");
  command.number("--jobs", options->jobs, 1, 256, "subjects that run at the same time");
  command.number("--causes", options->causes, 0, 1000,
                 "findings of which the likely cause is looked for (3)");
  command.choice("--order", options->order, {"gravity", "cycle"},
                 "the order in which findings are told (gravity)");
  command.option("--known-failures", options->known_failures,
                 "TOML file of cases that the subject is known to fail");
  command.option("--write-known-failures", options->write_known_failures,
                 "write what failed to this TOML file, and prune what is no longer true");
  command.option("--alarm-map", options->alarm_map,
                 "TOML file of what the subject's own alarms mean");
  command.flag("--resume", options->resume,
               "go on from the journal of an interrupted run in the same folder");
  command.flag("--fail-fast", options->fail_fast, "stop at the first NO-GO");
  add_subject_options(command, options->limits);
  add_sandbox_options(command, options->limits.sandbox, "auto");
  command.flag("--show-ids", options->limits.show_ids,
               "tell a subject behind a pipe the names of the cases, to find a fault");
  add_strict_option(command, options->limits);
  options->argv = arguments();
  command.run([options] { return certify(*options); });
}

}  // namespace gonogo::cli
