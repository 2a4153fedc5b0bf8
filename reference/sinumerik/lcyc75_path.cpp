// SPDX-License-Identifier: GPL-3.0-or-later
//
// One path that LCYC75 admits (reading sie.pocket.path): every level from the centre outwards,
// along the border of what the tool can reach, moved inwards by whole radii of the tool.
#include "reference/geometry/kernel.hpp"
#include "reference/sinumerik/lcyc75.hpp"

namespace gonogo::reference::sinumerik {
namespace {

using geometry::Aff_transformation_2;
using geometry::ORIGIN;

// A pass: the rectangle that the tool's centre runs round, with corners of a radius.
struct Pass {
  Number half_length;
  Number half_width;
  Number radius;
};

// A motion of a pass in the pocket's own frame, its centre the origin.
struct Segment {
  Point_2 to;
  std::optional<Point_2> centre;  // of an arc
};

Record record_of(const PocketMilling& pocket, RecordKind kind) {
  Record record;
  record.kind = kind;
  record.block = pocket.block;
  record.clause = pocket.clause;
  record.plane = pocket.plane;
  record.feed_mode = pocket.feed_mode;
  return record;
}

// From the pocket's own frame to base coordinates.
Aff_transformation_2 frame_of(const PocketMilling& pocket) {
  const auto& [cosine, sine] = pocket.direction;
  const Aff_transformation_2 turn(CGAL::ROTATION, sine, cosine);
  return Aff_transformation_2(CGAL::TRANSLATION, geometry::point(pocket.centre) - ORIGIN) * turn;
}

Record in_plane(const PocketMilling& pocket, const Aff_transformation_2& to_base,
                const Segment& segment) {
  const PlaneAxes axes = axes_of(pocket.plane);
  Record record = record_of(pocket, segment.centre ? RecordKind::arc : RecordKind::feed);
  record.axes = {axes.p, axes.q};
  geometry::put_in(record.to, axes, to_base(segment.to));
  record.feed = pocket.plane_feed;
  if (segment.centre) {
    record.centre = geometry::pair(to_base(*segment.centre));
    record.rot = pocket.sense;
  }
  return record;
}

Record in_depth(const PocketMilling& pocket, RecordKind kind, const Number& depth) {
  const PlaneAxes axes = axes_of(pocket.plane);
  Record record = record_of(pocket, kind);
  record.axes = {axes.d};
  record.to[axes.d] = depth;
  if (kind != RecordKind::rapid) record.feed = pocket.depth_feed;
  return record;
}

// SIE-LC75-12: the motions of a pass from (half_length, 0) round the centre, counterclockwise or
// clockwise.
std::vector<Segment> round(const Pass& pass, int sense) {
  const Number& a = pass.half_length;
  const Number& b = pass.half_width;
  const Number& r = pass.radius;
  const Number side = sense;  // of the first corner: +v counterclockwise
  std::vector<Segment> segments;
  const auto line = [&](const Number& u, const Number& v) {
    segments.push_back({{u, side * v}, std::nullopt});
  };
  const auto corner = [&](const Number& u, const Number& v, const Number& at_u,
                          const Number& at_v) {
    if (r.sign() > 0) segments.push_back({{u, side * v}, Point_2(at_u, side * at_v)});
  };
  line(a, b - r);
  corner(a - r, b, a - r, b - r);
  line(r - a, b);
  corner(-a, b - r, r - a, b - r);
  line(-a, r - b);
  corner(r - a, -b, r - a, r - b);
  line(a - r, -b);
  corner(a, r - b, a - r, r - b);
  line(a, 0);
  return segments;
}

// How far the innermost pass is moved inwards, in radii of the tool: until the tool clears what is
// inside it, or what roughing left.
Number innermost(const PocketMilling& pocket, const Number& narrowest, bool whole) {
  const Number all = (narrowest / pocket.tool_radius).floor();
  if (whole) return all;
  const Number strip = (pocket.allowance / pocket.tool_radius).ceil() - 1;
  return min(max(strip, 0), all);
}

bool moves(const Segment& segment, const Point_2& from) {
  return segment.centre || segment.to != from;
}

// SIE-LC75-10: a level. It begins and ends at the centre.
Generator<Item> clear_level(PocketMilling pocket, bool whole) {
  const Number half_length = pocket.length / 2 - pocket.tool_radius;
  const Number half_width = pocket.width / 2 - pocket.tool_radius;
  const Number corner = pocket.corner_radius - pocket.tool_radius;
  const Aff_transformation_2 to_base = frame_of(pocket);
  Point_2 at = ORIGIN;
  for (Number k = innermost(pocket, min(half_length, half_width), whole); k.sign() >= 0; k -= 1) {
    const Number inset = k * pocket.tool_radius;
    const Pass pass{half_length - inset, half_width - inset, max(corner - inset, 0)};
    std::vector<Segment> segments = round(pass, pocket.sense);
    segments.insert(segments.begin(), Segment{{pass.half_length, 0}, std::nullopt});
    for (const Segment& segment : segments) {
      if (!moves(segment, at)) continue;
      at = segment.to;
      const Item item = in_plane(pocket, to_base, segment);
      co_yield item;
    }
  }
  const Segment home{ORIGIN, std::nullopt};
  if (moves(home, at)) {
    const Item item = in_plane(pocket, to_base, home);
    co_yield item;
  }
}

}  // namespace

Generator<Item> contour_parallel(PocketMilling pocket) {
  // SIE-LC75-13: of roughing it belongs to the approach.
  if (pocket.finishing) {
    const Item approach = in_depth(pocket, RecordKind::rapid, pocket.clearance);
    co_yield approach;
  }
  const Number count = pocket.level_count();
  for (Number k = 1; k <= count; k += 1) {
    const Item plunge = in_depth(pocket, RecordKind::feed, pocket.depth_of_level(k));
    co_yield plunge;
    // SIE-LC75-07, SIE-LC75-11
    const bool whole = !pocket.finishing || (k == count && !pocket.contour_only);
    if (!whole && pocket.allowance.sign() == 0) continue;
    Generator<Item> level = clear_level(pocket, whole);
    while (const Item* item = level.next()) co_yield *item;
  }
  const Item retract = in_depth(pocket, RecordKind::rapid, pocket.retract);
  co_yield retract;
}

}  // namespace gonogo::reference::sinumerik
