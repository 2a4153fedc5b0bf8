// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curve's part for round motions of the reference: arcs, helices and circles in space, and the
// chords that a certifier grants for them.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

#include "oracle/motion/arc_turns.hpp"
#include "oracle/motion/curve.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {
namespace {

using reference::kAllAxes;
using reference::PlaneAxes;

// R9.
constexpr const char* kHelixTooClose = "The height of the helix is too close.";
constexpr const char* kSpiralTooClose = "The radius of the spiral is too close.";

// A piece of which it is open whether it ends on the curve decides nothing yet: if what follows
// departs, so does the whole; if it leads to the end, the whole is open.
CurveAnswer doubtful(CurveProgress progress, const char* reason) {
  progress.undecided_because = reason;
  progress.gap = GapReason::comparison;
  return CurveAnswer::goes(std::move(progress), false);
}

CurveProgress advanced(const CurveProgress& from, double turns) {
  CurveProgress progress = from;
  progress.arc += turns;
  return progress;
}

constexpr const char* kHangsOnRounding =
    "Rounding decides whether the arc makes a turn more or less than its record says.";

// What the motion may be by either answer. The first of two departures counts, unless the other is
// open.
CurveAnswer joined(CurveAnswer one, CurveAnswer other) {
  if (one.departs()) {
    const bool other_says = !other.departs() || other.departure == Departure::undecided;
    return other_says ? other : one;
  }
  std::ranges::move(other.ways, std::back_inserter(one.ways));
  return one;
}

}  // namespace

bool Curve::ends_at(const Position& point) const {
  if (!open_) return agree(point, reference_.to(), tolerances_.tolerance);
  const PlaneAxes axes = reference::axes_of(round_->arc()->record.plane);
  for (Axis axis : kAllAxes) {
    if (axis == axes.p || axis == axes.q) continue;
    if (!agree(point[axis], reference_.to()[axis], tolerances_.tolerance)) return false;
  }
  return open_->starts->admits(open_->end,
                               {point[axes.p] - open_->origin.p, point[axes.q] - open_->origin.q});
}

bool Curve::centre_agrees(const Record& arc) const {
  const std::array<Number, 2>& want = round_->arc()->record.centre;
  if (!open_) {
    return agree(want[0], arc.centre[0], tolerances_.tolerance) &&
           agree(want[1], arc.centre[1], tolerances_.tolerance);
  }
  return open_->starts->admits(open_->centre,
                               {arc.centre[0] - open_->origin.p, arc.centre[1] - open_->origin.q});
}

Departure Curve::on_curve(const Position& point, double turns, const Number& tolerance) const {
  if (!round_->on_circle(point, tolerance)) return Departure::geometry;
  const int on = std::min(round_->on_helix(point, turns, tolerance, true),
                          round_->on_spiral(point, turns, tolerance));
  if (on == 0) return Departure::undecided;
  return on < 0 ? Departure::geometry : Departure::none;
}

CurveAnswer Curve::follow_round(const CurveProgress& from, const Motion& subject) const {
  const RecordKind got = subject.record.kind;
  if (got == RecordKind::arc) return follow_arc(from, subject);
  if (got == RecordKind::arc3) return follow_arc3(from, subject);
  if (got == RecordKind::feed && takes_chords()) return follow_chord(from, subject);
  return CurveAnswer::departs(Departure::kind, "The motion is of another kind.");
}

// The end of a piece that sweeps `turns`: at the end of the arc, or on the way to it.
CurveAnswer Curve::end_of_piece(const CurveProgress& from, const Motion& subject,
                                double turns) const {
  const double whole = round_->whole();
  CurveProgress progress = advanced(from, turns);
  if (std::abs(progress.arc - whole) < kQuarterTurn && ends_at(subject.to())) {
    return CurveAnswer::goes(std::move(progress), true);
  }
  if (progress.arc >= whole) {
    // At the end's angle it is off in its radius or along another axis.
    const bool is_beyond = progress.arc > whole + kEstimate;
    return CurveAnswer::departs(Departure::geometry, is_beyond ? "The arc goes beyond its end."
                                                               : "The arc ends off the curve.");
  }
  const int height = round_->on_helix(subject.to(), progress.arc, tolerances_.tolerance);
  const int radius = round_->on_spiral(subject.to(), progress.arc, tolerances_.tolerance);
  if (!round_->on_circle(subject.to(), tolerances_.tolerance) || height < 0 || radius < 0) {
    return CurveAnswer::departs(Departure::geometry, "The arc ends off the curve.");
  }
  if (height == 0) return doubtful(std::move(progress), kHelixTooClose);
  if (radius == 0) return doubtful(std::move(progress), kSpiralTooClose);
  return CurveAnswer::goes(std::move(progress), false);
}

