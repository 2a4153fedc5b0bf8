// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a place is from where a motion may lead, for the evidence of a departure, mm. Along the
// linear axis where it is farthest, as the tolerance is meant; from a circle, along its radius.
#include <cmath>
#include <numbers>
#include <vector>

#include "oracle/motion/curve.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {

using reference::kAllAxes;
using reference::kLinearAxes;
using reference::PlaneAxes;

namespace {

// From the box between two points.
Number distance_from_box(const Position& from, const Position& to, const Position& point) {
  Number distance = 0;
  for (Axis axis : kLinearAxes) {
    distance = max(distance, min(from[axis], to[axis]) - point[axis]);
    distance = max(distance, point[axis] - max(from[axis], to[axis]));
  }
  return distance;
}

// |at - t along|, how far a point is along one axis from the point of a line at t.
struct AxisOffset {
  Number at;
  Number along;
};

Number farthest(const std::vector<AxisOffset>& offsets, const Number& t) {
  Number distance = 0;
  for (const AxisOffset& each : offsets) distance = max(distance, abs(each.at - t * each.along));
  return distance;
}

// From the line between two points. The largest of several |a - t b| is least at an end, where one
// of them is zero, or where two are equal.
Number distance_from_line(const Position& from, const Position& to, const Position& point) {
  std::vector<AxisOffset> offsets;
  for (Axis axis : kLinearAxes) {
    AxisOffset offset{point[axis] - from[axis], to[axis] - from[axis]};
    if (offset.at.sign() != 0 || offset.along.sign() != 0) offsets.push_back(std::move(offset));
  }
  Number least = min(farthest(offsets, 0), farthest(offsets, 1));
  const auto try_at = [&](const Number& at, const Number& along) {
    if (along.sign() == 0) return;
    const Number t = at / along;
    if (t.sign() > 0 && t < 1) least = min(least, farthest(offsets, t));
  };
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    try_at(offsets[i].at, offsets[i].along);
    for (std::size_t j = i + 1; j < offsets.size(); ++j) {
      try_at(offsets[i].at - offsets[j].at, offsets[i].along - offsets[j].along);
      try_at(offsets[i].at + offsets[j].at, offsets[i].along + offsets[j].along);
    }
  }
  return least;
}

// The angle from one vector to another in turns, in [0, 1), in the sense of the turning; about 0
// where no sign of it is visible.
Number part_between(const PlaneVector& a, const PlaneVector& b, int sense) {
  const Number along = dot(a, b);
  const Number across = cross(a, b) * sense;
  if (across.try_sign() || visible_sign(along) <= 0) {
    return exact::angle_degrees(along, across) / 360;
  }
  return exact::angle_degrees(-along, -across) / 360 - Number(1) / 2;
}

// The same with the whole turns that an estimate says.
Number turns_between(const PlaneVector& a, const PlaneVector& b, int sense, double turns) {
  const Number part = part_between(a, b, sense);
  return part + static_cast<std::int64_t>(std::lround(turns - estimate(part)));
}

bool is_nil(const PlaneVector& v) {
  return v.p.sign() == 0 && v.q.sign() == 0;
}

Number length(const PlaneVector& v) {
  return sqrt(norm_squared(v));
}

}  // namespace

// An arc is measured along the radius, and along the axis outside its plane, at the part of its
// sweep where the point is seen from its centre.
Number RoundCurve::distance(const Position& point, double turns) const {
  if (arc_ == nullptr) return distance_in_space(point);
  const Record& arc = arc_->record;
  const PlaneAxes axes = reference::axes_of(arc.plane);
  const PlaneVector a = from_centre(arc, arc_->from);
  const PlaneVector b = from_centre(arc, arc_->to());
  const PlaneVector v = from_centre(arc, point);
  const int sense = arc.rot < 0 ? -1 : 1;
  // From the centre no direction is seen, nor that of an end which is the centre.
  const bool has_part = !is_nil(a) && !is_nil(b) && !is_nil(v);
  const auto at_part = [&](const Number& first, const Number& last) -> Number {
    if (!has_part || first == last) return first;
    return first +
           turns_between(a, v, sense, turns) / turns_between(a, b, sense, whole_) * (last - first);
  };
  Number distance = abs(length(v) - (is_spiral() ? at_part(length(a), length(b)) : length(a)));
  const Number depth = at_part(motion_.from[axes.d], motion_.to()[axes.d]);
  return max(distance, abs(point[axes.d] - depth));
}

// The value at the middle of the box, and by how much it differs elsewhere in it at most.
struct RoundCurve::AtAngle {
  Number value;
  Number spread;
};

