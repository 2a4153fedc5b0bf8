// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/campaign.hpp"

#include <fmt/format.h>

#include <deque>
#include <exception>
#include <mutex>
#include <thread>

#include "campaign/case_judge.hpp"
#include "campaign/case_queue.hpp"
#include "campaign/selection.hpp"
#include "corpus/io/recheck.hpp"

namespace gonogo::oracle {
namespace {

// A subject that dies before its first record in each of so many first cases never worked: its
// command is wrong, and the run says nothing about what it implements.
constexpr std::size_t kDeadOnArrival = 5;
// A subject that has said who it is may have run other programs right.
constexpr std::size_t kDeadAfterGreeting = 20;
constexpr std::size_t kLongestNotes = 1000;

// What the workers share.
class Run {
 public:
  Run(const Corpus& corpus, const CampaignOptions& options, const ResultSink& results,
      const Progress& progress)
      : options_(options),
        results_(results),
        progress_(progress),
        known_failures_(options.known_failures),
        queue_(corpus, options.dialects, options.seed,
               [this](Case test) { return select(std::move(test)); }) {}

  void work(const SubjectMaker& make_subject);
  CampaignEnd end();

 private:
  std::optional<Case> select(Case test);
  void run_cases(CaseJudge& judge);
  void finish_case(CaseResult result);
  void note_life(const CaseResult& result);
  void note_greeting();

  const CampaignOptions& options_;
  const ResultSink& results_;
  const Progress& progress_;
  KnownFailures known_failures_;
  CampaignEnd end_;
  std::mutex mutex_;
  std::size_t finished_ = 0;
  std::size_t no_go_ = 0;
  std::size_t deaths_ = 0;  // before a record, while no case went otherwise
  std::size_t most_deaths_ = kDeadOnArrival;
  bool has_lived_ = false;
  bool stopped_ = false;
  std::exception_ptr failure_;
  CaseQueue queue_;  // last: its thread uses what stands above
};

// In the reading thread, the only one that notes cases.
std::optional<Case> Run::select(Case test) {
  known_failures_.note_case(test.id);
  if (!is_selected(options_, test)) return std::nullopt;
  auto merged = under(options_, std::move(test));
  if (!merged) {
    ++end_.left_out;
    return std::nullopt;
  }
  ++end_.cases;
  if (options_.is_done && options_.is_done(merged->id)) return std::nullopt;
  return merged;
}

void Run::note_greeting() {
  const std::lock_guard lock(mutex_);
  most_deaths_ = kDeadAfterGreeting;
}

void Run::note_life(const CaseResult& result) {
  if (has_lived_ || result.verdict.kind == VerdictKind::skip) return;
  const bool broke_down =
      result.verdict.kind == VerdictKind::crash || result.verdict.kind == VerdictKind::protocol;
  has_lived_ = !broke_down || !result.trace.empty();
  if (has_lived_ || ++deaths_ < most_deaths_) return;
  const std::string notes = result.notes.substr(0, kLongestNotes);
  throw SubjectUnusable(fmt::format(
      "The subject died at once in each of the first {} cases, so that nothing was judged. {}{}{}",
      most_deaths_, result.verdict.message, notes.empty() ? "" : "\nIt wrote to stderr: ", notes));
}

void Run::finish_case(CaseResult result) {
  const std::lock_guard lock(mutex_);
  if (stopped_) return;
  note_life(result);
  known_failures_.apply(result);
  ++finished_;
  if (decision(result.verdict.kind) == Decision::no_go) {
    ++no_go_;
    if (options_.fail_fast) stopped_ = true;
  }
  try {
    results_(result);
  } catch (...) {
    stopped_ = true;  // before another worker gets the lock: nothing more can be written
    throw;
  }
  if (progress_)
    progress_(finished_, options_.expected > 0 ? options_.expected : queue_.expected(), no_go_);
  if (stopped_) queue_.stop();
}

// Cases are taken ahead as far as the subject takes programs ahead. A result waits for the next
// one, because the end of the subject belongs to the last.
void Run::run_cases(CaseJudge& judge) {
  const std::size_t window = judge.window();
  const auto takers = static_cast<std::size_t>(options_.jobs);
  std::deque<Case> ahead;
  std::size_t announced = 0;  // of them
  std::optional<std::pair<Case, CaseResult>> last;
  const auto finish_last = [&] {
    if (last) finish_case(std::move(last->second));
    last.reset();
  };
  while (true) {
    if (ahead.size() <= window / 2) queue_.take(ahead, window - ahead.size(), takers);
    if (ahead.empty()) break;
    judge.prepare(ahead.front());
    while (announced < ahead.size() && judge.announce(ahead[announced])) ++announced;
    CaseResult result = judge.judge(ahead.front());
    finish_last();
    last.emplace(std::move(ahead.front()), std::move(result));
    if (decision(last->second.verdict.kind) == Decision::no_go) finish_last();
    ahead.pop_front();
    if (announced > 0) --announced;
    const std::lock_guard lock(mutex_);
    if (stopped_) return;
  }
  if (last) judge.finish(last->first, last->second);
  finish_last();
}

void Run::work(const SubjectMaker& make_subject) {
  try {
    CaseJudge judge(options_, make_subject);
    if (judge.info().greeted) note_greeting();
    run_cases(judge);
  } catch (...) {
    {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      stopped_ = true;
    }
    queue_.stop();
  }
}

CampaignEnd Run::end() {
  if (failure_) std::rethrow_exception(failure_);
  queue_.finish();
  end_.complete = !stopped_;
  if (end_.complete) end_.stale = known_failures_.stale();
  return std::move(end_);
}

}  // namespace

std::size_t count_cases(const Corpus& corpus, const CampaignOptions& options) {
  std::size_t count = 0;
  CaseReader reader(corpus, Detail::to_run, options.dialects);
  while (auto test = reader.next()) {
    if (!is_selected(options, *test)) continue;
    auto merged = under(options, *std::move(test));
    if (merged && !(options.is_done && options.is_done(merged->id))) ++count;
  }
  return count;
}

std::optional<std::string> first_wrong_vector(const Corpus& corpus,
                                              const CampaignOptions& options) {
  CaseReader reader(corpus, Detail::whole, options.dialects);
  while (const auto test = reader.next()) {
    if (!is_selected(options, *test)) continue;
    if (auto fault = recheck(*test)) return fmt::format("{}: {}", test->id, *fault);
  }
  return std::nullopt;
}

CampaignEnd run_campaign(const Corpus& corpus, const CampaignOptions& options,
                         const SubjectMaker& make_subject, const ResultSink& results,
                         const Progress& progress) {
  Run run(corpus, options, results, progress);
  std::vector<std::thread> workers;
  for (int i = 1; i < options.jobs; ++i) {
    workers.emplace_back([&] { run.work(make_subject); });
  }
  run.work(make_subject);
  for (std::thread& worker : workers) worker.join();
  return run.end();
}

}  // namespace gonogo::oracle
