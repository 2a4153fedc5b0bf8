// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <variant>

#include "campaign/case_roll.hpp"
#include "campaign/encoding.hpp"
#include "campaign/known_failures.hpp"
#include "campaign/results.hpp"
#include "campaign/selection.hpp"
#include "corpus/io/corpus.hpp"
#include "oracle/records/fresh_counts.hpp"
#include "publish/evidence/certificate_files.hpp"
#include "publish/evidence/compare.hpp"
#include "publish/evidence/statement.hpp"
#include "publish/evidence/text.hpp"
#include "publish/evidence/verify_cases.hpp"
#include "publish/evidence/verify_parts.hpp"
#include "publish/report/case_paths.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {
namespace {

namespace fs = std::filesystem;
using report::text_of;
using Result = Check::Result;

// Which gonogo.
struct Gauge {
  std::string version;
  std::string commit;  // empty: any

  bool is_that_of(const Json& header) const {
    const std::string own = text_of(header.value("gauge", Json::object()), "commit");
    return text_of(header, "gonogo") == version && (own.empty() || commit.empty() || own == commit);
  }
};

std::string gauge_of(const Json& header) {
  const std::string commit = text_of(header.value("gauge", Json::object()), "commit");
  return commit.empty() ? text_of(header, "gonogo")
                        : fmt::format("{} (commit {})", text_of(header, "gonogo"), commit);
}

// The header against its command line, and what of it follows from the rest.
void check_header(const Json& header, const Gauge& here, Findings& findings) {
  std::vector<std::string> faults = header_faults(header);
  if (header.contains("capped") && here.is_that_of(header)) {
    const RunTolerances run = run_tolerances(header);
    CampaignOptions asked = asked_in(header);
    asked.grants = run.grants;
    const Json own = capped_json(capped_declarations(asked, run.subject));
    if (header["capped"] != own) {
      faults.push_back(fmt::format("The header says capped {}, but its declarations make it {}.",
                                   dump(header["capped"]), dump(own)));
    }
  }
  findings.add_list(faults, "The header says what its command line does.");
}

// Statement and waivers, made again from the rest.
void check_statement(const fs::path& folder, const ResultsFacts& facts, const Gauge& here,
                     Findings& findings) {
  const std::string told = file_text((folder / kStatementJson).string());
  const Json json = Json::parse(told, nullptr, false);
  std::vector<std::string> faults;
  if (!json.is_object()) {
    findings.add(Result::fails, fmt::format("{} is no JSON object.", kStatementJson));
    return;
  }
  if (text_of(json, "decision") != facts.answer.decision) {
    faults.push_back(fmt::format("The statement says {}, but the cases come to {}.",
                                 text_of(json, "decision"), facts.answer.decision));
  }
  if (text_of(json, "results_sha256") != text_of(facts.footer, "sha256")) {
    faults.push_back("The statement is of other results: their SHA-256 differs.");
  }
  if (here.is_that_of(facts.header)) {
    const fs::path waivers = folder / kWaiversFile;
    const Statement own = make_statement(
        (folder / kResultsFile).string(),
        fs::exists(waivers) ? waiver_reasons(waivers.string()) : std::vector<std::string>(),
        report::texts_of(json, "files"), trace_files_of(folder));
    if (own.json != told) {
      faults.push_back(fmt::format("{} is not what the results state.", kStatementJson));
    }
    if (own.markdown != file_text((folder / kStatementText).string())) {
      faults.push_back(fmt::format("{} is not what the results state.", kStatementText));
    }
  } else {
    findings.add(Result::unchecked,
                 fmt::format("The wording of the statement: it was made by gonogo {}, this is {}.",
                             gauge_of(facts.header), here.version));
  }
  findings.add_list(faults, "The statement follows from results and waivers.");
}

// The files of the run are those whose sums the results name, and the traces are of its subject.
void check_run_files(const fs::path& folder, const ResultsFacts& facts, Findings& findings) {
  std::vector<std::string> faults;
  auto check = [&](const char* name, const char* key) {
    const std::string told = text_of(facts.header, key);
    const bool exists = fs::exists(folder / name);
    if (!facts.header.contains(key) || (told.empty() && !exists)) return;
    if (!exists) {
      faults.push_back(fmt::format("{} is missing, though the run had such a file.", name));
    } else if (file_sha256((folder / name).string()) != told) {
      faults.push_back(fmt::format("{} is not the file that the run had.", name));
    }
  };
  check(kWaiversFile, "known_failures");
  check(kAlarmMapFile, "alarm_map");
  if (const fs::path own = folder / kTraces / "subject.json"; fs::exists(own)) {
    const Json said = Json::parse(file_text(own.string()), nullptr, false);
    const Json subject = facts.header.value("subject", Json::object());
    const Json named = said.is_object() ? said.value("subject", Json::object()) : Json::object();
    for (const char* key : {"name", "version"}) {
      if (text_of(named, key) == text_of(subject, key)) continue;
      faults.push_back(fmt::format("{} has another {} than the header.", own.string(), key));
    }
    for (const char* key : {"dialects", "features", "numeric"}) {
      const Json told = subject.value(key, Json());
      if (said.is_object() && said.value(key, Json()) == told) continue;
      faults.push_back(fmt::format("{} has other {} than the header.", own.string(), key));
    }
  }
  findings.add_list(faults,
                    "Waivers, alarm map and what the subject declares are those of the run.");
}

// The corpus that is here, when it is that of the run.
std::optional<Corpus> corpus_of(const std::string& folder, const Json& header, Findings& findings) {
  const Json told = header.value("corpus", Json::object());
  const std::string version = text_of(told, "version");
  const auto unchecked = [&](const std::string& why) {
    findings.add(Result::unchecked,
                 fmt::format("Cases, profiles and features, of the corpus {}: {}", version, why));
    return std::nullopt;
  };
  if (folder.empty()) return unchecked("there is none here; name one with --corpus.");
  try {
    Corpus corpus(folder);
    const bool is_same = corpus.sha256() == text_of(told, "sha256");
    if (is_same && corpus.version() == version) {
      findings.add(Result::holds, fmt::format("The corpus {} here is that of the run.", version));
      return corpus;
    }
    if (is_same || corpus.version() == version) {
      findings.add(
          Result::fails,
          fmt::format("The corpus {} here has the version {} and the SHA-256 {}, that of "
                      "the run {} and {}.",
                      folder, corpus.version(), corpus.sha256(), version, text_of(told, "sha256")));
      return std::nullopt;
    }
    return unchecked(fmt::format("here is {}.", corpus.version()));
  } catch (const CorpusError& error) {
    return unchecked(error.what());
  }
}

template <typename Entries>
Entries entries_in(const fs::path& file,
                   std::variant<Entries, FileFault> (*read)(std::string_view text)) {
  if (!fs::exists(file)) return {};
  auto entries = read(file_text(file.string()));
  if (const auto* fault = std::get_if<FileFault>(&entries)) {
    throw ResultsError(fmt::format("{}: {}", file.string(), fault->message));
  }
  return std::get<Entries>(std::move(entries));
}

// Whether the footer has to name the entries of the alarm map that no case met.
bool tells_unused_alarms(const ResultsFacts& facts) {
  if (facts.footer.contains("unused_alarms")) return true;
  const auto argv = facts.header.value("argv", std::vector<std::string>());
  const bool is_run = !argv.empty() && argv.front() == "certify" &&
                      std::ranges::find(argv, "--fail-fast") == argv.end();
  return is_run && !text_of(facts.header, "alarm_map").empty() && !asked_in(facts.header).is_part();
}

// What the footer has to say of entries of the subject's files that are no longer true.
Json stale_entries(const fs::path& folder, const ResultsFacts& facts, const KnownFailures& known) {
  std::vector<std::string> stale = known.stale();
  if (!tells_unused_alarms(facts)) return {{"stale", stale}};
  std::vector<std::string> unused;
  const AlarmMap map(entries_in(folder / kAlarmMapFile, &alarm_map_from_toml));
  for (const std::string& native : map.natives()) {
    if (!facts.mapped.contains(native)) unused.push_back(native);
  }
  if (text_of(facts.header, "shard") == "1/1") {
    for (const std::string& native : unused) stale.push_back(stale_alarm(native));
  }
  return {{"stale", stale}, {"unused_alarms", unused}};
}

// Which cases there are, and each verdict, from corpus, header and traces.
void check_cases(const fs::path& folder, const std::optional<Corpus>& corpus,
                 const ResultsFacts& facts, const Gauge& here, Findings& findings) {
  const std::vector<KnownFailure> waivers =
      entries_in(folder / kWaiversFile, &known_failures_from_toml);
  VerdictsAgain verdicts(facts.header, (folder / kTraces).string(), waivers,
                         entries_in(folder / kAlarmMapFile, &alarm_map_from_toml),
                         here.is_that_of(facts.header));
  ResultsReader reader((folder / kResultsFile).string());
  if (!corpus) {
    for (Json line; reader.next(line);) verdicts.take(line, nullptr);
    return verdicts.tell(findings);
  }
  KnownFailures known(waivers);
  CaseRoll roll(
      *corpus, facts.header, [&](const Case* test, const Json& line) { verdicts.take(line, test); },
      [&](const std::string& id) { known.note_case(id); });
  for (CaseHead head; reader.next(head);) roll.take(head, reader.text());
  roll.finish();
  std::vector<std::string> faults = roll.faults();
  Json footer = stale_entries(folder, facts, known);
  footer["left_out"] = roll.left_out();
  for (const auto& [key, own] : footer.items()) {
    const Json told = facts.footer.value(key, Json());
    if (told == own) continue;
    faults.push_back(fmt::format("The footer says {} {}, but corpus and header make it {}.", key,
                                 dump(told), dump(own)));
  }
  findings.add_list(faults, fmt::format("Cases, profiles, features and expected gaps of {} lines "
                                        "are those of corpus and header.",
                                        grouped(facts.answer.cases)));
  verdicts.tell(findings);
}

}  // namespace

