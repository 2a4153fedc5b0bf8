// SPDX-License-Identifier: GPL-3.0-or-later
//
// G2 and G3 in all their forms, and helices.
#include <fmt/format.h>

#include <numbers>
#include <utility>

#include "fuzz/generate/sinumerik_writer.hpp"

namespace gonogo::generate {
namespace {

std::string_view centre_name(std::size_t axis) {
  return std::string_view("IJK").substr(axis, 1);
}

}  // namespace

bool SinumerikWriter::plane_is_exact(int plane) const {
  const PlaneOf axes = plane_of(plane);
  return state_.exact(axes.p) && state_.exact(axes.q);
}

// From the centre: along an axis, of a whole length, any.
SinumerikWriter::Pair SinumerikWriter::any_spoke() {
  if (choices_.one_in(100)) return {choices_.between(0, 14), 0};
  switch (choices_.below(4)) {
    case 0:
      return {any_sign(1 + length(20)), 0};
    case 1: {
      const std::int64_t k = any_sign(1 + length(5));
      return choices_.one_in(2) ? Pair{3 * k, 4 * k} : Pair{5 * k, -12 * k};
    }
    default:
      return {any_sign(1 + length(20)), any_sign(length(20))};
  }
}

// A place as far from the centre.
SinumerikWriter::Pair SinumerikWriter::turned(Pair from) {
  if (3 * from.q == 4 * from.p && choices_.one_in(2)) from = {from.p / 3 * 5, 0};
  if (5 * from.q == -12 * from.p && choices_.one_in(2)) from = {from.p / 5 * 13, 0};
  if (choices_.one_in(2)) std::swap(from.p, from.q);
  return {any_sign(from.p), any_sign(from.q)};
}

// By how much an end misses its circle: mostly nothing, or near one of the limits.
std::int64_t SinumerikWriter::beside(std::int64_t radius) {
  if (choices_.below(3) != 0) return 0;
  count("end beside the circle");
  const std::int64_t constant = error_const_ / state_.steps_of_count();
  const std::int64_t share = radius * error_factor_ / 1'000'000;
  switch (choices_.below(4)) {
    case 0:
      return any_sign(choices_.between(0, std::max(constant, share)));
    case 1:
      return any_sign(share + choices_.between(-1, 1));
    default:
      return any_sign(std::max(constant, share) + choices_.between(-1, 1));
  }
}

void SinumerikWriter::end_words(Words& words, int plane, Pair travel, bool both) {
  const PlaneOf axes = plane_of(plane);
  // An axis that does not move may be left out.
  if (both || travel.p != 0 || choices_.one_in(3)) words.push_back(axis_word(axes.p, travel.p));
  if (both || travel.q != 0 || choices_.one_in(3)) words.push_back(axis_word(axes.q, travel.q));
}

// Increments under G90 and G91 alike, or absolute.
void SinumerikWriter::centre_words(Words& words, int plane, Pair offset) {
  const PlaneOf axes = plane_of(plane);
  const auto put_offset = [&](std::size_t axis, std::int64_t value) {
    const Coordinate& at = state_.at[axis];
    const std::int64_t step = state_.steps_of_count();
    if (at.steps && *at.steps % step == 0 && choices_.one_in(3)) {
      words.push_back(named(centre_name(axis), *at.steps / step + value, How::absolute));
    } else {
      words.push_back(
          named(centre_name(axis), value, choices_.one_in(6) ? How::incremental : How::plain));
    }
  };
  // One of them may be left out where it is 0, unless the other alone makes a helix of it.
  const bool needs_both = plane != state_.plane && winds_;
  const bool names_p = offset.p != 0 || needs_both || choices_.one_in(3);
  if (names_p) put_offset(axes.p, offset.p);
  if (offset.q != 0 || !names_p || needs_both || choices_.one_in(3)) put_offset(axes.q, offset.q);
}

void SinumerikWriter::finish_arc(int plane, double p, double q) {
  const PlaneOf axes = plane_of(plane);
  const double sense = state_.motion == kCounterclockwise ? 1 : -1;
  Direction tangent{};
  tangent[axes.p] = -sense * (target_[axes.q].mm - q);
  tangent[axes.q] = sense * (target_[axes.p].mm - p);
  const bool helix = std::abs(target_[axes.d].mm - state_.at[axes.d].mm) > 0;
  arrive(tangent);
  state_.helix_in = helix ? plane : 0;
  // A place that no decimal says, on a small circle, says little about a direction.
  if (std::hypot(tangent[0], tangent[1], tangent[2]) < 0.5 && !plane_is_exact(plane)) {
    state_.tangent.reset();
  }
}

void SinumerikWriter::centre_arc(Words& words, int plane) {
  count(plane == state_.plane ? "arc by centre" : "arc by centre, plane by axes");
  const Pair start = any_spoke();
  // A half turn from a place that is no decimal would depend on its last bit.
  Pair end = {-start.q, start.p};
  const auto radius = static_cast<std::int64_t>(
      std::hypot(static_cast<double>(start.p), static_cast<double>(start.q)));
  if (plane_is_exact(plane) && plane_is_exact(state_.plane)) {
    end = turned(start);
    if (choices_.one_in(16)) {  // nearly where it starts
      end = {start.p, start.q + any_sign(choices_.between(1, 9))};
    } else {
      (end.p == 0 ? end.q : end.p) += beside(radius);
    }
  }
  // Beside the circle on the ray of the start: whether it is a full turn or none is undecided.
  const bool same = end.p == start.p && end.q == start.q;
  const bool on_ray = start.p * end.q == start.q * end.p && start.p * end.p + start.q * end.q > 0;
  if (on_ray && !same) end = {-start.q, start.p};
  const bool in_plane = plane == state_.plane;
  const bool helix = in_plane && choices_.one_in(4);
  const bool needs_both = (helix && !winds_) || !in_plane;
  end_words(words, plane, {end.p - start.p, end.q - start.q}, needs_both);
  centre_words(words, plane, {-start.p, -start.q});
  if (helix) helix_words(words);
  const PlaneOf axes = plane_of(plane);
  const double unit = state_.mm_of_count();
  finish_arc(plane, state_.at[axes.p].mm - unit * static_cast<double>(start.p),
             state_.at[axes.q].mm - unit * static_cast<double>(start.q));
}

void SinumerikWriter::full_circle(Words& words) {
  count("full circle");
  Pair start = any_spoke();
  if (start.p == 0) start.p = length_of(1'000);
  const bool helix = choices_.one_in(4);
  if (choices_.one_in(2)) end_words(words, state_.plane, {}, true);
  centre_words(words, state_.plane, {-start.p, -start.q});
  if (helix) helix_words(words);
  const PlaneOf axes = plane_of(state_.plane);
  const double unit = state_.mm_of_count();
  finish_arc(state_.plane, state_.at[axes.p].mm - unit * static_cast<double>(start.p),
             state_.at[axes.q].mm - unit * static_cast<double>(start.q));
}

void SinumerikWriter::radius_arc(Words& words, int plane) {
  if (winds_) plane = state_.plane;  // no end by CR= chooses another
  count(plane == state_.plane ? "arc by CR" : "arc by CR, plane by axes");
  Pair travel = {any_sign(1 + length(20)), any_sign(length(20))};
  if (choices_.one_in(3)) travel.q = 0;
  if (choices_.one_in(5)) travel = {3 * travel.p, 4 * travel.p};
  const double half = std::hypot(static_cast<double>(travel.p), static_cast<double>(travel.q)) / 2;
  const auto whole = static_cast<std::int64_t>(half);
  std::int64_t radius = whole + whole / 20 + 2 + length(choices_.one_in(8) ? 500 : 20);
  const bool exact = plane_is_exact(plane) && plane_is_exact(state_.plane);
  // About half the chord; one reading forgives a little.
  if (exact && choices_.one_in(4)) radius = whole + choices_.between(-9, 3);
  if (radius <= 0) radius = length_of(1'000);
  const bool in_plane = plane == state_.plane;
  const bool helix = in_plane && choices_.one_in(5);
  end_words(words, plane, travel, (helix && !winds_) || !in_plane);
  const bool major = choices_.one_in(3);
  words.push_back(named("CR", major ? -radius : radius));
  if (helix) helix_words(words);
  // Left of the chord: G3 of at most half a turn.
  const double unit = state_.mm_of_count();
  const auto r = static_cast<double>(radius);
  const double side = (state_.motion == kCounterclockwise) == major ? -1 : 1;
  const double height = side * std::sqrt(std::max(0.0, r * r - half * half)) / (2 * half);
  const PlaneOf axes = plane_of(plane);
  const auto p = static_cast<double>(travel.p);
  const auto q = static_cast<double>(travel.q);
  finish_arc(plane, state_.at[axes.p].mm + unit * (p / 2 - height * q),
             state_.at[axes.q].mm + unit * (q / 2 + height * p));
}

void SinumerikWriter::angle_arc(Words& words) {
  by_angle_ = true;
  std::int64_t angle = choices_.one_in(2)
                           ? choices_.pick({90'000, 180'000, 270'000, 30'000, 45'000, 1, 359'999})
                           : choices_.between(1, 359'999);
  // Nearly straight only where the chord is known to be short.
  if (state_.astray) angle = choices_.pick({90'000, 180'000, 300'000});
  const double sense = state_.motion == kCounterclockwise ? 1 : -1;
  const double turn = sense * static_cast<double>(angle) / 1'000 * std::numbers::pi / 180;
  const double unit = state_.mm_of_count();
  const PlaneOf axes = plane_of(state_.plane);
  const double at_p = state_.at[axes.p].mm;
  const double at_q = state_.at[axes.q].mm;
  const bool helix = choices_.one_in(4);
  if (choices_.one_in(2)) {
    count("arc by AR and centre");
    Pair start = any_spoke();
    if (start.p == 0) start.p = length_of(1'000);
    centre_words(words, state_.plane, {-start.p, -start.q});
    const double p = unit * static_cast<double>(start.p);
    const double q = unit * static_cast<double>(start.q);
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    target_[axes.p] = Coordinate::about(at_p + (c - 1) * p - s * q);
    target_[axes.q] = Coordinate::about(at_q + s * p + (c - 1) * q);
    if (helix) helix_words(words);
    finish_arc(state_.plane, at_p - p, at_q - q);
  } else {
    count("arc by AR and end");
    const Pair travel = {any_sign(1 + length(20)), any_sign(length(20))};
    end_words(words, state_.plane, travel, helix);
    if (helix) helix_words(words);
    const double height = 0.5 / std::tan(turn / 2);
    const double p = unit * static_cast<double>(travel.p);
    const double q = unit * static_cast<double>(travel.q);
    finish_arc(state_.plane, at_p + p / 2 - height * q, at_q + q / 2 + height * p);
  }
  if (choices_.one_in(40)) angle = choices_.pick({0, 360'000, 360'001, -90'000});
  words.push_back(named("AR", angle));
}

// About the pole, on whose circle the tool nearly stands.
void SinumerikWriter::polar_arc(Words& words) {
  const PlaneOf axes = plane_of(state_.plane);
  const double p = state_.at[axes.p].mm - state_.pole[0].mm;
  const double q = state_.at[axes.q].mm - state_.pole[1].mm;
  const double distance = std::hypot(p, q) / state_.mm_of_count();
  if (distance < 500) return centre_arc(words, state_.plane);
  count("polar arc");
  const bool on_circle = state_.at_polar && state_.radius && state_.angle &&
                         *state_.radius % state_.steps_of_count() == 0;
  auto radius = static_cast<std::int64_t>(std::llround(distance));
  const bool decimals =
      plane_is_exact(state_.plane) && state_.pole[0].steps && state_.pole[1].steps;
  // Whether it is the radius at the start is not for the last bit to decide.
  const bool hangs = !on_circle && !decimals && !state_.spoke &&
                     std::abs(distance - static_cast<double>(radius)) < 1e-6;
  const bool misses = choices_.one_in(6);
  if (misses || hangs) {
    radius += any_sign(on_circle || hangs ? choices_.pick({3, 40}) : beside(radius));
  }
  std::int64_t angle = any_angle();
  const bool exact = decimals && angle % 90'000 == 0 && !misses;
  if (on_circle && !misses && choices_.one_in(5)) {
    count("polar full circle or half turn");
    angle = *state_.angle + choices_.pick({0, 0, 180'000});
    while (angle > 360'000) angle -= 360'000;
    if (angle > 0 && choices_.one_in(2)) angle -= 360'000;
  } else if (!exact) {
    // Not nearly a full turn, nor a half one, where rounding would decide.
    const auto from =
        static_cast<std::int64_t>(std::llround(std::atan2(q, p) * 180 / std::numbers::pi * 1'000));
    const std::int64_t turn = ((angle - from) % 180'000 + 180'000) % 180'000;
    if (turn < 2'000 || turn > 178'000) angle += angle < 0 ? 5'000 : -5'000;
  }
  polar_target(angle, radius);
  polar_words(words, angle, radius);
  if (choices_.one_in(4)) helix_words(words);
  finish_arc(state_.plane, state_.pole[0].mm, state_.pole[1].mm);
  state_.at_polar = true;
}

void SinumerikWriter::helix_words(Words& words) {
  count("helix");
  if (choices_.below(5) != 0) third_axis_word(words);
  if (choices_.one_in(2)) {
    words.push_back(
        fmt::format("TURN={}", choices_.below(static_cast<std::uint32_t>(settings_.turns))));
  }
}

// Words that do not go with the others, and none that would.
void SinumerikWriter::arc_faults(Words& words) {
  if (!puts_wrong(20)) return;
  count("fault: form of arc");
  words.push_back(choices_.pick({"CR=12", "AR=90", "AP=30", "RP=5", "TURN=1000", "TURN=-1",
                                 "TURN=1.5", "I1=3", "CR=0", "I3 J4", "K2"}));
  faulted_ = true;
}

void SinumerikWriter::arc_block() {
  kind_ = Kind::arc;
  Words words;
  if (choices_.one_in(5)) set_plane(words, choices_.pick({17, 18, 19}));
  mode_words(words);
  enter(words, choices_.one_in(2) ? kClockwise : kCounterclockwise);
  // The axes of the end point may choose another plane.
  const int plane = choices_.one_in(5) ? plane_in_frame(choices_.pick({17, 18, 19})) : state_.plane;
  const std::uint32_t form = choices_.below(12);
  if (form < 4) {
    centre_arc(words, plane);
  } else if (form < 7) {
    radius_arc(words, plane);
  } else if (form < 9) {
    angle_arc(words);
  } else if (form < 11) {
    polar_arc(words);
  } else {
    full_circle(words);
  }
  // Where its end point's axes may choose the plane, whether A is one of them is undecided.
  if (form >= 7 && form < 11 && !inch_feed_ && choices_.one_in(10)) words.push_back(rotary_word());
  feed_words(words);
  arc_faults(words);
  write(std::move(words), Kind::arc);
}

}  // namespace gonogo::generate
