// SPDX-License-Identifier: GPL-3.0-or-later
// G2 and G3, in the plane in force.
#include <cmath>
#include <limits>

#include "expanders/common/circle.hpp"
#include "expanders/ngc/plan.hpp"
#include "expanders/ngc/radii.hpp"

namespace gonogo::expanders::ngc {
namespace {

constexpr AddressSet kOffsets{"IJK"};
constexpr Fixed kSmallestRadius = 1'270'000;  // 0.00127 mm

/// G2 and G3.
struct Arc {
  int plane = 17;
  Point to{};
  Axes axes = 0;
  Fixed centre_p = 0;
  Fixed centre_q = 0;
  int rot = 0;
  Feed feed;
};

/// One arc on its way from the block to the plan.
struct Sketch {
  const Plane& plane;
  const Point& from;
  Arc arc;
  Chord chord;
  bool counterclockwise;
  bool to_plane_axis;  ///< the block has a word of the plane's axes
};

// The offset along an axis of the plane: I, J, K belong to X, Y, Z.
char offset_of(std::size_t axis) {
  return static_cast<char>('I' + axis);
}

// NGC-ARC-01
int sense_of(const Machine& machine, bool counterclockwise) {
  int sense = counterclockwise ? 1 : -1;
  if (machine.state.plane == 18) sense = machine.alters("g18-sense-flipped"_fault, sense, -sense);
  return machine.alters("g3-clockwise"_fault, sense, -1);
}

// NGC-ARC-05
int turns_of(Machine& machine, const Block& block) {
  if (!block.has('P') || block.uses('P') || machine.adds("turns-ignored"_fault)) return 1;
  const Decimal& written = block.number('P');
  const std::optional<Fixed> whole = machine.whole.turns(written);
  const Fixed count = whole.value_or(written.value / kOne);
  const bool negative = whole ? *whole <= 0 : written.value < 0;
  const bool checked = (!negative && whole) || machine.spares("turns-unchecked"_fault);
  if (negative && checked) {
    machine.complain(AlarmKind::kValueSign, 'P', block);
  } else if (!whole && checked) {
    machine.complain(AlarmKind::kNotAnInteger, 'P', block);
  } else if (count > std::numeric_limits<std::int32_t>::max() - 1) {
    machine.complain(AlarmKind::kValueOutOfRange, 'P', block);
  } else {
    const int turns = count < 1 ? 1 : static_cast<int>(count);
    return machine.alters("turn-extra"_fault, turns, turns + 1);
  }
  return 1;
}

void put_centre(Machine& machine, const Block& block, const Chord& from_start, Sketch& sketch) {
  const Wide p = static_cast<Wide>(sketch.from[sketch.plane.p]) + from_start.p;
  const Wide q = static_cast<Wide>(sketch.from[sketch.plane.q]) + from_start.q;
  if (!fits(p) || !fits(q)) return machine.complain(AlarmKind::kValueOutOfRange, 'R', block);
  sketch.arc.centre_p = static_cast<Fixed>(p);
  sketch.arc.centre_q = static_cast<Fixed>(q);
}

// NGC-ARC-04: R > 0 at most 180 degrees, R < 0 more.
void take_radius(Machine& machine, const Block& block, Sketch& sketch) {
  const Fixed radius = length_of(machine, block, 'R');
  if (!sketch.to_plane_axis) return machine.complain(AlarmKind::kMissingWord, 'X', kNowhere);
  const bool long_way = machine.spares("radius-sign-ignored"_fault, radius < 0);
  const bool left = machine.alters("radius-centre-left"_fault, sketch.counterclockwise, true);
  Chord centre;
  switch (centre_from_radius(sketch.chord, radius, left, long_way, centre)) {
    case CircleDefect::kNoChord:
      return machine.complain(AlarmKind::kArcEndPoint, 'R', block);
    case CircleDefect::kRadiusTooShort: {
      // Half the chord may be longer by the smallest radius: then the centre lies in its middle.
      const Wide reach = 2 * (static_cast<Wide>(magnitude(radius)) + kSmallestRadius);
      const bool forgiven = machine.follows("ngc.arc-tolerance=linuxcnc"_reading) &&
                            sketch.chord.square() <= reach * reach;
      if (!machine.alters("short-radius-forgiven"_fault, forgiven, true)) {
        return machine.complain(AlarmKind::kArcRadius, 'R', block);
      }
      centre = {sketch.chord.p / 2, sketch.chord.q / 2};
      break;
    }
    case CircleDefect::kNone:
      break;
  }
  put_centre(machine, block, centre, sketch);
}

// One coordinate of the centre. NGC-DIS-01: G91.1 counts from the start, G90.1 is absolute.
Fixed centre_along(Machine& machine, const Block& block, std::size_t axis, char address) {
  const Fixed start = machine.state.position[axis];
  if (!block.has(address)) return start;
  const bool absolute =
      machine.spares("absolute-centre-ignored"_fault,
                     machine.alters("offsets-absolute"_fault, machine.state.absolute_centre, true));
  const Fixed length =
      machine.alters("inch-offsets-unscaled"_fault, length_of(machine, block, address),
                     block.number(address).value);
  const Wide place = absolute ? Wide{length} : Wide{start} + length;
  if (fits(place)) return static_cast<Fixed>(place);
  machine.complain(AlarmKind::kValueOutOfRange, address, block);
  return start;
}

// Which words a centre needs and may have; false: there is no centre to check.
bool check_centre_words(Machine& machine, const Block& block, const Sketch& sketch) {
  const char third = offset_of(sketch.plane.d);
  if (block.has(third)) machine.complain(AlarmKind::kAxisNotInPlane, third, block);
  const bool p = block.has(offset_of(sketch.plane.p));
  const bool q = block.has(offset_of(sketch.plane.q));
  if (!p && !q) return false;
  if (machine.state.absolute_centre && (!p || !q)) {
    machine.complain(AlarmKind::kMissingWord, offset_of(p ? sketch.plane.q : sketch.plane.p),
                     kNowhere);
    return false;
  }
  // Reading ngc.full-circle-words
  if (machine.follows("ngc.full-circle-words=needed"_reading) && !sketch.to_plane_axis) {
    machine.complain(AlarmKind::kMissingWord, 'X', kNowhere);
  }
  return true;
}

// Reading ngc.arc-tolerance, in squares of counts: 0.002 mm and 0.0002 in of one; 8 and 0.0008 mm2,
// 0.08 and 0.000008 in2 of LinuxCNC; 0.5 and 0.005 mm, 0.05 and 0.0005 in of its page; grbl's are
// millimetres alone.
RadiusTolerance tolerance_of(const Machine& machine) {
  constexpr Wide kSquareMillimetre = static_cast<Wide>(kOne) * kOne;
  const bool inch = machine.spares("inch-tolerance-millimetres"_fault, machine.state.inch);
  if (machine.follows("ngc.arc-tolerance=nist"_reading)) {
    return {squared(inch ? 5'080'000 : 2'000'000)};
  }
  if (machine.follows("ngc.arc-tolerance=grbl"_reading)) {
    return {squared(500'000'000), squared(5'000'000), true};
  }
  if (machine.follows("ngc.arc-tolerance=page"_reading)) {
    return {squared(inch ? 1'270'000'000 : 500'000'000), squared(inch ? 12'700'000 : 5'000'000)};
  }
  const Wide always = inch ? kSquareMillimetre * 516'128 / 10'000 : 8 * kSquareMillimetre;
  const Wide relative =
      inch ? kSquareMillimetre * 516'128 / 100'000'000 : kSquareMillimetre * 8 / 10'000;
  return {always, relative};
}

// The fault that lets the machine follow the radius of the start.
void move_end_onto_circle(Sketch& sketch, const Chord& end, Wide start_square, Wide end_square) {
  if (end_square == 0) return;
  const double ratio =
      std::sqrt(static_cast<double>(start_square)) / std::sqrt(static_cast<double>(end_square));
  sketch.arc.to[sketch.plane.p] =
      sketch.arc.centre_p + std::llround(static_cast<double>(end.p) * ratio);
  sketch.arc.to[sketch.plane.q] =
      sketch.arc.centre_q + std::llround(static_cast<double>(end.q) * ratio);
}

// NGC-ARC-03
void check_radii(Machine& machine, const Block& block, Sketch& sketch) {
  const Plane& plane = sketch.plane;
  Arc& arc = sketch.arc;
  const Chord start{sketch.from[plane.p] - arc.centre_p, sketch.from[plane.q] - arc.centre_q};
  const Chord end{arc.to[plane.p] - arc.centre_p, arc.to[plane.q] - arc.centre_q};
  const Wide start_square = start.square();
  const Wide end_square = end.square();
  const char word = block.has(offset_of(plane.p)) ? offset_of(plane.p) : offset_of(plane.q);
  const Wide smallest = squared(kSmallestRadius);
  const bool no_circle = machine.follows("ngc.arc-tolerance=linuxcnc"_reading)
                             ? start_square < smallest || end_square < smallest
                             : start_square == 0 || end_square == 0;
  if (no_circle) machine.complain(AlarmKind::kArcRadius, word, block);
  const RadiusTolerance tolerance = tolerance_of(machine);
  const bool apart = machine.alters("end-point-equality-refused"_fault,
                                    too_far_apart(start_square, end_square, tolerance, false),
                                    too_far_apart(start_square, end_square, tolerance, true));
  if (machine.spares("end-point-unchecked"_fault, apart)) {
    machine.complain(AlarmKind::kArcEndPoint, word, block);
  }
  if (machine.adds("end-onto-circle"_fault, start_square != end_square)) {
    move_end_onto_circle(sketch, end, start_square, end_square);
  }
}

// NGC-ARC-02
void take_centre(Machine& machine, const Block& block, Sketch& sketch) {
  if (!check_centre_words(machine, block, sketch)) return;
  const bool swapped = machine.adds("g18-offsets-swapped"_fault, sketch.plane.number == 18);
  const char first = offset_of(swapped ? sketch.plane.q : sketch.plane.p);
  const char second = offset_of(swapped ? sketch.plane.p : sketch.plane.q);
  sketch.arc.centre_p = centre_along(machine, block, sketch.plane.p, first);
  sketch.arc.centre_q = centre_along(machine, block, sketch.plane.q, second);
  if (!machine.in_alarm()) check_radii(machine, block, sketch);
}

// Faults of the axes that move along with the circle.
void spoil_helix(const Machine& machine, Sketch& sketch) {
  Point& to = sketch.arc.to;
  const std::size_t third = sketch.plane.d;
  to[third] = machine.alters("helix-flat"_fault, to[third], sketch.from[third]);
  const bool along_y = third == GONOGO_Y && (sketch.arc.axes & axis_bit(third)) != 0;
  if (machine.adds("helix-z-in-g18"_fault, along_y)) {
    to[GONOGO_Z] = to[third];
    to[third] = sketch.from[third];
  }
  if (machine.adds("arc-rotary-dropped"_fault, (sketch.arc.axes & ~kLinearAxes) != 0)) {
    sketch.arc.axes &= kLinearAxes;
    to[GONOGO_A] = sketch.from[GONOGO_A];
    to[GONOGO_C] = sketch.from[GONOGO_C];
  }
}

// NGC-FED-01: the speed at which the way along the arc takes 1/F minutes.
Fixed timed(Machine& machine, const Block& block, const Sketch& sketch) {
  const Plane& plane = sketch.plane;
  const Arc& arc = sketch.arc;
  const auto angle = [&](const Point& at) {
    return std::atan2(static_cast<long double>(at[plane.q] - arc.centre_q),
                      static_cast<long double>(at[plane.p] - arc.centre_p));
  };
  const long double pi = std::acos(-1.0L);
  long double swept = (angle(arc.to) - angle(sketch.from)) * (arc.rot > 0 ? 1 : -1);
  if (swept < 0) swept += 2 * pi;
  if (sketch.chord.square() == 0) swept = 2 * pi;
  swept += 2 * pi * (std::abs(arc.rot) - 1);
  const long double radius =
      std::hypot(static_cast<long double>(sketch.from[plane.p] - arc.centre_p),
                 static_cast<long double>(sketch.from[plane.q] - arc.centre_q));
  const auto rise = static_cast<long double>(arc.to[plane.d] - sketch.from[plane.d]);
  const long double chord = std::hypot(static_cast<long double>(sketch.chord.p),
                                       static_cast<long double>(sketch.chord.q));
  const long double way = machine.alters("inverse-time-of-chord"_fault, radius * swept, chord);
  return timed_feed(block, std::hypot(way, rise));
}

}  // namespace

void prepare_arc(Machine& machine, const Block& block, Plan& plan) {
  const State& state = machine.state;
  const Plane& plane = plane_of(state.plane);
  Arc arc;
  arc.plane = state.plane;
  arc.feed = feed_of(state);
  arc.to = commanded_point(machine, block, arc.axes);
  const bool counterclockwise = state.motion == Motion::kArcCounterclockwise;
  arc.rot = sense_of(machine, counterclockwise) * turns_of(machine, block);
  const Point& from = state.position;
  const Chord chord{arc.to[plane.p] - from[plane.p], arc.to[plane.q] - from[plane.q]};
  const bool to_plane_axis = (arc.axes & (axis_bit(plane.p) | axis_bit(plane.q))) != 0;
  Sketch sketch{plane, from, arc, chord, counterclockwise, to_plane_axis};
  const bool is_timed = state.feed_mode == FeedMode::kInverseTime;
  if (is_timed ? !block.has('F') : state.feed.linear == 0) {
    machine.complain(AlarmKind::kFeedMissing);
  }
  if (block.has('R') && block.has_any(kOffsets)) {
    machine.complain(AlarmKind::kConflictingWords, 'R', block);
  } else if (block.has('R')) {
    take_radius(machine, block, sketch);
  } else if (block.has_any(kOffsets)) {
    take_centre(machine, block, sketch);
  } else {
    machine.complain(AlarmKind::kMissingWord, 'R', kNowhere);
  }
  if (machine.in_alarm()) return;
  if (machine.adds("full-circle-dropped"_fault, chord.square() == 0)) return;
  spoil_helix(machine, sketch);
  if (is_timed) sketch.arc.feed.value = timed(machine, block, sketch);
  plan.motion = [&machine, arc = sketch.arc] {
    return machine.tracer.arc(plane_of(arc.plane), arc.centre_p, arc.centre_q, arc.rot, arc.to,
                              arc.axes, arc.feed);
  };
}

}  // namespace gonogo::expanders::ngc
