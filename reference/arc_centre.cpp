// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/arc_centre.hpp"

namespace gonogo::reference {
namespace {

// um of mm.
Number fine(const Number& length) {
  return length * 1000;
}

Number square(const Number& value) {
  return value * value;
}

}  // namespace

ArcEnds::ArcEnds(const PlaneAxes& axes, const Position& from, const Position& to)
    : start_p(from[axes.p]),
      start_q(from[axes.q]),
      end_p(to[axes.p]),
      end_q(to[axes.q]),
      dp(end_p - start_p),
      dq(end_q - start_q),
      chord_2(square(fine(dp)) + square(fine(dq))) {}

std::array<Number, 2> ArcEnds::middle() const {
  return {(start_p + end_p) / 2, (start_q + end_q) / 2};
}

bool ArcEnds::chord_within(const Number& length) const {
  return chord_2 <= square(fine(length));
}

std::optional<std::array<Number, 2>> centre_from_radius(const ArcEnds& ends, const Number& radius,
                                                        int sense) {
  const Number height_2 = square(fine(radius)) / ends.chord_2 - Number(1) / 4;  // in chords squared
  if (height_2.sign() < 0) return std::nullopt;
  const int side = -sense * radius.sign();  // +1: right of the chord
  const Number height = sqrt(height_2) * side;
  return {{(ends.start_p + ends.end_p) / 2 + height * ends.dq,
           (ends.start_q + ends.end_q) / 2 - height * ends.dp}};
}

OffsetCentre::OffsetCentre(const ArcEnds& ends, const Number& offset_p, const Number& offset_q)
    : centre{ends.start_p + offset_p, ends.start_q + offset_q} {
  const Number start_p = fine(offset_p);
  const Number start_q = fine(offset_q);
  const Number end_p = fine(ends.end_p - centre[0]);
  const Number end_q = fine(ends.end_q - centre[1]);
  start_2 = square(start_p) + square(start_q);
  end_2 = square(end_p) + square(end_q);
  reach = max(abs(start_p), abs(start_q)) + max(abs(end_p), abs(end_q));
}

bool OffsetCentre::radii_agree(const Number& limit) const {
  // Nearly always enough: the radii differ by the difference of their squares over their sum.
  if (abs(start_2 - end_2) <= fine(limit) * reach) return true;
  return radii_agree_squared(square(limit));
}

// abs(sqrt(a) - sqrt(b))^2 <= limit^2 without roots: a + b - limit^2 <= 2 sqrt(a b).
bool OffsetCentre::radii_agree_squared(const Number& limit_2) const {
  const Number left = start_2 + end_2 - fine(fine(limit_2));
  return left.sign() <= 0 || square(left) <= start_2 * end_2 * 4;
}

// sqrt(b) >= (1 - part) sqrt(a), where b is the smaller one.
bool OffsetCentre::radii_agree_in_part(const Number& part) const {
  return min(start_2, end_2) >= square(Number(1) - part) * max(start_2, end_2);
}

bool OffsetCentre::radius_below(const Number& length) const {
  return min(start_2, end_2) < square(fine(length));
}

}  // namespace gonogo::reference
