// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <variant>

#include "fuzz/generate/sinumerik_writer.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::generate {

using reference::Number;
using reference::Units;

void SinumerikWriter::make_profile() {
  profile_ = std::get<reference::Profile>(reference::default_profile(dialect_));
  // In this order, so that a seed's program stays what it is.
  if (settings_.machine.state) {
    if (choices_.one_in(8)) profile_.units = Units::inch;
    if (choices_.one_in(12)) profile_.block_skip = true;
  }
  if (is_802s()) make_tools();
  if (settings_.machine.state) make_state();
  if (settings_.machine.parameters) make_parameters();
  if (settings_.machine.readings) choose_readings();
  inch_feed_ = profile_.readings.is("sie.g70.f=inch"_reading);
  spindle_alarm_ = profile_.readings.is("sie.spindle=alarm"_reading);
  winds_ = profile_.readings.is("sie.arc.plane=helix"_reading);
  keeps_pole_ = profile_.readings.is("sie.pole.same-plane=kept"_reading);
  // Whether the feed of the profile is in inches is undecided.
  if (inch_feed_) profile_.initial.feed = 0;
  state_.inch = profile_.units == Units::inch;
  state_.motion = profile_.initial.motion;
  target_ = state_.at;
}

void SinumerikWriter::make_state() {
  for (const std::size_t axis : {0U, 1U, 2U}) {
    if (!choices_.one_in(3)) continue;
    const std::int64_t steps = choices_.between(-500'000, 500'000);
    profile_.initial.at[reference::kAllAxes[axis]] = Number::millionths(steps * 100);
    state_.at[axis] = Coordinate::exactly(steps);
  }
  choose_initial_modes();
  state_.plane = plane_code(profile_.initial.plane);
  if (choices_.one_in(8)) profile_.initial.spindle = choices_.pick({3, 4});
}

