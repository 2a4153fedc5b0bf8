// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which cases of a corpus a campaign runs, and under which profile.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "campaign/campaign.hpp"

namespace gonogo::oracle {

// Shard (from 1) of a case id: first 8 bytes of its SHA-256 modulo the number of shards, plus 1.
unsigned shard_of(std::string_view id, unsigned shards);

// Reads "i/n"; false when it is not of that form with 1 <= i <= n.
bool read_shard(const std::string& text, unsigned& number, unsigned& of);

bool is_selected(const CampaignOptions& options, const Case& test);

// What the header of a results file says of it: selection, shard, seed, profile and readings.
// Throws ResultsError.
CampaignOptions asked_in(const nlohmann::ordered_json& header);

// By dialect: what the subject declares and the machine, as it is without the profiles of the
// cases, does not admit (J-RUN-02).
using CappedDeclarations = std::vector<std::pair<std::string, Capped>>;
CappedDeclarations capped_declarations(const CampaignOptions& options, const SubjectInfo& subject);

// The case under the certifier's profile and readings; nothing when they contradict its own.
std::optional<Case> under(const CampaignOptions& options, Case test);

}  // namespace gonogo::oracle
