// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run a results file: <path>.lock is held while the results are written, and says by whom.
#pragma once

#include <stdexcept>
#include <string>

namespace gonogo::oracle {

// The results cannot go where they were sent, or a run cannot go on there: a sentence (wrong use).
class ResultsRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class ResultsLock {
 public:
  // Throws ResultsRefused when another run holds it, std::system_error.
  explicit ResultsLock(const std::string& results);
  ResultsLock(const ResultsLock&) = delete;
  ResultsLock& operator=(const ResultsLock&) = delete;
  ~ResultsLock();

 private:
  bool take();

  std::string path_;
  int descriptor_ = -1;
};

}  // namespace gonogo::oracle
