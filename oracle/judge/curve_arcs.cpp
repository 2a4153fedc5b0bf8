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

#include "oracle/judge/approximate.hpp"
#include "oracle/judge/curve.hpp"

namespace gonogo::oracle {
namespace {

using reference::kAllAxes;
using reference::PlaneAxes;

// Differences of less than this are no difference of whole turns.
// J-CONST-08.
constexpr double kQuarterTurn = 0.25;

using Vector2 = std::array<double, 2>;

// The directions in which a box of the tolerance about a point is seen from the centre, less the
// point's own, in radians; nothing where the centre lies in it.
std::optional<Vector2> directions_of_box(const Vector2& point, double tau) {
  if (std::abs(point[0]) <= tau && std::abs(point[1]) <= tau) return std::nullopt;
  Vector2 seen = {0, 0};
  for (const double p : {point[0] - tau, point[0] + tau}) {
    for (const double q : {point[1] - tau, point[1] + tau}) {
      const double aside = std::atan2(point[0] * q - point[1] * p, point[0] * p + point[1] * q);
      seen = {std::min(seen[0], aside), std::max(seen[1], aside)};
    }
  }
  return seen;
}

// Whether the boxes about two points are seen in one direction.
bool may_be_in_line(const Vector2& from, const Vector2& to, double tau) {
  const auto first = directions_of_box(from, tau);
  const auto last = directions_of_box(to, tau);
  if (!first || !last) return true;
  const double between =
      std::atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
  constexpr double kTurn = 2 * std::numbers::pi;
  constexpr double kRounding = 1e-9;
  return std::ranges::any_of(std::array{-kTurn, 0.0, kTurn}, [&](double turn) {
    const double apart = between + turn;
    return apart + (*last)[0] <= (*first)[1] + kRounding &&
           apart + (*last)[1] >= (*first)[0] - kRounding;
  });
}

// Whether the arc's ends, each moved by no more than the tolerance an axis, may lie on one ray from
// its centre: what it sweeps beside other whole turns is nil or a full turn then, and its numbers
// do not tell which. An estimate, for only what fits the curve is taken.
bool nearly_whole(const Motion& arc, const Number& tolerance) {
  const PlaneVector a = from_centre(arc.record, arc.from);
  const PlaneVector b = from_centre(arc.record, arc.to());
  const Vector2 from = {estimate(a.p), estimate(a.q)};
  const Vector2 to = {estimate(b.p), estimate(b.q)};
  const double tau = approximate(tolerance);
  const double sides =
      std::abs(from[0]) + std::abs(from[1]) + std::abs(to[0]) + std::abs(to[1]) + 2 * tau;
  const double along = from[0] * to[0] + from[1] * to[1];
  const double across = from[0] * to[1] - from[1] * to[0];
  return along >= -tau * sides && std::abs(across) <= tau * sides && may_be_in_line(from, to, tau);
}

// Whether the arc's centre lies within the tolerance of one of its ends, which then shows no
// direction: the record does not tell what part of a turn it sweeps. An estimate, for only what
// ends where the curve does is taken.
bool hides_its_sweep(const Motion& arc, const Number& tolerance) {
  const double tau = approximate(tolerance);
  const auto is_centre = [&](const PlaneVector& v) {
    return std::abs(estimate(v.p)) <= tau && std::abs(estimate(v.q)) <= tau;
  };
  return is_centre(from_centre(arc.record, arc.from)) ||
         is_centre(from_centre(arc.record, arc.to()));
}

// J-PATH-14.
constexpr const char* kHelixTooClose = "The height of the helix is too close.";
constexpr const char* kSpiralTooClose = "The radius of the spiral is too close.";

// A piece of which it is open whether it ends on the curve decides nothing yet, for it is not the
// end: if what follows departs, so does the whole; if it leads to the end, the whole is open.
CurveAnswer doubtful(CurveProgress progress, const char* reason) {
  progress.doubt = reason;
  return CurveAnswer::goes(std::move(progress), false);
}

// The end of the curve, after pieces that may all belong to it.
CurveAnswer at_end(CurveProgress progress) {
  if (progress.doubt != nullptr) {
    return CurveAnswer::undecided(GapReason::comparison, progress.doubt);
  }
  return CurveAnswer::goes(std::move(progress), true);
}

CurveProgress advanced(const CurveProgress& from, double turns) {
  CurveProgress progress = from;
  progress.arc += turns;
  return progress;
}

// Whether nothing is seen of a motion in the plane; a helix may rise there.
bool turns_unseen(const Motion& motion, const PlaneAxes& axes, const Number& tolerance) {
  return agree(motion.from[axes.p], motion.to()[axes.p], tolerance) &&
         agree(motion.from[axes.q], motion.to()[axes.q], tolerance) &&
         !goes_round(motion, tolerance);
}

// What the motion may be by either answer. Of two departures the second, unless the first is open.
CurveAnswer joined(CurveAnswer one, CurveAnswer other) {
  if (one.departs()) {
    const bool open = other.departs() && one.departure == Departure::undecided;
    return open ? one : other;
  }
  std::ranges::move(other.ways, std::back_inserter(one.ways));
  return one;
}

}  // namespace

bool Curve::ends_at(const Position& point) const {
  if (!open_) return agree(point, reference_.to(), terms_.tolerance);
  const PlaneAxes axes = reference::axes_of(round_->arc()->record.plane);
  for (Axis axis : kAllAxes) {
    if (axis == axes.p || axis == axes.q) continue;
    if (!agree(point[axis], reference_.to()[axis], terms_.tolerance)) return false;
  }
  return open_->starts->admits(open_->end,
                               {point[axes.p] - open_->origin.p, point[axes.q] - open_->origin.q});
}

bool Curve::centre_agrees(const Record& arc) const {
  const std::array<Number, 2>& want = round_->arc()->record.centre;
  if (!open_) {
    return agree(want[0], arc.centre[0], terms_.tolerance) &&
           agree(want[1], arc.centre[1], terms_.tolerance);
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
  if (got == RecordKind::feed && terms_.chord.sign() > 0) return follow_chord(from, subject);
  return CurveAnswer::departs(Departure::kind, "The motion is of another kind.");
}

// The end of a piece that sweeps `turns`: at the end of the arc, or on the way to it.
CurveAnswer Curve::end_of_piece(const CurveProgress& from, const Motion& subject,
                                double turns) const {
  const double whole = round_->whole();
  CurveProgress progress = advanced(from, turns);
  if (std::abs(progress.arc - whole) < kQuarterTurn && ends_at(subject.to())) {
    return at_end(std::move(progress));
  }
  if (progress.arc >= whole) {
    return CurveAnswer::departs(Departure::geometry, "The arc goes beyond its end.");
  }
  const int height = round_->on_helix(subject.to(), progress.arc, terms_.tolerance);
  const int radius = round_->on_spiral(subject.to(), progress.arc, terms_.tolerance);
  if (!round_->on_circle(subject.to(), terms_.tolerance) || height < 0 || radius < 0) {
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

// J-PATH-05.
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
  if (!nearly_whole(subject, terms_.tolerance)) return end_of_piece(from, subject, turns);
  CurveAnswer answer = nil_or_full(from, subject, turns);
  const double rest = round_->whole() - from.arc;
  if (std::abs(rest - turns) >= 1 || !hides_its_sweep(subject, terms_.tolerance)) return answer;
  CurveAnswer to_end = end_of_piece(from, subject, rest);
  if (to_end.departs() || !to_end.ways.front().done) return answer;
  return joined(std::move(answer), std::move(to_end));
}

// J-PATH-06. The nil and the full turn are both what may be meant. After other whole turns, a turn
// that the arc does make is no nil one; and an arc that ends exactly where it starts is a full turn
// by what a record means, unless the reference's turn is as small.
CurveAnswer Curve::nil_or_full(const CurveProgress& from, const Motion& subject,
                               double turns) const {
  const Record& got = subject.record;
  const PlaneAxes axes = reference::axes_of(got.plane);
  const bool closes = agree(subject.from[axes.p], subject.to()[axes.p], terms_.tolerance) &&
                      agree(subject.from[axes.q], subject.to()[axes.q], terms_.tolerance);
  const double before = std::abs(got.rot) - 1;
  const double part = turns - before;
  const double small = part < 0.5 ? part : part - 1;
  CurveAnswer full = end_of_piece(from, subject, before + small + 1);
  const bool exactly_whole = part == 1.0 && !turns_unseen(reference_, axes, terms_.tolerance);
  const bool is_full = (closes && exactly_whole) || (before > 0 && part >= 0.5);
  if (is_full || (!full.departs() && full.ways.front().done)) return full;
  return joined(std::move(full), end_of_piece(from, subject, before + small));
}

// Whether a chord agrees with the curve between its ends; 0: too close to say. Its middle is its
// farthest point from a circle; from a spiral it may be another one.
int Curve::chord_stays(const CurveProgress& from, const Motion& chord,
                       const Number& granted) const {
  constexpr int kEighths = 8;
  int answer = 1;
  for (const int eighth : {4, 1, 2, 3, 5, 6, 7}) {
    Position point;
    for (Axis axis : kAllAxes) {
      const Number way = chord.to()[axis] - chord.from[axis];
      point[axis] = chord.from[axis] + way * eighth / kEighths;
    }
    if (!round_->on_circle(point, granted)) return -1;
    if (!round_->is_spiral()) return 1;
    const double along = from.arc + round_->part_of_turn(chord.from, point);
    answer = std::min(answer, round_->on_spiral(point, along, granted));
  }
  return answer;
}

// J-PATH-10. A straight cut as a chord of the arc: its ends on the curve, and the sagitta within
// the chord tolerance that the certifier granted.
CurveAnswer Curve::follow_chord(const CurveProgress& from, const Motion& subject) const {
  const Number granted = terms_.tolerance + terms_.chord;
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
    return at_end(std::move(progress));
  }
  if (progress.arc >= whole && !agree(subject.to(), reference_.to(), granted)) {
    return CurveAnswer::departs(Departure::geometry, "The chord goes beyond the end of the arc.");
  }
  const int height = round_->on_helix(subject.to(), progress.arc, terms_.tolerance);
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
  const Number& tau = terms_.tolerance;
  return reference_.record.kind == RecordKind::arc3 && agree(arc3.from, reference_.from, tau) &&
         agree(via_of(arc3), via_of(reference_), tau) && agree(arc3.to(), reference_.to(), tau);
}

// J-PATH-09. A record of an arc in space has no centre: its three points stand for it. They agree
// with points of the reference's curve in their order, and the arc turns in its sense. The middles
// of its two parts agree with points of it too, to within twice the tolerance: that much may come
// of rounding three points that are well apart, while an intermediate point near an end that makes
// another circle of it shows there. Not where the program itself names the three points: what
// circle they make when they are rounded is its doing then. What nothing tells from its chord has
// no sense of its own, and follows the curve forward as a chord does.
CurveAnswer Curve::sweep_of_arc3(const CurveProgress& from, const Motion& subject,
                                 double& turns) const {
  const ThreePoints points(subject);
  const Number& tau = terms_.tolerance;
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
  // Half a turn, of which nothing tells whether it goes back, goes forward: `part` may be an
  // estimate of it that is a little more.
  constexpr double kEstimate = 1e-9;
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
  const Number& tau = terms_.tolerance;
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

}  // namespace gonogo::oracle
