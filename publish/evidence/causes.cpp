// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/causes.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "campaign/encoding.hpp"
#include "oracle/records/input_file.hpp"
#include "oracle/records/output_file.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {

using Json = nlohmann::ordered_json;

namespace {

constexpr const char* kCausesFile = "causes.json";

}  // namespace

Causes read_causes(const std::filesystem::path& folder) {
  using report::text_of;
  Causes causes;
  std::ifstream in = open_regular(folder / kCausesFile);
  if (!in) return causes;
  const Json file = Json::parse(in, nullptr, false);
  if (!file.is_object() || report::count_of(file, "format") != 1) return causes;
  causes.asked = report::count_of(file, "asked").value_or(0);
  const auto list = file.find("causes");
  if (list == file.end() || !list->is_array()) return causes;
  for (const Json& one : *list) {
    const auto kind = verdict_kind(text_of(one, "verdict"));
    if (!kind || text_of(one, "cause").empty()) continue;
    causes.of[{gravity(*kind), *kind, text_of(one, "dialect"), text_of(one, "clause"),
               text_of(one, "what")}] = {text_of(one, "cause"), text_of(one, "evidence")};
  }
  return causes;
}

void write_causes(const std::filesystem::path& folder, const Causes& causes) {
  if (causes.of.empty()) {
    std::filesystem::remove(folder / kCausesFile);
    return;
  }
  Json list = Json::array();
  for (const auto& [key, cause] : causes.of) {
    list.push_back({{"dialect", key.dialect},
                    {"verdict", name(key.kind)},
                    {"clause", key.clause},
                    {"what", key.what},
                    {"cause", cause.name},
                    {"evidence", cause.evidence}});
  }
  const Json file = {{"format", 1}, {"asked", causes.asked}, {"causes", list}};
  write_file(folder / kCausesFile, dump(file, 1) + "\n");
}

}  // namespace gonogo::oracle::evidence
