// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/certify_selection.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "campaign/results_reader.hpp"
#include "campaign/selection.hpp"
#include "cli/named_files.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/subjects.hpp"
#include "oracle/records/finding.hpp"
#include "publish/report/clauses.hpp"
#include "publish/report/command.hpp"
#include "publish/report/json_value.hpp"
#include "reference/nearest_word.hpp"
#include "reference/reading.hpp"

namespace gonogo::cli {
namespace {

// A word that is no key=value is refused in the same words by every dialect.
constexpr std::string_view kAnyDialect = "gsk988ta";

// What the files of the subject say of it.
void read_subject_files(const CertifyOptions& options, oracle::CampaignOptions& campaign) {
  if (!options.known_failures.empty()) {
    campaign.known_failures = load_known_failures(options.known_failures);
  }
  campaign.alarm_map = load_alarm_map(options.alarm_map);
}

// The cycles of the dialects that are judged.
std::set<std::string> cycles_of(const CertifyOptions& options, const oracle::Corpus& corpus) {
  std::set<std::string> known;
  oracle::CaseReader reader(corpus, oracle::Detail::to_run);
  while (const auto test = reader.next()) {
    if (options.dialects.empty() || std::ranges::count(options.dialects, test->dialect) > 0)
      known.insert(test->cycle);
  }
  return known;
}

// "gsk.g94.000001" of "gsk.g94.1": the numbers of cases have six digits.
std::string with_whole_number(const std::string& id) {
  constexpr std::size_t kDigits = 6;
  const std::size_t number = id.rfind('.') + 1;
  const std::size_t digits = id.size() - number;
  return digits < kDigits ? std::string(id).insert(number, kDigits - digits, '0') : id;
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

// The dialect of the readings whose names begin so; empty: there is none.
std::string dialect_of_room(const std::string& name) {
  const std::string room = name.substr(0, name.find('.')) + ".";
  const auto found = std::ranges::find_if(reference::readings(), [&](const auto& reading) {
    return std::string_view(reading.name).starts_with(room);
  });
  return found == reference::readings().end() ? std::string() : std::string(found->dialect);
}

// A name that no reading has, in the dialect of the run, else in that of its room.
[[noreturn]] void refuse_reading(const CertifyOptions& options, const std::string& name,
                                 const std::string& choice) {
  const std::string dialect =
      options.dialects.size() == 1 ? options.dialects.front() : dialect_of_room(name);
  if (!dialect.empty()) load_profile({dialect, "", {choice}});
  std::vector<std::string> known;
  for (const reference::Reading& reading : reference::readings()) known.emplace_back(reading.name);
  throw UsageError(fmt::format("There is no reading \"{}\". {}`gonogo spec` lists them.", name,
                               reference::did_you_mean(reference::nearest_word(name, known))));
}

}  // namespace

void check_readings(const CertifyOptions& options) {
  check_readings_once(options.readings);
  for (const std::string& choice : options.readings) {
    const std::string name = choice.substr(0, choice.find('='));
    const reference::Reading* known = reference::find_reading(name);
    if (known == nullptr && choice.size() > name.size()) refuse_reading(options, name, choice);
    load_profile({std::string(known != nullptr ? known->dialect : kAnyDialect), "", {choice}});
    if (!options.dialects.empty() && std::ranges::none_of(options.dialects, [&](auto& dialect) {
          return known->belongs_to(dialect);
        })) {
      throw UsageError(
          fmt::format("{} is a reading of {}, which --dialect leaves out.", name, known->dialect));
    }
  }
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

std::string none_selected(const oracle::Corpus& corpus) {
  return fmt::format("No case of the corpus {} is selected. `gonogo corpus list` names the cases.",
                     corpus.folder());
}

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

}  // namespace gonogo::cli
