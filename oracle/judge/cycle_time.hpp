// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long a program takes, as far as its records say: its cuts over their feeds and its dwells.
// Lengths of arcs and of slanting lines are enclosed, never rounded.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "oracle/motion/motion.hpp"

namespace gonogo::oracle {

// A sum that lies in [low, high].
class EnclosedSum {
 public:
  void add(const Number& term);
  // Exact where all terms are rational, else an enclosure.
  Number value() const;

 private:
  Number low_;
  Number high_;
};

// Numbers are exact, or enclosed to 2^-64 for each motion.
class CycleTime {
 public:
  // `start`: where the machine stands before the first record.
  explicit CycleTime(const Position& start) : at_(start) {}

  void take(const Record& record);
  // The machine gets where the record ends, and no time is counted.
  void leave_out(const Record& record);
  // The position gets a new name: new less old coordinate.
  void rename(const Position& by) { shift(at_, by); }

  Number feed_seconds() const { return feed_.value(); }  // cuts in mm/min
  Number revolutions() const { return turns_.value(); }  // of the spindle: cuts in mm/rev, threads
  Number dwell_seconds() const { return dwell_.value(); }
  Number rapid_length() const { return rapid_.value(); }  // mm along straight lines
  // Motions whose length is not known here: of rotary axes, circles askew in space.
  std::size_t left_out() const { return left_out_; }

 private:
  void take_motion(const Motion& motion);

  Position at_;
  EnclosedSum feed_;
  EnclosedSum turns_;
  EnclosedSum dwell_;
  EnclosedSum rapid_;
  std::size_t left_out_ = 0;
};

// What a program's times are made of, for people.
struct TimePart {
  std::string_view what;  // "cuts"
  std::string_view unit;  // "s"
  Number amount;
};
// Cuts and dwells, turns of the spindle, the length of traverses.
std::array<TimePart, 4> parts_of(const CycleTime& time);

// "30 s", "3.667 s (exactly 11/3)", "15.708 s (rounded)": exact where it is a short number, else
// rounded to three decimals, and marked so.
std::string amount_text(const TimePart& part);

// What is said of part number `part`: a sentence with a blank before it where `got` is off by a
// factor between units; empty: it is not.
std::string time_hint(std::size_t part, const Number& want, const Number& got);

}  // namespace gonogo::oracle
