// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/hunt_board.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "cli/hunt_causes.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "oracle/records/text.hpp"

namespace gonogo::cli {
namespace {

// "2:03:05"
std::string clock_text(double seconds) {
  const auto whole = static_cast<long>(seconds);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

HuntBoard::HuntBoard(const HuntWords& words, const HuntEnd& end)
    : words_(words),
      end_(end),
      on_(::isatty(STDERR_FILENO) == 1),
      jobs_(static_cast<std::size_t>(words.jobs)) {}

HuntBoard::~HuntBoard() {
  close();
}

void HuntBoard::close() {
  const std::lock_guard lock(mutex_);
  clear();
}

void HuntBoard::tell(const hunt::Finding& finding, const std::string& folder,
                     const std::string& id) {
  const std::lock_guard lock(mutex_);
  if (!told_.insert(finding.signature).second) return;
  ++findings_;
  found_ = Clock::now();
  clear();
  Output output;
  output.text() =
      fmt::format("{}. {}  {}\n{}\n", findings_, finding.signature.text(), id,
                  finding_text(finding, reduce_command(folder + "/findings/" + id, words_.trial)));
  output.tell();
}

bool HuntBoard::take_one(std::size_t job, const hunt::Hunt& hunt) {
  std::size_t tried = programs_;
  do {
    if (failed_ || end_.reached(tried, findings_)) return false;
  } while (!programs_.compare_exchange_weak(tried, tried + 1));
  if (!on_) return true;
  const std::lock_guard lock(mutex_);
  Job& mine = jobs_[job - 1];
  mine.round = hunt.count();
  mine.features = hunt.pool().features();
  mine.in_programs = hunt.pool().size();
  if (Clock::now() - shown_ >= std::chrono::milliseconds(200)) show();
  return true;
}

void HuntBoard::round_done(std::size_t job, const hunt::HuntCount& count) {
  {
    const std::lock_guard lock(mutex_);
    ++rounds_;
    Job& mine = jobs_[job - 1];
    mine.before += count;
    mine.round = {};
  }
  // The folder says what there is now.
  const std::lock_guard lock(folder_mutex_);
  tell_campaign(words_.campaign, words_.trial);
}

void HuntBoard::fail(const char* what) {
  const std::lock_guard lock(mutex_);
  failed_ = true;
  clear();
  complain("gonogo: {}\n", what);
}

std::vector<std::string> HuntBoard::lines(std::size_t columns) const {
  using Seconds = std::chrono::duration<double>;
  const double seconds = Seconds(Clock::now() - end_.begin).count();
  hunt::HuntCount count;
  const Job* widest = &jobs_.front();  // that has most features of the reference in its round
  for (const Job& job : jobs_) {
    count += job.before;
    count += job.round;
    if (job.features > widest->features) widest = &job;
  }
  const auto percent = [&](std::size_t part) {
    return part * 100 / std::max<std::size_t>(1, count.programs);
  };
  const double a_second = static_cast<double>(count.programs) / std::max(seconds, 0.001);
  const bool has_end = end_.programs != 0 || end_.time.count() != 0;
  const std::size_t findings = findings_;
  std::vector<std::string> lines = {
      fmt::format("gonogo hunt: {}, {} in {}", oracle::visible(words_.trial.subject),
                  words_.dialect, oracle::visible(words_.campaign)),
      fmt::format("  run time  {}{}", clock_text(seconds),
                  has_end ? fmt::format(", about {} left", clock_text(end_.seconds_left(programs_)))
                          : std::string()),
      fmt::format("  programs  {}, {:.0f} a second; {} rounds done by {} jobs", count.programs,
                  a_second, rounds_, jobs_.size()),
      fmt::format("  judged    {} %, with motion {} %; skipped {} %, undecided {} %, too long {} %",
                  percent(count.judged), percent(count.moved), percent(count.skipped),
                  percent(count.gaps), percent(count.too_long)),
      fmt::format("  reached   {} features of the reference in {} programs", widest->features,
                  widest->in_programs),
      findings == 0
          ? std::string("  findings  none is new")
          : fmt::format("  findings  {} new, the last {} ago; {} programs are NO-GO", findings,
                        clock_text(Seconds(Clock::now() - found_).count()), count.no_go)};
  for (std::string& line : lines) {
    if (line.size() > columns) line.resize(columns);
  }
  return lines;
}

void HuntBoard::show() {
  shown_ = Clock::now();
  const auto shown = lines(columns_of_terminal(STDERR_FILENO) - 1);
  std::string text = lines_ == 0 ? std::string() : fmt::format("\033[{}A", lines_);
  for (const std::string& line : shown) text += line + "\033[K\n";
  draw("{}", text);
  lines_ = shown.size();
}

// The lines go, and what is printed next stands in their place.
void HuntBoard::clear() {
  if (lines_ == 0) return;
  draw("\033[{}A\033[J", lines_);
  lines_ = 0;
}

}  // namespace gonogo::cli
