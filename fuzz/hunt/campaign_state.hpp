// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a long hunt keeps in its folder, so that it can be interrupted at any time and go on: how
// far it is, what it has found, and the programs that showed something new.
//   DIR/hunt.json, DIR/inputs/HASH.nc, HASH.json (the machine)
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fuzz/hunt/hunt.hpp"

namespace gonogo::hunt {

// A defect, as far as its signature distinguishes it.
struct KnownFinding {
  std::string id;         // of its vector
  std::size_t first = 0;  // round, from 1
  std::size_t last = 0;   // the last round that showed it
  std::size_t times = 0;  // programs that showed it
  // Rounds that were done when its program did not show it any more; 0: it stands.
  std::size_t mended = 0;

  bool stands() const { return mended == 0; }
};

struct CampaignState {
  // What must not change between two sessions.
  std::string dialect;
  std::string subject;
  std::uint64_t seed = 1;
  std::size_t programs_of_round = 0;
  std::size_t shard = 1;  // of `shards`
  std::size_t shards = 1;

  std::size_t rounds = 0;  // that are done
  HuntCount count;         // of them
  FeatureCounts features;  // of them
  std::string left_out;    // what the subject skipped in the last of them, for people
  std::map<Signature, KnownFinding> findings;
  std::vector<std::string> inputs;  // names, in the order of the pool
};

// Nothing where the folder has no such file. Throws std::invalid_argument where it cannot be read
// as one, naming it.
std::optional<CampaignState> read_campaign_state(const std::string& folder);
// The folders of all shards that lie in a campaign's, sorted; none where it is none.
std::vector<std::string> shards_of(const std::string& campaign);
// Whole or not at all. Throws std::system_error.
void write_campaign_state(const std::string& folder, const CampaignState& state);

// Those that the state names, in its order. Throws std::runtime_error where one is missing.
std::vector<generate::GeneratedProgram> read_inputs(const std::string& folder,
                                                    const CampaignState& state);
// Writes those that are not there yet; the names of all.
std::vector<std::string> write_inputs(const std::string& folder,
                                      const std::vector<generate::GeneratedProgram>& programs);

}  // namespace gonogo::hunt
