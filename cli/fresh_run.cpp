// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/fresh_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "cli/hunt_words.hpp"
#include "cli/output.hpp"
#include "cli/progress_line.hpp"
#include "cli/version.hpp"
#include "fuzz/hunt/fresh_programs.hpp"
#include "fuzz/hunt/known_signatures.hpp"

namespace gonogo::cli {
namespace {

using std::chrono::milliseconds;

// A run takes at most a fifth longer, or ten seconds (docs/evidence.md): a departure has to be made
// small in that time, too.
constexpr milliseconds kLeastTime{8'000};
constexpr int kPartOfTheRun = 6;
constexpr milliseconds kNoLimit = std::chrono::hours(24);
// So many times the limit of a case, as where one is run again: the machine may be slow.
constexpr int kTimesTheLimit = 4;

using Wanted = std::map<std::string, std::size_t>;

// As many as cases were judged, of a whole run that knows of no failure. A part of a run looks at
// something else, and what is known to fail departs on others, too.
Wanted wanted_programs(const CertifyOptions& options, const JudgedCorpus& judged,
                       const oracle::ResultsWriter::Standing& standing) {
  const oracle::CampaignOptions& campaign = judged.campaign;
  const bool is_default = options.fresh < 0;
  const bool is_whole = campaign.is_whole() && standing.known == 0 &&
                        campaign.known_failures.empty() && options.write_known_failures.empty();
  const bool can_be = !judged.subject.starts_with("capture:");
  if (standing.no_go > 0 || options.fresh == 0 || (is_default && !(is_whole && can_be))) return {};
  if (!can_be) {
    throw UsageError("Recorded output cannot be asked other programs: leave --fresh out.");
  }
  Wanted wanted = standing.judged;
  if (is_default) return wanted;
  for (auto& [dialect, programs] : wanted) programs = static_cast<std::size_t>(options.fresh);
  return wanted;
}

hunt::TrialOptions trial_of(const oracle::CampaignOptions& campaign) {
  hunt::TrialOptions trial;
  trial.grants = campaign.grants;
  trial.alarm_map = campaign.alarm_map;
  trial.run_limit = campaign.limits.run * kTimesTheLimit;
  return trial;
}

// What the certifier said of the machine, and what is known to fail there.
hunt::HuntOptions hunt_of(const std::string& dialect, const JudgedCorpus& judged,
                          const hunt::TrialOptions& trial) {
  const oracle::CampaignOptions& campaign = judged.campaign;
  hunt::HuntOptions options;
  options.dialect = dialect;
  options.seed = campaign.seed + campaign.shard - 1;
  if (campaign.profile && campaign.profile->dialect == dialect) options.profile = campaign.profile;
  std::vector<std::string> readings;
  std::ranges::copy_if(campaign.readings, std::back_inserter(readings), [&](const auto& choice) {
    return reference::find_reading(choice.substr(0, choice.find('=')))->belongs_to(dialect);
  });
  options.readings = readings_of(readings);
  if (campaign.known_failures.empty()) return options;
  hunt::Trial known(judged.maker, trial);
  options.known = hunt::known_signatures(campaign.known_failures, judged.corpus, dialect, known);
  return options;
}

hunt::FreshOptions fresh_options(const std::string& dialect, const JudgedCorpus& judged,
                                 std::size_t programs, milliseconds time) {
  hunt::FreshOptions options;
  options.trial = trial_of(judged.campaign);
  options.hunt = hunt_of(dialect, judged, options.trial);
  options.programs = programs;
  options.time = time;
  return options;
}

hunt::Provenance provenance_of(const JudgedCorpus& judged) {
  return {fmt::format("gonogo {}", kVersion), judged.subject, judged.campaign.seed};
}

}  // namespace

oracle::FreshCounts ask_fresh_programs(const CertifyOptions& options, const JudgedCorpus& judged,
                                       const std::string& report, oracle::ResultsWriter& results) {
  const Wanted wanted = wanted_programs(options, judged, results.standing());
  const std::size_t all =
      std::accumulate(wanted.begin(), wanted.end(), std::size_t{0},
                      [](std::size_t sum, const auto& entry) { return sum + entry.second; });
  const milliseconds time = std::max(kLeastTime, judged.took / kPartOfTheRun);
  ProgressLine progress(judged.subject + ", fresh programs");
  oracle::FreshCounts counts;
  std::size_t before = 0;
  for (const auto& [dialect, programs] : wanted) {
    hunt::FreshOptions one = fresh_options(dialect, judged, programs, time * programs / all);
    one.progress = [&](std::size_t done) { progress.show(before + done, all, 0); };
    const hunt::FreshAnswers answers = hunt::ask_fresh(
        judged.maker, one, fmt::format("{}/{}", report, oracle::kFreshRoom), provenance_of(judged));
    counts[dialect] = answers.count;
    before += programs;
    if (!answers.departure) continue;
    results.add_fresh(*answers.departure);
    break;
  }
  return counts;
}

std::optional<std::string> fresh_departure(const JudgedCorpus& judged,
                                           const oracle::FreshCounts& counts,
                                           const std::string& scratch) {
  for (const auto& [dialect, count] : counts) {
    const hunt::FreshAnswers answers =
        hunt::ask_fresh(judged.maker, fresh_options(dialect, judged, count.programs, kNoLimit),
                        scratch, provenance_of(judged));
    if (answers.departure) return answers.departure->id;
  }
  return std::nullopt;
}

}  // namespace gonogo::cli
