// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/start_reply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "oracle/records/features.hpp"
#include "oracle/records/record_json.hpp"
#include "oracle/records/text.hpp"

namespace gonogo::oracle {
namespace {

using simdjson::dom::array;
using simdjson::dom::element;
using simdjson::dom::object;

// Thrown inside this file only.
struct Refusal {
  std::string message;
};

std::optional<element> find(const object& source, std::string_view key) {
  for (auto field : source) {
    if (field.key == key) return field.value;
  }
  return std::nullopt;
}

// A misspelled key would be taken as left out, and less of the subject would be judged.
void check_keys(const object& source, std::string_view of,
                std::initializer_list<std::string_view> known) {
  for (auto field : source) {
    if (std::ranges::find(known, field.key) == known.end() && !field.key.starts_with("x-")) {
      throw Refusal{fmt::format("{} has no key \"{}\"; a key of your own begins with x-.", of,
                                excerpt(field.key, 60))};
    }
  }
}

std::string text_of(std::string_view key, const element& value) {
  std::string_view text;
  if (value.get(text) != simdjson::SUCCESS) {
    throw Refusal{fmt::format("The key \"{}\" must be a string.", key)};
  }
  return visible(text);
}

std::set<std::string> names_of(std::string_view key, const element& value) {
  array items;
  if (value.get(items) != simdjson::SUCCESS) {
    throw Refusal{fmt::format("The key \"{}\" must be an array of strings.", key)};
  }
  std::set<std::string> names;
  for (auto item : items) names.insert(text_of(key, item));
  return names;
}

// The features of a dialect, or with "" those of every subject. A dialect that the gauge does not
// know may have any.
void check_features(std::string_view dialect, const std::set<std::string>& names) {
  std::vector<std::string_view> known;
  for (const Feature& feature : feature_vocabulary()) {
    if (feature.dialect == dialect) known.push_back(feature.name);
  }
  if (known.empty()) return;
  for (const std::string& name : names) {
    if (std::ranges::find(known, name) != known.end()) continue;
    throw Refusal{fmt::format("The feature \"{}\" of {} is unknown; there are: {}.",
                              excerpt(name, 60), dialect.empty() ? "every dialect" : dialect,
                              fmt::join(known, " "))};
  }
}

// What a certificate says of the subject must name one program, not what a branch holds today.
void read_identity(const object& reply, SubjectInfo& info) {
  auto value = find(reply, "subject");
  object subject;
  if (!value || value->get(subject) != simdjson::SUCCESS) {
    throw Refusal{"The reply needs \"subject\":{\"name\":...,\"version\":...}."};
  }
  check_keys(subject, "\"subject\"", {"name", "version"});
  if (auto name = find(subject, "name")) info.name = text_of("name", *name);
  if (auto version = find(subject, "version")) info.version = text_of("version", *version);
  if (info.name.empty()) throw Refusal{"The subject needs a \"name\"."};
  constexpr std::array<std::string_view, 3> kBranches = {"main", "master", "trunk"};
  if (std::find(kBranches.begin(), kBranches.end(), info.version) != kBranches.end()) {
    throw Refusal{
        fmt::format("The version \"{}\" is a branch: give a release or a commit.", info.version)};
  }
}

void read_dialects(const object& reply, SubjectInfo& info) {
  auto value = find(reply, "dialects");
  if (!value) {
    info.everything = true;
    return;
  }
  object dialects;
  if (value->get(dialects) != simdjson::SUCCESS) {
    for (const std::string& name : names_of("dialects", *value)) info.dialects[name];
    return;
  }
  for (auto field : dialects) {
    std::set<std::string>& features = info.dialects[visible(field.key)];
    features = names_of(field.key, field.value);
    check_features(field.key, features);
  }
}

std::optional<Number> length_of(const object& numeric, std::string_view key, bool zero_allowed) {
  auto value = find(numeric, key);
  if (!value) return std::nullopt;
  // What values are rounded to has to be a rational number.
  if (value->type() == simdjson::dom::element_type::OBJECT) {
    throw Refusal{
        fmt::format("\"{}\" must be a decimal in quotes, no root and no enclosure.", key)};
  }
  auto read = read_number(key, *value);
  if (auto* fault = std::get_if<TraceFault>(&read)) throw Refusal{fault->message};
  const Number& number = std::get<Number>(read);
  if (number.sign() < 0 || (number.sign() == 0 && !zero_allowed)) {
    throw Refusal{fmt::format("\"{}\" must be {}.", key,
                              zero_allowed ? "zero or more" : "greater than zero")};
  }
  return number;
}

void read_numeric(const object& reply, SubjectInfo& info) {
  auto value = find(reply, "numeric");
  if (!value) return;
  object numeric;
  if (value->get(numeric) != simdjson::SUCCESS) {
    throw Refusal{"The key \"numeric\" must be an object."};
  }
  check_keys(numeric, "\"numeric\"", {"kind", "resolution", "feed_resolution", "chord"});
  if (auto kind = find(numeric, "kind")) {
    info.numeric_kind = text_of("kind", *kind);
    info.says_numeric = true;
  }
  if (info.numeric_kind != "fixed" && info.numeric_kind != "binary64" &&
      info.numeric_kind != "exact") {
    throw Refusal{"\"kind\" must be \"fixed\", \"binary64\" or \"exact\"."};
  }
  info.resolution = length_of(numeric, "resolution", false);
  info.feed_resolution = length_of(numeric, "feed_resolution", false);
  info.chord = length_of(numeric, "chord", true);
}

// A misspelled name would never be reported.
void read_readings(const object& reply, SubjectInfo& info) {
  auto value = find(reply, "readings");
  if (!value) return;
  info.readings = names_of("readings", *value);
  for (const std::string& name : info.readings) {
    if (name == "*" || reference::find_reading(name) != nullptr) continue;
    throw Refusal{
        fmt::format("There is no reading \"{}\"; `gonogo spec` names them.", excerpt(name, 60))};
  }
}

void read_window(const object& reply, SubjectInfo& info) {
  auto value = find(reply, "max_in_flight");
  if (!value) return;
  std::int64_t window = 0;
  if (value->type() != simdjson::dom::element_type::INT64 ||
      value->get(window) != simdjson::SUCCESS || window < 1 || window > 256) {
    throw Refusal{"\"max_in_flight\" must be a JSON integer from 1 to 256."};
  }
  info.max_in_flight = static_cast<int>(window);
}

}  // namespace

std::variant<SubjectInfo, JsonFault> read_start_reply(const object& reply) try {
  auto protocol = find(reply, "protocol");
  std::int64_t version = 0;
  if (!protocol || protocol->type() != simdjson::dom::element_type::INT64 ||
      protocol->get(version) != simdjson::SUCCESS || version != 1) {
    return JsonFault{"The reply to \"start\" must pick \"protocol\":1."};
  }
  check_keys(
      reply, "The reply to \"start\"",
      {"protocol", "subject", "dialects", "features", "readings", "numeric", "max_in_flight"});
  SubjectInfo info;
  read_identity(reply, info);
  read_dialects(reply, info);
  if (auto features = find(reply, "features")) {
    info.features = names_of("features", *features);
    check_features("", info.features);
  } else if (info.everything) {
    info.features = {"blocks"};
  }
  read_readings(reply, info);
  read_numeric(reply, info);
  read_window(reply, info);
  return info;
} catch (const Refusal& refusal) {
  return JsonFault{refusal.message};
}

SubjectInfo read_description(std::string_view text) {
  JsonDocument document;
  auto parsed = document.parse(text);
  if (auto* object = std::get_if<simdjson::dom::object>(&parsed)) {
    auto reply = read_start_reply(*object);
    if (auto* info = std::get_if<SubjectInfo>(&reply)) return std::move(*info);
    parsed = std::get<JsonFault>(reply);
  }
  throw SubjectUnusable("The subject's description cannot be used: " +
                        std::get<JsonFault>(parsed).message);
}

}  // namespace gonogo::oracle
