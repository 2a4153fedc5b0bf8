// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/campaign/campaign.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "oracle/campaign/reading_tally.hpp"
#include "oracle/corpus/sha256.hpp"

namespace gonogo::oracle {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kShownFailures = 50;

bool matches(const std::vector<std::string>& globs, const std::string& id) {
  if (globs.empty()) return true;
  return std::ranges::any_of(
      globs, [&](const std::string& glob) { return ::fnmatch(glob.c_str(), id.c_str(), 0) == 0; });
}

// Whether two profiles set one key to different values; else `into` takes the keys of `from` in.
bool merge_keys(Json& into, const Json& from) {
  for (const auto& [key, value] : from.items()) {
    if (!into.contains(key)) {
      into[key] = value;
    } else if (value.is_object() && into[key].is_object()) {
      if (!merge_keys(into[key], value)) return false;
    } else if (into[key] != value) {
      return false;
    }
  }
  return true;
}

// The case under the certifier's profile and readings; nothing when they contradict its own.
std::optional<Case> under(const CampaignOptions& options, const Case& test) {
  Case merged = test;
  if (options.profile) {
    if (options.profile->dialect != test.dialect) return std::nullopt;
    Json keys = Json::parse(reference::profile_json(test.profile));
    if (!merge_keys(keys, Json::parse(reference::profile_json(*options.profile)))) {
      return std::nullopt;
    }
    keys["dialect"] = test.dialect;
    merged.profile = std::get<reference::Profile>(reference::profile_from_json(keys.dump()));
  }
  for (const std::string& choice : options.readings) {
    const std::size_t equals = choice.find('=');
    const reference::Reading* reading = reference::find_reading(choice.substr(0, equals));
    if (reading == nullptr || !reading->belongs_to(test.dialect)) continue;
    const std::string value = choice.substr(equals + 1);
    const std::string& own = merged.profile.readings.get(reading->key);
    if (own != reading->fallback && own != value) return std::nullopt;
    merged.profile.readings.set(reading->key, value);
  }
  return merged;
}

bool selected(const CampaignOptions& options, const Case& test) {
  if (!options.case_id.empty() && test.id != options.case_id) return false;
  if (!options.dialects.empty() &&
      std::ranges::find(options.dialects, test.dialect) == options.dialects.end()) {
    return false;
  }
  if (options.shards > 1 && shard_of(test.id, options.shards) != options.shard) return false;
  return matches(options.only, test.id);
}

// What the workers share.
class Run {
 public:
  Run(const CampaignOptions& options, const ResultSink& results, const Progress& progress)
      : options_(options),
        results_(results),
        progress_(progress),
        known_failures_(options.known_failures) {}

  void select(const Corpus& corpus);
  void work(const SubjectMaker& make_subject);
  CampaignSummary summary();

 private:
  struct Outcome {
    CaseResult result;
    SessionVerdict session;  // of a case with open readings
  };
  void finish_case(CaseResult result, SessionVerdict session);

