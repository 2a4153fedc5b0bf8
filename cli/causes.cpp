// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/causes.hpp"

#include <exception>
#include <map>
#include <optional>
#include <set>

#include "campaign/selection.hpp"
#include "fuzz/identify/attribution.hpp"
#include "fuzz/identify/shared_causes.hpp"
#include "oracle/records/finding.hpp"

namespace gonogo::cli {
namespace {

// The case as the campaign asked for it.
std::optional<identify::ProgramAsked> asked_in(const oracle::Corpus& corpus,
                                               const oracle::CampaignOptions& campaign,
                                               const std::string& id) {
  oracle::CaseReader reader(corpus, oracle::Detail::to_run, campaign.dialects);
  while (const auto test = reader.next()) {
    if (test->id != id) continue;
    const auto own = oracle::under(campaign, *test);
    if (!own) return std::nullopt;
    return identify::ProgramAsked{own->id, own->program, own->profile};
  }
  return std::nullopt;
}

}  // namespace

oracle::evidence::Causes find_causes(const CampaignSummary& summary, const oracle::Corpus& corpus,
                                     const oracle::CampaignOptions& campaign,
                                     const oracle::SubjectMaker& make, std::size_t most) {
  oracle::evidence::Causes causes;
  identify::AttributionOptions options;
  options.tolerance = campaign.grants.tolerance;
  options.chord = campaign.grants.chord;
  options.feed_resolution = campaign.grants.feed_resolution;
  options.most_records = kMostRecordsToExplain;
  std::map<std::string, oracle::Cause> named;
  std::set<std::string> names;
  for (const oracle::Finding* finding : summary.findings.list()) {
    const oracle::VerdictKind kind = finding->key.kind;
    if (!oracle::is_other_answer(kind) || kind == oracle::VerdictKind::fail_reading) continue;
    if (causes.asked == most) break;
    ++causes.asked;
    try {
      const auto test = asked_in(corpus, campaign, finding->smallest.id);
      if (!test) continue;
      const std::unique_ptr<oracle::Subject> subject = make();
      const std::string known = identify::known_cause(*subject, *test, names, options);
      const oracle::Cause cause =
          known.empty() ? likely_cause(identify::attribute(*subject, corpus, *test, options))
                        : named[known];
      if (cause.empty()) continue;
      names.insert(cause.name);
      causes.of[finding->key] = named[cause.name] = cause;
    } catch (const std::exception&) {
      // The run has its answer; what it comes from is a courtesy.
      break;
    }
  }
  return causes;
}

}  // namespace gonogo::cli
