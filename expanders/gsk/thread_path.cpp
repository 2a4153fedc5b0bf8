// SPDX-License-Identifier: GPL-3.0-or-later
// G114 to G117: the motion. Where the manual leaves the path open this machine starts each thread
// at -p of the centre; reading gsk.thread.path = arc starts it at +p.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "expanders/gsk/site.hpp"

namespace gonogo::expanders::gsk {
namespace {

using Real = long double;

/// A unit vector.
struct Direction {
  Real cosine = 1;
  Real sine = 0;
};

// The angle of `part` / `whole` turns.
Direction direction_of(Fixed part, Fixed whole) {
  const Real angle =
      static_cast<Real>(part) / static_cast<Real>(whole) * (2 * std::numbers::pi_v<Real>);
  return {std::cos(angle), std::sin(angle)};
}

// The angles of both, the second taken `sense` times (1 or -1).
Direction turned(const Direction& from, const Direction& by, int sense) {
  const Real sine = sense < 0 ? -by.sine : by.sine;
  return {from.cosine * by.cosine - from.sine * sine, from.sine * by.cosine + from.cosine * sine};
}

Fixed rounded(Real value) {
  return static_cast<Fixed>(std::llround(value));
}

// Mills one thread; radii are measured from its centre.
class ThreadMill {
 public:
  ThreadMill(Machine& machine, const ThreadMilling& thread)
      : machine_(machine),
        thread_(thread),
        plane_(machine.plane()),
        start_(machine.follows("gsk.thread.path=arc"_reading) ? 1 : -1) {}

  bool run();

 private:
  Fixed passes() const;
  bool pass(Fixed number, bool last);
  bool enter(Fixed radius);
  bool semicircle(const Point& to, int rot);
  bool helix(Fixed radius, Direction& at);
  bool run_out(Fixed radius, const Direction& at);
  bool run_out_on_arc(Fixed radius, const Direction& at);
  bool run_out_straight(const Direction& at, const Direction& by);
  bool leave(bool last);
  Point point(Fixed radius, const Direction& at) const;
  const Point& centre() const { return thread_.site.centre; }

