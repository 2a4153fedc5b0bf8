// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/level_sense.hpp"

#include <algorithm>
#include <utility>

#include "oracle/region/chords.hpp"
#include "oracle/region/constants.hpp"
#include "oracle/region/winding.hpp"

namespace gonogo::oracle::region {

bool moves(const LevelMotion& motion) {
  if (!motion.is_arc) return false;
  return !(motion.from == motion.to && motion.from == motion.centre);
}

bool ends_agree(const LevelMotion& motion, const Number& tolerance) {
  return exact::abs(motion.from.p - motion.to.p) <= tolerance &&
         exact::abs(motion.from.q - motion.to.q) <= tolerance;
}

bool is_open(const LevelMotion& motion, const Number& within) {
  if (!motion.is_arc || motion.rot == 0 || whole_turns(motion.rot) > 0) return false;
  return !(motion.from == motion.to) && ends_agree(motion, within);
}

namespace {

// A negligible motion has none.
bool has_sense(const LevelMotion& motion, const Number& within) {
  return !motion.is_arc || (moves(motion) && !is_open(motion, within));
}

}  // namespace

LevelSense::LevelSense(const AnyLevel& terms, std::span<const LevelMotion> motions)
    : terms_(terms),
      motions_(motions),
      surely_(terms.border(), terms.sense, terms.tolerance - terms.slack),
      perhaps_(terms.border(), terms.sense, terms.tolerance + terms.slack),
      quarter_(min(terms.tool_radius, inner_radius(terms.border())) / Number(kSmallOfTool)),
      nearby_(enclose(quarter_).inf()) {
  if (terms.chord.sign() > 0) {
    chords_ = find_chords(motions, terms.chord + terms.tolerance);
    along_chords_.emplace(terms.border(), terms.sense, terms.tolerance + terms.chord);
  }
}

const LevelMotion* LevelSense::motion_against() {
  if (terms_.by_border) return along_border();
  for (const LevelMotion& motion : motions_) {
    if (turns_wrongly(motion)) return &motion;
  }
  if (const LevelMotion* motion = along_border()) return motion;
  if (const LevelMotion* motion = round_middle()) return motion;
  return terms_.chord.sign() > 0 ? of_chords() : nullptr;
}

bool LevelSense::is_against(const Arc& arc, bool counterclockwise) const {
  if (terms_.by_border) return surely_.of_arc(arc, counterclockwise).way < 0;
  return counterclockwise != (terms_.sense > 0);
}

// GSK-G110-09: by arcs turning the commanded way.
bool LevelSense::turns_wrongly(const LevelMotion& motion) const {
  if (!motion.is_arc || !has_sense(motion, terms_.turns.within)) return false;
  if (motion.rot == 0) return !(motion.from == motion.to);
  return (motion.rot > 0) != (terms_.sense > 0);
}

// J-PKT-06: rings round the middle, in pieces of any kind.
const LevelMotion* LevelSense::round_middle() {
  Winding winding(terms_.middle, terms_.sense, terms_.step.value_or(0),
                  Number(kBlur) * terms_.tolerance);
  for (const LevelMotion& motion : motions_) {
    if (!has_sense(motion, terms_.turns.within)) continue;
    const Against answer = winding.add(motion);
    if (answer == Against::yes) return &motion;
    if (answer == Against::undecided) {
      leave_undecided("Which way the path goes round is undecided.");
    }
  }
  return nullptr;
}

Line LevelSense::line_of(const LevelMotion& motion) const {
  return make_line(motion.from - terms_.middle, motion.to - terms_.middle);
}

Course LevelSense::course_along(const BorderSense& border, const LevelMotion& motion) const {
  if (!motion.is_arc) return border.of_line(line_of(motion));
  const bool about_end = motion.from == motion.centre || motion.to == motion.centre;
  if (motion.rot == 0 || about_end) return {};
  return border.of_arc(make_arc(motion, terms_.middle), motion.rot > 0);
}

// Whether the motion stays near where it begins.
bool LevelSense::is_small(const LevelMotion& motion) const {
  const IntervalVector way = enclose(motion.to) - enclose(motion.from);
  if (!(norm(way).sup() <= nearby_)) return false;
  if (!motion.is_arc || motion.rot == 0) return true;
  if (motion.from == motion.centre || motion.to == motion.centre) return true;
  const Arc arc = make_arc(motion, terms_.middle);
  return 2 * std::max(arc.ra.sup(), arc.rb.sup()) <= nearby_ || (arc.turns == 0 && !arc.sweep.wide);
}

// J-PKT-06, SIE-LC75-12: nowhere back along the border by more than the quarter. Places of the path
// may be off by the tolerance.
const LevelMotion* LevelSense::along_border() {
  const Number limit = quarter_ + terms_.tolerance;
  WayBack way(limit - terms_.slack, limit + terms_.slack);
  std::optional<PlanePoint> touch;
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    const LevelMotion& motion = motions_[i];
    if (!motion.is_arc && motion.from == motion.to) continue;
    Course narrow;
    Course wide;
    if (has_sense(motion, terms_.turns.within)) {
      narrow = wide = course_along(surely_, motion);
      if (terms_.slack.sign() != 0) wide = course_along(perhaps_, motion);
    }
    if (narrow.way == 0 && wide.way == 0) {
      narrow = wide = course_of_pieces(i, touch);
    } else {
      touch.reset();
      if (surely_.touches(motion.to - terms_.middle)) touch = motion.to - terms_.middle;
    }
    const Against answer = way.add(narrow, wide);
    if (answer == Against::yes) return &motion;
    if (answer == Against::undecided) leave_undecided("How far the path goes back is undecided.");
  }
  return nullptr;
}

// Small motions in a row that touch the border again and again, as one along it; straight chords
// that run along it likewise. `touch`: where they did, and how far they have been counted.
Course LevelSense::course_of_pieces(std::size_t number, std::optional<PlanePoint>& touch) const {
  const LevelMotion& motion = motions_[number];
  const BorderSense& border = is_chord(number) ? *along_chords_ : surely_;
  const BorderSense& length = is_chord(number) ? *along_chords_ : perhaps_;
  const PlanePoint to = motion.to - terms_.middle;
  const bool follows = is_chord(number) && border.runs_along(line_of(motion));
  const bool is_near =
      is_small(motion) && touch && norm(enclose(to) - enclose(*touch)).sup() <= nearby_;
  if (!follows && !is_near) touch.reset();
  if (!border.touches(to)) return {};
  if (!touch) touch = follows ? motion.from - terms_.middle : to;
  if (!length.is_long_enough(*touch, to)) return {};
  return length.between(*std::exchange(touch, to), to);
}

// J-PKT-06
const LevelMotion* LevelSense::of_chords() {
  const ChordTurning turning =
      turning_of(motions_, chords_, terms_.sense, Number(kBlur) * terms_.tolerance);
  if (turning.kind == Turning::undecided) {
    leave_undecided("Whether chords turn the wrong way is undecided.");
  }
  return turning.kind == Turning::against ? &motions_[turning.motion] : nullptr;
}

}  // namespace gonogo::oracle::region