CurveAnswer Curve::other_centre(const Motion& subject) const {
  CurveAnswer answer = CurveAnswer::departs(Departure::geometry, "The centre of the arc differs.");
  if (open_) return answer;  // many centres are meant
  const PlaneAxes axes = reference::axes_of(subject.record.plane);
  const std::array<Number, 2>& want = round_->arc()->record.centre;
  const std::array<Number, 2>& got = subject.record.centre;
  Position centre = subject.to();
  Position wanted = centre;
  for (const auto& [axis, i] : {std::pair(axes.p, 0U), std::pair(axes.q, 1U)}) {
    centre[axis] = got[i];
    wanted[axis] = want[i];
  }
  answer.centre = Apart{centre, largest_difference(centre, wanted)};
  return answer;
}

// R2.
CurveAnswer Curve::follow_arc(const CurveProgress& from, const Motion& subject) const {
  const Record& got = subject.record;
  if (round_->arc() == nullptr || round_->arc()->record.plane != got.plane) {
    return CurveAnswer::departs(Departure::geometry, "The arc lies in another plane.");
  }
  const Record& want = round_->arc()->record;
  if ((want.rot < 0) != (got.rot < 0)) {
    return CurveAnswer::departs(Departure::sense, "The arc turns the wrong way.");
  }
  if (!centre_agrees(got)) return other_centre(subject);
  const double turns = approximate_turns(subject);
  return joined(end_of_piece(from, subject, turns), by_rounding(from, subject, turns));
}

// J-PATH-06. Where rounding may have moved the end across the ray of the start: a turn more, or, of
// a record that is the curve's, rounded, one less, if it has one turn or as many as the arc's own.
// After other turns one that the arc does make is no nil one. Where an end may be the centre, the
// rest of the curve.
CurveAnswer Curve::by_rounding(const CurveProgress& from, const Motion& subject,
                               double turns) const {
  CurveAnswer answer = CurveAnswer::departs(Departure::geometry, {});
  const Number rounding = rounding_of(subject, tolerances_);
  const double before = std::abs(subject.record.rot) - 1;
  const bool is_small = turns - before < 0.5;
  const bool is_own = from.arc == 0 && subject.record.rot == round_->arc()->record.rot;
  const bool may_be_less = before == 0 || is_own;
  if ((is_small || may_be_less) && may_be_nil_or_whole(subject, rounding)) {
    CurveAnswer other = as_turns(from, subject, is_small ? turns + 1 : turns - 1);
    const bool ends = !other.departs() && other.ways.front().done;
    if (is_small || (ends && is_rounded_curve(from, subject))) answer = std::move(other);
  }
  const double rest = round_->whole() - from.arc;
  if (std::abs(rest - turns) >= 1 || !may_end_on_its_centre(subject, rounding)) return answer;
  CurveAnswer to_end = as_turns(from, subject, rest);
  if (to_end.departs() || !to_end.ways.front().done) return answer;
  return joined(std::move(answer), std::move(to_end));
}

// So many turns instead of those that the record says. It is open whether they are meant, unless
// the record is the curve's, rounded as the subject declares: a double may come out on either side
// of what was meant, decimals where the curve's ends are not one point, for one is rounded to one.
CurveAnswer Curve::as_turns(const CurveProgress& from, const Motion& subject, double turns) const {
  CurveAnswer answer = end_of_piece(from, subject, turns);
  const bool is_declared =
      tolerances_.resolution ? from.arc == 0 && !closes() : tolerances_.binary64;
  if (is_declared && is_rounded_curve(from, subject)) return answer;
  for (CurveWay& way : answer.ways) {
    way.progress.undecided_because = kHangsOnRounding;
    way.progress.gap = GapReason::two_readings;
  }
  return answer;
}

// Whether the arc of the reference ends where it starts, as far as can be seen.
bool Curve::closes() const {
  const Motion& want = *round_->arc();
  const PlaneAxes axes = reference::axes_of(want.record.plane);
  return visible_sign(want.from[axes.p] - want.to()[axes.p]) == 0 &&
         visible_sign(want.from[axes.q] - want.to()[axes.q]) == 0;
}

