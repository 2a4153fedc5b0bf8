// SPDX-License-Identifier: GPL-3.0-or-later
//
// How fast the replies of a subject come to which programs are sent ahead, and how long they may
// gather before the next look at its output: to look for each of them wakes a thread, and costs
// subject and runner as much as a short program does.
#pragma once

#include <chrono>
#include <cstddef>

namespace gonogo::oracle {

class ReplyPace {
 public:
  using Duration = std::chrono::steady_clock::duration;

  // With `open` programs sent and not answered; nil: look at once. So short that the subject never
  // runs out of programs, and no longer than a millisecond.
  Duration wait(std::size_t open) const;
  // `replies` of `open` programs were answered since the last look, `time` ago.
  void note(std::size_t replies, std::size_t open, Duration time);

 private:
  Duration pace_{0};  // of one reply; nil: not known
};

}  // namespace gonogo::oracle
