// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers, points and records as people read them.
#pragma once

#include <string>

#include "reference/record.hpp"

namespace gonogo::oracle::manual {

// Exact where a number is a short decimal, else six decimals.
std::string shown_number(const reference::Number& value);
// 'X'
char capital(reference::Axis axis);
// "X25 Z-30": the coordinates along `axes`.
std::string point_text(const reference::Position& at, const reference::AxisSet& axes);
// The records of a program, one after another: "feed to X25 Z-30, 300 mm/min", with shown_number.
class MotionTexts {
 public:
  explicit MotionTexts(const reference::Position& start) : at_(start) {}

  std::string next(const reference::Record& record);
  // A record that has no text.
  void pass(const reference::Record& record);
  // The place where the machine stands has another name: new less old coordinate.
  void rename(const reference::Position& shift);

 private:
  reference::Position at_;  // what a feed counts depends on which axes move
};

}  // namespace gonogo::oracle::manual
