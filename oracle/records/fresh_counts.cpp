// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/fresh_counts.hpp"

#include <array>

namespace gonogo::oracle {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::pair<const char*, std::size_t FreshCount::*>, 3> kFreshKeys = {
    {{"wanted", &FreshCount::wanted},
     {"programs", &FreshCount::programs},
     {"judged", &FreshCount::judged}}};

}  // namespace

void add_fresh(FreshCounts& sum, const FreshCounts& more) {
  for (const auto& [dialect, count] : more) {
    FreshCount& into = sum[dialect];
    for (const auto& [key, part] : kFreshKeys) into.*part += count.*part;
  }
}

std::size_t fresh_judged(const FreshCounts& counts) {
  std::size_t judged = 0;
  for (const auto& [dialect, count] : counts) judged += count.judged;
  return judged;
}

std::string hardly_answered(const FreshCounts& counts) {
  constexpr std::size_t kMany = 50;
  constexpr std::size_t kFewest = 10;  // one in so many
  for (const auto& [dialect, count] : counts) {
    if (count.programs >= kMany && count.judged * kFewest < count.programs) return dialect;
  }
  return {};
}

Json fresh_json(const FreshCounts& counts) {
  Json object = Json::object();
  for (const auto& [dialect, count] : counts) {
    for (const auto& [key, part] : kFreshKeys) object[dialect][key] = count.*part;
  }
  return object;
}

FreshCounts fresh_from_json(const Json& object) {
  FreshCounts counts;
  for (const auto& [dialect, one] : object.items()) {
    if (!one.is_object()) continue;
    for (const auto& [key, part] : kFreshKeys) {
      const Json number = one.value(key, Json());
      if (number.is_number_unsigned()) counts[dialect].*part = number.get<std::size_t>();
    }
  }
  return counts;
}

bool is_fresh(std::string_view id) {
  return id.starts_with(kFreshRoom) && id.substr(kFreshRoom.size()).starts_with('.');
}

}  // namespace gonogo::oracle
