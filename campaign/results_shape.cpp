// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/results_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace gonogo::oracle {

using Json = nlohmann::ordered_json;

namespace {

struct Kind {
  const char* name;
  bool (*holds)(const Json& value);
};

bool are_texts(const Json& value) {
  return value.is_array() &&
         std::ranges::all_of(value, [](const Json& one) { return one.is_string(); });
}

// What is not known or was not asked for is null.
constexpr Kind kText = {"text",
                        [](const Json& value) { return value.is_string() || value.is_null(); }};
constexpr Kind kFlag = {"true or false", [](const Json& value) { return value.is_boolean(); }};
constexpr Kind kCount = {"count", [](const Json& value) { return value.is_number_unsigned(); }};
constexpr Kind kObject = {"object", [](const Json& value) { return value.is_object(); }};
constexpr Kind kList = {"list", [](const Json& value) { return value.is_array(); }};
constexpr Kind kTexts = {"list of texts", are_texts};
constexpr Kind kShards = {
    "list of shards", [](const Json& value) {
      return value.is_array() && std::ranges::all_of(value, [](const Json& one) {
               return one.is_object() && one.value("shard", Json()).is_string() &&
                      kCount.holds(one.value("seed", Json())) &&
                      are_texts(one.value("argv", Json())) &&
                      kObject.holds(one.value("fresh", Json()));
             });
    }};
constexpr Kind kTextsByName = {
    "object of lists of texts", [](const Json& value) {
      return value.is_null() || (value.is_object() && std::ranges::all_of(value, are_texts));
    }};
constexpr Kind kCounts = {"object of counts", [](const Json& value) {
                            return value.is_object() && std::ranges::all_of(value, kCount.holds);
                          }};

struct Member {
  const char* outer;  // the object that it stands in; null: the line itself
  const char* key;
  Kind kind;
};

// An outer object stands before its members.
constexpr Member kHeader[] = {{nullptr, "gonogo", kText},
                              {nullptr, "gauge", kObject},
                              {"gauge", "commit", kText},
                              {nullptr, "corpus", kObject},
                              {"corpus", "version", kText},
                              {"corpus", "sha256", kText},
                              {nullptr, "subject", kObject},
                              {"subject", "spec", kText},
                              {"subject", "name", kText},
                              {"subject", "version", kText},
                              {"subject", "dialects", kTextsByName},
                              {"subject", "numeric", kObject},
                              {"subject", "features", kTexts},
                              {nullptr, "profile", kObject},
                              {nullptr, "readings", kTexts},
                              {nullptr, "tolerance", kText},
                              {nullptr, "chord", kText},
                              {nullptr, "feed_resolution", kText},
                              {nullptr, "blend", kText},
                              {nullptr, "feed_tolerance", kText},
                              {nullptr, "show_ids", kFlag},
                              {nullptr, "strict", kFlag},
                              {nullptr, "sandbox", kText},
                              {nullptr, "capped", kList},
                              {nullptr, "selection", kObject},
                              {"selection", "dialects", kTexts},
                              {"selection", "only", kTexts},
                              {"selection", "case", kText},
                              {"selection", "cases", kTexts},
                              {"selection", "cycles", kTexts},
                              {"selection", "clauses", kTexts},
                              {nullptr, "known_failures", kText},
                              {nullptr, "alarm_map", kText},
                              {nullptr, "seed", kCount},
                              {nullptr, "shard", kText},
                              {nullptr, "argv", kTexts},
                              {nullptr, "shards", kShards}};

constexpr Member kFooter[] = {{nullptr, "decision", kText},     {nullptr, "head", kText},
                              {nullptr, "totals", kCounts},     {nullptr, "cases", kCount},
                              {nullptr, "judged", kCount},      {nullptr, "left_out", kCount},
                              {nullptr, "assignments", kTexts}, {nullptr, "coordinates", kObject},
                              {nullptr, "stale", kTexts},       {nullptr, "unused_alarms", kTexts},
                              {nullptr, "fresh", kObject},      {nullptr, "sha256", kText}};

std::optional<std::string> fault_of(const Json& line, std::span<const Member> members) {
  for (const Member& member : members) {
    const auto outer = member.outer == nullptr ? line.end() : line.find(member.outer);
    if (member.outer != nullptr && outer == line.end()) continue;
    const Json& object = member.outer == nullptr ? line : *outer;
    const auto value = object.find(member.key);
    if (value == object.end() || member.kind.holds(*value)) continue;
    const std::string within = member.outer == nullptr ? "" : fmt::format("/{}", member.outer);
    return fmt::format("has no {} at {}/{}", member.kind.name, within, member.key);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> header_fault(const Json& header) {
  return fault_of(header, kHeader);
}

std::optional<std::string> footer_fault(const Json& footer) {
  return fault_of(footer, kFooter);
}

}  // namespace gonogo::oracle
