// SPDX-License-Identifier: GPL-3.0-or-later
//
// The generator of GSK programs: its state, and the blocks that it can write.
#pragma once

#include <array>
#include <string>

#include "fuzz/generate/program_writer.hpp"
#include "fuzz/generate/writers.hpp"

namespace gonogo::generate {

class GskWriter final : ProgramWriter {
 public:
  GskWriter(Choices& choices, const GeneratorSettings& settings, ProgramKind kind,
            Distribution* distribution)
      : ProgramWriter(choices, settings, kind, distribution) {}

  GeneratedProgram run();

 private:
  // The cycle in force, as far as the writer knows.
  enum class Mode { basic, turning, pocket, helix, thread };

  void make_profile();
  void make_state();
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
  void run_out_words(Words& words, std::int64_t height, std::int64_t room, bool internal);
  bool may_lack_angle(bool no_run_out) const;
  // What changes modes, or has nothing to do with them.
  void mode_block();

  // Words; lengths are in least increments.
  std::string axis_word(std::size_t axis, std::int64_t most_mm);
  int decimals() const override;
  std::string stray_word() override;
  // D is a radius here, L a step.
  std::string_view letters_of_codes() const override { return "GMNFSTOHC"; }
  bool may_have(Fault fault, const std::string& word) const override;
  // The words of cycles have a range.
  const char* far_out() const override { return mode_ == Mode::basic ? "9000" : "1000000"; }
  std::array<std::size_t, 3> plane_axes() const;
  // A word of axis 0 is a diameter where X is: twice the length.
  std::int64_t scaled(std::size_t axis, std::int64_t value) const {
    return axis == 0 && profile_.x_diameter ? value * 2 : value;
  }

  reference::Units units_ = reference::Units::mm;
  reference::Plane plane_ = reference::Plane::g18;
  Mode mode_ = Mode::basic;
  std::int64_t pocket_infeed_ = 1;
  int turning_code_ = 0;  // 90, 92 or 94 in Mode::turning
};

}  // namespace gonogo::generate
