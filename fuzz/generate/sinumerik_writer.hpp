// SPDX-License-Identifier: GPL-3.0-or-later
//
// The generator of SINUMERIK programs: the words and blocks that it can write.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/generate/program_writer.hpp"
#include "fuzz/generate/sinumerik_state.hpp"
#include "fuzz/generate/writers.hpp"

namespace gonogo::generate {

class SinumerikWriter final : ProgramWriter {
 public:
  SinumerikWriter(std::string_view dialect, Choices& choices, const GeneratorSettings& settings,
                  ProgramKind kind, Distribution* distribution)
      : ProgramWriter(choices, settings, kind, distribution), dialect_(dialect) {}

  GeneratedProgram run();

 private:
  enum Motion { kTraverse, kLine, kClockwise, kCounterclockwise, kCip, kCt };
  enum class Kind {
    line,
    arc,
    pole,
    dwell,
    frame,
    cycle,
    other
  };  // of a block, for what may be put wrong in it
  enum class How { plain, absolute, incremental };
  // Two lengths along the axes of a plane.
  struct Pair {
    std::int64_t p = 0;
    std::int64_t q = 0;
  };
  using Triple = std::array<std::int64_t, 3>;

  void make_profile();
  void make_state();
  void make_parameters();
  void make_head();
  void make_block();
  void resync();
  std::string words_of_a_place();

  // In sinumerik_modes.cpp: what changes modes, or has nothing to do with them.
  void mode_block();
  void setting_block();
  void assignment_block();
  void dwell_block();
  void outside_block();
  void ignored_block();
  void machine_block();
  void syntax_line();
  void units_words(Words& words);
  void feed_mode_words(Words& words);
  void mode_words(Words& words);
  void set_plane(Words& words, int asked);
  int any_parameter();
  void forget_pole();

  // In sinumerik_lines.cpp.
  void line_block();
  void rotary_block();
  void polar_line_block();
  void pole_block();
  void polar_words(Words& words, std::int64_t angle, std::int64_t radius);
  void polar_target(std::int64_t angle, std::int64_t radius);
  std::int64_t any_angle();
  void third_axis_word(Words& words);

  // In sinumerik_arcs.cpp.
  void arc_block();
  void centre_arc(Words& words, int plane);
  void radius_arc(Words& words, int plane);
  void angle_arc(Words& words);
  void polar_arc(Words& words);
  void full_circle(Words& words);
  void centre_words(Words& words, int plane, Pair offset);
  void end_words(Words& words, int plane, Pair travel, bool both);
  void helix_words(Words& words);
  void arc_faults(Words& words);
  Pair any_spoke();
  Pair turned(Pair from);
  std::int64_t beside(std::int64_t radius);
  void finish_arc(int plane, double p, double q);

  // In sinumerik_space.cpp.
  void cip_block();
  void ct_chain();
  bool ct_block();
  bool ct_words(Words& words, const Direction& tangent);
  bool straight_on(Words& words);
  void finish_ct(const Direction& tangent);
  std::array<Triple, 2> any_two_points();
  std::array<Triple, 2> two_points_in_line();

  // In sinumerik802s_frames.cpp.
  bool is_802s() const { return profile_.dialect == "sinumerik802s"; }
  bool make_802s_block();
  void make_tools();
  void clear_frame_lines();
  int plane_in_frame(int asked);
  void frame_block();
  void take_pole_back();
  void go_there_in_frame();
  void offset_words(Words& words);
  void rotation_words(Words& words, bool adds);
  Place in_base() const;
  Place in_frame(const Place& base) const;

  // In sinumerik802s_cycles.cpp: R parameters in thousandths, and the calls that read them.
  void assign(const std::map<int, std::int64_t>& values);
  void choose_planes(std::map<int, std::int64_t>& values);
  void choose_pocket(std::map<int, std::int64_t>& values, std::int64_t radius);
  void choose_depths(std::map<int, std::int64_t>& values);
  void break_pocket(std::map<int, std::int64_t>& values);
  bool tool_block(int tool);
  void call(const char* name);
  void leave_inches();
  void drilling_block();
  void pocket_block();

  // In sinumerik_words.cpp. Lengths are counts of 0.001 mm or inch, as words have them.
  std::int64_t any_sign(std::int64_t length) { return choices_.one_in(2) ? -length : length; }
  std::string code(int number);
  std::string constant(std::int64_t counts);
  std::string expression(std::int64_t counts);
  std::string named(std::string_view name, std::int64_t counts, How how = How::plain);
  // The word that leads an axis by `travel` from `from`; absolute only where that has a word.
  std::string travel_word(std::string_view name, const Coordinate& from, std::int64_t travel);
  std::string axis_word(std::size_t axis, std::int64_t travel);
  // To a place at random, absolute or not; or to one that is no decimal.
  std::string random_word(std::size_t axis, std::int64_t most_units);
  std::string irrational_word(std::size_t axis);
  std::string rotary_word();
  void enter(Words& words, Motion motion);
  void feed_words(Words& words);
  std::string new_feed();

  // The tool is where the words led: along a line, or a curve that ends in this direction.
  void arrive_straight();
  void arrive(const Direction& tangent);
  bool plane_is_exact(int plane) const;
  void write(Words words, Kind kind);

  int decimals() const override { return 3; }
  std::string stray_word() override;
  bool may_have(Fault fault, const std::string& word) const override;
  std::string printed(const std::string& word) override;
  std::string head() override;
  std::string tail() override;
  std::string negated(const std::string& word) const override;
  std::string with_value(const std::string& word, const char* value) const override;
  void on_fault() override { faulted_ = true; }

  std::string_view dialect_;
  SinumerikState state_;
  std::vector<std::int64_t> tools_;  // of sinumerik802s: radii, 0.001 mm; tool 1 first
  Place target_;                     // of the block that is being written
  Words assignments_;                // to R parameters, before the other words of the block
  Kind kind_ = Kind::other;          // of the block that is being written
  bool may_assign_ = true;
  bool inch_feed_ = false;      // the reading sie.g70.f = inch
  bool spindle_alarm_ = false;  // the reading sie.spindle = alarm
  bool winds_ = false;          // the reading sie.arc.plane = helix
  bool keeps_pole_ = false;     // the reading sie.pole.same-plane = kept
  bool new_feed_mode_ = false;  // the block has G94 or G95
  bool has_code_ = false;       // the block has a code of the motion group
  bool ends_ct_ = false;        // its code is the first after CT
  bool by_angle_ = false;       // the block has an AR=
  bool faulted_ = false;
  bool slashed_ = false;
  // The limit for ends beside their circle: 0.0001 mm, and millionths of the radius.
  std::int64_t error_const_ = 100;
  std::int64_t error_factor_ = 1'000;
};

}  // namespace gonogo::generate
