// SPDX-License-Identifier: GPL-3.0-or-later
//
// GSK-COM-05, G02 and G03: an arc by its radius or by its centre; with the depth axis, a helix.
#include <fmt/format.h>

#include "reference/gsk988ta/machine.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

// The start, the end and the chord of an arc in its plane.
struct Arc {
  PlaneAxes axes;
  Number start_p, start_q;
  Number end_p, end_q;
  Number dp, dq;   // end - start
  Number chord_2;  // squared

  Arc(const PlaneAxes& plane_axes, const Position& from, const Position& to)
      : axes(plane_axes),
        start_p(from[axes.p]),
        start_q(from[axes.q]),
        end_p(to[axes.p]),
        end_q(to[axes.q]),
        dp(end_p - start_p),
        dq(end_q - start_q),
        chord_2(dp * dp + dq * dq) {}
};

// The address of the centre's offset along an axis: I with X, J with Y, K with Z.
constexpr char offset_address(Axis axis) {
  return "IJK"[index(axis)];
}

// The centre from R: on the right of the chord for a short clockwise arc; a negative R asks for the
// long one. Nothing when the rules are broken.
std::optional<std::array<Number, 2>> centre_from_radius(BlockContext& block, const Arc& arc,
                                                        int sense) {
  const Number radius = block.words.length('R').value();
  if (arc.chord_2.sign() == 0) {
    block.alarm(AlarmClass::arc_end_point, "GSK-COM-05"_clause, 'R',
                "An arc given by R cannot end where it starts.");
    return std::nullopt;
  }
  const Number height_2 = radius * radius / arc.chord_2 - Number(1) / 4;  // in chords squared
  if (height_2.sign() < 0) {
    block.alarm(AlarmClass::arc_radius, "GSK-COM-05"_clause, 'R',
                "Twice the radius is less than the chord.");
    return std::nullopt;
  }
  const int side = -sense * radius.sign();  // +1: right of the chord
  const Number height = sqrt(height_2) * side;
  return {{(arc.start_p + arc.end_p) / 2 + height * arc.dq,
           (arc.start_q + arc.end_q) / 2 - height * arc.dp}};
}

// Whether abs(sqrt(a) - sqrt(b)) <= limit, without roots: a + b - limit^2 <= 2 sqrt(a b).
bool roots_agree(const Number& a, const Number& b, const Number& limit) {
  const Number left = a + b - limit * limit;
  return left.sign() <= 0 || left * left <= a * b * 4;
}

// The centre from I J K: kept as given; the radii at start and end may differ by parameter 3410.
std::optional<std::array<Number, 2>> centre_from_offsets(BlockContext& block, const Arc& arc) {
  const Number offset_p = block.words.length(offset_address(arc.axes.p)).value_or(0);
  const Number offset_q = block.words.length(offset_address(arc.axes.q)).value_or(0);
  const std::array<Number, 2> centre = {arc.start_p + offset_p, arc.start_q + offset_q};
  const Number start_2 = offset_p * offset_p + offset_q * offset_q;
  const Number end_p = arc.end_p - centre[0];
  const Number end_q = arc.end_q - centre[1];
  const Number end_2 = end_p * end_p + end_q * end_q;
  if (start_2.sign() == 0 && end_2.sign() == 0) {
    if (block.readings.is(ReadingKey::arc_zero_radius, "alarm")) {
      block.alarm(AlarmClass::arc_radius, "GSK-COM-05"_clause, offset_address(arc.axes.p),
                  "The radius of the arc is zero.");
    }
    return std::nullopt;
  }
  const Number limit = block.profile.parameter("3410").value_or(Number::millionths(10'000));
  const bool checked =
      limit.sign() > 0 ||
      (limit.sign() == 0 && block.readings.is(ReadingKey::arc_tolerance_zero, "exact"));
  if (checked && !roots_agree(start_2, end_2, limit)) {
    if (start_2.sign() == 0 && block.readings.is(ReadingKey::arc_zero_radius, "alarm")) {
      block.alarm(AlarmClass::arc_radius, "GSK-COM-05"_clause, offset_address(arc.axes.p),
                  "The arc begins at its centre.");
    }
    block.alarm(AlarmClass::arc_end_point, "GSK-COM-05"_clause, offset_address(arc.axes.p),
                fmt::format("The radii at start and end differ by more than {} mm.", limit.text()));
    return std::nullopt;
  }
  return centre;
}

}  // namespace

void run_arc(BlockContext& block, int sense) {
  const BlockWords& words = block.words;
  Machine& machine = block.machine;
  const PlaneAxes axes = axes_of(machine.plane);
  const bool by_radius = words.has('R');
  const bool by_centre = words.has(offset_address(axes.p)) || words.has(offset_address(axes.q));
  Position to;
  const AxisSet named = commanded_end_point(block, to);
  if (named.empty() && !by_radius && !by_centre) return;
  block.need_feed();
  if (!by_radius && !by_centre) {
    block.missing("GSK-COM-05"_clause, 'R');
    return;
  }
  const Arc arc(axes, machine.position, to);
  const auto centre =
      by_radius ? centre_from_radius(block, arc, sense) : centre_from_offsets(block, arc);
  if (!centre) {
    // Under gsk.arc.zero-radius = none only the axes outside the plane have a way to go.
    if (block.out.alarms.empty() && to != machine.position) run_straight_feed(block);
    return;
  }
  Record record = block.motion(RecordKind::arc, "GSK-COM-05"_clause, {});
  record.plane = machine.plane;
  record.centre = *centre;
  record.rot = sense;
  record.axes = named | AxisSet{axes.p, axes.q};
  record.to = to;
  machine.position = to;
  block.put(std::move(record));
}

}  // namespace gonogo::reference::gsk988ta
