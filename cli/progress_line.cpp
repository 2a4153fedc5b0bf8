// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress_line.hpp"
#include "cli/output.hpp"

#include <unistd.h>

#include <utility>

namespace gonogo::cli {

ProgressLine::ProgressLine(std::string subject)
    : subject_(std::move(subject)), on_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (on_) draw("\r\033[K");
}

void ProgressLine::show(std::size_t done, std::size_t all, std::size_t no_go) {
  if (!on_) return;
  const auto now = std::chrono::steady_clock::now();
  if (done < all && now - shown_ < std::chrono::milliseconds(100)) return;
  shown_ = now;
  const std::chrono::duration<double> spent = now - start_;
  const double left = spent.count() / static_cast<double>(done) * static_cast<double>(all - done);
  draw("\r\033[K{}: {} of {} cases, {} NO-GO, about {:.0f} s left", oracle::visible(subject_), done,
       all, no_go, left);
}

}  // namespace gonogo::cli
