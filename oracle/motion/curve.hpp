// SPDX-License-Identifier: GPL-3.0-or-later
//
// R1. A motion of the reference as a curve, and what a motion of the subject may be on it:
// a piece in its own sense, never back; for a traverse, a motion that leads to its end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/motion/labels.hpp"  // IWYU pragma: export
#include "oracle/motion/motion.hpp"
#include "oracle/motion/round_curve.hpp"
#include "oracle/motion/tolerances.hpp"
#include "oracle/records/gap_reason.hpp"

namespace gonogo::oracle {

enum class Departure : std::uint8_t { none, kind, block, feed, geometry, sense, undecided };

// A place of the subject's, and how far it is from where it may be, mm.
struct Apart {
  Position at;
  Number distance;
};

// How far pieces have come along a curve.
struct CurveProgress {
  Number line;     // along the axis that moves most
  double arc = 0;  // turns, to choose between whole turns only
  // A sentence: why it is open whether a piece belongs to the curve. Null: it is not open.
  const char* undecided_because = nullptr;
  GapReason gap = GapReason::none;   // the kind of that openness
  std::optional<Position> traverse;  // the nearest to its end so far, axis by axis
};

// One thing that a motion may be: a piece of the curve, with which it is `done` or not.
struct CurveWay {
  CurveProgress progress;
  bool done = false;
};

// All that a motion may be on a curve, the likeliest first; or why it departs.
struct CurveAnswer {
  std::vector<CurveWay> ways;
  Departure departure = Departure::none;
  std::string reason;               // a sentence when it departs
  GapReason gap = GapReason::none;  // of an undecided one
  // The centre of the subject's arc, where that is what differs.
  std::optional<Apart> centre = {};

  static CurveAnswer departs(Departure departure, std::string reason) {
    return {{}, departure, std::move(reason)};
  }
  static CurveAnswer undecided(GapReason gap, std::string reason) {
    return {{}, Departure::undecided, std::move(reason), gap};
  }
  static CurveAnswer goes(CurveProgress progress, bool done) {
    CurveAnswer answer;
    answer.ways.push_back({std::move(progress), done});
    return answer;
  }
  bool departs() const { return departure != Departure::none; }
};

class Curve {
 public:
  // `tolerances` must outlive the curve.
  Curve(Motion reference, const Tolerances& tolerances, std::optional<OpenArc> open = std::nullopt);
  Curve(const Curve&) = delete;

  const Motion& motion() const { return reference_; }
  // What a motion may be after pieces that have come as far as `from`.
  CurveAnswer follow(const CurveProgress& from, const Motion& subject) const;
  // Whether the motion starts as the curve does and follows it beyond its end: the two are equal
  // except for where they end.
  bool goes_beyond(const CurveProgress& from, const Motion& subject) const;
  // R3. The chord of an arc that agrees with it; nothing for another motion.
  std::optional<Motion> chord() const;
  // Where, and how far, a motion that departs is off what is left of the curve.
  Apart apart(const CurveProgress& from, const Motion& subject) const;
  // J-CMP-12: the point of a round motion that departs which is farthest from what is left of the
  // curve. If the motion goes round the other way on the same circle, the farthest from where the
  // curve is after the same angle. `known` where none is farther.
  Apart farthest(const Apart& known, const CurveProgress& from, const Motion& subject) const;

 private:
  CurveAnswer follow_any(const CurveProgress& from, const Motion& subject) const;
  CurveAnswer follow_traverse(const CurveProgress& from, const Motion& subject) const;
  CurveAnswer follow_line(const CurveProgress& from, const Motion& subject) const;
  CurveAnswer follow_thread(const CurveProgress& from, const Motion& subject) const;
  bool comes_as_line() const;
  CurveAnswer follow_flat(const CurveProgress& from, const Motion& subject) const;
  bool line_goes_beyond(const Motion& subject) const;

  // Those of round curves, in curve_arcs.cpp.
  CurveAnswer follow_round(const CurveProgress& from, const Motion& subject) const;
  CurveAnswer follow_arc(const CurveProgress& from, const Motion& subject) const;
  CurveAnswer follow_chord(const CurveProgress& from, const Motion& subject) const;
  CurveAnswer follow_arc3(const CurveProgress& from, const Motion& subject) const;
  bool takes_chords() const;
  // What the arc may be if its numbers are rounded, beside what its record says.
  CurveAnswer by_rounding(const CurveProgress& from, const Motion& subject, double turns) const;
  CurveAnswer as_turns(const CurveProgress& from, const Motion& subject, double turns) const;
  bool closes() const;
  bool is_rounded_curve(const CurveProgress& from, const Motion& subject) const;
  CurveAnswer other_centre(const Motion& subject) const;
  CurveAnswer end_of_piece(const CurveProgress& from, const Motion& subject, double turns) const;
  int chord_stays(const CurveProgress& from, const Motion& chord, const Number& granted) const;
  // Whether the points of the arc3 are those of the reference's, rounded.
  bool names_points_of_program(const Motion& arc3) const;
  // An arc3 of the subject as a piece of the curve, except where it ends; its sweep in turns.
  CurveAnswer sweep_of_arc3(const CurveProgress& from, const Motion& subject, double& turns) const;
  Departure on_curve(const Position& point, double turns, const Number& tolerance) const;
  bool arc_goes_beyond(const CurveProgress& from, const Motion& subject) const;
  bool chord_goes_beyond(const CurveProgress& from, const Motion& subject) const;
  bool ends_at(const Position& point) const;
  bool centre_agrees(const Record& arc) const;
  // The distance from what is left of the curve; `turns` along it, where it is round. In
  // curve_distance.cpp.
  Number distance(const CurveProgress& from, const Position& point, double turns) const;

  Motion reference_;
  const Tolerances& tolerances_;
  std::optional<OpenArc> open_;
  std::optional<RoundCurve> round_;  // an arc or a circle in space
};

// By estimates: either of two that are equally long will do, and enclosures of one length could not
// be distinguished.
Axis longest_axis(const Motion& motion);

}  // namespace gonogo::oracle
