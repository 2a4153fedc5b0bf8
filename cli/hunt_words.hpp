// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the two ways to hunt have in common: their words, and when they are over.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cli/trial_options.hpp"

namespace gonogo::cli {

struct HuntWords {
  TrialWords trial;
  std::string dialect;
  std::string method = "reference";
  std::vector<std::string> beside;  // further subjects, of --method operations
  std::string profile;
  std::vector<std::string> readings;
  std::string settings;
  bool everywhere = false;  // outside of the domain, too
  std::string known_failures;
  std::string corpus;  // of the known failures
  std::string time;
  long seed = 1;
  long programs = 0;     // 0: no limit
  long stop_after = 0;   // findings; 0: no limit
  std::string campaign;  // folder of a long hunt; empty: none
  std::string shard = "1/1";
  long jobs = 1;
  long round = 2'000;  // programs
};

// REQUIRES: load_profile has taken them.
std::vector<std::pair<reference::ReadingKey, std::string>> readings_of(
    const std::vector<std::string>& choices);

// " --tolerance 0.01 --chord 0.1", of what was given.
std::string tolerances_of(const LimitOptions& limits);

// The hunt on the command line, except when it is over.
std::string command_of(const HuntWords& words);

// The line that shows a finding in this folder again and reduces it.
std::string reduce_command(const std::string& folder, const TrialWords& words);

// A program below a finding, a line each, without what a terminal would obey.
std::string listed(const std::string& program);
// A line of a finding: its name, and the value or "nothing".
std::string finding_line(std::string_view name, const std::string& value);

// When a hunt is over, and how far it is.
struct HuntEnd {
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin = Clock::now();
  std::chrono::milliseconds time{0};  // 0: no limit
  std::size_t programs = 0;           // 0: no limit
  std::size_t findings = 0;           // 0: no limit

  explicit HuntEnd(const HuntWords& words);
  bool reached(std::size_t tried, std::size_t found) const;
  // Whether the user has interrupted the hunt (SIGINT), which then ends as if its time were over. A
  // second interrupt ends the program.
  bool is_broken_off() const;
  double seconds_left(std::size_t tried) const;
};

// Programs that were judged and moved the tool are few: that nothing was found says next to
// nothing.
bool judged_little(const hunt::HuntCount& count);

// What the words say of the programs. Throws UsageError.
hunt::HuntOptions hunt_options(const HuntWords& words);

// --profile, --everywhere, --reading, --settings and --time: which programs are tried.
void add_program_options(Command& command, HuntWords& words);

// --known-failures and --corpus
void add_known_failures(Command& command, std::string& known_failures, std::string& corpus);
// Makes what the known failures show on the subject no news, and says how much that is. Throws
// UsageError.
void know_failures(const HuntWords& words, hunt::HuntOptions& options);

// What is known before a hunt; each may be null.
struct HuntBefore {
  // Is given the hunt before it begins.
  std::function<void(hunt::Hunt&)> prepare;
  // The known cause of a finding, which is then not reported; empty: none.
  std::function<std::string(const hunt::Finding&)> known_cause;
};

// gonogo hunt
int hunt_programs(HuntWords words, const HuntBefore& before);

// gonogo hunt --campaign DIR
int hunt_campaign(HuntWords words);

// gonogo hunt --method properties
int hunt_properties(const HuntWords& words);

// gonogo hunt --method operations
int hunt_operations(const HuntWords& words);

}  // namespace gonogo::cli
