// SPDX-License-Identifier: GPL-3.0-or-later
//
// The generator of RS274/NGC programs: its state, and the blocks that it can write.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "generate/ngc_generator.hpp"
#include "generate/program_writer.hpp"

namespace gonogo::generate {

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
  bool is_g80_forgotten() const {
    return profile_.readings.is(reference::ReadingKey::ngc_g80_beside, "ignored");
  }
  std::array<Axis, 3> plane_axes() const;

  // The tool is where the words led.
  void arrive() { at_ = target_; }
  // Where it is now cannot be told.
  void lose_place() { at_ = target_ = {}; }
  void write(Words words);
  std::string beside_whole(const std::string& word);

  int decimals() const override { return 4; }
  std::string stray_word() override;
  bool may_have(Fault fault, const std::string& word) const override;
  std::string printed(const std::string& word) override;
  std::string head() override;
  void on_fault() override { lose_place(); }

  using Place = std::array<std::optional<std::int64_t>, 5>;

  bool opened_ = false;  // the program, by a %
  bool inch_ = false;
  bool incremental_ = false;
  bool absolute_centre_ = false;
  int plane_ = 17;
  int motion_ = -1;        // code of the motion group; -1: none
  bool has_code_ = false;  // the block has a code of the motion group
  bool dwells_ = false;    // the block has a G4
  bool rotary_ = false;    // the block turns a rotary axis alone
  // Where the tool stands and where the block leads, as words would say it, as far as known.
  Place at_;
  Place target_;
};

}  // namespace gonogo::generate