void SinumerikWriter::make_parameters() {
  if (choices_.one_in(8)) {
    error_const_ = choices_.pick({0, 20, 500});
    profile_.parameters["CIRCLE_ERROR_CONST"] = Number::millionths(error_const_ * 100);
  }
  if (choices_.one_in(8)) {
    error_factor_ = choices_.pick({0, 100, 5'000});
    profile_.parameters["CIRCLE_ERROR_FACTOR"] = Number::millionths(error_factor_);
  }
}

void SinumerikWriter::make_head() {
  if (choices_.one_in(4)) {
    text_ += choices_.pick({"%_N_TASCHE_MPF\n;$PATH=/_N_WKS_DIR\n", "%100\n", ";part 7\n", "%\n"});
  }
  if (choices_.one_in(4)) {
    text_ += "G17 G40 G71 G90 G94\n";
    state_.inch = false;
    state_.plane = 17;
  }
  Words words;
  if (!errs(20)) words.push_back(feed_word());
  if (choices_.below(spindle_alarm_ ? 20 : 2) != 0) {
    state_.speed = choices_.pick({300, 600, 1200, 1500});
    words.push_back(fmt::format("S{}", state_.speed));
    words.push_back(choices_.pick({"M3", "M4"}));
  }
  if (choices_.one_in(2)) {
    kind_ = Kind::line;
    enter(words, kTraverse);
    for (const std::size_t axis : {0U, 1U, 2U}) words.push_back(random_word(axis, 50));
    arrive_straight();
    write(std::move(words), Kind::line);
  } else if (!words.empty()) {
    write(std::move(words), Kind::other);
  }
}

// After a block in which something was put wrong, should the program go on.
void SinumerikWriter::resync() {
  std::map<int, std::int64_t> none;
  state_.parameters.swap(none);
  state_.known = true;
  state_.astray = false;
  state_.inch = false;
  state_.incremental = false;
  state_.plane = 17;
  state_.motion = kTraverse;
  state_.moved = true;
  state_.tangent.reset();
  state_.way.reset();
  state_.helix_in = 0;
  state_.pole = {};
  state_.spoke.reset();
  forget_pole();
  state_.speed = 600;
  if (is_802s()) clear_frame_lines();
  // The code of another plane takes the pole back in any case.
  if (keeps_pole_) text_ += "G18\n";
  text_ += "G90 G17 G71 G94 G0" + words_of_a_place();
  text_ += fmt::format(" {} S600 M3\n", feed_word());
}

// Absolute words of all three axes.
std::string SinumerikWriter::words_of_a_place() {
  std::string words;
  for (const std::size_t axis : {0U, 1U, 2U}) {
    const std::int64_t value = any_sign(length(50));
    state_.at[axis] = Coordinate::exactly(value * state_.steps_of_count());
    words += " " + word("XYZ"[axis], value);
  }
  target_ = state_.at;
  return words;
}

void SinumerikWriter::make_block() {
  if (!state_.known) resync();
  if (is_802s() && make_802s_block()) return;
  const std::uint32_t kind = choices_.below(24);
  if (kind < 4) return line_block();
  if (kind < 5) return polar_line_block();
  if (kind < 6) return rotary_block();
  if (kind < 8) {
    pole_block();
    if (choices_.one_in(2)) polar_line_block();
    return choices_.one_in(2) ? arc_block() : void();
  }
  if (kind < 16) return arc_block();
  if (kind < 18) return cip_block();
  if (kind < 21) return ct_chain();
  mode_block();
}

void SinumerikWriter::arrive_straight() {
  Direction way{};
  std::array<std::int64_t, 3> exact{};
  bool is_exact = true;
  bool moves = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    way[axis] = target_[axis].mm - state_.at[axis].mm;
    moves = moves || std::abs(way[axis]) > 1e-6;
    is_exact = is_exact && target_[axis].steps && state_.at[axis].steps;
    if (is_exact) exact[axis] = *target_[axis].steps - *state_.at[axis].steps;
  }
  state_.at = target_;
  state_.at_polar = false;
  state_.spoke.reset();
  state_.moved = true;
  // A motion of no length is none; one of nearly none is not to be built on.
  if (!moves && is_exact && state_.way) return;
  state_.tangent = moves ? std::optional(way) : std::nullopt;
  state_.way = moves && is_exact ? std::optional(exact) : std::nullopt;
  state_.helix_in = 0;
}

void SinumerikWriter::arrive(const Direction& tangent) {
  state_.at = target_;
  state_.at_polar = false;
  state_.spoke.reset();
  state_.moved = true;
  state_.tangent = tangent;
  state_.way.reset();
  state_.helix_in = 0;
}

void SinumerikWriter::write(Words words, Kind kind) {
  kind_ = kind;
  // The order of words means nothing except for assignments.
  if (assignments_.empty() && kind != Kind::other && choices_.one_in(6)) {
    for (std::size_t i = words.size(); i > 1; --i) {
      std::swap(words[i - 1], words[choices_.below(static_cast<std::uint32_t>(i))]);
    }
  }
  words.insert(words.begin(), assignments_.begin(), assignments_.end());
  assignments_.clear();
  put(std::move(words));
  if (faulted_) {
    state_.known = choices_.one_in(3);
    state_.astray = true;
  }
  // Where it went is not known, and so not what a tangent goes on from.
  if (state_.astray) {
    state_.tangent.reset();
    state_.way.reset();
    state_.spoke.reset();
  }
  if (slashed_ && profile_.block_skip) state_.known = false;
  faulted_ = false;
  by_angle_ = false;
  ends_ct_ = false;
  new_feed_mode_ = false;
  target_ = state_.at;
}

GeneratedProgram SinumerikWriter::run() {
  make_profile();
  make_head();
  const std::int64_t blocks = number_of_blocks(12);
  for (std::int64_t i = 0; i < blocks && !choices_.exhausted(); ++i) make_block();
  if (choices_.one_in(2)) {
    text_ += choices_.pick({"M30\n", "M5\nM2\n", "m17\n", "M30 ;end\nX99\n", "G0 X7 M30\nX99\n",
                            "G0 Z100 M30\n", "M2\n;\n"});
  }
  return {std::move(profile_), std::move(text_)};
}

GeneratedProgram generate_sinumerik(std::string_view dialect, Choices& choices,
                                    const GeneratorSettings& settings, ProgramKind kind,
                                    Distribution* distribution) {
  return SinumerikWriter(dialect, choices, settings, kind, distribution).run();
}

}  // namespace gonogo::generate
