// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/case_queue.hpp"

#include <algorithm>

namespace gonogo::oracle {

CaseQueue::CaseQueue(const Corpus& corpus, std::vector<std::string> dialects, std::uint64_t seed,
                     Select select)
    : reader_([this, &corpus, wanted = std::move(dialects), seed, choose = std::move(select)] {
        read(corpus, wanted, seed, choose);
      }) {}

CaseQueue::~CaseQueue() {
  stop();
  if (reader_.joinable()) reader_.join();
}

void CaseQueue::read(const Corpus& corpus, const std::vector<std::string>& dialects,
                     std::uint64_t seed, const Select& select) {
  std::exception_ptr failure;
  try {
    CaseReader reader(corpus, Detail::to_run, dialects, seed);
    bool wanted = true;
    while (wanted) {
      std::optional<Case> test = reader.next();
      if (!test) break;
      if (auto chosen = select(*std::move(test))) wanted = put(*std::move(chosen), reader.part());
    }
  } catch (...) {
    failure = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  failure_ = failure;
  at_end_ = true;
  not_empty_.notify_all();
}

bool CaseQueue::put(Case test, double part) {
  std::unique_lock lock(mutex_);
  if (waiting_.size() >= kMost) {
    // Not for each case that is taken: that would wake a thread a case.
    not_full_.wait(lock, [&] { return stopped_ || waiting_.size() <= kMost / 2; });
  }
  if (stopped_) return false;
  waiting_.push_back(std::move(test));
  ++selected_;
  part_ = part;
  not_empty_.notify_one();
  return true;
}

bool CaseQueue::take(std::deque<Case>& into, std::size_t most, std::size_t takers) {
  std::unique_lock lock(mutex_);
  not_empty_.wait(lock, [&] { return at_end_ || stopped_ || !waiting_.empty(); });
  if (failure_) std::rethrow_exception(failure_);
  if (stopped_ || waiting_.empty()) return false;
  std::size_t count = std::min(most, waiting_.size());
  if (at_end_) count = std::min(count, std::max<std::size_t>(1, waiting_.size() / takers));
  for (; count > 0; --count) {
    into.push_back(std::move(waiting_.front()));
    waiting_.pop_front();
  }
  if (waiting_.size() <= kMost / 2) not_full_.notify_one();
  return true;
}

void CaseQueue::stop() {
  const std::lock_guard lock(mutex_);
  stopped_ = true;
  not_full_.notify_all();
  not_empty_.notify_all();
}

void CaseQueue::finish() {
  if (reader_.joinable()) reader_.join();
  if (failure_) std::rethrow_exception(failure_);
}

std::size_t CaseQueue::expected() const {
  const std::lock_guard lock(mutex_);
  if (at_end_ || part_ <= 0) return selected_;
  return std::max(selected_, static_cast<std::size_t>(static_cast<double>(selected_) / part_));
}

}  // namespace gonogo::oracle
