// SPDX-License-Identifier: GPL-3.0-or-later
//
// The generator of HNC programs: its state, and the blocks that it can write.
#pragma once

#include <array>
#include <cstdlib>
#include <optional>
#include <string>

#include "fuzz/generate/program_writer.hpp"
#include "fuzz/generate/writers.hpp"

namespace gonogo::generate {

class HncWriter final : ProgramWriter {
 public:
  HncWriter(Choices& choices, const GeneratorSettings& settings, ProgramKind kind,
            Distribution* distribution)
      : ProgramWriter(choices, settings, kind, distribution) {}

  GeneratedProgram run();

 private:
  enum Axis : std::size_t { x, z };

  void make_profile();
  void make_state();
  void make_offsets();
  void make_head();
  void make_block();
  void repeat_block();
  // In hnc_modes.cpp: what changes modes, or has nothing to do with them.
  void mode_block();
  void setting_block();
  void outside_block();
  void mode_words(Words& words);
  void change_offset(Words& words);
  void set_position();
  // In hnc_turning.cpp.
  void basic_block();
  void thread_line();
  void arc_block();
  void cut_block(int code);
  // In hnc_thread.cpp.
  void thread_block();
  void near_ratio_words(Words& words);
  void run_out_words(Words& words);
  std::string e_word(std::int64_t length);
  void start_words(Words& words);
  void lead_words(Words& words, bool entry);
  // In hnc_pecking.cpp.
  void drill_block();
  void groove_block();
  void peck_words(Words& words, bool entry);
  void tiny_pecks(Words& words, Axis axis);
  void bottom_word(Words& words, Axis axis, bool entry);
  void width_words(Words& words);
  bool counts_from_withdrawn() const;
  bool keeps_words() const;

  // Words. Lengths are in least increments; values are lengths as a word of the axis counts them.
  std::int64_t any_sign(std::int64_t length) { return choices_.one_in(2) ? -length : length; }
  // A word of X is a diameter where X is: twice the length.
  std::int64_t scaled(Axis axis, std::int64_t length) const {
    return axis == x && diameter_ ? length * 2 : length;
  }
  // To a place at random, absolute or not.
  std::string axis_word(Axis axis, std::int64_t most_units);
  // By this much from where the tool stands.
  std::string travel_word(Axis axis, std::int64_t value);
  // Both end points of a cycle; seldom one.
  void end_words(Words& words, std::int64_t most_units);
  // The code where the command changes, and now and then where it does not. Whether it changes.
  bool enter(Words& words, int code);
  bool lacks_axis(std::uint32_t one_in, std::uint32_t one_in_refused);
  // Also a word that the command has no use for.
  void feed_words(Words& words, bool entry, const char* unused);
  // The tool is where the words led. A cycle leaves it where it was.
  void arrive() { at_ = target_; }
  // Its position is unknown now, and may be far away.
  void lose_place();
  void write(Words words);

  int decimals() const override { return units_ == reference::Units::inch ? 4 : 3; }
  std::string stray_word() override;
  bool may_have(Fault fault, const std::string& word) const override;
  std::string printed(const std::string& word) override;
  void on_fault() override { lose_place(); }

  using Place = std::array<std::optional<std::int64_t>, 2>;

  reference::Units units_ = reference::Units::mm;
  bool diameter_ = true;
  bool incremental_ = false;
  int code_ = 0;                 // of the motion group
  std::int64_t peck_ = 0;        // Q of the pecking cycle in force; 0: none
  std::int64_t withdrawal_ = 0;  // R of it
  bool tiny_ = false;            // the Q in force is one of a few increments
  bool counted_ = false;         // a number of axial steps is in force
  bool far_ = false;             // absolute words may lead far
  // Where the tool stands and where the block leads, as words would say it, as far as known.
  Place at_;
  Place target_;
};

}  // namespace gonogo::generate
