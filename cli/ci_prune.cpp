// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>

#include "cli/certify_options.hpp"
#include "cli/ci_words.hpp"
#include "cli/exit_code.hpp"
#include "cli/hunt_causes.hpp"
#include "cli/output.hpp"
#include "cli/subjects.hpp"
#include "fuzz/hunt/prune.hpp"

namespace gonogo::cli {
namespace {

// In the order of FindingStand.
constexpr std::array<std::string_view, 3> kStands = {"stands", "mended", "cannot say"};

std::string pruned_text(const std::string& folder, const hunt::Pruned& pruned) {
  std::string text = fmt::format("{}: {} of {} programs show all {} features\n", folder,
                                 pruned.inputs, pruned.inputs_before, pruned.features);
  for (const hunt::TriedFinding& finding : pruned.findings) {
    text += fmt::format("  {:<11}{}  {}\n", kStands[static_cast<std::size_t>(finding.stand)],
                        finding.signature.text(), finding.id);
  }
  return text;
}

// Runs the cases that the file names and no others, so that nothing is added that nobody has looked
// at.
int prune_known_failures(const CiWords& words) {
  CertifyOptions options = certify_options(words);
  options.report = words.hunt.campaign + "/known-failures";
  options.write_known_failures = words.hunt.known_failures;
  options.jobs = 0;  // the machine's
  options.causes = 0;
  for (const oracle::KnownFailure& entry : load_known_failures(words.hunt.known_failures)) {
    options.only.push_back(entry.cases);
  }
  if (options.only.empty()) return kGo;
  // That an entry is stale makes the run NO-GO, and is what this is for.
  return certify(options) == kUndecided ? kUndecided : kGo;
}

}  // namespace

std::vector<std::string> shards_in(const std::string& campaign) {
  std::vector<std::string> shards = hunt::shards_of(campaign);
  if (shards.empty()) {
    throw UsageError(
        fmt::format("{} is no folder of a campaign. `gonogo ci batch --campaign {}` begins one.",
                    campaign, campaign));
  }
  return shards;
}

hunt::CampaignState state_for(const std::string& shard, const std::string& dialect) {
  hunt::CampaignState state = hunt::read_campaign_state(shard).value();
  if (state.dialect != dialect) {
    throw UsageError(
        fmt::format("The campaign in {} is of {}, not {}.", shard, state.dialect, dialect));
  }
  return state;
}

int ci_prune(const CiWords& words) {
  const std::vector<std::string> shards = shards_in(words.hunt.campaign);
  hunt::Trial trial(trial_subject(words.hunt.trial), trial_options(words.hunt.trial));
  Output output;
  for (const std::string& shard : shards) {
    output.text() += pruned_text(shard, hunt::prune_campaign(shard, trial));
  }
  const hunt::HuntSummary summary = tell_campaign(words.hunt.campaign, words.hunt.trial);
  output.text() += finding_list_text(summary);
  output.text() += fmt::format("{}, {}: {}\n", words.hunt.trial.subject, summary.dialect,
                               findings_text(summary));
  output.tell();
  return words.hunt.known_failures.empty() ? kGo : prune_known_failures(words);
}

}  // namespace gonogo::cli