// Whether the record's numbers are those of what is left of the curve, rounded; where a piece
// starts is the subject's choice.
bool Curve::is_rounded_curve(const CurveProgress& from, const Motion& subject) const {
  const Motion& want = *round_->arc();
  const PlaneAxes axes = reference::axes_of(want.record.plane);
  const Number rounding = rounding_of(subject, tolerances_);
  bool agrees = true;
  for (const auto& [axis, i] : {std::pair(axes.p, 0U), std::pair(axes.q, 1U)}) {
    agrees = agrees && agree(subject.to()[axis], want.to()[axis], rounding) &&
             agree(subject.record.centre[i], want.record.centre[i], rounding) &&
             (from.arc != 0 || agree(subject.from[axis], want.from[axis], rounding));
  }
  return agrees;
}

// R3: that the certifier grants, or of an arc that agrees with its own.
bool Curve::takes_chords() const {
  return tolerances_.chord.sign() > 0 || (reference_.record.kind == RecordKind::arc && !open_ &&
                                          is_flat_arc(reference_, tolerances_.tolerance));
}

// Whether a chord agrees with the curve between its ends; 0: too close to say. Its middle is its
// farthest point from a circle; from a spiral it may be another one.
int Curve::chord_stays(const CurveProgress& from, const Motion& chord,
                       const Number& granted) const {
  int answer = 1;
  for (const int eighth : {4, 1, 2, 3, 5, 6, 7}) {
    Position point;
    for (Axis axis : kAllAxes) {
      const Number way = chord.to()[axis] - chord.from[axis];
      point[axis] = chord.from[axis] + way * eighth / 8;
    }
    if (!round_->on_circle(point, granted)) return -1;
    if (!round_->is_spiral()) return 1;
    const double along = from.arc + round_->part_of_turn(chord.from, point);
    answer = std::min(answer, round_->on_spiral(point, along, granted));
  }
  return answer;
}

// R3. A straight cut as a chord of the arc: its ends on the curve, and the sagitta within
// what the certifier granted and the tolerance.
CurveAnswer Curve::follow_chord(const CurveProgress& from, const Motion& subject) const {
  const Number granted = tolerances_.tolerance + tolerances_.chord;
  if (!round_->on_circle(subject.to(), granted)) {
    return CurveAnswer::departs(Departure::geometry, "The chord ends off the arc.");
  }
  const double turns = round_->part_of_turn(subject.from, subject.to());
  if (turns > 0.5) {
    return CurveAnswer::departs(Departure::geometry, "The chord goes back along the arc.");
  }
  const int inside = chord_stays(from, subject, granted);
  if (inside == 0) return CurveAnswer::undecided(GapReason::comparison, kSpiralTooClose);
  if (inside < 0) {
    return CurveAnswer::departs(Departure::geometry,
                                "The chord leaves the arc by more than was granted.");
  }
  const double whole = round_->whole();
  CurveProgress progress = advanced(from, turns);
  if (std::abs(progress.arc - whole) < kQuarterTurn && ends_at(subject.to())) {
    return CurveAnswer::goes(std::move(progress), true);
  }
  if (progress.arc >= whole && !agree(subject.to(), reference_.to(), granted)) {
    return CurveAnswer::departs(Departure::geometry, "The chord goes beyond the end of the arc.");
  }
  const int height = round_->on_helix(subject.to(), progress.arc, tolerances_.tolerance);
  if (height < 0) {
    return CurveAnswer::departs(Departure::geometry, "The chord ends off the helix.");
  }
  if (height == 0) return doubtful(std::move(progress), kHelixTooClose);
  const int radius = round_->on_spiral(subject.to(), progress.arc, granted);
  if (radius < 0) {
    return CurveAnswer::departs(Departure::geometry, "The chord ends off the spiral.");
  }
  if (radius == 0) return doubtful(std::move(progress), kSpiralTooClose);
  return CurveAnswer::goes(std::move(progress), false);
}

bool Curve::names_points_of_program(const Motion& arc3) const {
  const Number& tau = tolerances_.tolerance;
  return reference_.record.kind == RecordKind::arc3 && agree(arc3.from, reference_.from, tau) &&
         agree(via_of(arc3), via_of(reference_), tau) && agree(arc3.to(), reference_.to(), tau);
}

