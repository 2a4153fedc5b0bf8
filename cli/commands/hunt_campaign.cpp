// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo hunt --campaign DIR: a hunt of hours, in a folder that holds all that it needs to go on.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <thread>

#include "cli/exit_code.hpp"
#include "cli/hunt_causes.hpp"
#include "cli/hunt_words.hpp"
#include "cli/output.hpp"
#include "cli/version.hpp"
#include "hunt/campaign.hpp"
#include "oracle/records/text.hpp"

namespace gonogo::cli {
namespace {

using Clock = std::chrono::steady_clock;
using hunt::CampaignState;

std::string folder_of(const HuntWords& words, std::size_t shard, std::size_t shards) {
  return fmt::format("{}/shard-{}-of-{}", words.campaign, shard, shards);
}

// What the jobs of this process share.
class Board {
 public:
  Board(const HuntWords& words, const HuntEnd& end)
      : words_(words), end_(end), on_(::isatty(STDERR_FILENO) == 1) {}

  void tell(const hunt::Finding& finding, const std::string& folder, const std::string& id) {
    const std::lock_guard lock(mutex_);
    ++findings_;
    clear();
    Output output;
    output.text() = fmt::format("{}. {}  {}\n{}", findings_, finding.signature.text(), id,
                                finding_text(finding));
    output.text() +=
        fmt::format("  again: gonogo reduce {0} --subject {1} --profile {2}\n\n",
                    oracle::shell_quoted(folder + "/findings/" + id + "/program.nc"),
                    oracle::shell_quoted(words_.trial.subject),
                    oracle::shell_quoted(folder + "/findings/" + id + "/profile.json"));
    output.flush();
  }

  // Whether to go on, after one more program.
  bool tick() {
    const std::size_t tried = ++programs_;
    if (failed_ || end_.reached(tried, findings_)) return false;
    if (on_) show(tried);
    return true;
  }

  // The folder tells what there is now.
  void round_done() {
    const std::lock_guard lock(folder_mutex_);
    tell_campaign(words_.campaign, words_.trial);
  }

  void fail(const char* what) {
    const std::lock_guard lock(mutex_);
    failed_ = true;
    clear();
    complain("gonogo: {}\n", what);
  }
  bool failed() const { return failed_; }
  bool is_over() const { return failed_ || end_.reached(programs_, findings_); }
  std::size_t programs() const { return programs_; }
  std::size_t findings() const { return findings_; }  // that were told

 private:
  void clear() const {
    if (on_) complain("\r\033[K");
  }
  void show(std::size_t tried) {
    const std::lock_guard lock(mutex_);
    if (Clock::now() - shown_ < std::chrono::milliseconds(200)) return;
    shown_ = Clock::now();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    complain("\r\033[K{} programs, {:.0f} a second, {} new findings, about {:.0f} s left", tried,
             static_cast<double>(tried) / std::max(seconds, 0.001), findings_.load(),
             end_.seconds_left(tried));
    std::fflush(stderr);
  }

  const HuntWords& words_;
  const HuntEnd& end_;
  bool on_;
  std::mutex mutex_;
  std::mutex folder_mutex_;
  std::atomic<std::size_t> programs_ = 0;
  std::atomic<std::size_t> findings_ = 0;
  std::atomic<bool> failed_ = false;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_{};
};

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

void run_job(hunt::HuntCampaign& campaign, const std::string& folder, Board& board) {
  try {
    while (!board.is_over()) {
      const bool is_done = campaign.round([&](const hunt::Finding& finding,
                         const std::string& id) { board.tell(finding, folder, id); },
                     [&](const hunt::Hunt&) { return board.tick(); });
      if (is_done) board.round_done();
    }
  } catch (const std::exception& error) {
    board.fail(error.what());
  }
}

// Whether a face that stands is none of those that are known.
bool has_news(const hunt::HuntSummary& summary, const std::set<hunt::Signature>& known) {
  return std::ranges::any_of(summary.findings, [&](const hunt::CampaignFinding& finding) {
    return std::ranges::any_of(finding.faces, [&](const hunt::Face& face) {
      return face.stands && !known.contains(face.signature);
    });
  });
}

}  // namespace

int hunt_campaign(HuntWords words) {
  hunt::HuntOptions options = hunt_options(words);
  words.dialect = options.dialect;
  know_failures(words, options);
  if (!words.trial.out.empty()) {
    throw UsageError("A campaign has its own folder: --campaign DIR without --out.");
  }
  const Shard machine = shard_option(words.shard);
  const auto jobs = static_cast<std::size_t>(words.jobs);
  const std::size_t shards = machine.of * jobs;
  const HuntEnd end(words);
  std::filesystem::create_directories(words.campaign);
  Board board(words, end);
  struct Job {
    std::string folder;
    hunt::HuntCampaign campaign;
  };
  std::vector<std::unique_ptr<Job>> work;
  for (std::size_t job = 1; job <= jobs; ++job) {
    const std::size_t shard = (machine.number - 1) * jobs + job;
    const std::string folder = folder_of(words, shard, shards);
    try {
      work.push_back(std::make_unique<Job>(
          Job{folder, hunt::HuntCampaign(folder, wanted_state(words, shard, shards),
                                         trial_subject(words.trial), trial_options(words.trial),
                                         options, fmt::format("gonogo {}", kVersion))}));
    } catch (const std::invalid_argument& error) {
      throw UsageError(fmt::format("{} ({})", error.what(), folder));
    }
  }
  std::vector<std::thread> threads;
  for (const auto& job : work) {
    threads.emplace_back([&board, &job] { run_job(job->campaign, job->folder, board); });
  }
  for (std::thread& thread : threads) thread.join();
  const hunt::HuntSummary summary = tell_campaign(words.campaign, words.trial);
  Output output;
  output.text() = finding_list_text(summary);
  output.text() += fmt::format(
      "{}, {}: {} programs now; {} rounds of {} shards with {} programs are done, {} of them "
      "judged with motion; {}\npage: {}/index.html\n",
      words.trial.subject, words.dialect, board.programs(), summary.rounds, summary.shards,
      summary.count.programs, summary.count.moved, findings_text(summary), words.campaign);
  output.flush();
  if (board.failed()) return kUndecided;
  // What was told of a round that was broken off is not in the folder yet.
  if (has_news(summary, options.known) || board.findings() > 0) return kNoGo;
  return summary.count.programs == 0 || judged_little(summary.count) ? kUndecided : kGo;
}

}  // namespace gonogo::cli
