// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether a motion of the subject belongs to a motion of the reference (design section 6, path
// rules 3 and 4).
#pragma once

#include <optional>
#include <string>

#include "oracle/judge/motion.hpp"
#include "oracle/judge/terms.hpp"
#include "oracle/judge/turned_start.hpp"

namespace gonogo::oracle {

enum class Departure : std::uint8_t { none, kind, block, feed, geometry, sense, undecided };

struct MatchResult {
  Departure departure = Departure::none;
  bool done = false;   // the reference motion is complete
  std::string reason;  // a sentence when it departs
};

// An arc that may begin anywhere on a circle: then the reference's motion is only one of those that
// are meant, and its ends and centre follow from the starts that are left.
struct OpenArc {
  const TurnedStart* starts = nullptr;  // about `origin`
  PlaneVector origin;                   // along p and q
  Similarity end;                       // the end of the arc, from its start
  Similarity centre;                    // its centre, from its start
  Number radius;                        // of the arc
  Number slack;                         // how far its centre may lie from the motion's
};

// How far the subject has come along the current motion of the reference.
class CurveMatch {
 public:
  CurveMatch(const Motion& reference, const JudgeTerms& terms,
             std::optional<OpenArc> open = std::nullopt);
  // Tries the next motion of the subject; on a departure nothing is changed.
  MatchResult match(const Motion& subject);

 private:
  MatchResult match_rapid(const Motion& subject);
  MatchResult match_line(const Motion& subject);
  MatchResult match_thread(const Motion& subject);
  MatchResult match_arc(const Motion& subject);
  MatchResult match_chord(const Motion& subject);
  MatchResult end_of_piece(const Motion& subject, double turns);
  bool ends_at(const Position& point) const;
  bool centre_agrees(const Record& arc) const;
  bool on_circle(const Position& point, Number tolerance) const;
  // +1: the axes outside the plane agree at this part of the sweep; -1: they do not; 0: too close
  // to the tolerance to say.
  int on_helix(const Position& point, double turns) const;

  const Motion& reference_;
  const JudgeTerms& terms_;
  std::optional<OpenArc> open_;
  Number line_progress_;     // along the axis that moves most
  double arc_progress_ = 0;  // turns, to choose between whole turns only
};

// Whether the feeds of two cutting motions are the same on these terms.
bool feeds_agree(const Record& reference, const Record& subject, const JudgeTerms& terms);

}  // namespace gonogo::oracle
