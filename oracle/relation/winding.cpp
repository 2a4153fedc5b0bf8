// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "oracle/relation/free_step.hpp"
#include "reference/geometry/intersections.hpp"

namespace gonogo::relation {
namespace {

geometry::Vector_2 way(const Offset& offset) {
  return {offset.p, offset.q};
}

}  // namespace

Number Offset::square() const {
  return way(*this).squared_length();
}

Offset operator-(const Offset& a, const Offset& b) {
  const geometry::Vector_2 between = way(a) - way(b);
  return {between.x(), between.y()};
}

Number along(const Offset& a, const Offset& b) {
  return CGAL::scalar_product(way(a), way(b));
}

Number across(const Offset& a, const Offset& b) {
  return CGAL::determinant(way(a), way(b));
}

Number nearest_square(const Offset& from, const Offset& to) {
  using geometry::ORIGIN;
  return CGAL::squared_distance(geometry::Point_2(ORIGIN),
                                geometry::Segment_2(ORIGIN + way(from), ORIGIN + way(to)));
}

int Winding::quarter_of(const Offset& offset) {
  if (offset.q.sign() >= 0) return offset.p.sign() > 0 ? 0 : 1;
  return offset.p.sign() < 0 ? 2 : 3;
}

void Winding::take(const Offset& to) {
  if (max(abs(to.p), abs(to.q)) <= blind_) return;
  if (last_) {
    int steps = (quarter_of(to) - quarter_of(*last_) + 4) % 4;
    if (steps == 3) steps = -1;
    // Across the middle, on the side that the line passes it.
    if (steps == 2) steps = 2 * across(*last_, to).sign();
    quarters_ += std::int64_t{sense_} * steps;
    most_ = std::max(most_, quarters_);
  }
  last_ = to;
}

bool Rings::turns_again(const Offset& middle, const Offset& from, const Offset& to, int sense) {
  constexpr int kMostQuarters = 40;  // of ten turns
  const Number radius = rational_near(sqrt(to.square()));
  const auto is_it = [&](const Ring& ring) {
    const Offset apart = ring.middle - middle;
    return (ring.sense < 0) == (sense < 0) && abs(ring.radius - radius) <= width_ &&
           max(abs(apart.p), abs(apart.q)) <= width_;
  };
  auto ring = std::ranges::find_if(rings_, is_it);
  if (ring == rings_.end()) {
    const Winding winding(sense < 0 ? -1 : 1, blind_);
    ring = rings_.insert(ring, Ring{middle, radius, sense, winding, from});
  }
  if ((ring->end - from).square().sign() != 0) ring->winding.leave();
  ring->winding.take(from);
  ring->winding.take(to);
  ring->end = to;
  return ring->winding.quarters() > kMostQuarters;
}

bool moves_another_axis(const Event& piece, const Position& start, const reference::PlaneAxes& axes,
                        const Number& off) {
  for (const reference::Axis axis : reference::kAllAxes) {
    if (axis == axes.p || axis == axes.q || axis == axes.d) continue;
    if (abs(piece.to[axis] - start[axis]) > off) return true;
  }
  return false;
}

std::optional<std::size_t> end_of_small_stretch(SubjectSide& subject, std::size_t begin,
                                                const Position& place, const Number& tau) {
  if (begin > 0 && goes_on(subject.at(begin - 1), subject.at(begin))) return std::nullopt;
  for (std::size_t i = begin;; ++i) {
    const Event& piece = subject.at(i);
    if (!piece.is_motion()) return std::nullopt;
    for (const reference::Axis axis : reference::kAllAxes) {
      if (abs(piece.to[axis] - place[axis]) > tau) return std::nullopt;
    }
    if (!goes_on(piece, subject.at(i + 1))) return i + 1;
  }
}

int sense_of(const Event& piece, const reference::PlaneAxes& axes) {
  const reference::Record& motion = piece.source();
  if (piece.label->is_flat) return 0;
  if (motion.kind == reference::RecordKind::arc) return motion.rot < 0 ? -1 : 1;
  if (motion.kind != reference::RecordKind::arc3) return 0;
  const auto offset = [&](const Position& end, const reference::AxisSet& named) {
    const auto to = [&](reference::Axis axis) {
      return named.has(axis) ? rational_near(end[axis] - piece.start[axis]) : Number(0);
    };
    return Offset{to(axes.p), to(axes.q)};
  };
  return across(offset(motion.via, motion.via_axes), offset(motion.to, motion.axes)).sign();
}

}  // namespace gonogo::relation
