// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/campaign/selection.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "oracle/corpus/sha256.hpp"

namespace gonogo::oracle {

using Json = nlohmann::ordered_json;

namespace {

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

bool has_key(const Json& table, const reference::ProfileKey& key) {
  const Json* at = &table;
  for (const std::string& name : key) {
    if (!at->is_object() || !at->contains(name)) return false;
    at = &(*at)[name];
  }
  return true;
}

}  // namespace

unsigned shard_of(std::string_view id, unsigned shards) {
  Sha256 hash;
  hash.update(id);
  const auto digest = hash.digest();
  std::uint64_t first = 0;
  for (std::size_t i = 0; i < sizeof first; ++i) first = first << 8 | digest[i];
  return static_cast<unsigned>(first % shards) + 1;
}

bool is_selected(const CampaignOptions& options, const Case& test) {
  const auto is_named = [](const std::vector<std::string>& names, const std::string& name) {
    return names.empty() || std::ranges::find(names, name) != names.end();
  };
  if (!is_named(options.cases, test.id) || !is_named(options.cycles, test.cycle)) return false;
  if (!options.clauses.empty() && std::ranges::none_of(test.clauses, [&](const auto& clause) {
        return is_named(options.clauses, clause);
      })) {
    return false;
  }
  if (!options.dialects.empty() &&
      std::ranges::find(options.dialects, test.dialect) == options.dialects.end()) {
    return false;
  }
  if (options.shards > 1 && shard_of(test.id, options.shards) != options.shard) return false;
  return matches(options.only, test.id);
}

std::optional<Case> under(const CampaignOptions& options, Case test) {
  if (options.profile) {
    if (options.profile->dialect != test.dialect) return std::nullopt;
    Json keys = Json::parse(reference::profile_json(test.profile));
    const Json machine = Json::parse(reference::profile_json(*options.profile));
    const auto is_other = [&](const reference::ProfileKey& key) {
      return has_key(keys, key) && !has_key(machine, key);  // there it is the default
    };
    if (std::ranges::any_of(options.profile_keys, is_other)) return std::nullopt;
    if (!merge_keys(keys, machine)) return std::nullopt;
    keys["dialect"] = test.dialect;
    test.profile = std::get<reference::Profile>(reference::profile_from_json(keys.dump()));
  }
  for (const std::string& choice : options.readings) {
    const std::size_t equals = choice.find('=');
    const reference::Reading* reading = reference::find_reading(choice.substr(0, equals));
    if (reading == nullptr || !reading->belongs_to(test.dialect)) continue;
    const std::string value = choice.substr(equals + 1);
    const std::string_view own = test.profile.readings.get(reading->key);
    if (own != reading->fallback && own != value) return std::nullopt;
    test.profile.readings.set(reading->key, value);
  }
  return test;
}

}  // namespace gonogo::oracle
