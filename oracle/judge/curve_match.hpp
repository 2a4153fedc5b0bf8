// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-PATH-01. Whether a motion of the subject belongs to a motion of the reference: pieces of it in
// its own sense, none of them back, and traverses that end where it ends.
#pragma once

#include <optional>
#include <string>

#include "oracle/judge/motion.hpp"
#include "oracle/judge/round_curve.hpp"
#include "oracle/judge/terms.hpp"

namespace gonogo::oracle {

enum class Departure : std::uint8_t { none, kind, block, feed, geometry, sense, undecided };

// A place of the subject's, and how far it is from where it may be, mm.
struct Apart {
  Position at;
  Number distance;
};

struct MatchResult {
  Departure departure = Departure::none;
  bool done = false;   // the reference motion is complete
  std::string reason;  // a sentence when it departs
  // The centre of the subject's arc, where that is what differs.
  std::optional<Apart> centre = {};
  // Undecided: how far along the curve it ends, in turns, if it belongs to it.
  std::optional<double> reached = {};

  static MatchResult departs(Departure departure, std::string reason) {
    return {departure, false, std::move(reason)};
  }
};

// How far the subject has come along the current motion of the reference.
class CurveMatch {
 public:
  // `reference` and `terms` must outlive the match.
  CurveMatch(const Motion& reference, const JudgeTerms& terms,
             std::optional<OpenArc> open = std::nullopt);
  CurveMatch(const CurveMatch&) = delete;
  // Tries the next motion of the subject; on a departure nothing is changed.
  MatchResult match(const Motion& subject);
  // Whether the motion starts as the reference's does and follows it beyond its end: the two are
  // equal but for where they end.
  bool goes_beyond(const Motion& subject) const;
  // Where a motion that departs is off what is left of the reference's, and how far.
  Apart apart(const Motion& subject) const;

 private:
  MatchResult match_rapid(const Motion& subject);
  MatchResult match_line(const Motion& subject);
  bool is_flat_arc3() const;
  MatchResult match_flat(const Motion& subject);
  MatchResult match_thread(const Motion& subject);
  MatchResult match_round(const Motion& subject);
  MatchResult match_piece(const Motion& subject);
  MatchResult match_any_piece(const Motion& subject);
  MatchResult at_end(double progress);
  MatchResult match_arc(const Motion& subject);
  // Of an arc whose ends are seen from its centre in one direction.
  MatchResult nil_or_full(const Motion& subject, double turns);
  MatchResult other_centre(const Motion& subject) const;
  MatchResult match_chord(const Motion& subject);
  int chord_stays(const Motion& chord, const Number& granted) const;
  MatchResult match_arc3(const Motion& subject);
  MatchResult end_of_piece(const Motion& subject, double turns);
  // Whether the points of the arc3 are those of the reference's, rounded.
  bool names_points_of_program(const Motion& arc3) const;
  // An arc3 of the subject as a piece of the curve, but for where it ends; its sweep in turns.
  MatchResult follow_arc3(const Motion& subject, double& turns) const;
  Departure on_curve(const Position& point, double turns, const Number& tolerance) const;
  bool line_goes_beyond(const Motion& subject) const;
  bool arc_goes_beyond(const Motion& subject) const;
  bool ends_at(const Position& point) const;
  bool centre_agrees(const Record& arc) const;
  // From what is left of the curve; `turns` along it, where it is round.
  Number distance(const Position& point, double turns) const;

  const Motion& reference_;
  const JudgeTerms& terms_;
  std::optional<OpenArc> open_;
  std::optional<RoundCurve> round_;  // an arc or a circle in space
  struct Progress {
    Number line;                       // along the axis that moves most
    double arc = 0;                    // turns, to choose between whole turns only
    double none = 0;                   // of those, what may have been meant as none
    std::string doubt;                 // of a piece of which it is open whether it belongs to it
    std::optional<Position> traverse;  // the nearest to its end so far, axis by axis
  };
  Progress progress_;
};

// By estimates: of two that are as long as each other either will do, and enclosures of one length
// could not be told apart.
Axis longest_axis(const Motion& motion);

// Whether the feeds of two cutting motions are the same on these terms.
bool feeds_agree(const Record& reference, const Record& subject, const JudgeTerms& terms);

}  // namespace gonogo::oracle
