// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/causes.hpp"

#include <exception>
#include <optional>

#include "identify/attribution.hpp"
#include "oracle/campaign/selection.hpp"
#include "oracle/records/finding.hpp"

namespace gonogo::cli {
namespace {

// A bound on the trials for a finding: a run is not to wait for its explanation.
constexpr std::size_t kMostRecords = 1'000'000;

// The case as the campaign asked for it.
std::optional<identify::ProgramAsked> asked_in(const oracle::Corpus& corpus,
                                               const oracle::CampaignOptions& campaign,
                                               const std::string& id) {
  oracle::CaseReader reader(corpus, oracle::Detail::to_run);
  while (const auto test = reader.next()) {
    if (test->id != id) continue;
    const auto own = oracle::under(campaign, *test);
    if (!own) return std::nullopt;
    return identify::ProgramAsked{own->id, own->program, own->profile};
  }
  return std::nullopt;
}

// The mistake that explains all that departs, or more than half of it, and all that passes: with
// one that programs would not pass with, the subject does something else.
std::string cause_in(const identify::Attribution& found) {
  if (!found.complete.empty()) return found.complete.front().name;
  if (found.partial.empty()) return {};
  const identify::Cause& best = found.partial.front();
  const bool is_likely = 2 * best.departures > found.departures && best.passes == found.passes();
  return is_likely ? best.name : std::string();
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
  options.most_records = kMostRecords;
  std::size_t asked = 0;
  for (const oracle::Finding* finding : summary.findings.list()) {
    const oracle::VerdictKind kind = finding->key.kind;
    if (!oracle::is_other_answer(kind) || kind == oracle::VerdictKind::fail_reading) continue;
    if (asked++ == most) break;
    try {
      const auto test = asked_in(corpus, campaign, finding->smallest.id);
      if (!test) continue;
      const std::unique_ptr<oracle::Subject> subject = make();
      std::string cause = cause_in(identify::attribute(*subject, corpus, *test, options));
      if (!cause.empty()) causes[finding->key] = std::move(cause);
    } catch (const std::exception&) {
      // The run has its answer; what it comes from is a courtesy.
      break;
    }
  }
  return causes;
}

}  // namespace gonogo::cli