  Machine& machine_;
  const ThreadMilling& thread_;
  const Plane& plane_;
  int start_;  // the thread starts on this side of the centre, along p
};

// GSK-G114-04.
Fixed ThreadMill::passes() const {
  const Fixed whole = thread_.height / thread_.infeed;
  const bool extra = machine_.has("thread-extra-pass"_fault);
  return whole + (thread_.height % thread_.infeed != 0 || extra ? 1 : 0);
}

bool ThreadMill::run() {
  const Fixed count = passes();
  for (Fixed number = 1; number <= count; ++number) {
    if (!pass(number, number == count)) return false;
  }
  return true;
}

// GSK-G114-06: one pass; it cuts t = min(n Q, P) deep.
bool ThreadMill::pass(Fixed number, bool last) {
  Fixed cut = number * thread_.infeed;
  if (!machine_.has("thread-last-pass-too-deep"_fault)) cut = std::min(cut, thread_.height);
  const Fixed radius = thread_.surface - thread_.side * cut;
  Direction at{static_cast<Real>(start_), 0};
  return enter(radius) && helix(radius, at) && run_out(radius, at) && leave(last);
}

Point ThreadMill::point(Fixed radius, const Direction& at) const {
  Point to = machine_.state.position;
  to[plane_.p] = centre()[plane_.p] + rounded(static_cast<Real>(radius) * at.cosine);
  to[plane_.q] = centre()[plane_.q] + rounded(static_cast<Real>(radius) * at.sine);
  return to;
}

bool ThreadMill::semicircle(const Point& to, int rot) {
  const Point& from = machine_.state.position;
  if (from == to) return true;
  const Fixed middle_p = from[plane_.p] + (to[plane_.p] - from[plane_.p]) / 2;
  const Fixed middle_q = from[plane_.q] + (to[plane_.q] - from[plane_.q]) / 2;
  return machine_.arc(middle_p, middle_q, rot, to, 0);
}

// By a semicircle to the uncut surface, then straight in to the radius of the pass.
bool ThreadMill::enter(Fixed radius) {
  const Direction at{static_cast<Real>(start_), 0};
  if (!semicircle(point(thread_.surface, at), thread_.rot)) return false;
  return machine_.cut(point(radius, at), axis_bit(plane_.p));
}

// Turns from the R plane to the bottom; the last may be part of one.
bool ThreadMill::helix(Fixed radius, Direction& at) {
  const Fixed depth = magnitude(thread_.site.depth);
  Fixed whole = depth / thread_.lead;
  Fixed rest = depth % thread_.lead;
  if (machine_.has("thread-partial-turn-dropped"_fault) && whole > 0) rest = 0;
  if (machine_.has("thread-turn-short"_fault) && whole > 1) --whole;
  if (rest != 0) at = turned(at, direction_of(rest, thread_.lead), thread_.rot);
  Point to = point(radius, at);
  to[plane_.d] += sign_of(thread_.site.depth) * (whole * thread_.lead + rest);
  const int rot = static_cast<int>(whole + (rest != 0 ? 1 : 0)) * thread_.rot;
  return machine_.arc(centre()[plane_.p], centre()[plane_.q], rot, to, axis_bit(plane_.d));
}

// GSK-G114-11: J = 0 is no run-out.
bool ThreadMill::run_out(Fixed radius, const Direction& at) {
  if (thread_.run_out == 0) return true;
  const Direction angle = direction_of(thread_.angle, 360 * kOne);
  if (machine_.follows("gsk.thread.runout=radial"_reading)) return run_out_straight(at, angle);
  if (machine_.follows("gsk.thread.runout=tangent"_reading)) {
    // K from the tangent is 90 - K from the normal.
    return run_out_straight(at, {angle.sine, angle.cosine});
  }
  return run_out_on_arc(radius, at);
}

// J long, `by` from the normal on the free side toward the feed direction.
bool ThreadMill::run_out_straight(const Direction& at, const Direction& by) {
  const auto length = static_cast<Real>(thread_.run_out);
  const Real out = length * by.cosine * thread_.side;
  const Real along = length * by.sine * thread_.rot;
  Point to = machine_.state.position;
  to[plane_.p] += rounded(out * at.cosine - along * at.sine);
  to[plane_.q] += rounded(out * at.sine + along * at.cosine);
  return machine_.cut(to, axis_bit(plane_.p) | axis_bit(plane_.q));
}

// To the radius J further on the free side, K degrees further round, by the arc that leaves the
// helix tangentially. In the frame of the normal (outwards) and the feed direction at the helix's
// end the run-out is (u, v); its circle has its centre on the normal, (u^2 + v^2) / 2u from there.
bool ThreadMill::run_out_on_arc(Fixed radius, const Direction& at) {
  const int out = machine_.has("run-out-into-wall"_fault) ? -thread_.side : thread_.side;
  const int sense = machine_.has("run-out-backwards"_fault) ? -thread_.rot : thread_.rot;
  const Direction by = direction_of(thread_.angle, 360 * kOne);
  const Fixed end_radius = radius + out * thread_.run_out;
  const Point to = point(end_radius, turned(at, by, sense));
  if (to == machine_.state.position) return true;
  const Real u = static_cast<Real>(end_radius) * by.cosine - static_cast<Real>(radius);
  const Real v = static_cast<Real>(end_radius) * by.sine;
  const Real distance = u == 0 ? 0 : (u * u + v * v) / (2 * u);
  if (u == 0 || std::abs(distance) > static_cast<Real>(kLargest) / 4) {
    return machine_.cut(to, axis_bit(plane_.p) | axis_bit(plane_.q));
  }
  const Real from_centre = static_cast<Real>(radius) + distance;
  const Fixed centre_p = centre()[plane_.p] + rounded(from_centre * at.cosine);
  const Fixed centre_q = centre()[plane_.q] + rounded(from_centre * at.sine);
  return machine_.arc(centre_p, centre_q, distance < 0 ? sense : -sense, to, 0);
}

// Back to the R plane, and along p to the safe position.
bool ThreadMill::leave(bool last) {
  const bool stays = machine_.has("thread-no-retract"_fault) && !last;
  if (!stays && !machine_.tracer.rapid_axis(plane_.d, thread_.site.r_plane)) return false;
  const Fixed safe = thread_.surface + thread_.side * thread_.run_out;
  return machine_.tracer.rapid_axis(plane_.p, centre()[plane_.p] + start_ * safe);
}

}  // namespace

// GSK-G114-08: F is the speed along the path, as the records have it.
bool mill_thread(Machine& machine, const ThreadMilling& thread) {
  if (!approach(machine, thread.site)) return false;  // GSK-G114-05
  if (thread.site.depth != 0 && !ThreadMill(machine, thread).run()) return false;
  if (machine.has("thread-ends-at-r-plane"_fault)) return true;
  return retract(machine, thread.site, thread.site.initial_plane,  // GSK-G114-07
                 machine.follows("gsk.thread.return=feed"_reading));
}

}  // namespace gonogo::expanders::gsk
