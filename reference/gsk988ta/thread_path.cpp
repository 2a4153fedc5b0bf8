// SPDX-License-Identifier: GPL-3.0-or-later
//
// GSK-G114-06 and GSK-G114-11: each pass goes by a semicircle to +rho_0 on p, straight in to the
// pass radius r_n, down the helix, out along the run-out, up to the R plane, and along p to the
// safe position. Below the R plane it moves along the helices and their run-out alone
// (GSK-G114-10).
#include "reference/gsk988ta/thread_path.hpp"

#include "reference/clause_literal.hpp"
#include "reference/geometry/kernel.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

using geometry::pair;
using geometry::point;
using geometry::Point_2;
using geometry::Vector_2;

// A way in the plane, at an angle from +p in the cycle's own sense.
Vector_2 polar(const ThreadMilling& thread, const Number& length, const Number& degrees) {
  const auto [cosine, sine] = cos_sin_degrees(degrees);
  return Vector_2(cosine, sine * Number(thread.sense)) * length;
}

// Where the helices end, in degrees from +p in the cycle's sense: the last turn may be partial.
Number end_angle(const ThreadMilling& thread) {
  const Number turns = turns_of(thread);
  return (turns - turns.floor()) * 360;
}

// +1 external, -1 internal: the side of the material from which the tool leaves.
Number free_side(const ThreadMilling& thread) {
  return thread.external ? 1 : -1;
}

// GSK-G114-11: J to the free side, K degrees further round. Polar: the end lies at the radius
// r_n +- J. Radial: straight, K from the normal towards the direction of feed. Tangent: straight,
// K from the direction of feed towards the normal.
Point_2 run_out_end(const ThreadMilling& thread, const Number& radius) {
  const Point_2 centre = point(thread.centre);
  const Number theta = end_angle(thread);
  const Number& k = thread.runout_angle;
  const Number& j = thread.runout_length;
  if (thread.runout == ThreadRunOut::radial || thread.runout == ThreadRunOut::tangent) {
    const Number normal = thread.external ? 0 : 180;  // from the radius vector
    const Number turn = thread.runout == ThreadRunOut::radial ? k : Number(90) - k;
    const Number angle = theta + (thread.external ? turn : normal - turn);
    return centre + polar(thread, radius, theta) + polar(thread, j, angle);
  }
  return centre + polar(thread, radius + free_side(thread) * j, theta + k);
}

// The polar run-out: the arc that leaves the circle of radius r at S tangentially and ends at E.
// With u the radius vector at S, t the direction of feed, E - S = a u + b t: its centre is S + w u
// with w = (a^2 + b^2) / (2 a); for a = 0 it is straight. By lengths alone, which are rational
// where the points are enclosures.
Record polar_run_out(const MillingSite& site, const ThreadMilling& thread, const Number& radius) {
  const ClauseId clause = "GSK-G114-11"_clause;
  const Point_2 end = run_out_end(thread, radius);
  const auto [cos_k, sin_k] = cos_sin_degrees(thread.runout_angle);
  const Number end_radius = radius + free_side(thread) * thread.runout_length;
  const Number a = end_radius * cos_k - radius;
  if (a.sign() == 0) return site.feed_to(clause, pair(end));
  const Number chord_2 =
      radius * radius + end_radius * end_radius - radius * end_radius * cos_k * 2;
  const Number w = chord_2 / (a * 2);
  const Point_2 middle = point(thread.centre) + polar(thread, radius + w, end_angle(thread));
  // A centre on the far side of the path from the thread's turns the other way round.
  return site.arc_to(clause, pair(end), pair(middle), a.sign() < 0 ? thread.sense : -thread.sense);
}

Record run_out(const MillingSite& site, const ThreadMilling& thread, const Number& radius) {
  if (thread.runout == ThreadRunOut::radial || thread.runout == ThreadRunOut::tangent) {
    return site.feed_to("GSK-G114-11"_clause, pair(run_out_end(thread, radius)));
  }
  return polar_run_out(site, thread, radius);
}

// Where a pass leaves the thread.
Point_2 end_of_cut(const ThreadMilling& thread, const Number& radius) {
  if (thread.runout_length.sign() != 0) return run_out_end(thread, radius);
  return point(thread.centre) + polar(thread, radius, end_angle(thread));
}

Point_2 end_of_pass(const ThreadMilling& thread, const Number& n) {
  return {thread.centre[0] + safe_radius(thread), end_of_cut(thread, thread.radius_of_pass(n)).y()};
}

Record helix(const MillingSite& site, const ThreadMilling& thread, const Number& radius) {
  const Point_2 end = point(thread.centre) + polar(thread, radius, end_angle(thread));
  const auto turns = static_cast<std::int32_t>(turns_of(thread).ceil().to_int64().value());
  Record record = site.arc_to("GSK-G114-06"_clause, pair(end), thread.centre, thread.sense * turns);
  record.axes.add(site.axes.d);
  record.to[site.axes.d] = thread.bottom;
  return record;
}

}  // namespace

Number turns_of(const ThreadMilling& thread) {
  return abs(thread.travel) / thread.lead;
}

Number safe_radius(const ThreadMilling& thread) {
  return thread.start_radius + free_side(thread) * thread.runout_length;
}

std::array<Number, 2> end_of_passes(const ThreadMilling& thread) {
  return pair(end_of_pass(thread, thread.passes()));
}

Generator<Record> thread_passes(MillingSite site, ThreadMilling thread) {
  const ClauseId clause = "GSK-G114-06"_clause;
  const Axis p = site.axes.p;
  const Point_2 centre = point(thread.centre);
  const Point_2 start = centre + Vector_2(thread.start_radius, 0);
  const Number passes = thread.passes();  // GSK-G114-04
  for (Number n = 1; n <= passes; n += 1) {
    const Point_2 from = n > 1 ? end_of_pass(thread, n - 1) : centre;
    if (from != start) {
      co_yield site.arc_to(clause, pair(start), pair(CGAL::midpoint(from, start)), thread.sense);
    }
    const Number radius = thread.radius_of_pass(n);
    Record infeed = site.motion(RecordKind::feed, clause);
    infeed.axes = {p};
    infeed.to[p] = thread.centre[0] + radius;
    co_yield infeed;

    co_yield helix(site, thread, radius);
    if (thread.runout_length.sign() != 0) co_yield run_out(site, thread, radius);

    co_yield site.rapid_depth(clause, site.r_plane);
    Record away = site.motion(RecordKind::rapid, clause);
    away.axes = {p};
    away.to[p] = end_of_pass(thread, n).x();
    co_yield away;
  }
}

}  // namespace gonogo::reference::gsk988ta