// J-PATH-09. A record of an arc in space has no centre: its three points stand for it. They agree
// with points of the reference's curve in their order, and the arc turns in its sense. The middles
// of its two parts agree with points of it too, to within twice the tolerance: that much may come
// of rounding three points that are well apart, while an intermediate point near an end that makes
// another circle of it shows there. Not where the program itself names the three points: what
// circle they make when they are rounded is its doing then. What agrees with its chord has
// no sense of its own, and follows the curve forward as a chord does.
CurveAnswer Curve::sweep_of_arc3(const CurveProgress& from, const Motion& subject,
                                 double& turns) const {
  const ThreePoints points(subject);
  const Number& tau = tolerances_.tolerance;
  if (!points.circle) {
    return CurveAnswer::departs(Departure::geometry, "The three points of the arc lie in line.");
  }
  const bool flat = points.is_flat(tau);
  if (!flat && !round_->same_sense(points.circle->normal)) {
    return CurveAnswer::departs(Departure::sense, "The arc turns the wrong way.");
  }
  // About its own axis whole turns are sure, about the reference's the parts are those that count.
  const double to_end = flat ? 0 : points.turns();
  const double to_via = flat ? 0 : part_of_turn(*points.circle, points.from.at, points.via.at);
  // Half a turn, which may go back or forward, goes forward: `part` may be an
  // estimate of it that is a little more.
  const auto sweep_to = [&](const Position& point, double own) {
    const double part = round_->part_of_turn(subject.from, point);
    return part + std::floor(own - part + 0.5 + kEstimate);
  };
  turns = sweep_to(subject.to(), to_end);
  if (turns < 0 && !agree(subject.from, subject.to(), tau)) {
    return CurveAnswer::departs(Departure::geometry, "The arc goes back along the curve.");
  }
  turns = std::max(turns, 0.0);
  const auto off = [](Departure departure) {
    return departure == Departure::undecided
               ? CurveAnswer::undecided(GapReason::comparison, kHelixTooClose)
               : CurveAnswer::departs(departure, "The arc leaves the curve between its ends.");
  };
  const auto departure_at = [&](const Position& point, double own, const Number& tolerance) {
    return on_curve(point, from.arc + sweep_to(point, own), tolerance);
  };
  const Position via = via_of(subject);
  if (const Departure at = departure_at(via, to_via, tau); at != Departure::none) return off(at);
  if (names_points_of_program(subject)) return {};
  // Rationals in place of other numbers move a middle by far less than this.
  const Number slack = points.exact() ? Number(0) : Number::binary(1, -kMiddleBits);
  for (const bool first : {true, false}) {
    const SpacePoint middle = first ? middle_seen_from(points.to.at, points.from.at, points.via.at)
                                    : middle_seen_from(points.from.at, points.via.at, points.to.at);
    Position point = subject.from;
    for (Axis axis : reference::kLinearAxes) point[axis] = middle[reference::index(axis)];
    const double own = first ? to_via / 2 : (to_via + to_end) / 2;
    const Departure at = departure_at(point, own, tau * 2 - slack);
    if (at == Departure::none) continue;
    if (slack.sign() == 0 || departure_at(point, own, tau * 2 + slack) == at) return off(at);
    return CurveAnswer::undecided(GapReason::comparison,
                                  "The width of an enclosure decides about an arc.");
  }
  return {};
}

CurveAnswer Curve::follow_arc3(const CurveProgress& from, const Motion& subject) const {
  double turns = 0;
  CurveAnswer answer = sweep_of_arc3(from, subject, turns);
  return answer.departs() ? answer : end_of_piece(from, subject, turns);
}

// Only arcs without height are joined.
bool Curve::arc_goes_beyond(const CurveProgress& from, const Motion& subject) const {
  const Number& tau = tolerances_.tolerance;
  double turns = 0;
  if (subject.record.kind == RecordKind::arc3) {
    if (sweep_of_arc3(from, subject, turns).departs()) return false;
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
  return round_->on_circle(subject.to(), tau) && from.arc + turns >= round_->whole();
}

bool Curve::chord_goes_beyond(const CurveProgress& from, const Motion& subject) const {
  if (!takes_chords() ||
      !round_->on_circle(subject.to(), tolerances_.tolerance + tolerances_.chord)) {
    return false;
  }
  const double turns = round_->part_of_turn(subject.from, subject.to());
  return turns <= 0.5 && from.arc + turns >= round_->whole();
}

}  // namespace gonogo::oracle
