// SPDX-License-Identifier: GPL-3.0-or-later
//
// CIP, the arc through three points, and chains of CT, the arc tangent to what was before.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/generate/sinumerik_writer.hpp"

namespace gonogo::generate {
namespace {

double dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double norm(const Direction& a) {
  return std::sqrt(dot(a, a));
}
Direction difference(const Place& a, const Place& b) {
  return {a[0].mm - b[0].mm, a[1].mm - b[1].mm, a[2].mm - b[2].mm};
}
double cross_length(const Direction& a, const Direction& b) {
  return norm({a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]});
}

}  // namespace

// Travels to the intermediate and to the end point.
std::array<SinumerikWriter::Triple, 2> SinumerikWriter::any_two_points() {
  std::array<Triple, 2> points{};
  if (choices_.one_in(3)) {  // on a circle in a plane of axes
    const PlaneOf plane = plane_of(choices_.pick({17, 18, 19}));
    Pair start = any_spoke();
    start.p += start.p < 0 ? -50 : 50;
    const Pair via = turned(start);
    const Pair end = turned(start);
    points[0][plane.p] = via.p - start.p;
    points[0][plane.q] = via.q - start.q;
    points[1][plane.p] = end.p - start.p;
    points[1][plane.q] = end.q - start.q;
    return points;
  }
  for (Triple& point : points) {
    for (std::int64_t& travel : point)
      travel = choices_.one_in(4) ? 0 : any_sign(length_of(50) + length(20));
  }
  return points;
}

std::array<SinumerikWriter::Triple, 2> SinumerikWriter::two_points_in_line() {
  std::array<Triple, 2> points{};
  const std::int64_t to_via = choices_.pick({-1, 0, 1, 2, 3});
  const std::int64_t to_end = choices_.pick({0, 2, 3, 3});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t travel = choices_.one_in(4) ? 0 : any_sign(length(10));
    points[0][axis] = to_via * travel;
    points[1][axis] = to_end * travel;
  }
  return points;
}

void SinumerikWriter::cip_block() {
  kind_ = Kind::arc;
  Words words;
  mode_words(words);
  const bool exact = state_.exact(0) && state_.exact(1) && state_.exact(2);
  const auto [to_via, to_end] =
      exact && choices_.one_in(6) ? two_points_in_line() : any_two_points();
  Direction via{};
  Direction end{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    via[axis] = state_.mm_of_count() * static_cast<double>(to_via[axis]);
    end[axis] = state_.mm_of_count() * static_cast<double>(to_end[axis]);
  }
  const Direction last = {end[0] - via[0], end[1] - via[1], end[2] - via[2]};
  const double area = cross_length(via, end);
  const bool in_line = area < 1e-3 * norm(via) * norm(end) + 1e-9 || norm(last) < 1e-3;
  // Points in line decide on an alarm: not where they are no decimals.
  if (in_line && !exact) return line_block();
  // On a circle as large the last digit of a point moves the far side by more than the tolerance.
  constexpr double kLargestRadius = 1e5;  // mm
  if (!in_line && norm(via) * norm(end) * norm(last) > 2 * kLargestRadius * area) {
    return line_block();
  }
  enter(words, kCip);
  static constexpr std::string_view kVia[] = {"I1", "J1", "K1"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (to_end[axis] != 0 || choices_.one_in(3)) words.push_back(axis_word(axis, to_end[axis]));
    if (to_via[axis] == 0 && !choices_.one_in(3)) continue;
    words.push_back(travel_word(kVia[axis], state_.at[axis], to_via[axis]));
  }
  feed_words(words);
  if (choices_.one_in(40)) {
    words.push_back(choices_.pick({"CR=5", "I3", "AP=30 RP=5", "TURN=1"}));
    faulted_ = true;
  }
  if (in_line) {
    count("CIP in line");
    arrive_straight();
  } else {
    // For the circle through via, the end and the start, in that order.
    Direction tangent{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      tangent[axis] = last[axis] / dot(last, last) - end[axis] / dot(end, end);
    }
    arrive(tangent);
  }
  write(std::move(words), Kind::arc);
}

void SinumerikWriter::ct_chain() {
  for (std::uint32_t i = 1 + choices_.below(4); i > 0 && ct_block() && state_.known; --i) {
  }
}

