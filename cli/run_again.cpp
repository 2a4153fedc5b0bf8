// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_again.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "campaign/results_reader.hpp"
#include "campaign/results_writer.hpp"
#include "campaign/selection.hpp"
#include "cli/fresh_run.hpp"
#include "cli/options.hpp"
#include "cli/run_limits.hpp"
#include "cli/subjects.hpp"
#include "publish/evidence/statement.hpp"
#include "publish/report/json_value.hpp"
#include "subjects/private_folder.hpp"

namespace gonogo::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void read_subject_files(const fs::path& folder, oracle::CampaignOptions& campaign) {
  if (const fs::path path = folder / oracle::evidence::kWaiversFile; fs::exists(path)) {
    campaign.known_failures = load_known_failures(path.string());
  }
  if (const fs::path path = folder / oracle::evidence::kAlarmMapFile; fs::exists(path)) {
    campaign.alarm_map = load_alarm_map(path.string());
  }
}

oracle::CampaignOptions options_of(const Json& header, const fs::path& folder) {
  using oracle::report::text_of;
  oracle::CampaignOptions campaign = oracle::asked_in(header);
  campaign.grants = {
      length_option(text_of(header, "tolerance"), "the tolerance of the run"),
      length_option(text_of(header, "chord"), "the chord of the run"),
      feed_option(text_of(header, "feed_resolution"), "the feed resolution of the run"),
      header.value("strict", false)};
  campaign.limits = limits_of_run(header).limits();
  campaign.limits.stated = {campaign.profile, campaign.readings};
  campaign.jobs = static_cast<int>(std::max(1L, ::sysconf(_SC_NPROCESSORS_ONLN)));
  read_subject_files(folder, campaign);
  return campaign;
}

// Fresh programs that were drawn from one seed.
struct FreshShare {
  std::uint64_t seed = 0;
  unsigned shard = 1;
  oracle::FreshCounts counts;
};

// Nothing: the results do not say from which seeds. Each shard of a merged run has its own.
std::optional<std::vector<FreshShare>> fresh_shares(const Json& header,
                                                    const oracle::CampaignOptions& campaign,
                                                    const oracle::FreshCounts& counts) {
  const Json argv = header.value("argv", Json::array());
  const bool is_merged = !argv.empty() && argv.front() == "merge";
  if (!header.contains("shards")) {
    if (is_merged || !header.contains("seed")) return std::nullopt;
    return std::vector<FreshShare>{{campaign.seed, campaign.shard, counts}};
  }
  std::vector<FreshShare> shares;
  for (const Json& one : header.at("shards")) {
    FreshShare share;
    share.seed = one.at("seed").get<std::uint64_t>();
    share.shard = oracle::asked_in({{"shard", one.at("shard")}}).shard;
    share.counts = oracle::fresh_from_json(one.at("fresh"));
    shares.push_back(std::move(share));
  }
  return shares;
}

// Nothing: the run had none. Into which programs departures are reduced hangs on time; that there
// are so many does not.
std::optional<oracle::evidence::Check> same_fresh_programs(const std::string& certified,
                                                           const JudgedCorpus& judged,
                                                           const std::string& scratch) {
  using oracle::evidence::Check;
  oracle::ResultsReader reader(certified);
  std::vector<std::string> told;
  for (oracle::CaseHead head; reader.next(head);) {
    if (oracle::is_fresh(head.id)) told.push_back(head.id);
  }
  const oracle::FreshCounts counts =
      oracle::fresh_from_json(reader.footer().value_or(Json::object()).value("fresh", Json()));
  if (counts.empty()) return std::nullopt;
  const auto shares = fresh_shares(reader.header(), judged.campaign, counts);
  if (!shares) {
    return Check{Check::Result::unchecked,
                 "The fresh programs were not derived: the results do not say from which seeds."};
  }
  std::vector<std::string> departures;
  for (const FreshShare& share : *shares) {
    oracle::CampaignOptions campaign = judged.campaign;
    campaign.seed = share.seed;
    campaign.shard = share.shard;
    const auto id =
        fresh_departure({judged.corpus, campaign, judged.maker, judged.subject, judged.took},
                        share.counts, scratch);
    if (id) departures.push_back(*id);
  }
  if (departures.size() > told.size()) {
    return Check{Check::Result::fails,
                 fmt::format("The subject departs on the fresh program {}, which has no line.",
                             departures.back())};
  }
  if (departures.size() == told.size()) {
    return Check{Check::Result::holds, "The fresh programs were run again."};
  }
  return Check{
      Check::Result::fails,
      fmt::format("{} is a departure, but the subject did not depart again.", told.back())};
}

}  // namespace

std::vector<oracle::evidence::Check> run_again(const std::string& certificate,
                                               const std::string& corpus_path,
                                               const std::string& subject) {
  const std::string certified = (fs::path(certificate) / oracle::evidence::kResultsFile).string();
  Json header = oracle::ResultsReader(certified).header();
  oracle::CampaignOptions campaign = options_of(header, certificate);
  campaign.limits = sandboxed(std::move(campaign.limits), limits_of_run(header).sandbox, subject,
                              {corpus_path, certificate});
  const oracle::SubjectMaker maker = subject_maker(subject, campaign.limits);
  const oracle::Corpus corpus(corpus_path);
  const oracle::PrivateFolder scratch;
  const std::string path = (fs::path(scratch.path()) / oracle::evidence::kResultsFile).string();
  oracle::ResultsWriter results(path, header.dump());
  const oracle::CampaignEnd end = oracle::run_campaign(
      corpus, campaign, maker, [&](const oracle::CaseResult& result) { results.add(result); },
      nullptr);
  oracle::ResultsWriter::Ending ending;
  ending.left_out = end.left_out;
  ending.stale = end.stale;
  ending.is_shard = campaign.shards > 1;
  if (campaign.alarm_map && campaign.is_whole()) ending.alarms = campaign.alarm_map->natives();
  results.close(ending);
  std::vector<oracle::evidence::Check> checks = oracle::evidence::same_cases(certified, path);
  const JudgedCorpus judged{corpus, campaign, maker, subject, {}};
  if (auto check = same_fresh_programs(certified, judged, scratch.path())) {
    checks.push_back(*std::move(check));
  }
  return checks;
}

}  // namespace gonogo::cli
