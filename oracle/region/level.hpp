// SPDX-License-Identifier: GPL-3.0-or-later
//
// The region judge: whether the motions of one pocket level clear what they must and nothing else.
// The manual gives no path for a level, so the level is judged by what the tool removes.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "oracle/records/gap_reason.hpp"
#include "reference/exact/number.hpp"

namespace gonogo::oracle::region {

using exact::Number;

// A point of the plane (first and second axis), mm; also a vector. It has the operations of the
// kernel of reference/geometry/, for code that does without that kernel.
struct PlanePoint {
  Number p;
  Number q;
};
PlanePoint operator+(const PlanePoint& a, const PlanePoint& b);
PlanePoint operator-(const PlanePoint& a, const PlanePoint& b);
bool operator==(const PlanePoint& a, const PlanePoint& b);
Number dot(const PlanePoint& a, const PlanePoint& b);
Number cross(const PlanePoint& a, const PlanePoint& b);
Number norm_squared(const PlanePoint& a);

// One motion of a level, in the plane. An arc whose radii at start and end differ is the curve with
// the radius linear in the angle.
struct LevelMotion {
  bool is_arc = false;
  PlanePoint from;
  PlanePoint to;
  PlanePoint centre;       // arcs
  int rot = 0;             // arcs: sign = sense (+ counterclockwise), |rot| - 1 whole turns first
  std::size_t record = 0;  // which record of the subject, for the finding
};
inline bool same_cut(const LevelMotion& a, const LevelMotion& b) {
  return a.is_arc == b.is_arc && a.rot == b.rot && a.from == b.from && a.to == b.to &&
         (!a.is_arc || a.centre == b.centre);
}

// A core rectangle about the origin, sides along the axes, grown by a disc: a rectangle with
// rounded corners; with a core that is a line a slot, with a core that is a point a circle. Lengths
// in mm.
struct RoundedRectangle {
  Number core_p;  // half the core's sides, >= 0
  Number core_q;
  Number radius;  // of the disc, >= 0

  friend bool operator==(const RoundedRectangle&, const RoundedRectangle&) = default;
};

// From half the length and half the width. REQUIRES: 0 <= corner_radius <= both.
RoundedRectangle rounded_rectangle(const Number& half_length, const Number& half_width,
                                   const Number& corner_radius);

// J-PATH-06. For an arc whose ends are no farther apart than `within`, rounding may have made a
// whole turn of none or the reverse. What the record says is tried first; where only the other turn
// is right, that is GO, or, where the record `is_ambiguous`, a gap.
struct OpenTurns {
  Number within;
  bool is_ambiguous = false;

  friend bool operator==(const OpenTurns&, const OpenTurns&) = default;
};

// What the levels of all pockets have.
struct CommonLevel {
  Number tool_radius;                        // > 0
  int sense = -1;                            // of turning: + is counterclockwise
  PlanePoint plunge;                         // where the tool came down
  Number tolerance;                          // > 0
  Number chord = {};                         // >= 0; 0: no chords of arcs are granted
  std::optional<OpenTurns> open_turns = {};  // none: within the tolerance
  // How far a point of a motion may lie from where it truly is: a rational stands for it, or a
  // rational rotation near the true one has turned it (frame.hpp). GO then holds with tolerance -
  // slack, NO-GO with tolerance + slack; what lies between is a gap. 0 <= slack < tolerance.
  Number slack = {};

  friend bool operator==(const CommonLevel&, const CommonLevel&) = default;
};

// What a level of a circular pocket (GSK G110/G111) must satisfy.
//   gouge: no motion more than `tolerance` outside E, the disc of radius
//          pocket_radius - tool_radius
//   cover: every point of the disc of radius pocket_radius lies within tool_radius + tolerance of
//          the arcs or the plunge point
//   step:  every point of E lies within step/2 + tolerance of the arcs or the plunge point
//   sense: every arc turns as `sense` says, and the path goes round the centre that way
//   order: every place is cut from what was cut before it, within step + 3 tolerances (order.hpp)
// Where chords are granted, straight motions that are chords of arcs count as arcs (chords.hpp),
// and `chord` is added to the tolerance of gouge (for them), cover and step, twice to that of
// order.
struct CircularLevel : CommonLevel {
  PlanePoint centre;
  Number pocket_radius;  // > tool_radius
  Number step;           // 0 < step < 2 * tool_radius

  friend bool operator==(const CircularLevel&, const CircularLevel&) = default;
};

// What a level of a pocket with rounded corners (SINUMERIK LCYC75) must satisfy. The motions are in
// the pocket's own frame: its centre is the origin, its length runs along p, its width along q.
//   sense: motions along the border of E, lines too, go round the centre as `sense` says; a border
//          that is a point or a line has no direction, nor has one no more than the tolerance wide
//   gouge: no motion more than `tolerance` outside E, the points whose tool disc lies in `area`
//   cover: every point of `area` that is not in `cleared` lies within tool_radius + tolerance of
//          the motions or the plunge point
// A motion that runs no more than the tolerance beside the border runs along it, if it is longer
// than four times the tolerance.
// A chord is added to the tolerance of cover; for lines also to those of gouge and of running along
// the border.
struct RectangularLevel : CommonLevel {
  RoundedRectangle area;                    // its radius is at least the tool's
  std::optional<RoundedRectangle> cleared;  // by an earlier level: the rest is a strip

  friend bool operator==(const RectangularLevel&, const RectangularLevel&) = default;
};

enum class Rule { gouge, cover, step, sense, order };

// A departure, with a point that proves it. The deviation is the distance from what is admissible,
// with no tolerance taken off: exact for round arcs and lines; where an arc with two radii decides,
// or the order, a certified lower bound, and the witness lies within 1e-9 of the motion.
struct Finding {
  Rule rule = Rule::gouge;
  std::optional<std::size_t> record;  // the motion at fault, where there is one
  PlanePoint witness;                 // checked exactly against all motions
  Number deviation;                   // at the witness, mm (0 for sense)
};

struct LevelVerdict {
  enum class Kind { go, no_go, gap } kind = Kind::go;
  std::optional<Finding> finding;  // no_go
  std::string gap;                 // why it could not be decided
  GapReason reason = GapReason::none;
  bool by_filter = true;  // decided by certified subdivision alone

  static LevelVerdict undecided(GapReason reason, std::string why) {
    return {Kind::gap, {}, std::move(why), reason};
  }
};

// The first rule broken in the order sense, gouge, cover, step, order.
LevelVerdict judge_level(const CircularLevel& level, std::span<const LevelMotion> motions);
LevelVerdict judge_level(const RectangularLevel& level, std::span<const LevelMotion> motions);

}  // namespace gonogo::oracle::region
