// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

namespace gonogo::expanders {

/// Place of a word in its block, from 0; kNowhere stands behind all words.
using Position = std::uint32_t;
inline constexpr Position kNowhere = std::numeric_limits<Position>::max();

/// The rules that a block breaks. Every rule is checked; of several broken ones that is reported
/// whose word stands first.
template <typename Kind>
class Complaints {
 public:
  /// An alarm and the letter of the word at fault; 0: none, or a name of several letters.
  struct Alarm {
    Kind kind{};
    char word = 0;
  };

  /// Notes a broken rule.
  void complain(Kind kind, char word, Position position) {
    if (in_alarm_ && position >= position_) return;
    in_alarm_ = true;
    alarm_ = {kind, word};
    position_ = position;
  }
  void complain(Kind kind) { complain(kind, 0, kNowhere); }
  bool in_alarm() const { return in_alarm_; }
  const Alarm& alarm() const { return alarm_; }

 private:
  bool in_alarm_ = false;
  Alarm alarm_;
  Position position_ = kNowhere;
};

}  // namespace gonogo::expanders
