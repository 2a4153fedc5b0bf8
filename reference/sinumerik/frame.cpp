// SPDX-License-Identifier: GPL-3.0-or-later
//
// G158, G258 and G259, and what they make of coordinates.
#include "reference/sinumerik/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "reference/clause_literal.hpp"
#include "reference/reading_literal.hpp"
#include "reference/sinumerik/machine.hpp"

namespace gonogo::reference::sinumerik {

using geometry::Aff_transformation_2;

std::array<Number, 2> Frame::direction_in(Plane plane) const {
  if (plane != plane_) return {1, 0};
  return {rotation_.m(0, 0), rotation_.m(1, 0)};
}

void Frame::clear() {
  *this = Frame();
}

void Frame::translate(const Position& by) {
  const Position way = turned(by);
  for (const Axis axis : kLinearAxes) translation_[axis] += way[axis];
  is_translated_ = true;
}

void Frame::set_rotation(Plane plane, const Number& degrees) {
  plane_ = plane;
  angle_ = degrees - (degrees / 360).floor() * 360;
  const auto [cosine, sine] = exact::cos_sin_degrees(angle_);
  rotation_ = Aff_transformation_2(CGAL::ROTATION, sine, cosine);
}

namespace {

// A, C and the axis upright on the plane stay.
Position turned_in(const PlaneAxes& axes, const Aff_transformation_2& turn, Position way) {
  geometry::put_in(way, axes, turn(geometry::vector_in(axes, way)));
  return way;
}

}  // namespace

Position Frame::turned(const Position& way) const {
  return is_rotated() ? turned_in(axes_of(plane_), rotation_, way) : way;
}

Position Frame::turned_back(const Position& way) const {
  return is_rotated() ? turned_in(axes_of(plane_), rotation_.inverse(), way) : way;
}

Position Frame::to_base(const Position& workpiece) const {
  Position out = turned(workpiece);
  for (const Axis axis : kLinearAxes) out[axis] += translation_[axis];
  return out;
}

Position Frame::to_workpiece(const Position& base) const {
  Position out = base;
  for (const Axis axis : kLinearAxes) out[axis] -= translation_[axis];
  return turned_back(out);
}

Record Frame::to_base(Record record, const Position& end) const {
  record.to = to_base(end);
  const PlaneAxes turned_axes = axes_of(plane_);
  const auto name_both = [&](AxisSet& axes) {
    if (is_rotated() && (axes.has(turned_axes.p) || axes.has(turned_axes.q))) {
      axes = axes | AxisSet{turned_axes.p, turned_axes.q};
    }
  };
  name_both(record.axes);
  if (record.kind == RecordKind::arc) {
    const PlaneAxes axes = axes_of(record.plane);
    Position centre;
    geometry::put_in(centre, axes, geometry::point(record.centre));
    record.centre = geometry::pair(geometry::point_in(axes, to_base(centre)));
  } else if (record.kind == RecordKind::arc3) {
    record.via = to_base(record.via);
    name_both(record.via_axes);
  }
  return record;
}

namespace {

// SIE-CT-02: the direction of the motion before turns along. A helix goes on climbing along its
// axis where that does not turn.
void turn_last_motion(LastMotion& last, const Frame& old, const Frame& next) {
  const auto tilts = [&](const Frame& frame) {
    return frame.is_rotated() && axes_of(frame.plane()).d != last.arc->climb->axis;
  };
  if (last.arc && last.arc->climb && (tilts(old) || tilts(next))) {
    last.direction = whole_direction(last);
    last.arc->climb.reset();
  }
  last.direction = next.turned_back(old.turned(last.direction));
}

// The same place seen in another frame, where its centre stays a rational point. Nothing where it
// does not, or where a rotation tilts its plane.
std::optional<PlaceMark> in_frame(const PlaceMark& mark, const Frame& old, const Frame& next) {
  Number turned_back;  // degrees
  for (const auto& [frame, sense] : {std::pair(&old, 1), {&next, -1}}) {
    if (!frame->is_rotated()) continue;
    if (frame->plane() != mark.plane) return std::nullopt;
    turned_back += frame->angle() * sense;
  }
  const PlaneAxes axes = axes_of(mark.plane);
  Position centre;
  geometry::put_in(centre, axes, mark.centre);
  centre = next.to_workpiece(old.to_base(centre));
  if (!centre[axes.p].is_rational() || !centre[axes.q].is_rational()) return std::nullopt;
  PlaceMark found{mark.plane, geometry::point_in(axes, centre), mark.radius_2, mark.polar};
  if (found.polar) found.polar->angle += turned_back;
  return found;
}

// SIE-FRM-04: what stood in the old frame stands in the new one, and nothing moves.
void stand_in(Machine& machine, const Frame& next) {
  machine.position = next.to_workpiece(machine.base);
  if (machine.mark) machine.mark = in_frame(*machine.mark, machine.frame, next);
  if (machine.last) turn_last_motion(*machine.last, machine.frame, next);
  const bool changes = machine.frame.is_in_force() || next.is_in_force();
  if (machine.pole_is_put && changes) machine.pole_is_of_before = true;
  std::optional<PolarState>& before = machine.polar_before;
  if (before && before->pole_is_put && changes) before->pole_is_of_before = true;
  for (const Axis axis : kLinearAxes) {
    machine.untravelled[axis] += next.translation()[axis] - machine.frame.translation()[axis];
  }
  machine.frame = next;
}

// SIE-FRM-04: no word of an axis or of an angle where it does not belong.
bool refuse(BlockContext& block, std::initializer_list<Address> addresses) {
  bool refused = false;
  for (const Address address : addresses) {
    if (!block.words.has(address)) continue;
    refused = true;
    block.alarm(
        AlarmClass::conflicting_words, "SIE-FRM-04"_clause, name_of(address),
        fmt::format("{} does not stand beside G{}.", name_of(address).text(), block.codes.once));
  }
  return refused;
}

// SIE-FRM-03: RPL45, where it may stand so.
void warn_of_bare_rpl(BlockContext& block) {
  const grammar::NamedWord& word = *block.words.word(Address::rpl);
  if (word.has_equals) return;
  block.out.warnings.push_back(
      {"RPL stands without '='; it is read as if it had one.", word.where});
}

}  // namespace

bool has_untravelled(const Machine& machine) {
  return std::ranges::any_of(kLinearAxes,
                             [&](Axis axis) { return machine.untravelled[axis].try_sign() != 0; });
}

// SIE-FRM-06: axes that were sent somewhere stand in the frame in force.
void travel(Machine& machine, AxisSet axes) {
  if (!has_untravelled(machine)) return;
  Position along = machine.frame.turned_back(machine.untravelled);
  for (const Axis axis : kLinearAxes) {
    if (axes.has(axis)) along[axis] = 0;
  }
  machine.untravelled = machine.frame.turned(along);
}

// SIE-FRM-01
void run_translation(BlockContext& block) {
  if (refuse(block, {Address::a, Address::c, Address::rpl})) return;
  Machine& machine = block.machine;
  Position by;
  bool any = false;
  for (const Axis axis : kLinearAxes) {
    const Address address = address_of(axis);
    if (!block.words.has(address)) continue;
    if (block.words.dimension(address) != grammar::Dimension::as_in_force) {
      block.alarm(AlarmClass::conflicting_words, "SIE-FRM-04"_clause, name_of(address),
                  "AC and IC have no meaning for a translation.");
      return;
    }
    by[axis] = block.words.length(address);
    any = true;
  }
  Frame next = machine.frame;
  if (!any) {
    next.clear();
  } else if (!next.is_in_force()) {
    next.set_translation(by);
  } else if (block.readings.is("sie.g158=additive"_reading)) {
    next.translate(by);
  } else {
    if (!block.readings.is("sie.g158=translation-only"_reading)) next.clear();
    next.set_translation(by);
  }
  stand_in(machine, next);
}

// SIE-FRM-02, SIE-FRM-04
void run_rotation(BlockContext& block) {
  if (refuse(block, {Address::x, Address::y, Address::z, Address::a, Address::c})) return;
  Machine& machine = block.machine;
  const bool adds = block.codes.once == 259;
  Frame next = machine.frame;
  if (!adds) {
    // Touched where it can matter only.
    const bool keeps =
        machine.frame.is_translated() && block.readings.is("sie.g258=rotation-only"_reading);
    if (keeps) {
      next.set_rotation(machine.plane, 0);
    } else {
      next.clear();
    }
  }
  if (block.words.has(Address::rpl)) {
    warn_of_bare_rpl(block);
    const Number base = adds ? next.angle() : Number(0);
    next.set_rotation(machine.plane, base + block.words.written(Address::rpl));
  } else if (adds) {
    block.missing("SIE-FRM-04"_clause, WordName("RPL"));
    return;
  }
  stand_in(machine, next);
}

// SIE-FRM-04: the position stays. Whether a pole goes along, and whether G53 leaves a programmed
// frame out, too, no text says.
void leave_out_frames(BlockContext& block) {
  const Machine& machine = block.machine;
  const BlockWords& words = block.words;
  const auto leave_out = [&](std::string_view code, std::string_view what) {
    if (block.out.not_covered) return;
    block.out.not_covered =
        NotCovered{block.line, std::string(code), fmt::format("No text says whether {}.", what),
                   words.place_of(WordName(code)).value_or(words.behind())};
  };
  const bool is_pole = block.codes.once == 110 || block.codes.once == 111;
  if (machine.pole_is_of_before && block.codes.once == 112) {
    leave_out("G112", "a pole goes along with G158, G258 and G259");
  } else if (machine.pole_is_of_before && words.is_polar() && !is_pole) {
    leave_out(words.has(Address::rp) ? "RP" : "AP", "a pole goes along with G158, G258 and G259");
  }
  const auto has = [&](Axis axis) { return words.has(address_of(axis)); };
  const bool goes = std::ranges::any_of(kLinearAxes, has) || words.is_polar() ||
                    words.has_centre() || words.has_intermediate();
  if (block.codes.without_offset && machine.frame.is_in_force() && goes) {
    leave_out("G53", "G53 leaves out G158, G258 and G259, too");
  }
}

bool admits_plane(BlockContext& block, Plane plane, WordName word) {
  const Frame& frame = block.machine.frame;
  if (!frame.is_rotated() || frame.plane() == plane) return true;
  block.alarm(AlarmClass::plane_not_allowed, "SIE-FRM-05"_clause, word,
              fmt::format("A rotation in G{} is in force.", plane_code(frame.plane())));
  return false;
}

}  // namespace gonogo::reference::sinumerik
