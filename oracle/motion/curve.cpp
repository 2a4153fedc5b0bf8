// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/curve.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/motion/arc_turns.hpp"
#include "oracle/motion/places.hpp"

namespace gonogo::oracle {
namespace {

using reference::kAllAxes;
using reference::PlaneAxes;

// Whether two rational points agree; false also where that takes more than rationals.
bool rationally_agree(const Position& a, const Position& b, const Number& tolerance) {
  return std::ranges::all_of(kAllAxes, [&](Axis axis) {
    const Number difference = a[axis] - b[axis];
    return difference.is_rational() && difference <= tolerance && -difference <= tolerance;
  });
}

// Whether there is a t of [0, 1] at which from + t (to - from) agrees with the point on every axis.
// Most often it is an end of the line, without a division.
bool agrees_with_line(const Motion& line, const Position& point, const Number& tolerance) {
  if (rationally_agree(point, line.to(), tolerance)) return true;
  if (rationally_agree(point, line.from, tolerance)) return true;
  Number low = 0;
  Number high = 1;
  for (Axis axis : kAllAxes) {
    const Number travel = line.to()[axis] - line.from[axis];
    if (visible_sign(travel) == 0) {
      if (!agree(point[axis], line.from[axis], tolerance)) return false;
      continue;
    }
    const Number offset = point[axis] - line.from[axis];
    Number first = (offset - tolerance) / travel;
    Number second = (offset + tolerance) / travel;
    if (travel.sign() < 0) std::swap(first, second);
    low = max(low, first);
    high = min(high, second);
  }
  return !(high < low);
}

bool moves_one_axis(const Motion& motion, const Number& tolerance) {
  const AxisSet moved = moved_axes(motion, tolerance);
  return std::ranges::count_if(kAllAxes, [&](Axis axis) { return moved.has(axis); }) == 1;
}

}  // namespace

Axis longest_axis(const Motion& motion) {
  Axis longest = Axis::x;
  double length = -1;
  for (Axis axis : kAllAxes) {
    const double travel = std::abs(estimate(motion.to()[axis] - motion.from[axis]));
    if (travel > length) {
      length = travel;
      longest = axis;
    }
  }
  return longest;
}

Curve::Curve(Motion reference, const Tolerances& tolerances, std::optional<OpenArc> open)
    : reference_(std::move(reference)), tolerances_(tolerances), open_(std::move(open)) {
  if (is_round(reference_.record.kind)) round_.emplace(reference_, open_);
}

CurveAnswer Curve::follow(const CurveProgress& from, const Motion& subject) const {
  const Record& want = reference_.record;
  const Record& got = subject.record;
  if (tolerances_.compare_blocks && want.block != got.block) {
    return CurveAnswer::departs(Departure::block, "The motion belongs to another block.");
  }
  CurveAnswer answer = follow_any(from, subject);
  const bool is_cut = want.kind != RecordKind::rapid && want.kind != RecordKind::thread;
  if (is_cut && !answer.departs() && !feeds_agree(want, got, tolerances_)) {
    return CurveAnswer::departs(Departure::feed, "The feed differs.");
  }
  return answer;
}

CurveAnswer Curve::follow_any(const CurveProgress& from, const Motion& subject) const {
  const RecordKind want = reference_.record.kind;
  const RecordKind got = subject.record.kind;
  if (got == RecordKind::feed && comes_as_line()) return follow_line(from, subject);
  if (round_) return follow_round(from, subject);
  if (want == RecordKind::feed && is_round(got)) return follow_flat(from, subject);
  if (want != got) {
    return CurveAnswer::departs(Departure::kind, "The motion is of another kind.");
  }
  if (want == RecordKind::rapid) return follow_traverse(from, subject);
  if (want == RecordKind::thread) return follow_thread(from, subject);
  return follow_line(from, subject);
}

// R2. A line whose lead counts instead of a feed. A piece that goes on has the spindle angle
// of the first: at another one it would cut beside the groove.
CurveAnswer Curve::follow_thread(const CurveProgress& from, const Motion& subject) const {
  CurveAnswer answer = follow_line(from, subject);
  if (answer.departs()) return answer;
  if (!leads_agree(reference_.record, subject.record, tolerances_)) {
    return CurveAnswer::departs(Departure::feed, "The lead differs.");
  }
  if (!start_angles_agree(reference_.record, subject.record, tolerances_)) {
    return CurveAnswer::departs(Departure::geometry,
                                "The thread starts at another angle of the spindle.");
  }
  return answer;
}

// R4: rapids that end where it ends, monotone on each axis, no other axis.
CurveAnswer Curve::follow_traverse(const CurveProgress& from, const Motion& subject) const {
  const Position& reached = from.traverse ? *from.traverse : subject.from;
  for (Axis axis : kAllAxes) {
    const Number& target = reference_.to()[axis];
    const Number& end = subject.to()[axis];
    const Number& tau = tolerances_.tolerance;
    const bool above_low = end >= target - tau || end >= reached[axis] - tau;
    const bool below_high = end <= target + tau || end <= reached[axis] + tau;
    if (!above_low || !below_high) {
      return CurveAnswer::departs(Departure::geometry, "The traverse leaves the way to its end.");
    }
  }
  CurveProgress progress = from;
  const bool done = agree(subject.to(), reference_.to(), tolerances_.tolerance);
  if (!done) {
    // Not the piece's own end: steps back within the tolerance must not add up.
    Position nearest = reached;
    for (Axis axis : kAllAxes) {
      const Number& target = reference_.to()[axis];
      const int side = visible_sign(target - nearest[axis]);
      if (visible_sign(target - subject.to()[axis]) * side < 0) {
        nearest[axis] = target;
      } else if (visible_sign(subject.to()[axis] - nearest[axis]) * side > 0) {
        nearest[axis] = subject.to()[axis];
      }
    }
    progress.traverse = std::move(nearest);
  }
  return CurveAnswer::goes(std::move(progress), done);
}

CurveAnswer Curve::follow_line(const CurveProgress& from, const Motion& subject) const {
  const Number& tau = tolerances_.tolerance;
  if (!agrees_with_line(reference_, subject.from, tau) &&
      !same_place(subject.from, reference_.from, tolerances_)) {
    return CurveAnswer::departs(Departure::geometry, "The cut does not start on the line.");
  }
  if (!agrees_with_line(reference_, subject.to(), tau)) {
    return CurveAnswer::departs(Departure::geometry, "The cut does not end on the line.");
  }
  const Axis axis = longest_axis(reference_);
  const int direction = visible_sign(reference_.to()[axis] - reference_.from[axis]);
  const Number reached = (subject.to()[axis] - reference_.from[axis]) * direction;
  if (reached < from.line - tau) {
    return CurveAnswer::departs(Departure::geometry, "The cut goes back along the line.");
  }
  CurveProgress progress = from;
  progress.line = max(from.line, reached);
  return CurveAnswer::goes(std::move(progress), agree(subject.to(), reference_.to(), tau));
}

// R3: whether the reference is an arc in space that agrees with its chord: rounded, its three
// points may lie in line, and then it can be put out only as that. Or one of more than half a turn,
// along which a line leads by no angle.
bool Curve::comes_as_line() const {
  const RecordKind kind = reference_.record.kind;
  const Number& tau = tolerances_.tolerance;
  if (kind == RecordKind::arc) return !open_ && is_narrow_arc(reference_, tau);
  return kind == RecordKind::arc3 && agrees_with_chord(reference_, tau);
}

// R3. An arc that agrees with its chord.
CurveAnswer Curve::follow_flat(const CurveProgress& from, const Motion& subject) const {
  const Number& tau = tolerances_.tolerance;
  const auto is_on_line = [&](const Position& at) { return agrees_with_line(reference_, at, tau); };
  const bool is_arc = subject.record.kind == RecordKind::arc;
  const bool agrees = agrees_with_chord(subject, tau) &&
                      (is_arc ? std::ranges::all_of(farthest_of_flat(subject, tau), is_on_line)
                              : is_on_line(via_of(subject)));
  if (!agrees) {
    return CurveAnswer::departs(Departure::kind,
                                "The cut goes along an arc instead of a straight line.");
  }
  return follow_line(from, subject);
}

bool Curve::goes_beyond(const CurveProgress& from, const Motion& subject) const {
  if (tolerances_.compare_blocks && reference_.record.block != subject.record.block) return false;
  const bool cut = reference_.record.kind != RecordKind::rapid;
  if (cut && !feeds_agree(reference_.record, subject.record, tolerances_)) return false;
  const bool is_arc = is_round(subject.record.kind);
  if (round_ && is_arc) return arc_goes_beyond(from, subject);
  if (round_) {
    return subject.record.kind == RecordKind::feed &&
           (chord_goes_beyond(from, subject) || (chord() && line_goes_beyond(subject)));
  }
  const bool is_chord = reference_.record.kind == RecordKind::feed && is_arc &&
                        agrees_with_chord(subject, tolerances_.tolerance);
  return (is_chord || reference_.record.kind == subject.record.kind) && line_goes_beyond(subject);
}

std::optional<Motion> Curve::chord() const {
  if (open_ || !agrees_with_chord(reference_, tolerances_.tolerance)) return std::nullopt;
  return chord_of(reference_);
}

bool Curve::line_goes_beyond(const Motion& subject) const {
  const Number& tau = tolerances_.tolerance;
  // Traverses are joined along a single axis only.
  const bool traverse = reference_.record.kind == RecordKind::rapid;
  if (traverse &&
      (!moves_one_axis(subject, tau) || moved_axes(reference_, tau) != moved_axes(subject, tau))) {
    return false;
  }
  return agrees_with_line(reference_, subject.from, tau) &&
         agrees_with_line(subject, reference_.to(), tau);
}

}  // namespace gonogo::oracle
