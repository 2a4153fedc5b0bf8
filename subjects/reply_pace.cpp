// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/reply_pace.hpp"

#include <algorithm>

namespace gonogo::oracle {
namespace {

constexpr std::size_t kFew = 8;  // programs, too few to let the subject work through them unseen
constexpr ReplyPace::Duration kMost = std::chrono::milliseconds(1);

}  // namespace

ReplyPace::Duration ReplyPace::wait(std::size_t open) const {
  // What comes this slowly does not gather.
  if (open < kFew || 2 * pace_ > kMost) return {};
  return std::min(kMost, pace_ * static_cast<Duration::rep>(open / 4));
}

void ReplyPace::note(std::size_t replies, std::size_t open, Duration time) {
  if (replies == 0) return;
  const Duration measured = time / static_cast<Duration::rep>(replies);
  if (replies < open) {
    pace_ = measured;
  } else {
    // It had nothing more to do, who knows for how long.
    pace_ = (pace_ == Duration::zero() ? measured : std::min(pace_, measured)) / 2;
  }
}

}  // namespace gonogo::oracle
