// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frames of SINUMERIK 802S: G158, G258, G259, and where the tool stands in them.
#include <fmt/format.h>

#include <numbers>

#include "fuzz/generate/sinumerik_writer.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::generate {
namespace {

constexpr std::int64_t kFullTurn = 360'000;

std::int64_t modulo_turn(std::int64_t angle) {
  return (angle % kFullTurn + kFullTurn) % kFullTurn;
}

Coordinate plus(const Coordinate& a, const Coordinate& b) {
  return {a.mm + b.mm, a.steps && b.steps ? std::optional(*a.steps + *b.steps) : std::nullopt};
}
Coordinate minus(const Coordinate& a) {
  return {-a.mm, a.steps ? std::optional(-*a.steps) : std::nullopt};
}

// In the plane: from its first axis toward the second. By quarters decimals stay decimals.
Place rotated(const Place& place, int plane, std::int64_t angle) {
  const PlaneOf axes = plane_of(plane);
  Place result = place;
  Coordinate& p = result[axes.p];
  Coordinate& q = result[axes.q];
  if (angle % 90'000 == 0) {
    for (std::int64_t quarters = modulo_turn(angle) / 90'000; quarters > 0; --quarters) {
      std::swap(p, q);
      p = minus(p);
    }
    return result;
  }
  const double radians = static_cast<double>(angle) / 1'000 * std::numbers::pi / 180;
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  p = Coordinate::about(c * place[axes.p].mm - s * place[axes.q].mm);
  q = Coordinate::about(s * place[axes.p].mm + c * place[axes.q].mm);
  return result;
}

Direction rotated(const Direction& way, int plane, std::int64_t angle) {
  const Place turned = rotated(
      Place{Coordinate::about(way[0]), Coordinate::about(way[1]), Coordinate::about(way[2])}, plane,
      angle);
  return {turned[0].mm, turned[1].mm, turned[2].mm};
}

Place sum(const Place& a, const Place& b) {
  return {plus(a[0], b[0]), plus(a[1], b[1]), plus(a[2], b[2])};
}

}  // namespace

Place SinumerikWriter::in_base() const {
  const SinumerikFrame& frame = state_.frame;
  return sum(frame.translation, rotated(state_.at, frame.plane, frame.angle));
}

Place SinumerikWriter::in_frame(const Place& base) const {
  const SinumerikFrame& frame = state_.frame;
  const Place from_zero = sum(base, {minus(frame.translation[0]), minus(frame.translation[1]),
                                     minus(frame.translation[2])});
  return rotated(from_zero, frame.plane, -frame.angle);
}

// Another plane than that of the rotation in force is an alarm: seldom.
int SinumerikWriter::plane_in_frame(int asked) {
  const bool turns = state_.frame.angle != 0;
  return turns && asked != state_.frame.plane && !choices_.one_in(10) ? state_.frame.plane : asked;
}

// G158 alone clears both under each reading that replaces, G258 alone the rotation that may be
// left.
void SinumerikWriter::clear_frame_lines() {
  state_.frame = {};
  text_ += "G158\nG258\n";
}

// The offset of G158, in the units in force.
void SinumerikWriter::offset_words(Words& words) {
  Place offset;
  const std::uint32_t without = choices_.below(5);
  for (const std::size_t axis : {0U, 1U, 2U}) {
    if (axis == without) continue;
    const std::int64_t value = any_sign(length(30));
    offset[axis] = Coordinate::exactly(value * state_.steps_of_count());
    const char name = "XYZ"[axis];
    words.push_back(named({&name, 1}, value));
  }
  SinumerikFrame& frame = state_.frame;
  if (profile_.readings.is("sie.g158=additive"_reading)) {
    frame.translation = sum(frame.translation, rotated(offset, frame.plane, frame.angle));
  } else {
    if (!profile_.readings.is("sie.g158=translation-only"_reading)) frame = {};
    frame.translation = offset;
  }
}

void SinumerikWriter::rotation_words(Words& words, bool adds) {
  const std::int64_t angle = any_angle();
  SinumerikFrame& frame = state_.frame;
  if (adds) {
    frame.angle = modulo_turn(frame.angle + angle);
  } else {
    if (!profile_.readings.is("sie.g258=rotation-only"_reading)) frame = {};
    frame.angle = modulo_turn(angle);
  }
  frame.plane = state_.plane;
  // Which one reading does not have; whether a word may follow without a blank is undecided.
  const bool required = profile_.readings.is("sie.rpl-equals=required"_reading);
  const bool without_equals = angle >= 0 && (required ? puts_wrong(8) : choices_.one_in(8));
  if (without_equals && required) {
    count("fault: RPL without =");
    faulted_ = true;
  }
  words.push_back(without_equals ? "RPL" + constant(angle) + " " : named("RPL", angle));
}

void SinumerikWriter::frame_block() {
  kind_ = Kind::frame;
  may_assign_ = false;
  if (state_.pole[0].mm != 0 || state_.pole[1].mm != 0) take_pole_back();
  const Place base = in_base();
  const SinumerikFrame before = state_.frame;
  const std::uint32_t kind = choices_.below(10);
  const int number = kind < 5 ? 158 : kind < 7 ? 258 : 259;
  const bool alone = kind == 4 || kind == 6;
  count(fmt::format("frame G{}{}", number, alone ? " alone" : ""));
  Words words = {code(number)};
  if (alone) {
    const bool keeps_offset =
        number == 258 && profile_.readings.is("sie.g258=rotation-only"_reading);
    const Place offset = state_.frame.translation;
    state_.frame = {};
    if (keeps_offset) state_.frame.translation = offset;
  } else if (number == 158) {
    offset_words(words);
  } else {
    rotation_words(words, number == 259);
  }
  state_.at = in_frame(base);
  // A CT after it goes on as before, seen from the new frame.
  if (state_.tangent) {
    const Direction in_base = rotated(*state_.tangent, before.plane, before.angle);
    state_.tangent = rotated(in_base, state_.frame.plane, -state_.frame.angle);
  }
  state_.way.reset();
  state_.spoke.reset();
  state_.at_polar = false;
  state_.moved = true;
  if (!faulted_ && puts_wrong(25)) {
    count("fault: word of a frame");
    words.push_back(choices_.pick({"F100", "A5", "G90", "M8", "CR=5", "G1", "S300"}));
    faulted_ = true;
  }
  write(std::move(words), Kind::frame);
  may_assign_ = true;
  if (profile_.readings.is("sie.frame.increment=with-translation"_reading)) go_there_in_frame();
}

// Before a frame, for where a pole goes no text says. A rotation in force refuses another plane.
void SinumerikWriter::take_pole_back() {
  if (keeps_pole_) {
    const char* const other_plane = state_.plane == 17 ? "G18\n" : "G17\n";
    text_ += state_.frame.angle != 0 ? "G111\n" : other_plane;
  }
  text_ += fmt::format("G{}\n", state_.plane);
  state_.pole = {};
  forget_pole();
}

// Before an increment, which would go the translation, too.
void SinumerikWriter::go_there_in_frame() {
  text_ += "G90 G0" + words_of_a_place() + "\n";
  state_.incremental = false;
  state_.motion = kTraverse;
  state_.tangent.reset();
}

// False: a path command is due.
bool SinumerikWriter::make_802s_block() {
  const std::uint32_t kind = choices_.below(20);
  if (kind < 4) {
    frame_block();
    return true;
  }
  if (kind < 7) {
    kind < 5 || !settings_.pockets ? drilling_block() : pocket_block();
    return true;
  }
  return false;
}

}  // namespace gonogo::generate