std::vector<Check> verify_certificate(const std::string& folder, const std::string& corpus,
                                      const std::string& version, const std::string& commit) {
  Findings findings;
  try {
    check_sums(folder, findings);
    ResultsFacts facts = read_results((fs::path(folder) / kResultsFile).string());
    // A file of them may be empty.
    if (const fs::path waivers = fs::path(folder) / kWaiversFile; fs::exists(waivers)) {
      const auto entries = known_failures_from_toml(file_text(waivers.string()));
      const auto* const list = std::get_if<std::vector<KnownFailure>>(&entries);
      facts.knows_failures = list == nullptr || !list->empty();
    }
    check_footer(facts, findings);
    const Gauge here{version, commit};
    check_header(facts.header, here, findings);
    check_statement(folder, facts, here, findings);
    check_run_files(folder, facts, findings);
    check_cases(folder, corpus_of(corpus, facts.header, findings), facts, here, findings);
    tell_fresh_programs(facts, findings);
  } catch (const std::runtime_error& error) {
    // A file that is faulty; what follows from it cannot be checked any more.
    findings.add(Result::fails, error.what());
  }
  return findings.take();
}

std::vector<Check> same_cases(const std::string& certified, const std::string& run_again) {
  Findings findings;
  try {
    const Comparison comparison = compare_runs({certified, run_again});
    std::vector<std::string> faults;
    for (const ChangedCase& changed : comparison.changed) {
      faults.push_back(fmt::format("{}: certified {}, now {}.", changed.id, dump(changed.runs[0]),
                                   dump(changed.runs[1])));
    }
    for (const std::string& id : comparison.gone.first) {
      if (is_fresh(id)) continue;  // is derived from its line, and only the corpus is run again
      faults.push_back(fmt::format("{} was certified, but was not run again.", id));
    }
    for (const std::string& id : comparison.added.first) {
      faults.push_back(fmt::format("{} was run again, but stands not in the certificate.", id));
    }
    findings.add_list(
        faults, fmt::format("The subject was run again: {} cases, all the same.", comparison.same));
  } catch (const ResultsError& error) {
    findings.add(Result::fails, error.what());
  }
  return findings.take();
}

}  // namespace gonogo::oracle::evidence
