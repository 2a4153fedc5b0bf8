// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/curve.hpp"

#include <map>
#include <vector>

#include "reference/geometry/kernel.hpp"

namespace gonogo::relation {

using reference::kAllAxes;
using reference::kLinearAxes;
using reference::Record;
using reference::RecordKind;

namespace {

constexpr int kBitsOfPlace = 60;
// Nearer than this, two numbers are one: about 1e-12 mm.
const Number kOneNumber = Number::binary(1, -40);

Position minus(const Position& a, const Position& b) {
  Position difference;
  for (const Axis axis : kAllAxes) difference[axis] = a[axis] - b[axis];
  return difference;
}

// Along the linear axes.
Number dot(const Position& a, const Position& b) {
  return CGAL::scalar_product(geometry::vector_of(a), geometry::vector_of(b));
}

Number length_of(const Position& vector) {
  return rational_near(sqrt(dot(vector, vector)));
}

// The angle from u to `v`, in (0, 360] degrees; u and w stand upright on each other.
Number degrees_to(const Position& u, const Position& w, const Position& v) {
  const Number along = dot(u, v);
  const Number across = dot(w, v);
  if (along.sign() > 0 && abs(across) <= along * kOneNumber) return 360;
  return rational_near(angle_degrees(along, across));
}

// Drift and growth follow from the end.
void lead_to(Turning& turning, const Position& from, const Position& to) {
  const Position start = minus(from, turning.centre);
  const Position end = minus(to, turning.centre);
  const Number first = length_of(turning.u);
  const Number along_u = dot(end, turning.u) / first;
  const Number along_w = dot(end, turning.w) / first;
  const Number last = rational_near(sqrt(along_u * along_u + along_w * along_w));
  turning.radius = max(first, last);
  turning.growth = abs(last - first) <= kOneNumber ? Number(0) : (last - first) / first;
  for (const Axis axis : kAllAxes) {
    turning.drift[axis] = reference::is_linear(axis) ? Number(0) : end[axis] - start[axis];
  }
}

std::optional<Turning> turning_of_arc(const Record& arc, const Position& from, const Position& to,
                                      Turn turn) {
  const reference::PlaneAxes axes = reference::axes_of(arc.plane);
  Turning turning;
  turning.centre = from;
  turning.centre[axes.p] = rational_near(arc.centre[0]);
  turning.centre[axes.q] = rational_near(arc.centre[1]);
  const int sense = arc.rot < 0 ? -1 : 1;
  turning.u = minus(from, turning.centre);
  turning.w[axes.p] = -turning.u[axes.q] * sense;
  turning.w[axes.q] = turning.u[axes.p] * sense;
  Position in_plane = minus(to, turning.centre);
  for (const Axis axis : kAllAxes) {
    if (axis != axes.p && axis != axes.q) in_plane[axis] = 0;
  }
  if (dot(turning.u, turning.u) <= kOneNumber || dot(in_plane, in_plane) <= kOneNumber) {
    return std::nullopt;
  }
  const Number part = degrees_to(turning.u, turning.w, in_plane);
  turning.degrees = part + Number(360) * (std::int64_t{arc.rot < 0 ? -1 : 1} * arc.rot - 1);
  if (turn == Turn::the_other) turning.degrees += part > Number(180) ? -360 : 360;
  if (turning.degrees.sign() <= 0) return std::nullopt;
  lead_to(turning, from, to);
  turning.drift[axes.d] = to[axes.d] - from[axes.d];
  return turning;
}

// Nothing where the three points lie in line.
std::optional<Turning> turning_of_circle(const Position& from, const Position& via,
                                         const Position& to) {
  const auto place = [](const Position& at) { return geometry::ORIGIN + geometry::vector_of(at); };
  const geometry::Vector_3 normal =
      CGAL::cross_product(place(via) - place(from), place(to) - place(from));
  if (normal.squared_length() <= kOneNumber * kOneNumber) return std::nullopt;
  const geometry::Point_3 centre = CGAL::circumcenter(place(from), place(via), place(to));
  const geometry::Vector_3 start = place(from) - centre;
  const Position middle = geometry::position_of(centre - geometry::ORIGIN);
  Turning turning;
  turning.centre = from;
  for (const Axis axis : kLinearAxes) turning.centre[axis] = middle[axis];
  turning.u = geometry::position_of(start);
  turning.w = geometry::position_of(CGAL::cross_product(normal, start) /
                                    length_of(geometry::position_of(normal)));
  turning.degrees = degrees_to(turning.u, turning.w, minus(to, turning.centre));
  lead_to(turning, from, to);
  return turning;
}

// In how many steps a turn is cut: then a chord lies within tau/8 of the curve, for
// r (1 - cos(pi/n)) < 5 r / n^2, and a radius that changes by c adds less than 2 c / n.
Number width_of(const Turning& turning, std::int64_t steps_of_turn) {
  const Number n = steps_of_turn;
  return turning.radius * 5 / (n * n) + abs(turning.growth) * turning.radius * 2 / n;
}

// Without a tolerance no number of steps is enough: the turn is cut into few, and the answer lies
// within the width of these, unless the two sides have the same pieces.
std::int64_t steps_of_turn(const Turning& turning, const Number& tau) {
  constexpr std::int64_t kMost = std::int64_t{1} << 40;
  constexpr std::int64_t kFew = 1 << 10;
  if (tau.sign() == 0) return kFew;
  std::int64_t steps = 64;
  while (steps < kMost && width_of(turning, steps) * 8 > tau) steps += steps / 4;
  return steps;
}

std::array<Number, 2> cos_sin_of(std::int64_t step, std::int64_t steps_of_turn) {
  const auto [cosine, sine] = exact::cos_sin_degrees(Number(360) * step / steps_of_turn);
  return {rational_near(cosine), rational_near(sine)};
}

// The same from a table, where a turn has no more steps than that.
std::array<Number, 2> direction(std::int64_t step, std::int64_t steps_of_turn) {
  constexpr std::int64_t kMostKept = 1 << 14;
  if (steps_of_turn > kMostKept) return cos_sin_of(step, steps_of_turn);
  thread_local std::map<std::int64_t, std::vector<std::optional<std::array<Number, 2>>>> tables;
  auto& table = tables[steps_of_turn];
  table.resize(static_cast<std::size_t>(steps_of_turn));
  auto& entry = table[static_cast<std::size_t>(step % steps_of_turn)];
  if (!entry) entry = cos_sin_of(step % steps_of_turn, steps_of_turn);
  return *entry;
}

Position point_of(const Turning& turning, const Number& part, const Number& cosine,
                  const Number& sine) {
  Position point = turning.centre;
  const Number scale = Number(1) + turning.growth * part;
  for (const Axis axis : kAllAxes) {
    point[axis] += turning.drift[axis] * part;
    if (!reference::is_linear(axis)) continue;
    if (turning.u[axis].sign() == 0 && turning.w[axis].sign() == 0) continue;
    point[axis] += (turning.u[axis] * cosine + turning.w[axis] * sine) * scale;
  }
  return point;
}

// Its middle is farthest: r (1 - cos(half the sweep)), of a whole turn and more the diameter.
bool is_within_of_chord(const Turning& turning, const Number& tau) {
  if (turning.degrees >= Number(360)) return turning.radius * 2 <= tau;
  const Number cosine = rational_near(exact::cos_degrees(turning.degrees / 2));
  return turning.radius * (Number(1) - cosine) <= tau;
}

}  // namespace

Number rational_near(const Number& number) {
  return number.is_rational() ? number : number.bounds(kBitsOfPlace)[0];
}

Position rational_near(const Position& position) {
  Position near;
  for (const Axis axis : kAllAxes) near[axis] = rational_near(position[axis]);
  return near;
}

Position end_of(const Record& record, const Position& from) {
  Position to = from;
  for (const Axis axis : kAllAxes) {
    if (record.axes.has(axis)) to[axis] = record.to[axis];
  }
  return to;
}

Rastered rastered(const Position& position, const Number& tau) {
  const Number raster = min(Number::millionths(1), tau / 128);
  Rastered result;
  for (const Axis axis : kAllAxes) {
    const Number near = rational_near(position[axis]);
    const Number steps = raster.sign() > 0 ? near / raster : Number(0);
    result.at[axis] = raster.sign() > 0 ? steps.floor() * raster : near;
    const bool is_exact = position[axis].is_rational() && result.at[axis] == near;
    if (!is_exact) result.width = max(raster, Number::binary(1, -kBitsOfPlace));
  }
  return result;
}

namespace {

// Along the axis where they are farthest; of anything but an arc nothing.
std::optional<Number> between_ends(const Record& record, const Position& from) {
  if (record.kind != RecordKind::arc) return std::nullopt;
  const reference::PlaneAxes axes = reference::axes_of(record.plane);
  return max(abs(rational_near(record.to[axes.p] - from[axes.p])),
             abs(rational_near(record.to[axes.q] - from[axes.q])));
}

}  // namespace

bool ends_agree(const Record& arc, const Position& from, const Number& tau) {
  const std::optional<Number> apart = between_ends(arc, from);
  return apart && *apart <= tau;
}

bool has_two_readings(const Record& record, const Position& from, const Number& tau) {
  const std::optional<Number> apart = between_ends(record, from);
  return apart && *apart > kOneNumber && *apart <= tau;
}

Cutter::Cutter(const Record& record, const Position& from, const Number& tau, Turn turn)
    : tau_(tau), to_(end_of(record, from)), here_(rastered(from, tau)) {
  const Position start = rational_near(from);
  const Position end = rational_near(to_);
  if (record.kind == RecordKind::arc) {
    const bool other = turn == Turn::the_other && ends_agree(record, from, tau);
    turning_ = turning_of_arc(record, start, end, other ? Turn::the_other : Turn::as_written);
    is_flat_ = !turning_;
  } else if (record.kind == RecordKind::arc3) {
    Position via = start;
    for (const Axis axis : kLinearAxes) {
      if (record.via_axes.has(axis)) via[axis] = rational_near(record.via[axis]);
    }
    turning_ = turning_of_circle(start, via, end);
    if (!turning_) via_ = via;
    is_flat_ = !turning_;
  }
  if (!turning_) return;
  // A circle that is nowhere wider than tau does not show how often it is gone round.
  const Number turns = (turning_->degrees / 360).floor();
  if (turning_->radius * 2 <= tau && turns > Number(2)) turning_->degrees -= (turns - 2) * 360;
  is_flat_ = is_within_of_chord(*turning_, tau);
  steps_of_turn_ = steps_of_turn(*turning_, tau);
  steps_ = turning_->degrees * steps_of_turn_ / 360;
}

Chord Cutter::chord_to(const Position& point, const Number& width) {
  Rastered next = rastered(point, tau_);
  Chord chord{here_.at, next.at, width + max(here_.width, next.width)};
  here_ = std::move(next);
  return chord;
}

std::optional<Chord> Cutter::next() {
  if (is_done_) return std::nullopt;
  if (via_) {
    const Position via = *via_;
    via_.reset();
    return chord_to(via, 0);
  }
  ++step_;
  if (!turning_ || Number(step_) >= steps_) {
    is_done_ = true;
    return chord_to(to_, turning_ ? width_of(*turning_, steps_of_turn_) : Number(0));
  }
  const auto [cosine, sine] = direction(step_, steps_of_turn_);
  return chord_to(point_of(*turning_, Number(step_) / steps_, cosine, sine),
                  width_of(*turning_, steps_of_turn_));
}

}  // namespace gonogo::relation