// False where there is nothing to go on from, or where rounding would decide.
bool SinumerikWriter::ct_block() {
  kind_ = Kind::arc;
  Words words;
  if (choices_.one_in(8)) set_plane(words, choices_.pick({17, 18, 19}));
  const auto give_up = [&] {
    if (!words.empty()) write(std::move(words), Kind::other);
    return false;
  };
  if (!state_.tangent) {
    // At the head of a program nothing is before it.
    if (state_.moved || !choices_.one_in(3)) return give_up();
    count("CT first");
    words.push_back("CT");
    words.push_back(axis_word(0, 5'000));
    state_.motion = kCt;
    arrive({1, 1, 1});
    faulted_ = true;
    write(std::move(words), Kind::arc);
    return false;
  }
  const PlaneOf plane = plane_of(state_.plane);
  Direction tangent{};
  tangent[plane.p] = (*state_.tangent)[plane.p];
  tangent[plane.q] = (*state_.tangent)[plane.q];
  if (state_.helix_in != 0 && state_.helix_in != state_.plane) return give_up();
  if (norm(tangent) < 1e-3 * norm(*state_.tangent)) {
    const bool exactly = state_.way && (*state_.way)[plane.p] == 0 && (*state_.way)[plane.q] == 0;
    if (!exactly || !choices_.one_in(3)) return give_up();
    count("CT without a direction in the plane");
  }
  if (choices_.one_in(8)) mode_words(words);
  enter(words, kCt);
  if (!ct_words(words, tangent)) {
    state_.motion = -1;  // so that the next motion has its code
    return give_up();
  }
  feed_words(words);
  if (choices_.one_in(60)) {
    words.push_back(choices_.pick({"CR=5", "I3", "AR=90", "TURN=1", "I1=2"}));
    faulted_ = true;
  }
  finish_ct(tangent);
  write(std::move(words), Kind::arc);
  return true;
}

// Where the line before it leads, or straight back.
bool SinumerikWriter::straight_on(Words& words) {
  const PlaneOf plane = plane_of(state_.plane);
  if (!state_.way || !plane_is_exact(state_.plane)) return false;
  const Pair way = {(*state_.way)[plane.p], (*state_.way)[plane.q]};
  const std::int64_t step = state_.steps_of_count();
  if (way.p % step != 0 || way.q % step != 0) return false;
  count("CT straight");
  const std::int64_t times = choices_.pick({1, 1, 2, 3, -1});
  end_words(words, state_.plane, {times * way.p / step, times * way.q / step}, true);
  return true;
}

// The words of the end. False: rounding would decide whether it lies straight ahead.
bool SinumerikWriter::ct_words(Words& words, const Direction& tangent) {
  if (choices_.one_in(6) && straight_on(words)) return true;
  const PlaneOf plane = plane_of(state_.plane);
  if (!state_.at_polar && choices_.one_in(5)) {
    const std::int64_t angle = any_angle();
    const std::int64_t radius = length_of(1'000) + length(30);
    polar_target(angle, radius);
    Direction way{};
    way[plane.p] = target_[plane.p].mm - state_.at[plane.p].mm;
    way[plane.q] = target_[plane.q].mm - state_.at[plane.q].mm;
    if (cross_length(tangent, way) < 1e-2 * norm(tangent) * norm(way) + 1e-9) return false;
    count("CT polar");
    polar_words(words, angle, radius);
    return true;
  }
  const Pair travel = {any_sign(1 + length(20)), any_sign(length(20))};
  Direction way{};
  way[plane.p] = static_cast<double>(travel.p);
  way[plane.q] = static_cast<double>(travel.q);
  if (cross_length(tangent, way) < 1e-2 * norm(tangent) * norm(way) && norm(tangent) > 0) {
    return false;
  }
  const bool helix = choices_.one_in(5);
  end_words(words, state_.plane, travel, helix);
  if (helix) third_axis_word(words);
  return true;
}

// Turned about the chord: as the tangent at the start on its other side.
void SinumerikWriter::finish_ct(const Direction& tangent) {
  const PlaneOf plane = plane_of(state_.plane);
  Direction chord = difference(target_, state_.at);
  const bool helix = chord[plane.d] != 0;
  chord[plane.d] = 0;
  const bool polar = !target_[plane.p].steps || !target_[plane.q].steps;
  if (cross_length(tangent, chord) <= 1e-9 * norm(tangent) * norm(chord)) {
    arrive_straight();
  } else {
    const double share = 2 * dot(tangent, chord) / dot(chord, chord);
    Direction at_end{};
    for (std::size_t axis = 0; axis < 3; ++axis) at_end[axis] = share * chord[axis] - tangent[axis];
    arrive(at_end);
    state_.helix_in = helix ? state_.plane : 0;
  }
  // A place of the last polar words, or one not looked into.
  state_.at_polar = polar && state_.angle && state_.radius;
}

}  // namespace gonogo::generate
