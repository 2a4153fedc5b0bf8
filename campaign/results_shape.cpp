// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/results_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>

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
constexpr Kind kAny = {"value", [](const Json&) { return true; }};
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
  const char* place;  // a JSON pointer
  Kind kind;
};

// An outer object stands before its members.
constexpr Member kHeader[] = {{"/format", kAny},
                              {"/gonogo", kText},
                              {"/gauge", kObject},
                              {"/gauge/commit", kText},
                              {"/gauge/sha256", kAny},
                              {"/corpus", kObject},
                              {"/corpus/version", kText},
                              {"/corpus/sha256", kText},
                              {"/subject", kObject},
                              {"/subject/spec", kText},
                              {"/subject/name", kText},
                              {"/subject/version", kText},
                              {"/subject/dialects", kTextsByName},
                              {"/subject/numeric", kObject},
                              {"/subject/numeric/kind", kAny},
                              {"/subject/numeric/resolution", kAny},
                              {"/subject/numeric/feed_resolution", kAny},
                              {"/subject/numeric/chord", kAny},
                              {"/subject/features", kTexts},
                              {"/profile", kObject},
                              {"/machine", kAny},
                              {"/machine/dialect", kAny},
                              {"/machine/sets", kAny},
                              {"/readings", kTexts},
                              {"/tolerance", kText},
                              {"/chord", kText},
                              {"/feed_resolution", kText},
                              {"/blend", kText},
                              {"/feed_tolerance", kText},
                              {"/show_ids", kFlag},
                              {"/strict", kFlag},
                              {"/sandbox", kText},
                              {"/capped", kList},
                              {"/selection", kObject},
                              {"/selection/dialects", kTexts},
                              {"/selection/only", kTexts},
                              {"/selection/case", kText},
                              {"/selection/cases", kTexts},
                              {"/selection/cycles", kTexts},
                              {"/selection/clauses", kTexts},
                              {"/known_failures", kText},
                              {"/alarm_map", kText},
                              {"/seed", kCount},
                              {"/shard", kText},
                              {"/argv", kTexts},
                              {"/shards", kShards}};
constexpr Member kFooter[] = {
    {"/decision", kText},       {"/head", kText},          {"/totals", kCounts},
    {"/cases", kCount},         {"/judged", kCount},       {"/left_out", kCount},
    {"/assignments", kTexts},   {"/coordinates", kObject}, {"/stale", kTexts},
    {"/unused_alarms", kTexts}, {"/fresh", kObject},       {"/sha256", kText}};

std::optional<std::string> fault_of(const Json& line, std::span<const Member> members) {
  for (const Member& member : members) {
    const Json::json_pointer place(member.place);
    if (!line.contains(place) || member.kind.holds(line.at(place))) continue;
    return fmt::format("has no {} at {}", member.kind.name, member.place);
  }
  return std::nullopt;
}

// Members are looked at where the table has some of them.
std::string surplus_of(const Json& object, std::span<const Member> members,
                       const std::string& above = {}) {
  for (const auto& [key, value] : object.items()) {
    const std::string place = above + "/" + key;
    const auto is_it = [&](const Member& member) { return member.place == place; };
    const auto is_below = [&](const Member& member) {
      return std::string_view(member.place).starts_with(place + "/");
    };
    if (key.find('/') != std::string::npos || std::ranges::none_of(members, is_it)) return place;
    if (!value.is_object() || std::ranges::none_of(members, is_below)) continue;
    if (std::string below = surplus_of(value, members, place); !below.empty()) return below;
  }
  return {};
}

}  // namespace

std::optional<std::string> header_fault(const Json& header) {
  return fault_of(header, kHeader);
}

std::optional<std::string> footer_fault(const Json& footer) {
  return fault_of(footer, kFooter);
}

std::string header_surplus(const Json& header) {
  return surplus_of(header, kHeader);
}

std::string footer_surplus(const Json& footer) {
  return surplus_of(footer, kFooter);
}

}  // namespace gonogo::oracle
