// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "campaign/encoding.hpp"
#include "corpus/io/files.hpp"
#include "fuzz/hunt/campaign_json.hpp"
#include "fuzz/hunt/hunt_summary.hpp"
#include "oracle/records/output_file.hpp"

namespace gonogo::hunt {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSummaryFormat = 1;

std::string summary_file(const std::string& folder) {
  return folder + "/campaign.json";
}

Json seen_json(std::size_t round, const std::optional<std::chrono::system_clock::time_point>& at) {
  Json json = {{"round", round}};
  if (at) json["at"] = date_text(*at);
  return json;
}

Json symptom_json(const Symptom& symptom) {
  return {{"verdict", oracle::name(symptom.signature.kind)},
          {"clause", symptom.signature.clause},
          {"what", symptom.signature.what},
          {"code", symptom.signature.code},
          {"folder", symptom.folder},
          {"programs", symptom.programs},
          {"first", seen_json(symptom.first, symptom.first_seen)},
          {"last", seen_json(symptom.last, symptom.last_seen)},
          {"stands", symptom.stands}};
}

Json finding_json(const CampaignFinding& finding) {
  Json symptoms = Json::array();
  for (const Symptom& symptom : finding.symptoms) symptoms.push_back(symptom_json(symptom));
  return {{"cause", finding.cause.name},
          {"evidence", finding.cause.evidence},
          {"stands", finding.stands()},
          {"faces", symptoms}};
}

}  // namespace

void write_campaign_summary(const std::string& folder, const HuntSummary& summary) {
  Json findings = Json::array();
  for (const CampaignFinding& finding : summary.findings) findings.push_back(finding_json(finding));
  const Json json = {{"format", kSummaryFormat},
                     {"dialect", summary.dialect},
                     {"subject", summary.subject},
                     {"shards", summary.shards},
                     {"rounds", summary.rounds},
                     {"seconds", fmt::format("{:.1f}", summary.seconds)},
                     {"inputs", summary.inputs},
                     {"count", count_json(summary.count)},
                     {"features", features_json(summary.features)},
                     {"left_out", summary.left_out},
                     {"findings", findings}};
  oracle::write_file(summary_file(folder), oracle::dump(json, 1) + "\n");
}

KnownCauses read_known_causes(const std::string& folder) try {
  KnownCauses known;
  if (!std::filesystem::exists(summary_file(folder))) return known;
  const Json json = Json::parse(oracle::file_text(summary_file(folder)));
  if (json.at("format").get<int>() != kSummaryFormat) return {};
  for (const Json& finding : json.at("findings")) {
    for (const Json& symptom : finding.at("faces")) {
      const auto kind = oracle::verdict_kind(symptom.at("verdict").get<std::string>());
      if (!kind) return {};
      const Signature signature{
          json.at("dialect").get<std::string>(), *kind, symptom.at("clause").get<std::string>(),
          symptom.at("what").get<std::string>(), symptom.at("code").get<std::string>()};
      const oracle::Cause cause{finding.at("cause").get<std::string>(),
                                finding.value("evidence", std::string())};
      if (!cause.empty()) known.causes[signature] = cause;
      known.asked.insert(signature);
    }
  }
  return known;
} catch (const Json::exception&) {
  return {};  // it is written anew
}

}  // namespace gonogo::hunt
