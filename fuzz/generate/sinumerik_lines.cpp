// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traverses and feeds, Cartesian and polar, and poles.
#include <fmt/format.h>

#include <numbers>

#include "fuzz/generate/sinumerik_writer.hpp"

namespace gonogo::generate {
namespace {

double radians(std::int64_t thousandths) {
  return static_cast<double>(thousandths) / 1'000 * std::numbers::pi / 180;
}

// The cosine of a multiple of 90 degrees.
std::int64_t quarter_cosine(std::int64_t angle) {
  const std::int64_t quarter = (angle / 90'000 % 4 + 4) % 4;
  return quarter == 0 ? 1 : quarter == 2 ? -1 : 0;
}

// `base` and a radius (0.0001 mm) along an angle (0.001 degrees), along p and q.
std::array<Coordinate, 2> about(const std::array<Coordinate, 2>& base, std::int64_t angle,
                                std::int64_t radius) {
  if (angle % 90'000 == 0) {
    return {base[0].moved(radius * quarter_cosine(angle)),
            base[1].moved(radius * quarter_cosine(angle - 90'000))};
  }
  const double r = static_cast<double>(radius) / 10'000;
  return {Coordinate::about(base[0].mm + r * std::cos(radians(angle))),
          Coordinate::about(base[1].mm + r * std::sin(radians(angle)))};
}

}  // namespace

void SinumerikWriter::line_block() {
  kind_ = Kind::line;
  Words words;
  mode_words(words);
  // The motion of power-on, without a code.
  if (state_.motion != -1 || state_.moved || choices_.below(3) != 0) {
    enter(words, choices_.one_in(2) ? kLine : kTraverse);
  }
  const std::uint32_t without = choices_.below(5);
  for (const std::size_t axis : {0U, 1U, 2U}) {
    if (axis != without) words.push_back(random_word(axis, 50));
  }
  // Whose feed holds where the linear axes happen not to move is undecided in inches.
  if (!inch_feed_ && choices_.one_in(6)) words.push_back(rotary_word());
  feed_words(words);
  arrive_straight();
  write(std::move(words), Kind::line);
}

void SinumerikWriter::rotary_block() {
  count("rotary alone");
  kind_ = Kind::other;
  Words words;
  mode_words(words);
  enter(words, choices_.one_in(2) ? kLine : kTraverse);
  words.push_back(rotary_word());
  feed_words(words);
  // What a CT after it goes on from is undecided.
  state_.tangent.reset();
  state_.way.reset();
  write(std::move(words), Kind::other);
}

std::int64_t SinumerikWriter::any_angle() {
  switch (choices_.below(4)) {
    case 0:
      return any_sign(choices_.between(0, 4) * 90'000);
    case 1:
      return any_sign(choices_.pick({30'000, 45'000, 60'000, 135'000, 210'000, 315'000, 330'000}));
    case 2:
      return any_sign(choices_.between(0, 360) * 1'000);
    default:
      return choices_.between(-360'000, 360'000);
  }
}

// One at least: without them it is no polar target.
void SinumerikWriter::polar_words(Words& words, std::int64_t angle, std::int64_t radius) {
  const std::int64_t steps = radius * state_.steps_of_count();
  const bool old_radius = state_.radius && *state_.radius == steps && choices_.below(3) != 0;
  const bool old_angle =
      state_.angle && *state_.angle == angle && !old_radius && choices_.one_in(2);
  if (!old_angle) {
    const std::int64_t by = state_.angle ? angle - *state_.angle : 0;
    const bool adds = state_.angle && by >= -360'000 && by <= 360'000 && choices_.one_in(4);
    words.push_back(adds ? named("AP", by, How::incremental)
                         : named("AP", angle, choices_.one_in(6) ? How::absolute : How::plain));
  }
  if (!old_radius) words.push_back(named("RP", radius));
  state_.angle = angle;
  state_.radius = steps;
}

void SinumerikWriter::polar_target(std::int64_t angle, std::int64_t radius) {
  const PlaneOf plane = plane_of(state_.plane);
  const auto [p, q] = about(state_.pole, angle, radius * state_.steps_of_count());
  target_[plane.p] = p;
  target_[plane.q] = q;
}

void SinumerikWriter::third_axis_word(Words& words) {
  words.push_back(random_word(plane_of(state_.plane).d, 20));
}

void SinumerikWriter::polar_line_block() {
  count("polar line");
  kind_ = Kind::other;
  Words words;
  if (choices_.one_in(8)) mode_words(words);
  enter(words, choices_.one_in(2) ? kLine : kTraverse);
  const std::int64_t angle = any_angle();
  const std::int64_t radius =
      state_.radius && *state_.radius % state_.steps_of_count() == 0 && choices_.one_in(3)
          ? *state_.radius / state_.steps_of_count()
          : 1 + length(40);
  polar_target(angle, radius);
  polar_words(words, angle, radius);
  if (choices_.one_in(4)) third_axis_word(words);
  feed_words(words);
  // Cartesian and polar, an angle too large, a pole that has no radius yet.
  if (choices_.one_in(40)) words.push_back("X5");
  if (choices_.one_in(60)) words.push_back(choices_.pick({"AP=360.001", "AP=-361", "RP=-5"}));
  arrive_straight();
  state_.at_polar = true;
  write(std::move(words), Kind::line);
}

void SinumerikWriter::pole_block() {
  kind_ = Kind::pole;
  may_assign_ = false;
  const int base = choices_.pick({110, 111, 111, 112});
  count(fmt::format("pole G{}", base));
  Words words = {code(base)};
  const PlaneOf plane = plane_of(state_.plane);
  std::array<Coordinate, 2> from = state_.pole;
  if (base == 110) from = {state_.at[plane.p], state_.at[plane.q]};
  if (base == 111) from = {};
  state_.spoke.reset();
  switch (choices_.below(6)) {
    case 0:
      break;
    case 1: {
      const std::int64_t angle = any_angle();
      const std::int64_t radius = 1 + length(40);
      words.push_back(named("AP", angle));
      words.push_back(named("RP", radius));
      from = about(from, angle, radius * state_.steps_of_count());
      break;
    }
    default: {
      const Pair by = {any_sign(length(30)), any_sign(length(30))};
      for (const auto& [axis, value] : {std::pair(plane.p, by.p), std::pair(plane.q, by.q)}) {
        const char name = "XYZ"[axis];
        const How how = choices_.one_in(8) ? How::incremental : How::plain;
        words.push_back(named({&name, 1}, value, how));
      }
      const std::int64_t step = state_.steps_of_count();
      from = {from[0].moved(by.p * step), from[1].moved(by.q * step)};
      if (base == 110) state_.spoke = {-by.p * step, -by.q * step};
    }
  }
  state_.pole = from;
  state_.angle.reset();
  state_.radius.reset();
  state_.at_polar = false;
  write(std::move(words), Kind::pole);
  may_assign_ = true;
}

}  // namespace gonogo::generate
