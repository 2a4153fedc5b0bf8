// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace gonogo::cli {

// A line that is rewritten in place on a terminal; nothing in a pipe.
class ProgressLine {
 public:
  explicit ProgressLine(std::string subject);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  bool is_on() const { return on_; }
  // Called after each case.
  void show(std::size_t done, std::size_t all, std::size_t no_go);

 private:
  std::string subject_;
  bool on_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point shown_{};
};

}  // namespace gonogo::cli
