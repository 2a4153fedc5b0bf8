// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/run_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "oracle/records/case_head.hpp"
#include "oracle/records/run_scope.hpp"
#include "oracle/records/text.hpp"
#include "reference/descriptor.hpp"
#include "reference/dialect.hpp"

namespace gonogo::oracle {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostListed = 3;

std::string text_in(const Json& object, const char* key) {
  const Json value = object.value(key, Json());
  return value.is_string() ? visible(value.get<std::string>()) : std::string();
}

// "case a", "cases a, b", "12 cases".
void add_names(std::vector<std::string>& into, const std::string& what, const Json& names) {
  if (!names.is_array() || names.empty()) return;
  std::vector<std::string> texts;
  for (const Json& name : names) {
    texts.push_back(name.is_string() ? visible(name.get<std::string>()) : "");
  }
  const std::string many = names.size() == 1 ? what : what + "s";
  into.push_back(texts.size() > kMostListed ? fmt::format("{} {}", texts.size(), many)
                                            : fmt::format("{} {}", many, fmt::join(texts, ", ")));
}

void add_grants(const Json& header, std::vector<std::string>& granted) {
  struct Grant {
    const char* key;
    const char* what;
    const char* unit;
  };
  constexpr std::array<Grant, 5> kGrants = {{{"tolerance", "tolerance", " mm"},
                                             {"chord", "chord", " mm"},
                                             {"feed_resolution", "feed resolution", ""},
                                             {"blend", "blend", " mm"},
                                             {"feed_tolerance", "feed tolerance", " %"}}};
  for (const Grant& grant : kGrants) {
    const std::string number = text_in(header, grant.key);
    if (!number.empty()) granted.push_back(fmt::format("{} {}{}", grant.what, number, grant.unit));
  }
  if (!text_in(header, "known_failures").empty()) granted.emplace_back("known failures");
  if (!text_in(header, "alarm_map").empty()) granted.emplace_back("alarm map");
  // A subject that knows the names can look answers up (docs/evidence.md).
  if (header.value("show_ids", Json(false)) == true) granted.emplace_back("names of cases");
  if (!header.value("profile", Json::object()).empty() || header.contains("machine")) {
    granted.emplace_back("a profile of the certifier's");
  }
  add_names(granted, "reading", header.value("readings", Json()));
}

void add_part(const Json& header, std::vector<std::string>& part) {
  const std::string shard = text_in(header, "shard");
  if (!shard.empty() && shard != "1/1") part.push_back("shard " + shard);
  const Json selection = header.value("selection", Json::object());
  add_names(part, "glob", selection.value("only", Json()));
  if (const std::string one = text_in(selection, "case"); !one.empty())
    part.push_back("case " + one);
  add_names(part, "case", selection.value("cases", Json()));
  add_names(part, "cycle", selection.value("cycles", Json()));
  add_names(part, "clause", selection.value("clauses", Json()));
}

bool names(const Json& list, std::string_view name) {
  return std::ranges::find(list, Json(name)) != list.end();
}

// " (g74, g84 of rs274 pass some on themselves)": cycles that the subject was asked for.
std::string cycles_with_m_functions(const Json& header) {
  const Json none = Json::object();  // of a header that says nothing of its subject
  const Json declared = header.value("/subject/dialects"_json_pointer, none);
  const Json asked = header.value("/selection/dialects"_json_pointer, Json::array());
  std::string text;
  for (const reference::Dialect& dialect : reference::dialects()) {
    const std::string dialect_name(dialect.name);
    if (!asked.empty() && !names(asked, dialect_name)) continue;
    Json features;
    if (declared.is_object() && !declared.contains(dialect_name)) continue;
    if (declared.is_object()) features = declared[dialect_name];
    std::string cycles;
    for (const reference::Code& code : dialect.descriptor->codes) {
      if (!code.passes_m || (!features.empty() && !names(features, code.feature))) continue;
      cycles += fmt::format("{}{}", cycles.empty() ? "" : ", ", code.feature);
    }
    if (!cycles.empty())
      text += fmt::format("{}{} of {}", text.empty() ? "" : "; ", cycles, dialect.name);
  }
  return text.empty() ? text : fmt::format(" ({} pass some on themselves)", text);
}

std::set<std::string> texts_in(const Json& list) {
  std::set<std::string> texts;
  if (!list.is_array()) return texts;
  for (const Json& one : list) {
    if (one.is_string()) texts.insert(one.get<std::string>());
  }
  return texts;
}

}  // namespace

std::optional<SubjectInfo> declared_in(const Json& header) {
  const Json subject = header.is_object() ? header.value("subject", Json()) : Json();
  if (!subject.is_object()) return std::nullopt;
  const bool must_say = header.value("format", Json(0)) == kResultsFormat;
  if (!must_say && !subject.contains("dialects")) return std::nullopt;
  SubjectInfo info;
  info.features = texts_in(subject.value("features", Json()));
  const Json dialects = subject.value("dialects", Json());
  info.everything = !dialects.is_object();
  if (info.everything) return info;
  for (const auto& [dialect, features] : dialects.items()) {
    info.dialects[dialect] = texts_in(features);
  }
  return info;
}

// J-RUN-01.
RunConditions conditions_of(const Json& header, const Json& footer) {
  RunConditions conditions;
  if (!header.is_object()) return conditions;
  add_grants(header, conditions.granted);
  conditions.strict = header.value("strict", Json(false)) == true;
  conditions.sandbox = text_in(header, "sandbox");
  if (const Json seed = header.value("seed", Json()); seed.is_number_unsigned()) {
    conditions.seed = seed.get<std::uint64_t>();
  }
  if (footer.is_object() && footer.contains("fresh")) {
    conditions.fresh = fresh_from_json(footer["fresh"]);
  }
  add_part(header, conditions.part);
  const Json features = header.value("/subject/features"_json_pointer, Json());
  const auto lacks = [&](const char* feature) {
    return features.is_array() && !names(features, feature);
  };
  if (lacks("m")) {
    conditions.not_compared.push_back({"M functions", cycles_with_m_functions(header)});
  }
  if (lacks("blocks")) conditions.not_compared.push_back({"source lines", {}});
  return conditions;
}

std::string RunConditions::text() const {
  std::string text;
  const auto put = [&](std::string_view what, const std::vector<std::string>& list) {
    if (!list.empty()) text += fmt::format("; {}: {}", what, fmt::join(list, ", "));
  };
  put("granted", granted);
  put("a part", part);
  std::vector<std::string> lacking;
  for (const NotCompared& one : not_compared) lacking.push_back(one.what + one.beside);
  put("not compared", lacking);
  if (strict) text += "; strict";
  if (!sandbox.empty()) text += "; sandbox: " + sandbox;
  if (fresh) {
    const std::size_t judged = fresh_judged(*fresh);
    std::size_t drawn = 0;
    for (const auto& [dialect, count] : *fresh) drawn += count.programs;
    text += "; fresh programs: ";
    text += judged > 0 ? grouped(judged) : drawn > 0 ? "none of " + grouped(drawn) : "none";
  }
  if (seed != 0) text += fmt::format("; seed {}", seed);
  return text;
}

std::string RunConditions::short_text() const {
  std::vector<std::string> all = granted;
  all.insert(all.end(), part.begin(), part.end());
  for (const NotCompared& one : not_compared) all.push_back("without " + one.what);
  if (strict) all.emplace_back("strict");
  return fmt::format("{}", fmt::join(all, ", "));
}

}  // namespace gonogo::oracle
