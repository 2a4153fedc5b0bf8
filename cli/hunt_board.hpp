// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the jobs of a campaign share: when all is over, what they found, and on a terminal how the
// hunt goes, some lines that are drawn anew in place.
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "cli/hunt_words.hpp"

namespace gonogo::cli {

class HuntBoard {
 public:
  HuntBoard(const HuntWords& words, const HuntEnd& end);
  ~HuntBoard();
  HuntBoard(const HuntBoard&) = delete;
  HuntBoard& operator=(const HuntBoard&) = delete;

  void tell(const hunt::Finding& finding, const std::string& folder, const std::string& id);
  // Whether the job, from 1, is to try one more program, which counts from now on.
  bool take_one(std::size_t job, const hunt::Hunt& hunt);
  // A round of the job is in its folder.
  void round_done(std::size_t job, const hunt::HuntCount& count);
  void fail(const char* what);
  // Takes the lines off the terminal.
  void close();

  bool failed() const { return failed_; }
  bool is_over() const { return failed_ || end_.reached(programs_, findings_); }
  std::size_t programs() const { return programs_; }
  std::size_t findings() const { return findings_; }  // that were reported

 private:
  using Clock = std::chrono::steady_clock;
  struct Job {
    hunt::HuntCount before;  // of its rounds that are done
    hunt::HuntCount round;   // of the one under way
    std::size_t features = 0;
    std::size_t in_programs = 0;
  };

  // How the hunt goes; none is longer than `columns`.
  std::vector<std::string> lines(std::size_t columns) const;
  void show();
  void clear();

  const HuntWords& words_;
  const HuntEnd& end_;
  bool on_;
  std::mutex mutex_;
  std::mutex folder_mutex_;
  std::vector<Job> jobs_;
  std::set<hunt::Signature> told_;  // another job may find the same
  std::size_t rounds_ = 0;
  std::size_t lines_ = 0;  // that stand on the terminal
  std::atomic<std::size_t> programs_ = 0;
  std::atomic<std::size_t> findings_ = 0;
  std::atomic<bool> failed_ = false;
  Clock::time_point found_{};
  Clock::time_point shown_{};
};

}  // namespace gonogo::cli
