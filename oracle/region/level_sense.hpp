// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which way the motions of a level go round (GSK-G110-09, SIE-LC75-12, J-PKT-06).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "oracle/region/border_sense.hpp"
#include "oracle/region/rules.hpp"

namespace gonogo::oracle::region {

// An arc that moves: not a turn of radius 0.
bool moves(const LevelMotion& motion);
// Ends no farther apart than the tolerance on either axis.
bool ends_agree(const LevelMotion& motion, const Number& tolerance);
// Such ends, but not the same point: rounding may have made this of no motion at all or of a whole
// turn.
bool is_open(const LevelMotion& motion, const Number& within);

class LevelSense {
 public:
  // Both must outlive it.
  LevelSense(const AnyLevel& terms, std::span<const LevelMotion> motions);

  // The first motion that goes the wrong way; null: none.
  const LevelMotion* motion_against();
  // What stayed undecided in that, a sentence; null: nothing.
  const char* doubt() const { return doubt_; }

  // Whether an arc that rounding leaves open goes the wrong way as a whole turn.
  bool is_against(const Arc& arc, bool counterclockwise) const;
  // Whether it is a chord of an arc, where chords are granted.
  bool is_chord(std::size_t motion) const { return !chords_.empty() && chords_[motion]; }

 private:
  bool turns_wrongly(const LevelMotion& motion) const;
  const LevelMotion* along_border();
  const LevelMotion* round_middle();
  const LevelMotion* of_chords();
  Course course_along(const BorderSense& border, const LevelMotion& motion) const;
  Course course_of_pieces(std::size_t motion, std::optional<PlanePoint>& touch) const;
  Line line_of(const LevelMotion& motion) const;
  bool is_small(const LevelMotion& motion) const;
  void leave_undecided(const char* why) {
    if (doubt_ == nullptr) doubt_ = why;
  }

  const AnyLevel& terms_;
  std::span<const LevelMotion> motions_;
  BorderSense surely_;
  BorderSense perhaps_;
  Number quarter_;            // of the tool's radius, or of half the width of E where that is less
  double nearby_;             // how far small motions lead from the border
  std::vector<bool> chords_;  // of the motions, where they are granted
  std::optional<BorderSense> along_chords_;
  const char* doubt_ = nullptr;  // the first
};

}  // namespace gonogo::oracle::region
