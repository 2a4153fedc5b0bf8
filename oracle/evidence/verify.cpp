// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/evidence/verify.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "oracle/campaign/results.hpp"
#include "oracle/campaign/tally.hpp"
#include "oracle/corpus/corpus.hpp"
#include "oracle/corpus/id_set.hpp"
#include "oracle/evidence/certificate_files.hpp"
#include "oracle/evidence/compare.hpp"
#include "oracle/evidence/rejudge.hpp"
#include "oracle/evidence/statement.hpp"
#include "oracle/evidence/verify_sums.hpp"
#include "oracle/evidence/verify_traces.hpp"
#include "oracle/report/case_paths.hpp"
#include "oracle/report/json_value.hpp"

namespace gonogo::oracle::evidence {
namespace {

namespace fs = std::filesystem;
using report::text_of;
using Result = Check::Result;

// What one reading of the results gives the checks.
struct ResultsFacts {
  Json header;
  Json footer;
  RunAnswer answer;
  std::vector<std::string> strangers;  // cases that the corpus here does not have
  std::vector<std::string> misjudged;  // sentences
  std::size_t rejudged = 0;
  std::size_t not_rejudged = 0;           // NO-GO, but the line does not hold what it takes
  std::vector<std::string> inconsistent;  // lines whose verdict is not what the tally makes of it
};

std::vector<std::string> texts_in(const Json& object, const char* key) {
  std::vector<std::string> texts;
  for (const Json& item : object.value(key, Json::array())) {
    if (item.is_string()) texts.push_back(item.get<std::string>());
  }
  return texts;
}

// `known`: the cases of the corpus here; null: there is none. Throws ResultsError.
ResultsFacts read_results(const std::string& path, const IdSet* known) {
  ResultsReader reader(path);
  ResultsFacts facts;
  facts.header = reader.header();
  const RunTerms terms = run_terms(reader.header());
  const bool from_samples =
      text_of(facts.header.value("subject", Json::object()), "spec").starts_with("capture:");
  Tally tally;
  Json line;
  while (reader.next(line)) {
    const CaseRow row = case_row(line);
    if (known != nullptr && !known->contains(row.id)) {
      facts.strangers.push_back(fmt::format("{} is no case of the corpus.", row.id));
    }
    const VerdictKind kind = tally.add(facts_of(reader.text()));
    if (kind != row.kind) {
      facts.inconsistent.push_back(
          fmt::format("{}: the line says {}, but with the readings of the whole run it is {}.",
                      row.id, row.verdict(), name(kind)));
    }
    if (row.decision() != Decision::no_go) continue;
    const Rejudged again = from_samples ? Rejudged{} : rejudge(line, terms);
    ++(again.judged ? facts.rejudged : facts.not_rejudged);
    if (!again.fault.empty()) facts.misjudged.push_back(again.fault);
  }
  if (!reader.footer()) {
    throw ResultsError(fmt::format("{} has no footer: it is incomplete.", path));
  }
  facts.footer = *reader.footer();
  facts.answer = tally.finish(texts_in(facts.footer, "stale"));
  return facts;
}

void check_footer(const ResultsFacts& facts, Findings& findings) {
  std::vector<std::string> faults = facts.inconsistent;
  auto compare = [&](std::string_view what, const Json& told, const Json& own) {
    if (told == own) return;
    faults.push_back(fmt::format("The footer says {} {}, but the cases come to {}.", what,
                                 report::dump(told), report::dump(own)));
  };
  const Json& footer = facts.footer;
  compare("totals", footer.value("totals", Json(nullptr)), Json(facts.answer.totals));
  compare("judged", footer.value("judged", Json(nullptr)), Json(facts.answer.judged));
  compare("readings", footer.value("assignments", Json(nullptr)), Json(facts.answer.assignments));
  if (footer.contains("coordinates") || !facts.answer.coordinates.empty()) {
    compare("coordinates", footer.value("coordinates", Json(nullptr)),
            coordinates_json(facts.answer.coordinates));
  }
  compare("decision", footer.value("decision", Json(nullptr)), Json(facts.answer.decision));
  if (footer.contains("head"))
    compare("head", footer.value("head", Json(nullptr)), Json(facts.answer.head));
  findings.add_list(faults,
                    fmt::format("Totals, readings and decision ({}) follow from the {} cases.",
                                facts.answer.decision, facts.answer.cases));
}

void check_again(const ResultsFacts& facts, Findings& findings) {
  findings.add_list(
      facts.misjudged,
      fmt::format("{} NO-GO judged again from program and trace: all the same.", facts.rejudged));
  if (facts.not_rejudged > 0) {
    findings.add(Result::holds,
                 fmt::format("{} NO-GO have no trace to judge again (a crash, a timeout, a state "
                             "leak, a known failure that passes, ...); --subject runs them again.",
                             facts.not_rejudged));
  }
}

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
        texts_in(json, "files"), trace_files_of(folder));
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

// The files of the run are those whose sums the results name.
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
  findings.add_list(faults, "Waivers and alarm map are those of the run.");
}

