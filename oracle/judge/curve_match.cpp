// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/curve_match.hpp"

#include <algorithm>
#include <cmath>

namespace gonogo::oracle {
namespace {

using reference::kAllAxes;
using reference::PlaneAxes;

// Differences of less than this are no difference of whole turns.
constexpr double kQuarterTurn = 0.25;

constexpr const char* kHelixTooClose = "The height of the helix is too close.";

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
  return agree(motion.from, motion.to(), tolerance) && !goes_round(motion, tolerance);
}

bool moves_one_axis(const Motion& motion, const Number& tolerance) {
  const AxisSet moved = moved_axes(motion, tolerance);
  return std::ranges::count_if(kAllAxes, [&](Axis axis) { return moved.has(axis); }) == 1;
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
    : reference_(reference), terms_(terms), open_(std::move(open)) {
  if (is_round(reference.record.kind)) round_.emplace(reference_, open_);
}

MatchResult CurveMatch::match(const Motion& subject) {
  const Record& want = reference_.record;
  const Record& got = subject.record;
  if (terms_.compare_blocks && want.block != got.block) {
    return departs(Departure::block, "The motion belongs to another block.");
  }
  MatchResult result = departs(Departure::kind, "The motion is of another kind.");
  if (round_) {
    if (got.kind == RecordKind::arc) result = match_arc(subject);
    if (got.kind == RecordKind::arc3) result = match_arc3(subject);
    if (got.kind == RecordKind::feed && terms_.chord.sign() > 0) result = match_chord(subject);
  } else if (want.kind == RecordKind::feed && got.kind == RecordKind::arc3) {
    result = match_flat(subject);
  } else if (want.kind == got.kind) {
    if (want.kind == RecordKind::rapid) return match_rapid(subject);
    if (want.kind == RecordKind::thread) return match_thread(subject);
    result = match_line(subject);
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
  // Or where the reference stood before what it dropped, and the subject may not have.
  const bool stood = reference_.stood && agree(subject.from, *reference_.stood, terms_.tolerance);
  if (start.empty() && !stood) {
    return departs(Departure::geometry, "The cut does not start on the line.");
  }
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

// An arc in space that nothing tells from its chord.
MatchResult CurveMatch::match_flat(const Motion& subject) {
  const Position via = via_of(subject);
  if (!ThreePoints(subject).is_flat(terms_.tolerance) ||
      agreeing_parameters(reference_, via, terms_.tolerance).empty()) {
    return departs(Departure::kind, "The cut goes along an arc instead of a straight line.");
  }
  return match_line(subject);
}

bool CurveMatch::ends_at(const Position& point) const {
  if (!open_) return agree(point, reference_.to(), terms_.tolerance);
  const PlaneAxes axes = reference::axes_of(round_->arc()->record.plane);
  for (Axis axis : kAllAxes) {
    if (axis == axes.p || axis == axes.q) continue;
    if (!agree(point[axis], reference_.to()[axis], terms_.tolerance)) return false;
  }
  return open_->starts->admits(open_->end,
                               {point[axes.p] - open_->origin.p, point[axes.q] - open_->origin.q});
}

bool CurveMatch::centre_agrees(const Record& arc) const {
  const std::array<Number, 2>& want = round_->arc()->record.centre;
  if (!open_) {
    return agree(want[0], arc.centre[0], terms_.tolerance) &&
           agree(want[1], arc.centre[1], terms_.tolerance);
  }
  return open_->starts->admits(open_->centre,
                               {arc.centre[0] - open_->origin.p, arc.centre[1] - open_->origin.q});
}

Departure CurveMatch::on_curve(const Position& point, double turns, const Number& tolerance) const {
  if (!round_->on_circle(point, tolerance)) return Departure::geometry;
  const int height = round_->on_helix(point, turns, tolerance, true);
  if (height == 0) return Departure::undecided;
  return height < 0 ? Departure::geometry : Departure::none;
}

// The end of a piece that sweeps `turns`: at the end of the arc, or on the way to it.
MatchResult CurveMatch::end_of_piece(const Motion& subject, double turns) {
  const double whole = round_->whole();
  const double progress = arc_progress_ + turns;
  if (std::abs(progress - whole) < kQuarterTurn && ends_at(subject.to())) {
    arc_progress_ = progress;
    return {Departure::none, true, {}};
  }
  if (progress >= whole) return departs(Departure::geometry, "The arc goes beyond its end.");
  const int height = round_->on_helix(subject.to(), progress, terms_.tolerance);
  if (!round_->on_circle(subject.to(), terms_.tolerance) || height < 0) {
    return departs(Departure::geometry, "The arc ends off the curve.");
  }
  if (height == 0) return departs(Departure::undecided, kHelixTooClose);
  arc_progress_ = progress;
  return {};
}

MatchResult CurveMatch::match_arc(const Motion& subject) {
  const Record& got = subject.record;
  if (round_->arc() == nullptr || round_->arc()->record.plane != got.plane) {
    return departs(Departure::geometry, "The arc lies in another plane.");
  }
  const Record& want = round_->arc()->record;
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
  const Number granted = terms_.tolerance + terms_.chord;
  if (!round_->on_circle(subject.to(), granted)) {
    return departs(Departure::geometry, "The chord ends off the arc.");
  }
  const double turns = round_->part_of_turn(subject.from, subject.to());
  if (turns > 0.5) return departs(Departure::geometry, "The chord goes back along the arc.");
  // The middle of the chord is its farthest point from the arc.
  Position middle;
  for (Axis axis : kAllAxes) middle[axis] = (subject.from[axis] + subject.to()[axis]) / 2;
  if (!round_->on_circle(middle, granted)) {
    return departs(Departure::geometry, "The chord leaves the arc by more than was granted.");
  }
  const double whole = round_->whole();
  const double progress = arc_progress_ + turns;
  if (std::abs(progress - whole) < kQuarterTurn && ends_at(subject.to())) {
    arc_progress_ = progress;
    return {Departure::none, true, {}};
  }
  if (progress >= whole && !agree(subject.to(), reference_.to(), granted)) {
    return departs(Departure::geometry, "The chord goes beyond the end of the arc.");
  }
  const int height = round_->on_helix(subject.to(), progress, terms_.tolerance);
  if (height < 0) return departs(Departure::geometry, "The chord ends off the helix.");
  if (height == 0) return departs(Departure::undecided, kHelixTooClose);
  arc_progress_ = progress;
  return {};
}

// A record of an arc in space has no centre: its three points stand for it. They agree with points
// of the reference's curve in their order, and the arc turns in its sense. The middles of its two
// parts agree with points of it too, to within twice the tolerance: that much may come of rounding
// three points that are well apart, while an intermediate point near an end that makes another
// circle of it shows there. What nothing tells from its chord has no sense of its own, and follows
// the curve forward as a chord does.
MatchResult CurveMatch::follow_arc3(const Motion& subject, double& turns) const {
  const ThreePoints points(subject);
  const Number& tau = terms_.tolerance;
  if (!points.circle) {
    return departs(Departure::geometry, "The three points of the arc lie in line.");
  }
  const bool flat = points.is_flat(tau);
  if (!flat && !round_->same_sense(points.circle->normal)) {
    return departs(Departure::sense, "The arc turns the wrong way.");
  }
  // About its own axis whole turns are sure, about the reference's the parts are those that count.
  const double to_end = flat ? 0 : points.turns();
  const double to_via = flat ? 0 : part_of_turn(*points.circle, points.from.at, points.via.at);
  const auto sweep_to = [&](const Position& point, double own) {
    const double part = round_->part_of_turn(subject.from, point);
    return part + std::round(own - part);
  };
  turns = sweep_to(subject.to(), to_end);
  if (turns < 0 && !agree(subject.from, subject.to(), tau)) {
    return departs(Departure::geometry, "The arc goes back along the curve.");
  }
  turns = std::max(turns, 0.0);
  const auto off = [](Departure departure) {
    return departure == Departure::undecided
               ? departs(departure, kHelixTooClose)
               : departs(departure, "The arc leaves the curve between its ends.");
  };
  const auto departure_at = [&](const Position& point, double own, const Number& tolerance) {
    return on_curve(point, arc_progress_ + sweep_to(point, own), tolerance);
  };
  const Position via = via_of(subject);
  if (const Departure at = departure_at(via, to_via, tau); at != Departure::none) return off(at);
  // Rationals in place of other numbers move a middle by far less than this.
  const Number slack = points.exact() ? Number(0) : Number::binary(1, -20);
  for (const bool first : {true, false}) {
    const SpacePoint middle = first ? middle_seen_from(points.to.at, points.from.at, points.via.at)
                                    : middle_seen_from(points.from.at, points.via.at, points.to.at);
    Position point = subject.from;
    for (Axis axis : reference::kLinearAxes) point[axis] = middle[reference::index(axis)];
    const double own = first ? to_via / 2 : (to_via + to_end) / 2;
    const Departure at = departure_at(point, own, tau * 2 - slack);
    if (at == Departure::none) continue;
    if (slack.sign() == 0 || departure_at(point, own, tau * 2 + slack) == at) return off(at);
    return departs(Departure::undecided, "The width of an enclosure decides about an arc.");
  }
  return {};
}

MatchResult CurveMatch::match_arc3(const Motion& subject) {
  double turns = 0;
  MatchResult result = follow_arc3(subject, turns);
  return result.departure == Departure::none ? end_of_piece(subject, turns) : result;
}

bool CurveMatch::goes_beyond(const Motion& subject) const {
  const bool cut = reference_.record.kind != RecordKind::rapid;
  if (cut && !feeds_agree(reference_.record, subject.record, terms_)) return false;
  if (round_) return is_round(subject.record.kind) && arc_goes_beyond(subject);
  return reference_.record.kind == subject.record.kind && line_goes_beyond(subject);
}

bool CurveMatch::line_goes_beyond(const Motion& subject) const {
  const Number& tau = terms_.tolerance;
  // Traverses are joined along a single axis only.
  const bool traverse = reference_.record.kind == RecordKind::rapid;
  if (traverse &&
      (!moves_one_axis(subject, tau) || moved_axes(reference_, tau) != moved_axes(subject, tau))) {
    return false;
  }
  return !agreeing_parameters(reference_, subject.from, tau).empty() &&
         !agreeing_parameters(subject, reference_.to(), tau).empty();
}

// Only arcs without height are joined.
bool CurveMatch::arc_goes_beyond(const Motion& subject) const {
  const Number& tau = terms_.tolerance;
  double turns = 0;
  if (subject.record.kind == RecordKind::arc3) {
    if (follow_arc3(subject, turns).departure != Departure::none) return false;
  } else {
    const Motion* arc = round_->arc();
    if (arc == nullptr || arc->record.plane != subject.record.plane ||
        (arc->record.rot < 0) != (subject.record.rot < 0) || !centre_agrees(subject.record)) {
      return false;
    }
    const PlaneAxes axes = reference::axes_of(arc->record.plane);
    for (Axis axis : kAllAxes) {
      if (axis == axes.p || axis == axes.q) continue;
      if (!agree(subject.to()[axis], reference_.from[axis], tau)) return false;
    }
    turns = approximate_turns(subject);
  }
  return round_->on_circle(subject.to(), tau) && arc_progress_ + turns >= round_->whole();
}

}  // namespace gonogo::oracle
