// SPDX-License-Identifier: GPL-3.0-or-later
//
// The generator of RS274/NGC programs: its state, and the blocks that it can write.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "fuzz/generate/program_writer.hpp"
#include "fuzz/generate/writers.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::generate {

// For a code of the motion group.
constexpr bool is_pecking(int motion) {
  return motion == 73 || motion == 83;
}
constexpr bool is_tapping(int motion) {
  return motion == 74 || motion == 84;
}
constexpr bool is_dwelling(int motion) {
  return motion == 82 || motion == 86 || motion == 89;
}
constexpr bool is_hole_cycle(int motion) {
  return motion == 73 || motion == 74 || (motion >= 81 && motion <= 89);
}

class NgcWriter final : ProgramWriter {
 public:
  NgcWriter(Choices& choices, const GeneratorSettings& settings, ProgramKind kind,
            Distribution* distribution)
      : ProgramWriter(choices, settings, kind, distribution) {}

  GeneratedProgram run();

 private:
  enum Axis : std::size_t { x, y, z, a, c };
  // Two lengths along the axes of the plane.
  struct Pair {
    std::int64_t p = 0;
    std::int64_t q = 0;
  };

  void make_profile();
  void make_state();
  void make_head();
  void make_block();
  void make_end();
  void start_modes(int motion);
  // In ngc_modes.cpp: what changes modes, or has nothing to do with them.
  void mode_block();
  void setting_block();
  void units_block();
  void dwell_block();
  void outside_block();
  void mode_words(Words& words);
  // In ngc_further_modes.cpp: some blocks under a mode, and the way back.
  void further_modes();
  void feed_mode_blocks();
  void diameter_blocks();
  void saved_modes_blocks();
  void polar_blocks();
  void polar_words(Words& words);
  // In ngc_motion.cpp.
  void line_block();
  void rotary_block();
  // In ngc_arcs.cpp.
  void arc_block();
  void radius_words(Words& words);
  void centre_words(Words& words);
  void end_words(Words& words, Pair travel);
  void offset_words(Words& words, Pair offset);
  void helix_words(Words& words);
  void arc_faults(Words& words, bool by_radius);
  Pair turned(Pair from);
  std::int64_t beside(std::int64_t radius);
  void choose_plane(Words& words);
  void set_plane(Words& words);
  // In ngc_cycles.cpp: cycles of holes.
  void cycle_block();
  void cycle_modes(Words& words, bool first);
  void level_words(Words& words, bool first);
  void place_words(Words& words, std::int64_t holes);
  void count_cycle(bool first);
  bool keeps_levels(bool first) const;
  std::int64_t above_tool();
  std::int64_t hole_depth();
  bool levels_are_told() const;
  std::optional<std::int64_t> clear_level() const;
  // In ngc_cycle_words.cpp: what else their blocks have.
  void own_words(Words& words, bool first);
  void peck_words(Words& words, bool first);
  std::int64_t peck_length();
  std::int64_t hole_count(Words& words);
  void cycle_faults(Words& words);
  void replace(Words& words, std::string_view text);
  std::string_view letters_unused_by_cycle() const;
  // In ngc_threads.cpp.
  void synchronous_block();
  void threading_block();
  std::int64_t pass_words(Words& words);
  void taper_words(Words& words, std::int64_t travel, std::int64_t depth);
  void threading_faults(Words& words);
  // M3 or M4, where the spindle does not turn so.
  void spindle_words(Words& words, std::initializer_list<int> senses);
  std::string spindle_word(int sense);

  // Words. Lengths are in least increments.
  std::int64_t any_sign(std::int64_t length) { return choices_.one_in(2) ? -length : length; }
  std::string code(int number);
  // To a place at random, absolute or not.
  std::string axis_word(Axis axis, std::int64_t most_units);
  // By this much from where the tool stands. REQUIRES: G91 holds, or the place is known.
  std::string travel_word(Axis axis, std::int64_t value);
  // The code where the motion changes, and now and then where it does not.
  void enter(Words& words, int motion);
  void set_incremental(Words& words, bool incremental);
  void feed_words(Words& words);
  // A word that no code of the block uses; `letters` are such.
  void unused_words(Words& words, std::string_view letters);
  bool is_g80_forgotten() const { return profile_.readings.is("ngc.g80-beside=ignored"_reading); }
  std::array<Axis, 3> plane_axes() const;

  // The tool is where the words led.
  void arrive() { at_ = target_; }
  // Its position is unknown now.
  void lose_place() { at_ = target_ = {}; }
  // `whole`: letters of its words that have to be whole numbers.
  void write(Words words, std::string_view whole = "GMP");
  std::string beside_whole(const std::string& word);

  int decimals() const override { return 4; }
  std::string stray_word() override;
  bool may_have(Fault fault, const std::string& word) const override;
  bool may_be_far(char address) const;
  std::string printed(const std::string& word) override;
  std::string head() override;
  void on_fault() override {
    lose_place();
    sticky_ = {};
    initial_.reset();
  }

  using Place = std::array<std::optional<std::int64_t>, 5>;
  // Numbers of a cycle that stay in force, as far as known.
  struct StickyWords {
    std::optional<std::int64_t> r;
    std::optional<std::int64_t> depth;
    std::optional<std::int64_t> q;
  };
  static constexpr int kG33Point1 = 331;

  bool opened_ = false;  // the program, by a %
  bool inch_ = false;
  bool incremental_ = false;
  bool absolute_centre_ = false;
  int plane_ = 17;
  int motion_ = -1;             // code of the motion group; -1: none
  bool has_code_ = false;       // the block has a code of the motion group
  bool dwells_ = false;         // the block has a G4
  bool rotary_ = false;         // the block turns a rotary axis alone
  bool inverse_time_ = false;   // G93: an F in each block
  bool is_polar_ = false;       // the places of a cycle's block
  std::string mode_to_enter_;   // beside the motion that comes; empty: none
  int spindle_ = 5;             // M3, M4 or M5
  bool spindle_named_ = false;  // in the block
  int retract_ = 0;             // G98 or G99; 0: not said
  int series_plane_ = 0;        // of the cycles one behind the other; 0: changed since
  bool minute_pecks_ = false;   // Q is small: a hole of common depth would have thousands
  std::string_view whole_;      // letters of words that have to be whole numbers
  StickyWords sticky_;
  std::optional<std::int64_t> initial_;  // level of the series
  // Where the tool stands and where the block leads, as words would say it, as far as known.
  Place at_;
  Place target_;
};

}  // namespace gonogo::generate
