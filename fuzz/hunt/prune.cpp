// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/prune.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <tuple>
#include <unordered_set>

#include "fuzz/hunt/coverage.hpp"
#include "fuzz/hunt/finding_files.hpp"

namespace gonogo::hunt {
namespace {

namespace fs = std::filesystem;
using oracle::Decision;

FindingStand stand_of(Trial& trial, const Signature& signature, const Reproducer& reproducer) {
  const bool flickers =
      signature.kind == oracle::VerdictKind::state_leak && reproducer.before.empty();
  const std::optional<oracle::Verdict> verdict = trial.run_alone(reproducer);
  if (!verdict) return FindingStand::cannot_say;
  const Decision decided = decision(verdict->kind);
  if (decided == Decision::no_go) return FindingStand::stands;
  return decided == Decision::go && !flickers ? FindingStand::mended : FindingStand::cannot_say;
}

void try_findings(const std::string& folder, Trial& trial, CampaignState& state, Pruned& pruned) {
  for (auto& [signature, finding] : state.findings) {
    const Reproducer reproducer =
        read_reproducer(folder + "/findings/" + finding.id, state.dialect);
    const FindingStand stand = stand_of(trial, signature, reproducer);
    if (stand == FindingStand::stands) finding.mended = 0;
    if (stand == FindingStand::mended && finding.stands()) finding.mended = state.rounds;
    pruned.findings.push_back({signature, finding.id, stand});
  }
}

// The inputs that the state does not name.
void remove_others(const std::string& folder, const std::vector<std::string>& kept) {
  const std::set<std::string> names(kept.begin(), kept.end());
  const fs::path inputs = fs::path(folder) / "inputs";
  if (!fs::exists(inputs)) return;
  std::vector<fs::path> others;
  for (const auto& entry : fs::directory_iterator(inputs)) {
    if (!names.contains(entry.path().stem().string())) others.push_back(entry.path());
  }
  for (const fs::path& other : others) fs::remove(other);
}

}  // namespace

std::vector<generate::GeneratedProgram> needed_programs(
    std::vector<generate::GeneratedProgram> programs, std::size_t* features) {
  struct Shown {
    std::size_t program = 0;
    Coverage coverage;
  };
  std::vector<Shown> order;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    auto coverage = coverage_of(programs[i], kMostCostInHunt);
    if (coverage) order.push_back({i, *std::move(coverage)});
  }
  std::ranges::sort(order, {}, [&](const Shown& one) {
    return std::tuple(one.coverage.cost, programs[one.program].text.size(), one.program);
  });
  std::unordered_set<std::uint64_t> shown;
  std::vector<generate::GeneratedProgram> needed;
  for (const Shown& one : order) {
    bool is_needed = false;
    for (const std::uint64_t feature : one.coverage.features) {
      is_needed = shown.insert(feature).second || is_needed;
    }
    if (is_needed) needed.push_back(std::move(programs[one.program]));
  }
  if (features != nullptr) *features = shown.size();
  return needed;
}

Pruned prune_campaign(const std::string& folder, Trial& trial) {
  auto state = read_campaign_state(folder);
  if (!state) throw std::runtime_error(fmt::format("There is no hunt in {}.", folder));
  Pruned pruned;
  try_findings(folder, trial, *state, pruned);
  pruned.inputs_before = state->inputs.size();
  const auto kept = needed_programs(read_inputs(folder, *state), &pruned.features);
  state->inputs = write_inputs(folder, kept);
  pruned.inputs = state->inputs.size();
  write_campaign_state(folder, *state);
  // Behind the state: one that is interrupted here has files too many, and none too few.
  remove_others(folder, state->inputs);
  return pruned;
}

}  // namespace gonogo::hunt