// The corpus that is here, as far as it can be read.
struct CorpusHere {
  std::string version;  // empty: there is none
  std::string sha256;
  std::string fault;  // why there is none, a sentence
  IdSet ids;
};

CorpusHere corpus_in(const std::string& folder) {
  CorpusHere here;
  if (folder.empty()) {
    here.fault = "there is none here; name one with --corpus.";
    return here;
  }
  try {
    const Corpus corpus(folder);
    corpus.for_each([&](const Case& test) {
      here.ids.insert(test.id);
      return true;
    });
    here.sha256 = corpus.sha256();
    here.version = corpus.version();
  } catch (const CorpusError& error) {
    here.fault = error.what();
  }
  return here;
}

void check_corpus(const CorpusHere& here, const ResultsFacts& facts, Findings& findings) {
  const Json told = facts.header.value("corpus", Json::object());
  const std::string version = text_of(told, "version");
  if (here.version.empty()) {
    findings.add(Result::unchecked, fmt::format("The corpus {}: {}", version, here.fault));
    return;
  }
  if (here.version != version) {
    findings.add(Result::unchecked, fmt::format("The corpus: the run had version {}, here is {}.",
                                                version, here.version));
    return;
  }
  std::vector<std::string> faults = facts.strangers;
  if (here.sha256 != text_of(told, "sha256")) {
    faults.push_back(
        fmt::format("The corpus {} here has another SHA-256 than that of the run.", version));
  }
  findings.add_list(faults, fmt::format("The corpus {} here is that of the run.", version));
}

void check_traces_of(const std::string& folder, const ResultsFacts& facts,
                     const std::string& corpus, const CorpusHere& here, Findings& findings) {
  const Json told = facts.header.value("corpus", Json::object());
  if (here.sha256 != text_of(told, "sha256")) {
    findings.add(
        Result::unchecked,
        "The traces: their programs are those of the corpus of the run, which is not here.");
    return;
  }
  check_traces((fs::path(folder) / kResultsFile).string(), (fs::path(folder) / kTraces).string(),
               corpus, findings);
}

}  // namespace

std::vector<Check> verify_certificate(const std::string& folder, const std::string& corpus,
                                      const std::string& version, const std::string& commit) {
  Findings findings;
  try {
    check_sums(folder, findings);
    const CorpusHere here = corpus_in(corpus);
    const ResultsFacts facts = read_results((fs::path(folder) / kResultsFile).string(),
                                            here.version.empty() ? nullptr : &here.ids);
    check_footer(facts, findings);
    check_statement(folder, facts, {version, commit}, findings);
    check_run_files(folder, facts, findings);
    check_corpus(here, facts, findings);
    check_again(facts, findings);
    if (fs::exists(fs::path(folder) / kTraces))
      check_traces_of(folder, facts, corpus, here, findings);
  } catch (const std::runtime_error& error) {
    // A file that is faulty; what follows from it cannot be checked any more.
    findings.add(Result::fails, error.what());
  }
  return findings.take();
}

std::vector<Check> same_cases(const std::string& certified, const std::string& run_again) {
  Findings findings;
  try {
    const Comparison comparison = compare_results(certified, run_again);
    std::vector<std::string> faults;
    for (const ChangedCase& changed : comparison.changed) {
      faults.push_back(fmt::format("{}: certified {}, now {}.", changed.id,
                                   report::dump(changed.before), report::dump(changed.after)));
    }
    for (const std::string& id : comparison.first_gone) {
      faults.push_back(fmt::format("{} was certified, but was not run again.", id));
    }
    for (const std::string& id : comparison.first_added) {
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
