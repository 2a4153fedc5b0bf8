// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/campaign_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "campaign/encoding.hpp"
#include "corpus/io/files.hpp"
#include "corpus/io/sha256.hpp"
#include "fuzz/hunt/campaign_json.hpp"
#include "fuzz/hunt/program_files.hpp"
#include "oracle/records/output_file.hpp"

namespace gonogo::hunt {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;

std::string name_of(const generate::GeneratedProgram& program) {
  constexpr std::size_t kDigits = 16;
  oracle::Sha256 hash;
  hash.update(program.text + "\n" + reference::profile_json(program.profile));
  return hash.hex().substr(0, kDigits);
}

HuntCount count_of(const Json& json) {
  HuntCount count;
  for (const auto& [name, member] : kHuntCounts) count.*member = json.at(name).get<std::size_t>();
  return count;
}

Json json_of(const Signature& signature, const KnownFinding& finding) {
  return {{"kind", oracle::name(signature.kind)},
          {"clause", signature.clause},
          {"what", signature.what},
          {"code", signature.code},
          {"id", finding.id},
          {"first_round", finding.first},
          {"last_round", finding.last},
          {"programs", finding.times},
          {"mended_after", finding.mended}};
}

FeatureCounts features_in(const Json& json) {
  FeatureCounts features;
  for (const auto& [feature, count] : json.items()) {
    features[feature] = {count.at("judged").get<std::size_t>(),
                         count.at("skipped").get<std::size_t>(),
                         count.at("no_go").get<std::size_t>()};
  }
  return features;
}

void read_finding(const Json& json, CampaignState& state) {
  const auto kind = oracle::verdict_kind(json.at("kind").get<std::string>());
  if (!kind) throw std::runtime_error("a finding is of no known kind");
  const Signature signature{state.dialect, *kind, json.at("clause").get<std::string>(),
                            json.at("what").get<std::string>(), json.at("code").get<std::string>()};
  state.findings[signature] = {
      json.at("id").get<std::string>(), json.at("first_round").get<std::size_t>(),
      json.at("last_round").get<std::size_t>(), json.at("programs").get<std::size_t>(),
      json.value("mended_after", std::size_t{0})};
}

CampaignState state_of(const Json& json) {
  if (json.at("format").get<int>() != kFormat) throw std::runtime_error("it is of another format");
  CampaignState state;
  state.dialect = json.at("dialect").get<std::string>();
  state.subject = json.at("subject").get<std::string>();
  state.seed = json.at("seed").get<std::uint64_t>();
  state.programs_of_round = json.at("programs_of_round").get<std::size_t>();
  state.shard = json.at("shard").get<std::size_t>();
  state.shards = json.at("shards").get<std::size_t>();
  state.rounds = json.at("rounds").get<std::size_t>();
  state.count = count_of(json.at("count"));
  // Campaigns of before have neither.
  state.features = features_in(json.value("features", Json::object()));
  state.left_out = json.value("left_out", std::string());
  for (const Json& finding : json.at("findings")) read_finding(finding, state);
  state.inputs = json.at("inputs").get<std::vector<std::string>>();
  return state;
}

fs::path state_file(const std::string& folder) {
  return fs::path(folder) / "hunt.json";
}

}  // namespace

std::optional<CampaignState> read_campaign_state(const std::string& folder) {
  const fs::path path = state_file(folder);
  if (!fs::exists(path)) return std::nullopt;
  try {
    return state_of(Json::parse(oracle::file_text(path.string())));
  } catch (const std::exception&) {
    throw std::invalid_argument(fmt::format(
        "{} is not what a hunt wrote: put it back, or begin in another folder.", path.string()));
  }
}

std::vector<std::string> shards_of(const std::string& campaign) {
  std::vector<std::string> shards;
  if (!fs::is_directory(campaign)) return shards;
  for (const auto& entry : fs::directory_iterator(campaign)) {
    if (fs::exists(state_file(entry.path().string()))) shards.push_back(entry.path().string());
  }
  std::ranges::sort(shards);
  return shards;
}

void write_campaign_state(const std::string& folder, const CampaignState& state) {
  Json findings = Json::array();
  for (const auto& [signature, finding] : state.findings) {
    findings.push_back(json_of(signature, finding));
  }
  const Json json = {{"format", kFormat},
                     {"dialect", state.dialect},
                     {"subject", state.subject},
                     {"seed", state.seed},
                     {"programs_of_round", state.programs_of_round},
                     {"shard", state.shard},
                     {"shards", state.shards},
                     {"rounds", state.rounds},
                     {"count", count_json(state.count)},
                     {"features", features_json(state.features)},
                     {"left_out", state.left_out},
                     {"findings", findings},
                     {"inputs", state.inputs}};
  fs::create_directories(folder);
  oracle::write_file(state_file(folder), oracle::dump(json, 1) + "\n");
}

std::vector<generate::GeneratedProgram> read_inputs(const std::string& folder,
                                                    const CampaignState& state) {
  std::vector<generate::GeneratedProgram> programs;
  for (const std::string& name : state.inputs) {
    const fs::path path = fs::path(folder) / "inputs" / name;
    programs.push_back(read_program(path.string() + ".nc", path.string() + ".json", state.dialect));
  }
  return programs;
}

std::vector<std::string> write_inputs(const std::string& folder,
                                      const std::vector<generate::GeneratedProgram>& programs) {
  const fs::path inputs = fs::path(folder) / "inputs";
  fs::create_directories(inputs);
  std::vector<std::string> names;
  for (const generate::GeneratedProgram& program : programs) {
    names.push_back(name_of(program));
    const fs::path path = inputs / names.back();
    if (fs::exists(path.string() + ".nc")) continue;
    oracle::write_file(path.string() + ".json", reference::profile_json(program.profile) + "\n");
    oracle::write_file(path.string() + ".nc", program.text);
  }
  return names;
}

}  // namespace gonogo::hunt
