// SPDX-License-Identifier: GPL-3.0-or-later
//
// When the rounds of a long hunt ended and how long they took, a line each, apart from what the
// hunt found: that is the same whenever it ran.
//   DIR/rounds.jsonl
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "oracle/records/text.hpp"

namespace gonogo::hunt {

struct RoundTime {
  std::size_t round = 0;  // from 1
  std::chrono::system_clock::time_point ended;
  std::chrono::duration<double> took{0};
  std::size_t programs = 0;
};

// Throws std::system_error.
void append_round_time(const std::string& folder, const RoundTime& time);
// In the order of rounds; of one that was done again the last. A line that was not written to its
// end says nothing. Empty without the file.
std::vector<RoundTime> read_round_times(const std::string& folder);

using oracle::date_text;

}  // namespace gonogo::hunt
