// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo hunt --campaign DIR: a hunt of hours, in a folder that holds all that it needs to go on.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "cli/exit_code.hpp"
#include "cli/hunt_board.hpp"
#include "cli/hunt_causes.hpp"
#include "cli/hunt_words.hpp"
#include "cli/output.hpp"
#include "cli/version.hpp"
#include "fuzz/hunt/campaign.hpp"

namespace gonogo::cli {
namespace {

using hunt::CampaignState;

CampaignState wanted_state(const HuntWords& words, std::size_t shard, std::size_t shards) {
  CampaignState state;
  state.dialect = words.dialect;
  state.subject = words.trial.subject;
  state.seed = static_cast<std::uint64_t>(words.seed);
  state.programs_of_round = static_cast<std::size_t>(words.round);
  state.shard = shard;
  state.shards = shards;
  return state;
}

void run_job(hunt::HuntCampaign& campaign, const std::string& folder, std::size_t job,
             HuntBoard& board) {
  try {
    while (!board.is_over()) {
      const auto done =
          campaign.round([&](const hunt::Finding& finding,
                             const std::string& id) { board.tell(finding, folder, id); },
                         [&](const hunt::Hunt& hunt) { return board.take_one(job, hunt); });
      if (done) board.round_done(job, *done);
    }
  } catch (const std::exception& error) {
    board.fail(error.what());
  }
}

// Whether a symptom that stands is none of those that are known.
bool has_news(const hunt::HuntSummary& summary, const std::set<hunt::Signature>& known) {
  return std::ranges::any_of(summary.findings, [&](const hunt::CampaignFinding& finding) {
    return std::ranges::any_of(finding.symptoms, [&](const hunt::Symptom& symptom) {
      return symptom.stands && !known.contains(symptom.signature);
    });
  });
}

// What ends within the first round of every job leaves nothing in the folder.
void check_whole_rounds(const HuntWords& words) {
  const long least = words.round * words.jobs;
  if (words.programs == 0 || words.programs >= least) return;
  throw UsageError(fmt::format(
      "--programs {} ends within the first {} of {} programs, of which nothing would be kept: give "
      "--programs {} or more.",
      words.programs, words.jobs == 1 ? "round" : fmt::format("rounds of {} jobs", words.jobs),
      words.round, least));
}

// The shards of a campaign divide its rounds: with others it would be another hunt, beside it.
void check_shards(const HuntWords& words, std::size_t machines, std::size_t shards) {
  for (const std::string& folder : hunt::shards_of(words.campaign)) {
    const std::string name = std::filesystem::path(folder).filename().string();
    std::size_t there = 0;
    if (std::sscanf(name.c_str(), "shard-%*u-of-%zu", &there) != 1 || there == shards) continue;
    const std::string jobs =
        there % machines == 0 ? fmt::format(": give --jobs {}", there / machines) : std::string();
    throw UsageError(fmt::format("The hunt in {} has {}, not {}{}.", words.campaign,
                                 oracle::counted(there, "shard", "shards"), shards, jobs));
  }
}

struct Job {
  std::size_t number;
  std::string folder;
  hunt::HuntCampaign campaign;
};

// Throws UsageError.
std::unique_ptr<Job> make_job(const HuntWords& words, const hunt::HuntOptions& options,
                              std::size_t job, std::size_t shard, std::size_t shards) {
  const std::string folder = fmt::format("{}/shard-{}-of-{}", words.campaign, shard, shards);
  try {
    return std::make_unique<Job>(
        Job{job, folder,
            hunt::HuntCampaign(folder, wanted_state(words, shard, shards),
                               trial_subject(words.trial), trial_options(words.trial), options,
                               fmt::format("gonogo {}", kVersion))});
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("{} ({})", error.what(), folder));
  } catch (const oracle::ResultsRefused& error) {
    throw UsageError(error.what());
  }
}

}  // namespace

int hunt_campaign(HuntWords words) {
  hunt::HuntOptions options = hunt_options(words);
  words.dialect = options.dialect;
  know_failures(words, options);
  if (!words.trial.out.empty()) {
    throw UsageError("A campaign has its own folder: --campaign DIR without --out.");
  }
  check_whole_rounds(words);
  const Shard machine = shard_option(words.shard);
  const auto jobs = static_cast<std::size_t>(words.jobs);
  const std::size_t shards = machine.of * jobs;
  check_shards(words, machine.of, shards);
  const HuntEnd end(words);
  std::filesystem::create_directories(words.campaign);
  HuntBoard board(words, end);
  std::vector<std::unique_ptr<Job>> work;
  for (std::size_t job = 1; job <= jobs; ++job) {
    const std::size_t shard = (machine.number - 1) * jobs + job;
    work.push_back(make_job(words, options, job, shard, shards));
  }
  std::vector<std::thread> threads;
  for (const auto& job : work) {
    threads.emplace_back(
        [&board, &job] { run_job(job->campaign, job->folder, job->number, board); });
  }
  for (std::thread& thread : threads) thread.join();
  board.close();
  if (end.is_broken_off()) {
    complain(
        "gonogo: broken off; the rounds that were done are kept, and the same command goes on.\n");
  }
  const hunt::HuntSummary summary = tell_campaign(words.campaign, words.trial);
  Output output;
  output.text() = finding_list_text(summary);
  output.text() += fmt::format(
      "{}, {}: {} programs now; {} with {} programs are done, {} of them judged with motion; "
      "{}\npage: {}/index.html\n",
      words.trial.subject, words.dialect, board.programs(), rounds_text(summary),
      summary.count.programs, summary.count.moved, findings_text(summary), words.campaign);
  output.tell();
  if (board.failed()) return kUndecided;
  // What was printed of an interrupted round is not in the folder yet.
  if (has_news(summary, options.known) || board.findings() > 0) return kNoGo;
  return summary.count.programs == 0 || judged_little(summary.count) ? kUndecided : kGo;
}

}  // namespace gonogo::cli