// Nothing where the box is seen at more than a right angle. Its half diagonal, at most 3/2 of the
// tolerance, is seen at no more than pi/2 times its part of the distance, which is a quarter of
// that part in turns.
std::optional<RoundCurve::AtAngle> RoundCurve::at_angle(const Position& point, double turns,
                                                        const Number& tolerance,
                                                        const Number& first,
                                                        const Number& last) const {
  const Record& arc = arc_->record;
  const PlaneVector a = from_centre(arc, arc_->from);
  const PlaneVector b = from_centre(arc, arc_->to());
  const PlaneVector v = from_centre(arc, point);
  const Number seen = tolerance * 3 / 2;
  if (is_nil(a) || is_nil(b) || norm_squared(v) <= seen * seen) return std::nullopt;
  const int sense = arc.rot < 0 ? -1 : 1;
  const Number change = (last - first) / turns_between(a, b, sense, whole_);
  return AtAngle{first + turns_between(a, v, sense, turns) * change,
                 abs(change) * seen / (length(v) * 4)};
}

bool RoundCurve::is_surely_off_helix(Axis axis, const Position& point, double turns,
                                     const Number& tolerance) const {
  const auto height = at_angle(point, turns, tolerance, motion_.from[axis], motion_.to()[axis]);
  return height && abs(point[axis] - height->value) > tolerance + height->spread;
}

bool RoundCurve::is_surely_off_spiral(const Position& point, double turns,
                                      const Number& tolerance) const {
  const PlaneVector v = from_centre(arc_->record, point);
  const auto radius =
      at_angle(point, turns, tolerance, length(from_centre(arc_->record, arc_->from)),
               length(from_centre(arc_->record, arc_->to())));
  if (!radius) return false;
  const PlaneVector near{max(abs(v.p) - tolerance, 0), max(abs(v.q) - tolerance, 0)};
  const PlaneVector far{abs(v.p) + tolerance, abs(v.q) + tolerance};
  return length(near) > radius->value + radius->spread ||
         length(far) < radius->value - radius->spread;
}

// From the whole circle.
Number RoundCurve::distance_in_space(const Position& point) const {
  if (!points_->circle) return 0;
  const SpaceCircle& circle = *points_->circle;
  const SpacePoint v = space_point(point) - circle.centre;
  const Number normal_2 = dot(circle.normal, circle.normal);
  const Number above = dot(v, circle.normal);
  const Number above_2 = above * above / normal_2;
  const Number beside = sqrt(dot(v, v) - above_2) - sqrt(circle.radius_2);
  return sqrt(above_2 + beside * beside);
}

Number Curve::distance(const CurveProgress& from, const Position& point, double turns) const {
  const RecordKind kind = reference_.record.kind;
  if (kind == RecordKind::rapid) {
    return distance_from_box(from.traverse ? *from.traverse : reference_.from, reference_.to(),
                             point);
  }
  if (!round_ || comes_as_line()) {
    Position reached = reference_.from;
    const Axis axis = longest_axis(reference_);
    const Number travel = abs(reference_.to()[axis] - reference_.from[axis]);
    const Number part = travel.sign() == 0 ? Number(0) : from.line / travel;
    for (Axis each : kAllAxes) {
      reached[each] += part * (reference_.to()[each] - reference_.from[each]);
    }
    return distance_from_line(reached, reference_.to(), point);
  }
  Number least = largest_difference(point, reference_.to());
  // A sweep that is nearly whole may be nil.
  for (const double each : {turns, turns - 1}) {
    if (each < from.arc - kEstimate || each > round_->whole() + kEstimate) continue;
    least = min(least, round_->distance(point, each));
  }
  return least;
}

