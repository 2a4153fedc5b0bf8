// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "oracle/relation/free_step.hpp"

namespace gonogo::relation {

using reference::HelixPocket;
using reference::Record;
using reference::RecordKind;

namespace {

using Side = std::array<Number, 2>;  // along p and q

Record arc_of(const HelixPocket& pocket, const Side& centre, const Side& to, std::int32_t turns) {
  const reference::PlaneAxes axes = reference::axes_of(pocket.plane);
  Record arc;
  arc.kind = RecordKind::arc;
  arc.block = pocket.block;
  arc.clause = pocket.clause;
  arc.plane = pocket.plane;
  arc.rot = pocket.sense * turns;
  arc.centre = centre;
  arc.axes = {axes.p, axes.q};
  arc.to[axes.p] = to[0];
  arc.to[axes.q] = to[1];
  arc.feed = pocket.feed;
  arc.feed_mode = pocket.feed_mode;
  return arc;
}

Side middle_of(const Side& a, const Side& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
}

// A semicircle from the centre to the side, the helix, perhaps a flat turn, and a semicircle back.
std::vector<Record> path_by(const HelixPocket& pocket, const Side& side) {
  const Side middle = middle_of(pocket.centre, side);
  Record helix = arc_of(pocket, pocket.centre, side, pocket.turns);
  const reference::Axis depth = reference::axes_of(pocket.plane).d;
  helix.axes.add(depth);
  helix.to[depth] = pocket.bottom;
  std::vector<Record> path = {arc_of(pocket, middle, side, 1), std::move(helix)};
  if (pocket.flat) path.push_back(arc_of(pocket, pocket.centre, side, 1));
  path.push_back(arc_of(pocket, middle, pocket.centre, 1));
  return path;
}

}  // namespace

std::vector<std::vector<Record>> paths_of(const HelixPocket& pocket, SubjectSide& subject,
                                          std::size_t begin, const Number& tau) {
  const reference::PlaneAxes axes = reference::axes_of(pocket.plane);
  std::vector<std::vector<Record>> paths;
  for (std::size_t i = begin; subject.at(i).part == Part::cut; ++i) {
    const Position& end = subject.at(i).to;
    // Behind the entry at the R plane nothing comes back to it.
    if (abs(end[axes.d] - rational_near(pocket.r_plane)) > tau) break;
    const Number p = end[axes.p] - rational_near(pocket.centre[0]);
    const Number q = end[axes.q] - rational_near(pocket.centre[1]);
    const Number distance = rational_near(sqrt(p * p + q * q));
    const bool is_on_circle = distance.sign() > 0 && abs(distance - pocket.radius) <= tau * 2;
    if (!is_on_circle || !subject.at(i + 1).begins) continue;
    const Number scale = pocket.radius / distance;
    paths.push_back(path_by(pocket, {pocket.centre[0] + p * scale, pocket.centre[1] + q * scale}));
  }
  return paths;
}

}  // namespace gonogo::relation
