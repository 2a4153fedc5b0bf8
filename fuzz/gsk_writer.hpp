// SPDX-License-Identifier: GPL-3.0-or-later
//
// The generator of GSK programs: its state, and the blocks that it can write.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "fuzz/gsk_generator.hpp"

namespace gonogo::fuzz {

class GskWriter {
 public:
  GskWriter(Choices& choices, const GskSettings& settings, Distribution* distribution)
      : choices_(choices), settings_(settings), distribution_(distribution) {}

  GeneratedProgram run();

 private:
  // The cycle in force, as far as the writer knows.
  enum class Mode { basic, turning, pocket, helix, thread };
  using Words = std::vector<std::string>;

  void count(const std::string& name) {
    if (distribution_ != nullptr) ++(*distribution_)[name];
  }
  void make_profile();
  void make_head();
  void make_block();

  // In gsk_turning.cpp.
  void basic_block();
  void arc_block();
  void turning_block();
  // In gsk_milling.cpp.
  void pocket_block();
  void helix_block();
  void thread_block();
  void mill_place(Words& words, std::int64_t depth);
  void mill_r(Words& words, bool down);
  void run_out_words(Words& words, std::int64_t height, std::int64_t room);
  // What changes modes, or has nothing to do with them.
  void mode_block();

  // Words; lengths are in least increments.
  std::int64_t length(std::int64_t most_mm);
  std::string word(char address, std::int64_t increments) const;
  std::string axis_word(std::size_t axis, std::int64_t most_mm);
  std::string feed_word();
  int decimals() const;
  std::int64_t unit() const;  // increments of one mm or inch
  std::array<std::size_t, 3> plane_axes() const;
  // A word of axis 0 is a diameter where X is: twice the length.
  std::int64_t scaled(std::size_t axis, std::int64_t value) const {
    return axis == 0 && profile_.x_diameter ? value * 2 : value;
  }

  // Writes the block, now and then with one thing put wrong.
  void put(Words words);
  void spoil(Words& words);

  Choices& choices_;
  const GskSettings& settings_;
  Distribution* distribution_;
  reference::Profile profile_;
  reference::Units units_ = reference::Units::mm;
  reference::Plane plane_ = reference::Plane::g18;
  Mode mode_ = Mode::basic;
  int turning_code_ = 0;  // 90, 92 or 94 in Mode::turning
  std::string text_;
};

}  // namespace gonogo::fuzz
