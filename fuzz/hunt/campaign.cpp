// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/campaign.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <stdexcept>

#include "fuzz/hunt/round_times.hpp"

namespace gonogo::hunt {
namespace {

template <typename Value>
void check_same(const char* what, const Value& there, const Value& wanted) {
  if (there == wanted) return;
  throw std::invalid_argument(
      fmt::format("The hunt in that folder has another {}: {}, not {}.", what, there, wanted));
}

// Rounds of all shards differ: none of two seeds that are near each other meet (splitmix64).
std::uint64_t seed_of(const CampaignState& state) {
  const std::uint64_t number = state.rounds * state.shards + state.shard;
  std::uint64_t mixed = state.seed + number * 0x9E37'79B9'7F4A'7C15U;
  mixed = (mixed ^ (mixed >> 30U)) * 0xBF58'476D'1CE4'E5B9U;
  mixed = (mixed ^ (mixed >> 27U)) * 0x94D0'49BB'1331'11EBU;
  return mixed ^ (mixed >> 31U);
}

}  // namespace

HuntCampaign::HuntCampaign(std::string folder, CampaignState wanted, SubjectMaker maker,
                           TrialOptions trial, HuntOptions options, std::string gonogo)
    : folder_(std::move(folder)),
      state_(std::move(wanted)),
      maker_(std::move(maker)),
      trial_(std::move(trial)),
      options_(std::move(options)),
      gonogo_(std::move(gonogo)) {
  std::filesystem::create_directories(folder_);
  lock_ = std::make_unique<oracle::ResultsLock>(folder_ + "/hunt.json");
  auto there = read_campaign_state(folder_);
  if (!there) return;
  check_same("dialect", there->dialect, state_.dialect);
  check_same("subject", there->subject, state_.subject);
  check_same("seed", there->seed, state_.seed);
  check_same("length of a round", there->programs_of_round, state_.programs_of_round);
  check_same("shard", fmt::format("{}/{}", there->shard, there->shards),
             fmt::format("{}/{}", state_.shard, state_.shards));
  state_ = *std::move(there);
}

std::optional<HuntCount> HuntCampaign::round(const Tell& tell, const GoOn& go_on) {
  HuntOptions options = options_;
  options.dialect = state_.dialect;
  options.seed = seed_of(state_);
  Hunt hunt(maker_, trial_, options);
  for (const auto& program : read_inputs(folder_, state_)) hunt.offer(program);
  // One that was mended is news when it shows again.
  for (const auto& [signature, finding] : state_.findings) {
    if (finding.stands()) hunt.know(signature);
  }
  const auto begin = std::chrono::steady_clock::now();
  std::map<Signature, KnownFinding> fresh;
  while (hunt.count().programs < state_.programs_of_round) {
    if (!go_on(hunt)) return std::nullopt;
    std::optional<Finding> finding = hunt.step();
    if (finding) {
      hunt.reduce(*finding, {});
      const Provenance provenance{gonogo_, state_.subject, options.seed};
      const std::string id =
          write_finding(folder_, *finding, hunt.trial().examine(finding->reproducer),
                        hunt.trial().info(), provenance);
      fresh[finding->signature] = {id, state_.rounds + 1, state_.rounds + 1, 1};
      tell(*finding, id);
    }
  }
  for (const auto& [signature, finding] : fresh) {
    const auto [known, is_new] = state_.findings.try_emplace(signature, finding);
    if (is_new) continue;
    known->second.id = finding.id;
    known->second.mended = 0;
  }
  keep(hunt);
  append_round_time(folder_, {state_.rounds, std::chrono::system_clock::now(),
                              std::chrono::steady_clock::now() - begin, hunt.count().programs});
  return hunt.count();
}

void HuntCampaign::keep(const Hunt& hunt) {
  ++state_.rounds;
  state_.count += hunt.count();
  for (const auto& [signature, programs] : hunt.seen()) {
    const auto known = state_.findings.find(signature);
    if (known == state_.findings.end() || !known->second.stands()) continue;
    KnownFinding& finding = known->second;
    const bool is_first = finding.first == state_.rounds;
    finding.last = state_.rounds;
    finding.times = is_first ? programs : finding.times + programs;
  }
  add_features(state_.features, hunt.features());
  state_.left_out = hunt.supported().left_out();
  state_.inputs = write_inputs(folder_, hunt.pool().programs());
  write_campaign_state(folder_, state_);
}

}  // namespace gonogo::hunt
