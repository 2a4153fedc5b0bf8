// SPDX-License-Identifier: GPL-3.0-or-later
//
// R3: what partners have in common besides their place.
#pragma once

#include "oracle/relation/definition.hpp"
#include "reference/record.hpp"

namespace gonogo::relation {

struct Label {
  reference::RecordKind kind = reference::RecordKind::rapid;  // an arc3 is an arc
  reference::FeedMode feed_mode = reference::FeedMode::per_minute;
  Number feed;
  Number lead;
  Number start;
  std::uint64_t block = 0;    // 0 where lines are not compared
  bool is_flat = false;       // an arc that may come as its chord, or a chord as the arc
  bool finds_centre = false;  // an arc whose centre the control computes
};

Label label_of(const reference::Record& motion, bool is_flat, const Tolerances& tolerances);

// Whether two motions of one side have one label, to the last digit.
bool is_same(const Label& a, const Label& b);

// Whether `got` is `want`, or as far off as rounding to the resolution puts it. Two enclosures that
// overlap agree: nothing says that they differ.
bool agree(const Number& want, const Number& got, const std::optional<Number>& resolution,
           const Tolerances& tolerances);

enum class Likeness : std::uint8_t {
  same,    // partners may have them
  number,  // a number alone differs
  other,
};
Likeness compare(const Label& want, const Label& got, const Tolerances& tolerances);

// Whether a straight cut stands for an arc because the certifier grants chords.
bool is_granted_chord(const Label& want, const Label& got, const Tolerances& tolerances);

}  // namespace gonogo::relation
