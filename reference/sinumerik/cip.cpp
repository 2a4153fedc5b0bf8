// SPDX-License-Identifier: GPL-3.0-or-later
//
// CIP: a circle in space through an intermediate point. Points are seen from the start.
#include "reference/clause_literal.hpp"
#include "reference/reading_literal.hpp"
#include "reference/sinumerik/machine.hpp"

namespace gonogo::reference::sinumerik {
namespace {

constexpr ClauseId kPoints = "SIE-CIP-02"_clause;
using geometry::ORIGIN;
using geometry::Point_3;
using geometry::Vector_3;

Point_3 seen_from_start(const EndPoint& point) {
  return ORIGIN + geometry::vector_of(point.by);
}

// SIE-CIP-02: coordinates that are left out are those of the start.
EndPoint intermediate_point(const BlockContext& block) {
  EndPoint via;
  via.to = block.machine.position;
  for (const Axis axis : kLinearAxes) {
    if (!block.words.has(intermediate_address(axis))) continue;
    AxisWord word = block.words.intermediate_word(axis);
    if (word.incremental) word.value += untravelled_along(block, axis);
    const Number& start = block.machine.position[axis];
    via.by[axis] = word.incremental ? word.value : word.value - start;
    via.to[axis] = word.incremental ? start + word.value : word.value;
  }
  return via;
}

// The circle goes positively about its axis, and at its end upright on the radius.
Vector_3 direction_at_end(const Point_3& via, const Point_3& end, const Vector_3& axis) {
  const Point_3 centre = CGAL::circumcenter(Point_3(ORIGIN), via, end);
  return CGAL::cross_product(axis, end - centre);
}

void put_circle(BlockContext& block, const EndPoint& end, const EndPoint& via,
                const Vector_3& direction) {
  Record record = block.motion_to(RecordKind::arc3, "SIE-CIP-01"_clause, end.named, end.to);
  record.via_axes = AxisSet{Axis::x, Axis::y, Axis::z};
  for (const Axis axis : kLinearAxes) record.via[axis] = via.to[axis];
  LastMotion last;
  last.direction = geometry::position_of(direction);
  block.machine.last = std::move(last);
  put_motion(block, end, std::move(record));
}

}  // namespace

void run_intermediate(BlockContext& block) {
  refuse_words(block, {Address::i, Address::j, Address::k, Address::cr, Address::ar, Address::ap,
                       Address::rp});
  refuse_turns(block);
  need_cutting(block);
  if (!block.words.has_intermediate()) {
    block.missing(kPoints, WordName("I1"));
    return;
  }
  if (block.words.is_polar()) return;
  std::optional<EndPoint> end = end_point(block);
  if (!end) return;
  end->named = end->named | AxisSet{Axis::x, Axis::y, Axis::z};
  const EndPoint via = intermediate_point(block);
  const Point_3 middle = seen_from_start(via);
  const Point_3 last = seen_from_start(*end);
  const Vector_3 axis = CGAL::cross_product(middle - ORIGIN, last - ORIGIN);
  if (any_nonzero({axis.x(), axis.y(), axis.z()})) {
    put_circle(block, *end, via, direction_at_end(middle, last, axis));
    return;
  }
  // SIE-CIP-01: on one line the intermediate point is between the others, or it is none.
  const bool is_between =
      CGAL::collinear_are_strictly_ordered_along_line(Point_3(ORIGIN), middle, last);
  if (is_between && block.readings.is("sie.cip.collinear=straight"_reading)) {
    put_line(block, RecordKind::feed, "SIE-CIP-01"_clause, *end);
    return;
  }
  const char* word = "I1";
  if (!block.words.has(Address::i1)) word = block.words.has(Address::j1) ? "J1" : "K1";
  block.alarm(AlarmClass::arc_intermediate_point, is_between ? "SIE-CIP-01"_clause : kPoints,
              WordName(word), "Start, intermediate point and end are no three points of a circle.");
}

}  // namespace gonogo::reference::sinumerik
