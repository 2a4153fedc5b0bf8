// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/gsk988ta/pocket_paths.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

// A motion in the plane of the level to p = centre + s, q = centre.
Record motion_to(const PocketLevel& level, RecordKind kind, const Number& s) {
  const PlaneAxes axes = axes_of(level.plane);
  Record record;
  record.kind = kind;
  record.block = level.block;
  record.clause = level.clause;
  record.plane = level.plane;
  record.axes = {axes.p, axes.q};
  record.to[axes.p] = level.centre[0] + s;
  record.to[axes.q] = level.centre[1];
  record.feed = level.feed;
  record.feed_mode = level.feed_mode;
  return record;
}

// An arc that ends at s and whose centre lies at `middle` on the same line.
Record arc_to(const PocketLevel& level, const Number& s, const Number& middle) {
  Record record = motion_to(level, RecordKind::arc, s);
  record.centre = {level.centre[0] + middle, level.centre[1]};
  record.rot = level.sense;
  return record;
}

}  // namespace

Generator<Record> semicircles(PocketLevel level) {
  const Number outermost = level.pocket_radius - level.tool_radius;
  Number from = 0;
  for (std::int64_t k = 1; abs(from) < outermost; ++k) {
    const Number reach = min(level.step * Number(k) / 2, outermost);
    const Number to = k % 2 == 1 ? reach : -reach;
    co_yield arc_to(level, to, (from + to) / 2);
    from = to;
  }
  co_yield arc_to(level, from, 0);
}

Generator<Record> concentric_circles(PocketLevel level) {
  const Number outermost = level.pocket_radius - level.tool_radius;
  Number radius = 0;
  for (std::int64_t k = 1; radius < outermost; ++k) {
    radius = min(level.step * Number(k), outermost);
    co_yield motion_to(level, RecordKind::feed, radius);
    co_yield arc_to(level, radius, 0);
  }
}

}  // namespace gonogo::reference::gsk988ta
