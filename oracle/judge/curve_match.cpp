// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/curve_match.hpp"

#include <cmath>
#include <numbers>

#include "oracle/approximate.hpp"

namespace gonogo::oracle {
namespace {

using reference::kAllAxes;
using reference::PlaneAxes;

// Differences of less than this are no difference of whole turns.
constexpr double kQuarterTurn = 0.25;

MatchResult departs(Departure departure, std::string reason) {
  return {departure, false, std::move(reason)};
}

// 2^-exponent of the magnitude of a.
Number scaled_down(const Number& a, int exponent) {
  return abs(a) * Number::binary(1, -exponent);
}

// The parameters t of [0, 1] at which from + t (to - from) agrees with `point` on every axis.
struct Span01 {
  Number low = 0;
  Number high = 1;
  bool empty() const { return high < low; }
};

Span01 agreeing_parameters(const Motion& line, const Position& point, const Number& tolerance) {
  Span01 span;
  for (Axis axis : kAllAxes) {
    const Number travel = line.to()[axis] - line.from[axis];
    const Number offset = point[axis] - line.from[axis];
    if (travel.sign() == 0) {
      if (abs(offset) > tolerance) return {1, 0};
      continue;
    }
    Number first = (offset - tolerance) / travel;
    Number second = (offset + tolerance) / travel;
    if (travel.sign() < 0) std::swap(first, second);
    span.low = max(span.low, first);
    span.high = min(span.high, second);
  }
  return span;
}

Axis longest_axis(const Motion& motion) {
  Axis longest = Axis::x;
  Number length = -1;
  for (Axis axis : kAllAxes) {
    const Number travel = abs(motion.to()[axis] - motion.from[axis]);
    if (travel > length) {
      length = travel;
      longest = axis;
    }
  }
  return longest;
}

bool is_too_small_to_see(const Motion& motion, const Number& tolerance) {
  return agree(motion.from, motion.to(), tolerance) && !nearly_full_turn(motion);
}

// Whether `got` is the exact value, or that correctly rounded.
bool rounds_to(const Number& exact, const Number& got, const std::optional<Number>& resolution,
               const JudgeTerms& terms) {
  const Number difference = abs(exact - got);
  if (difference.sign() == 0) return true;
  if (resolution && difference * 2 <= *resolution) return true;
  // Two units in the last place of a double lie between 2^-52 and 2^-51 of the value.
  return terms.binary64 && difference <= scaled_down(exact, 51);
}

}  // namespace

bool feeds_agree(const Record& reference, const Record& subject, const JudgeTerms& terms) {
  return reference.feed_mode == subject.feed_mode &&
         rounds_to(reference.feed, subject.feed, terms.feed_resolution, terms);
}

CurveMatch::CurveMatch(const Motion& reference, const JudgeTerms& terms,
                       std::optional<OpenArc> open)
    : reference_(reference), terms_(terms), open_(std::move(open)) {}

MatchResult CurveMatch::match(const Motion& subject) {
  const Record& want = reference_.record;
  const Record& got = subject.record;
  if (terms_.compare_blocks && want.block != got.block) {
    return departs(Departure::block, "The motion belongs to another block.");
  }
  const bool chord =
      want.kind == RecordKind::arc && got.kind == RecordKind::feed && terms_.chord.sign() > 0;
  if (want.kind != got.kind && !chord) {
    return departs(Departure::kind, "The motion is of another kind.");
  }
  MatchResult result;
  switch (want.kind) {
    case RecordKind::rapid:
      return match_rapid(subject);
    case RecordKind::feed:
      result = match_line(subject);
      break;
    case RecordKind::arc:
      result = chord ? match_chord(subject) : match_arc(subject);
      break;
    case RecordKind::thread:
      return match_thread(subject);
    default:
      return departs(Departure::undecided, "No rule compares this kind of motion.");
  }
  if (result.departure == Departure::none && !feeds_agree(want, got, terms_)) {
    return departs(Departure::feed, "The feed differs.");
  }
  return result;
}

// A line whose lead counts instead of a feed. The spindle angle is that of its beginning: of the
// first of several pieces.
MatchResult CurveMatch::match_thread(const Motion& subject) {
  const Record& want = reference_.record;
  const Record& got = subject.record;
  const bool begins = agree(subject.from, reference_.from, terms_.tolerance);
  const MatchResult result = match_line(subject);
  if (result.departure != Departure::none) return result;
  if (!rounds_to(want.lead, got.lead, terms_.resolution, terms_)) {
    return departs(Departure::feed, "The lead differs.");
  }
  const Number turn = 360;
  const Number apart = got.start - want.start - turn * ((got.start - want.start) / turn).floor();
  if (begins && !rounds_to(0, min(apart, turn - apart), terms_.resolution, terms_)) {
    return departs(Departure::geometry, "The thread starts at another angle of the spindle.");
  }
  return result;
}

// Rule 4: rapids that end where it ends, monotone on each axis, no other axis.
MatchResult CurveMatch::match_rapid(const Motion& subject) {
  for (Axis axis : kAllAxes) {
    const Number& start = subject.from[axis];
    const Number& target = reference_.to()[axis];
    const Number& end = subject.to()[axis];
    const Number& tau = terms_.tolerance;
    // Not by min() and max(), which enclosures of one value could not decide.
    const bool above_low = end >= target - tau || end >= start - tau;
    const bool below_high = end <= target + tau || end <= start + tau;
    if (!above_low || !below_high) {
      return departs(Departure::geometry, "The traverse leaves the way to its end.");
    }
  }
  return {Departure::none, agree(subject.to(), reference_.to(), terms_.tolerance), {}};
}

MatchResult CurveMatch::match_line(const Motion& subject) {
  const Span01 start = agreeing_parameters(reference_, subject.from, terms_.tolerance);
  const Span01 end = agreeing_parameters(reference_, subject.to(), terms_.tolerance);
  if (start.empty()) return departs(Departure::geometry, "The cut does not start on the line.");
  if (end.empty()) return departs(Departure::geometry, "The cut does not end on the line.");
  const Axis axis = longest_axis(reference_);
  const int direction = (reference_.to()[axis] - reference_.from[axis]).sign();
  const Number progress = (subject.to()[axis] - reference_.from[axis]) * direction;
  if (progress < line_progress_ - terms_.tolerance) {
    return departs(Departure::geometry, "The cut goes back along the line.");
  }
  line_progress_ = max(line_progress_, progress);
  return {Departure::none, agree(subject.to(), reference_.to(), terms_.tolerance), {}};
}

bool CurveMatch::ends_at(const Position& point) const {
  if (!open_) return agree(point, reference_.to(), terms_.tolerance);
  const PlaneAxes axes = reference::axes_of(reference_.record.plane);
  for (Axis axis : kAllAxes) {
    if (axis == axes.p || axis == axes.q) continue;
    if (!agree(point[axis], reference_.to()[axis], terms_.tolerance)) return false;
  }
  return open_->starts->admits(open_->end,
                               {point[axes.p] - open_->origin.p, point[axes.q] - open_->origin.q});
}

bool CurveMatch::centre_agrees(const Record& arc) const {
  const std::array<Number, 2>& want = reference_.record.centre;
  if (!open_) {
    return agree(want[0], arc.centre[0], terms_.tolerance) &&
           agree(want[1], arc.centre[1], terms_.tolerance);
  }
  return open_->starts->admits(open_->centre,
                               {arc.centre[0] - open_->origin.p, arc.centre[1] - open_->origin.q});
}

// Whether the circle about the reference's centre passes through the box round the point: the box's
// nearest and farthest distances from the centre enclose the radius.
bool CurveMatch::on_circle(const Position& point, Number tolerance) const {
  const PlaneVector v = from_centre(reference_.record, point);
  const PlaneVector a = from_centre(reference_.record, reference_.from);
  const PlaneVector b = from_centre(reference_.record, reference_.to());
  Number start_2 = a.p * a.p + a.q * a.q;
  Number end_2 = b.p * b.p + b.q * b.q;
  if (open_) {
    start_2 = end_2 = open_->radius * open_->radius;
    tolerance += open_->slack;
  }
  const Number p = abs(v.p);
  const Number q = abs(v.q);
  const Number near_p = max(p - tolerance, 0);
  const Number near_q = max(q - tolerance, 0);
  const Number far_p = p + tolerance;
  const Number far_q = q + tolerance;
  return near_p * near_p + near_q * near_q <= max(start_2, end_2) &&
         far_p * far_p + far_q * far_q >= min(start_2, end_2);
}

// The sweep is estimated, so a band round the tolerance is left undecided: the estimate's own
// error, and the height that the helix gains over a tolerance's length of arc.
int CurveMatch::on_helix(const Position& point, double turns) const {
  constexpr double kEstimate = 1e-7;  // mm
  const PlaneAxes axes = reference::axes_of(reference_.record.plane);
  const double whole = approximate_turns(reference_);
  const double tolerance = approximate(terms_.tolerance);
  const PlaneVector start = from_centre(reference_.record, reference_.from);
  const double radius = std::hypot(approximate(start.p), approximate(start.q));
  int answer = 1;
  for (Axis axis : kAllAxes) {
    if (axis == axes.p || axis == axes.q) continue;
    const Number travel = reference_.to()[axis] - reference_.from[axis];
    if (travel.sign() == 0) {
      if (!agree(point[axis], reference_.from[axis], terms_.tolerance)) return -1;
      continue;
    }
    const double height = approximate(travel);
    const double slope = std::abs(height) / (2 * std::numbers::pi * radius * whole);
    const double want = approximate(reference_.from[axis]) + turns / whole * height;
    const double difference = std::abs(want - approximate(point[axis]));
    if (difference > tolerance + 2 * slope * tolerance + kEstimate) return -1;
    if (difference > tolerance - kEstimate) answer = 0;
  }
  return answer;
}

// The end of a piece that sweeps `turns`: at the end of the arc, or on the way to it.
MatchResult CurveMatch::end_of_piece(const Motion& subject, double turns) {
  const double whole = approximate_turns(reference_);
  const double progress = arc_progress_ + turns;
  if (ends_at(subject.to()) && std::abs(progress - whole) < kQuarterTurn) {
    arc_progress_ = progress;
    return {Departure::none, true, {}};
  }
  if (progress >= whole) return departs(Departure::geometry, "The arc goes beyond its end.");
  const int height = on_helix(subject.to(), progress);
  if (!on_circle(subject.to(), terms_.tolerance) || height < 0) {
    return departs(Departure::geometry, "The arc ends off the curve.");
  }
  if (height == 0) return departs(Departure::undecided, "The height of the helix is too close.");
  arc_progress_ = progress;
  return {};
}

MatchResult CurveMatch::match_arc(const Motion& subject) {
  const Record& want = reference_.record;
  const Record& got = subject.record;
  if (want.plane != got.plane)
    return departs(Departure::geometry, "The arc lies in another plane.");
  if ((want.rot < 0) != (got.rot < 0)) {
    return departs(Departure::sense, "The arc turns the wrong way.");
  }
  if (!centre_agrees(got)) return departs(Departure::geometry, "The centre of the arc differs.");
  const double turns = approximate_turns(subject);
  const PlaneAxes axes = reference::axes_of(got.plane);
  const bool closes = agree(subject.from[axes.p], subject.to()[axes.p], terms_.tolerance) &&
                      agree(subject.from[axes.q], subject.to()[axes.q], terms_.tolerance);
  if (!closes) return end_of_piece(subject, turns);
  // Start and end agree: the nil and the full turn are tried, and the one that fits is taken. After
  // other whole turns, a turn that the arc does make is no nil one; and an arc that ends exactly
  // where it starts is a full turn by what a record means, unless the reference's is as small.
  const double before = std::abs(got.rot) - 1;
  const double part = turns - before;
  const double small = part < 0.5 ? part : part - 1;
  MatchResult full = end_of_piece(subject, before + small + 1);
  const bool exactly_whole = part == 1.0 && !is_too_small_to_see(reference_, terms_.tolerance);
  if (full.departure == Departure::none || exactly_whole || (before > 0 && part >= 0.5)) {
    return full;
  }
  MatchResult nil = end_of_piece(subject, before + small);
  const bool open = nil.departure != Departure::none && full.departure == Departure::undecided;
  return open ? full : nil;
}

// A straight cut as a chord of the arc: its ends on the curve, and the sagitta within the chord
// tolerance that the certifier granted.
MatchResult CurveMatch::match_chord(const Motion& subject) {
  if (!on_circle(subject.to(), terms_.tolerance + terms_.chord)) {
    return departs(Departure::geometry, "The chord ends off the arc.");
  }
  Motion arc = subject;
  arc.record.kind = RecordKind::arc;
  arc.record.plane = reference_.record.plane;
  arc.record.centre = reference_.record.centre;
  arc.record.rot = reference_.record.rot < 0 ? -1 : 1;
  const double turns = approximate_turns(arc);
  if (turns > 0.5) return departs(Departure::geometry, "The chord goes back along the arc.");
  // The middle of the chord is its farthest point from the arc.
  Position middle;
  for (Axis axis : kAllAxes) middle[axis] = (subject.from[axis] + subject.to()[axis]) / 2;
  if (!on_circle(middle, terms_.tolerance + terms_.chord)) {
    return departs(Departure::geometry, "The chord leaves the arc by more than was granted.");
  }
  const double whole = approximate_turns(reference_);
  const double progress = arc_progress_ + turns;
  const Number granted = terms_.tolerance + terms_.chord;
  if (ends_at(subject.to()) && std::abs(progress - whole) < kQuarterTurn) {
    arc_progress_ = progress;
    return {Departure::none, true, {}};
  }
  if (progress >= whole && !agree(subject.to(), reference_.to(), granted)) {
    return departs(Departure::geometry, "The chord goes beyond the end of the arc.");
  }
  const int height = on_helix(subject.to(), progress);
  if (height < 0) return departs(Departure::geometry, "The chord ends off the helix.");
  if (height == 0) return departs(Departure::undecided, "The height of the helix is too close.");
  arc_progress_ = progress;
  return {};
}

}  // namespace gonogo::oracle
