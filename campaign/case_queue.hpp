// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cases of a campaign on their way from the corpus to the workers: read in a thread of its own,
// never more than a few hundred ahead.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "corpus/io/corpus.hpp"

namespace gonogo::oracle {

class CaseQueue {
 public:
  // The case to run for a case of the corpus; nothing: it is not run.
  using Select = std::function<std::optional<Case>(Case)>;

  // Begins to read the cases of these dialects (none: of all), in the order of the seed. The corpus
  // must outlive the queue; `select` is called in the reading thread.
  CaseQueue(const Corpus& corpus, std::vector<std::string> dialects, std::uint64_t seed,
            Select select);
  CaseQueue(const CaseQueue&) = delete;
  CaseQueue& operator=(const CaseQueue&) = delete;
  ~CaseQueue();

  // Appends the next cases, at most `most` and at least one unless there are no more; shares the
  // last of them out among `takers`. False when there are none. Throws what the reading threw.
  bool take(std::deque<Case>& into, std::size_t most, std::size_t takers);
  // Nobody will take any more.
  void stop();
  // Waits until the corpus has been read or `stop` was called. Throws what the reading threw.
  void finish();

  // How many cases there are in all: exact once the corpus has been read, else estimated.
  std::size_t expected() const;

 private:
  void read(const Corpus& corpus, const std::vector<std::string>& dialects, std::uint64_t seed,
            const Select& select);
  bool put(Case test, double part);

  static constexpr std::size_t kMost = 512;
  mutable std::mutex mutex_;
  std::condition_variable not_full_;
  std::condition_variable not_empty_;
  std::deque<Case> waiting_;
  std::size_t selected_ = 0;
  double part_ = 0;  // of the corpus that has been read
  bool at_end_ = false;
  bool stopped_ = false;
  std::exception_ptr failure_;
  std::thread reader_;  // last: it uses all of the above
};

}  // namespace gonogo::oracle