namespace {

// A point of an arc, turned so many degrees from its start in its sense, or against it.
Position turned(const Motion& arc, const Number& degrees, bool backward) {
  const PlaneAxes axes = reference::axes_of(arc.record.plane);
  const PlaneVector a = from_centre(arc.record, arc.from);
  const PlaneVector b = from_centre(arc.record, arc.to());
  const int sense = arc.record.rot < 0 ? -1 : 1;
  const auto [cosine, sine] = exact::cos_sin_degrees(degrees * (backward ? -sense : sense));
  Position point = arc.from;
  point[axes.p] = arc.record.centre[0] + a.p * cosine - a.q * sine;
  point[axes.q] = arc.record.centre[1] + a.p * sine + a.q * cosine;
  if (is_nil(a) || is_nil(b)) return point;
  for (Axis axis : kAllAxes) {
    if (axis == axes.p || axis == axes.q || arc.from[axis] == arc.to()[axis]) continue;
    const Number part = degrees / 360 / turns_between(a, b, sense, approximate_turns(arc));
    point[axis] += part * (arc.to()[axis] - arc.from[axis]);
  }
  return point;
}

// Degrees from the start of an arc to points between its ends, of the first turn: halves of right
// angles, where coordinates are exact, or about its middle.
std::vector<Number> angles_within(const Motion& arc) {
  const double sweep = std::min(approximate_turns(arc) * 360, 360.0);
  std::vector<Number> angles;
  for (int degrees = kWitnessDegrees; degrees < sweep; degrees += kWitnessDegrees)
    angles.emplace_back(degrees);
  if (angles.empty()) angles.push_back(Number::millionths(std::llround(sweep * 500'000)));
  return angles;
}

// Where an arc of one radius in its plane is directly beside, above or below its centre: it reaches
// farthest out there.
std::vector<Position> outermost(const Motion& arc) {
  const PlaneAxes axes = reference::axes_of(arc.record.plane);
  const PlaneVector a = from_centre(arc.record, arc.from);
  const PlaneVector b = from_centre(arc.record, arc.to());
  const Number square = a.p * a.p + a.q * a.q;
  const Number growth = b.p * b.p + b.q * b.q - square;
  const Number rise = arc.to()[axes.d] - arc.from[axes.d];
  const auto& [p, q] = arc.record.centre;
  for (const Number& number : {p, q, square, growth, rise}) {
    if (!number.is_rational()) return {};
  }
  if (growth.sign() != 0 || rise.sign() != 0) return {};
  const int sense = arc.record.rot < 0 ? -1 : 1;
  const double start = std::atan2(estimate(a.q), estimate(a.p)) * 180 / std::numbers::pi;
  const double sweep = std::min(approximate_turns(arc) * 360, 360.0);
  std::vector<Position> points;
  for (const int degrees : {0, 90, 180, 270}) {
    double turned_by = std::fmod(sense * (degrees - start), 360.0);
    if (turned_by < 0) turned_by += 360;
    if (turned_by < kEstimate || turned_by > sweep - kEstimate) continue;
    const int out = degrees < 180 ? 1 : -1;
    const bool along_p = degrees % 180 == 0;
    Position point = arc.from;
    point[axes.p] = along_p ? Number::root(p, out, square) : p;
    point[axes.q] = along_p ? q : Number::root(q, out, square);
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace

Apart Curve::farthest(const Apart& known, const CurveProgress& from, const Motion& subject) const {
  const std::optional<Motion> arc = as_arc(subject);
  if (!arc || arc->record.kind != RecordKind::arc) return known;
  Apart most = known;
  const auto take = [&](Position point, Number distance) {
    if (estimate(distance) > estimate(most.distance))
      most = {std::move(point), std::move(distance)};
  };
  std::vector<Position> points = outermost(*arc);
  for (const Number& degrees : angles_within(*arc)) points.push_back(turned(*arc, degrees, false));
  for (Position& point : points) {
    const double turns = from.arc + (round_ ? round_->part_of_turn(arc->from, point) : 0);
    Number off = distance(from, point, turns);
    Number off_start = largest_difference(point, arc->from);
    if (estimate(off_start) < estimate(off)) off = std::move(off_start);
    take(std::move(point), std::move(off));
  }
  const bool is_other_way = reference_.record.kind == RecordKind::arc &&
                            (reference_.record.rot < 0) != (arc->record.rot < 0);
  if (!is_other_way || most.distance > tolerances_.tolerance) return most;
  for (const Number& degrees : angles_within(*arc)) {
    Position point = turned(*arc, degrees, false);
    Number off = largest_difference(point, turned(*arc, degrees, true));
    take(std::move(point), std::move(off));
  }
  return most;
}

// J-CMP-12: its end, or a point before that if the end lies where it may.
Apart Curve::apart(const CurveProgress& from, const Motion& subject) const {
  const auto turns_to = [&](const Position& point) {
    return from.arc + (round_ ? round_->part_of_turn(subject.from, point) : 0);
  };
  const bool is_arc = subject.record.kind == RecordKind::arc;
  const double sweep = is_arc ? approximate_turns(subject) : 0;
  const double to_end = is_arc ? from.arc + sweep : turns_to(subject.to());
  Apart end{subject.to(), distance(from, subject.to(), to_end)};
  if (end.distance > tolerances_.tolerance) return end;
  std::vector<Position> others;
  if (subject.record.kind == RecordKind::arc3) others.push_back(via_of(subject));
  if (subject.record.kind == RecordKind::feed) {
    others.push_back(subject.from);
    for (Axis axis : kAllAxes) {
      others.back()[axis] += (subject.to()[axis] - subject.from[axis]) / 2;
    }
  }
  for (const Position& point : others) {
    Apart there{point, distance(from, point, turns_to(point))};
    if (there.distance > tolerances_.tolerance) return there;
  }
  return end;
}

}  // namespace gonogo::oracle
