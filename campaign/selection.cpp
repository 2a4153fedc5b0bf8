// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/selection.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "campaign/results_reader.hpp"
#include "corpus/io/sha256.hpp"
#include "reference/dialect.hpp"

namespace gonogo::oracle {

using Json = nlohmann::ordered_json;

namespace {

bool matches(const std::vector<std::string>& globs, const std::string& id) {
  if (globs.empty()) return true;
  return std::ranges::any_of(
      globs, [&](const std::string& glob) { return ::fnmatch(glob.c_str(), id.c_str(), 0) == 0; });
}

// Whether it is one of the names; none: all are asked for.
bool is_asked(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::ranges::find(names, name) != names.end();
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

// The certifier's profile. A header that does not name its dialect is of the only one asked for.
void read_machine(const Json& header, CampaignOptions& asked) {
  const Json profile = header.value("profile", Json::object());
  const Json machine = header.value("machine", Json());
  if (profile.empty() && machine.is_null()) return;
  std::string dialect = asked.dialects.size() == 1 ? asked.dialects.front() : std::string();
  asked.profile_keys = reference::keys_of_json(profile.dump());
  if (!machine.is_null()) {
    dialect = machine.at("dialect").get<std::string>();
    asked.profile_keys = machine.at("sets").get<std::vector<reference::ProfileKey>>();
  }
  auto read = reference::profile_from_json(profile.dump(), dialect);
  if (const auto* error = std::get_if<reference::ProfileError>(&read)) {
    throw ResultsError(fmt::format("The profile of the header: {}", error->message));
  }
  asked.profile = std::get<reference::Profile>(std::move(read));
}

}  // namespace

CampaignOptions asked_in(const Json& header) try {
  CampaignOptions asked;
  const Json selection = header.value("selection", Json::object());
  const auto names = [&](const char* key) {
    return selection.value(key, std::vector<std::string>());
  };
  asked.dialects = names("dialects");
  asked.only = names("only");
  asked.cases = names("cases");
  asked.cycles = names("cycles");
  asked.clauses = names("clauses");
  const Json one = selection.value("case", Json());
  if (one.is_string()) asked.cases = {one.get<std::string>()};
  asked.readings = header.value("readings", std::vector<std::string>());
  asked.seed = header.value("seed", std::uint64_t{0});
  const auto shard = header.at("shard").get<std::string>();
  if (!read_shard(shard, asked.shard, asked.shards)) {
    throw ResultsError(fmt::format("The header's shard \"{}\" is no shard i/n.", shard));
  }
  read_machine(header, asked);
  return asked;
} catch (const Json::exception& error) {
  throw ResultsError(fmt::format("The header cannot be read: {}.", error.what()));
}

unsigned shard_of(std::string_view id, unsigned shards) {
  return static_cast<unsigned>(leading_bytes(id) % shards) + 1;
}

bool read_shard(const std::string& text, unsigned& number, unsigned& of) {
  char rest = 0;
  return std::sscanf(text.c_str(), "%u/%u%c", &number, &of, &rest) == 2 && number >= 1 &&
         number <= of;
}

bool is_selected(const CampaignOptions& options, const Case& test) {
  const auto is_of_clause = [&](const auto& clause) { return is_asked(options.clauses, clause); };
  return is_asked(options.cases, test.id) && is_asked(options.cycles, test.cycle) &&
         (options.clauses.empty() || std::ranges::any_of(test.clauses, is_of_clause)) &&
         is_asked(options.dialects, test.dialect) &&
         (options.shards <= 1 || shard_of(test.id, options.shards) == options.shard) &&
         matches(options.only, test.id);
}

CappedDeclarations capped_declarations(const CampaignOptions& options, const SubjectInfo& subject) {
  CappedDeclarations found;
  for (const reference::Dialect& dialect : reference::dialects()) {
    const std::string name(dialect.name);
    if (!is_asked(options.dialects, name) || !subject.declares(name, "")) continue;
    const bool is_set = options.profile && options.profile->dialect == name;
    const auto machine =
        is_set ? *options.profile : std::get<reference::Profile>(reference::default_profile(name));
    for (Capped& one : capped(subject, machine, options.grants)) {
      found.emplace_back(name, std::move(one));
    }
  }
  return found;
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