  const CampaignOptions& options_;
  const ResultSink& results_;
  const Progress& progress_;
  KnownFailures known_failures_;
  std::vector<Case> cases_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  CampaignSummary summary_;
  std::map<std::string, Outcome> open_;  // cases whose readings the campaign must reconcile
  std::map<std::string, std::size_t> judged_by_dialect_;
  std::exception_ptr failure_;
  std::size_t done_ = 0;
};

void Run::select(const Corpus& corpus) {
  corpus.for_each([&](const Case& test) {
    known_failures_.note_case(test.id);
    if (!selected(options_, test)) return true;
    if (auto merged = under(options_, test)) {
      judged_by_dialect_[merged->dialect];
      cases_.push_back(*std::move(merged));
    } else {
      ++summary_.left_out;
    }
    return true;
  });
  summary_.cases = cases_.size();
}

void Run::finish_case(CaseResult result, SessionVerdict session) {
  std::lock_guard lock(mutex_);
  ++done_;
  known_failures_.apply(result);
  if (result.verdict.kind == VerdictKind::xfail) session = {};  // explains no reading
  const Decision answer = decision(result.verdict.kind);
  if (answer == Decision::no_go) {
    ++summary_.no_go;
    if (options_.fail_fast) stop_ = true;
  }
  const VerdictKind kind = result.verdict.kind;
  if (kind == VerdictKind::oracle_error) ++summary_.oracle_errors;
  if (kind == VerdictKind::oracle_gap && !result.expected_gap) ++summary_.unexpected_gaps;
  if (answer != Decision::undecided && kind != VerdictKind::skip) {
    ++summary_.footer.judged;
    ++judged_by_dialect_[result.dialect];
  }
  const bool unexpected = answer == Decision::no_go || kind == VerdictKind::oracle_error ||
                          (kind == VerdictKind::oracle_gap && !result.expected_gap);
  if (unexpected && summary_.failures.size() < kShownFailures) {
    summary_.failures.push_back(result);
  }
  // Cases with open readings wait: in the end one assignment must explain all that passed.
  if (answer == Decision::go && !session.open.empty()) {
    std::string id = result.id;
    open_.emplace(std::move(id), Outcome{std::move(result), std::move(session)});
  } else {
    results_(result);
  }
  if (progress_) progress_(done_, cases_.size(), summary_.no_go);
}

void Run::work(const SubjectMaker& make_subject) {
  try {
    std::unique_ptr<Subject> subject = make_subject();
    while (!stop_) {
      const std::size_t i = next_++;
      if (i >= cases_.size()) break;
      SessionVerdict session;
      CaseResult result = judge_case(cases_[i], options_, *subject, session);
      finish_case(std::move(result), std::move(session));
    }
  } catch (...) {
    std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
    stop_ = true;
  }
}

CampaignSummary Run::summary() {
  if (failure_) std::rethrow_exception(failure_);
  // In the order of the ids, so that the answer does not depend on the number of jobs.
  ReadingTally tally;
  for (auto& [id, outcome] : open_) {
    if (!tally.add(outcome.session)) {
      outcome.result.verdict.kind = VerdictKind::fail_reading;
      outcome.result.verdict.message =
          "No single assignment of readings explains this case and those before it.";
      summary_.reading_conflict = id;
      ++summary_.no_go;
      if (summary_.failures.size() < kShownFailures) summary_.failures.push_back(outcome.result);
    }
    results_(outcome.result);
  }
  summary_.footer.assignments = tally.texts();
  summary_.complete = done_ == cases_.size();
  summary_.judged_nothing =
      judged_by_dialect_.empty() ||
      std::ranges::any_of(judged_by_dialect_, [](const auto& entry) { return entry.second == 0; });
  std::ranges::sort(summary_.failures, {}, &CaseResult::id);
  summary_.stale = known_failures_.of_no_case();
  if (options_.alarm_map && options_.is_whole()) {
    for (std::string& native : options_.alarm_map->unused()) {
      summary_.stale.push_back(std::move(native));
    }
  }
  return std::move(summary_);
}

}  // namespace

unsigned shard_of(std::string_view id, unsigned shards) {
  Sha256 hash;
  hash.update(id);
  const std::uint64_t first = std::stoull(hash.hex().substr(0, 16), nullptr, 16);
  return static_cast<unsigned>(first % shards) + 1;
}

int CampaignSummary::exit_code() const {
  if (no_go > 0 || !stale.empty()) return 1;
  if (!complete || judged_nothing || oracle_errors > 0 || unexpected_gaps > 0) return 3;
  return 0;
}

std::string_view CampaignSummary::decision() const {
  constexpr std::array<std::string_view, 4> kByExitCode = {"GO", "NO-GO", "", "UNDECIDED"};
  return kByExitCode[static_cast<std::size_t>(exit_code())];
}

CampaignSummary run_campaign(const Corpus& corpus, const CampaignOptions& options,
                             const SubjectMaker& make_subject, const ResultSink& results,
                             const Progress& progress) {
  Run run(options, results, progress);
  run.select(corpus);
  std::vector<std::thread> workers;
  for (int i = 1; i < options.jobs; ++i) {
    workers.emplace_back([&] { run.work(make_subject); });
  }
  run.work(make_subject);
  for (std::thread& worker : workers) worker.join();
  return run.summary();
}

}  // namespace gonogo::oracle
