// SPDX-License-Identifier: GPL-3.0-or-later
//
// End points, Cartesian and polar, and the pole.
#include <fmt/format.h>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"
#include "reference/sinumerik/machine.hpp"

namespace gonogo::reference::sinumerik {
namespace {

using grammar::Dimension;

constexpr ClauseId kRules = "SIE-POL-02"_clause;

struct PolarPoint {
  Number radius;
  Number angle;
};

void move_axis(EndPoint& end, Axis axis, const AxisWord& word, const Number& from) {
  end.named.add(axis);
  end.by[axis] = word.incremental ? word.value : word.value - from;
  end.to[axis] = word.incremental ? from + word.value : word.value;
}

// SIE-POL-02: the ranges of the words, as written. Whether they are kept.
bool check_ranges(BlockContext& block) {
  const BlockWords& words = block.words;
  bool kept = true;
  if (words.has(Address::rp) && decided(kRules, "RP", words.written(Address::rp)) < 0) {
    block.alarm(AlarmClass::value_sign, kRules, WordName("RP"),
                with_values("The polar radius {} is below zero.", {words.written(Address::rp)}));
    kept = false;
  }
  if (words.has(Address::ap) &&
      decided(kRules, "abs(AP) - 360", exact::abs(words.written(Address::ap)), 360) > 0) {
    block.alarm(AlarmClass::value_out_of_range, kRules, WordName("AP"),
                with_values("A polar angle is from -360 to 360 degrees, and not {}.",
                            {words.written(Address::ap)}));
    kept = false;
  }
  return kept;
}

// SIE-POL-02: AP=IC() adds to the angle in force; AP under G91 only under a reading. Nothing is
// asked where the first of a pole is its own angle.
bool adds_to_angle(const BlockContext& block, const std::optional<Number>& in_force) {
  const Dimension dimension = block.words.dimension(Address::ap);
  if (dimension != Dimension::as_in_force) return dimension == Dimension::incremental;
  return block.machine.modes.incremental && in_force && in_force->sign() != 0 &&
         block.readings.is("sie.ap.g91=incremental"_reading);
}

// SIE-POL-02: AP and RP hold on.
std::optional<PolarPoint> polar_point(BlockContext& block) {
  const BlockWords& words = block.words;
  Machine& machine = block.machine;
  const bool in_range = check_ranges(block);
  if (words.has(Address::rp)) machine.polar_radius = words.length(Address::rp);
  if (words.has(Address::ap)) {
    const Number& angle = words.written(Address::ap);
    if (!adds_to_angle(block, machine.polar_angle)) {
      machine.polar_angle = angle;
    } else if (machine.polar_angle) {
      machine.polar_angle = *machine.polar_angle + angle;
    }
  }
  if (!machine.polar_angle) block.missing(kRules, WordName("AP"));
  if (!machine.polar_radius) block.missing(kRules, WordName("RP"));
  if (!in_range || !machine.polar_angle || !machine.polar_radius) return std::nullopt;
  return PolarPoint{*machine.polar_radius, *machine.polar_angle};
}

Vector_2 polar_vector(const PolarPoint& polar) {
  const auto [cosine, sine] = exact::cos_sin_degrees(polar.angle);
  return Vector_2(cosine, sine) * polar.radius;
}

// SIE-ARC-10: whether a polar point is the place where the machine stands; nothing when that does
// not show in the polar coordinates.
std::optional<bool> is_place(const Machine& machine, const PolarPoint& polar) {
  const std::optional<PlaceMark>& mark = machine.mark;
  if (!mark || !mark->polar || mark->plane != machine.plane ||
      !surely_equal(mark->centre, machine.pole)) {
    return std::nullopt;
  }
  if (polar.radius != mark->polar->radius) return false;
  if (polar.radius.sign() == 0) return true;
  const Number turns = (polar.angle - mark->polar->angle) / Number(360);
  return turns == turns.floor();
}

void add_polar(BlockContext& block, const PolarPoint& polar, EndPoint& end) {
  const Machine& machine = block.machine;
  const PlaneAxes axes = block.plane_axes();
  const Point_2 at = machine.pole + polar_vector(polar);
  end.closed = is_place(machine, polar);
  if (!end.closed.value_or(false)) {
    move_axis(end, axes.p, {false, at.x()}, machine.position[axes.p]);
    move_axis(end, axes.q, {false, at.y()}, machine.position[axes.q]);
  }
  end.named = end.named | AxisSet{axes.p, axes.q};
  end.mark = PlaceMark{machine.plane, machine.pole, polar.radius * polar.radius,
                       PlaceMark::Polar{polar.radius, polar.angle}};
}

// SIE-COM-01: no Cartesian words of the plane beside AP and RP.
bool refuse_cartesian(BlockContext& block) {
  bool refused = false;
  for (const Axis axis : {block.plane_axes().p, block.plane_axes().q}) {
    const Address address = address_of(axis);
    if (!block.words.has(address)) continue;
    refused = true;
    block.alarm(AlarmClass::conflicting_words, "SIE-COM-01"_clause, name_of(address),
                fmt::format("{} is an axis of the plane: it does not stand beside AP and RP.",
                            name_of(address).text()));
  }
  return refused;
}

// SIE-POL-01: what the words of the pole's block add to its base. Both axes of the plane, or AP
// and RP; what is not written is 0.
std::optional<Vector_2> pole_words(BlockContext& block) {
  const BlockWords& words = block.words;
  const PlaneAxes axes = block.plane_axes();
  if (!words.is_polar()) {
    const auto along = [&](Axis axis) {
      return words.has(address_of(axis)) ? words.length(address_of(axis)) : Number();
    };
    return Vector_2(along(axes.p), along(axes.q));
  }
  const bool refused = refuse_cartesian(block);
  const bool in_range = check_ranges(block);
  if (!words.has(Address::ap)) block.missing(kRules, WordName("AP"));
  if (!words.has(Address::rp)) block.missing(kRules, WordName("RP"));
  if (refused || !in_range || !words.has(Address::ap) || !words.has(Address::rp)) {
    return std::nullopt;
  }
  return polar_vector({words.length(Address::rp), words.written(Address::ap)});
}

void forget_polar(Machine& machine) {
  machine.polar_angle.reset();
  machine.polar_radius.reset();
}

// SIE-POL-04: whether the block does something else from that pole, AP and RP than from the
// workpiece zero without them.
bool shows(const BlockContext& block, const PolarState& before) {
  const BlockWords& words = block.words;
  if (before.pole_is_put) return true;
  if (block.codes.once == 112) return false;
  if (before.polar_radius && !words.has(Address::rp)) return true;
  if (!before.polar_angle) return false;
  return !words.has(Address::ap) || adds_to_angle(block, before.polar_angle);
}

}  // namespace

std::optional<EndPoint> end_point(BlockContext& block) {
  const BlockWords& words = block.words;
  const bool is_polar = words.is_polar();
  EndPoint end;
  end.to = block.machine.position;
  // SIE-ARC-06
  if (is_polar) {
    const bool refused = refuse_cartesian(block);
    const std::optional<PolarPoint> polar = polar_point(block);
    if (refused || !polar) return std::nullopt;
    add_polar(block, *polar, end);
  }
  for (const Axis axis : kAllAxes) {
    if (!words.has(address_of(axis))) continue;
    AxisWord word = words.axis_word(axis);
    if (word.incremental) word.value += untravelled_along(block, axis);
    move_axis(end, axis, word, block.machine.position[axis]);
  }
  return end;
}

// SIE-FRM-06: an increment behind another translation.
Number untravelled_along(const BlockContext& block, Axis axis) {
  const Machine& machine = block.machine;
  if (!has_untravelled(machine)) return {};
  const Number way = machine.frame.turned_back(machine.untravelled)[axis];
  const bool is_none = way.try_sign() == 0;
  if (is_none || block.readings.is("sie.frame.increment=alone"_reading)) return {};
  return way;
}

// SIE-POL-02: the pole goes to the workpiece zero.
void take_plane(Machine& machine, Plane plane) {
  PolarState& polar = machine;
  if (plane != machine.plane) {
    machine.polar_before.reset();
  } else if (polar.pole_is_put || polar.polar_angle || polar.polar_radius) {
    machine.polar_before = polar;
  }
  machine.plane = plane;
  polar = PolarState{CGAL::ORIGIN, false, false, std::nullopt, std::nullopt};
}

// SIE-POL-04
void settle_pole(BlockContext& block) {
  std::optional<PolarState>& before = block.machine.polar_before;
  const bool puts_another = block.codes.once == 110 || block.codes.once == 111;
  if (!before || !(block.words.is_polar() || puts_another || block.codes.once == 112)) return;
  PolarState& polar = block.machine;
  const bool is_kept = !puts_another && shows(block, *before) &&
                       block.readings.is("sie.pole.same-plane=kept"_reading);
  if (is_kept) polar = *before;
  before.reset();
}

// SIE-POL-01
void run_pole(BlockContext& block) {
  Machine& machine = block.machine;
  const PlaneAxes axes = block.plane_axes();
  const std::optional<Vector_2> by = pole_words(block);
  if (!by) return;
  Point_2 base = CGAL::ORIGIN;  // G111: the workpiece zero
  if (block.codes.once == 110) base = block.position_in(axes);
  if (block.codes.once == 112) base = machine.pole;
  machine.pole = base + *by;
  machine.pole_is_put = true;
  machine.pole_is_of_before = false;
  forget_polar(machine);
  if (block.words.is_polar() && surely_equal(base, block.position_in(axes))) {
    // SIE-ARC-10: seen from the pole the machine stands on the other side, exactly RP away.
    const Number radius = block.words.length(Address::rp);
    const Number angle = block.words.written(Address::ap) + 180;
    machine.mark =
        PlaceMark{machine.plane, machine.pole, radius * radius, PlaceMark::Polar{radius, angle}};
  }
}

}  // namespace gonogo::reference::sinumerik
