// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "hunt/campaign_json.hpp"
#include "hunt/hunt_summary.hpp"
#include "oracle/corpus/files.hpp"
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

Json face_json(const Face& face) {
  return {{"verdict", oracle::name(face.signature.kind)},
          {"clause", face.signature.clause},
          {"what", face.signature.what},
          {"code", face.signature.code},
          {"folder", face.folder},
          {"programs", face.programs},
          {"first", seen_json(face.first, face.first_seen)},
          {"last", seen_json(face.last, face.last_seen)},
          {"stands", face.stands}};
}

Json finding_json(const CampaignFinding& finding) {
  Json faces = Json::array();
  for (const Face& face : finding.faces) faces.push_back(face_json(face));
  return {{"cause", finding.cause}, {"stands", finding.stands()}, {"faces", faces}};
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
  oracle::write_file(summary_file(folder), json.dump(1) + "\n");
}

KnownCauses read_known_causes(const std::string& folder) try {
  KnownCauses known;
  if (!std::filesystem::exists(summary_file(folder))) return known;
  const Json json = Json::parse(oracle::file_text(summary_file(folder)));
  if (json.at("format").get<int>() != kSummaryFormat) return {};
  for (const Json& finding : json.at("findings")) {
    for (const Json& face : finding.at("faces")) {
      const auto kind = oracle::verdict_kind(face.at("verdict").get<std::string>());
      if (!kind) return {};
      const Signature signature{json.at("dialect").get<std::string>(), *kind,
                                face.at("clause").get<std::string>(),
                                face.at("what").get<std::string>(),
                                face.at("code").get<std::string>()};
      const auto cause = finding.at("cause").get<std::string>();
      if (!cause.empty()) known.causes[signature] = cause;
      known.asked.insert(signature);
    }
  }
  return known;
} catch (const Json::exception&) {
  return {};  // it is written anew
}

}  // namespace gonogo::hunt
