// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/standing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "oracle/judge/space_circle.hpp"

namespace gonogo::oracle {
namespace {

// Two coordinates that are rounded to doubles are off by no more than half a unit in the last place
// each: together by 2^-52 of the larger one, which is less than this.
Number rounding_of(const Number& a, const Number& b) {
  constexpr int kBits = 52;
  const double size = std::max(std::abs(estimate(a)), std::abs(estimate(b)));
  int exponent = 0;
  std::frexp(size, &exponent);
  return Number::binary(1, exponent - kBits);
}

}  // namespace

bool same_place(const Position& a, const Position& b, const JudgeTerms& terms) {
  for (Axis axis : reference::kAllAxes) {
    if (agree(a[axis], b[axis], terms.tolerance)) continue;
    if (!terms.binary64) return false;
    if (!agree(a[axis], b[axis], terms.tolerance + rounding_of(a[axis], b[axis]))) return false;
  }
  return true;
}

bool stays_at(const Position& place, const Motion& motion, const JudgeTerms& terms) {
  return same_place(motion.from, place, terms) && same_place(motion.to(), place, terms) &&
         !goes_round(motion, terms.tolerance);
}

bool may_stand_at(const Position& point, const Position& here, const Dropped* dropped,
                  const JudgeTerms& terms) {
  if (same_place(point, here, terms)) return true;
  if (dropped == nullptr) return false;
  return same_place(point, dropped->stood, terms) ||
         std::ranges::any_of(dropped->motions, [&](const Record& record) {
           return same_place(point, record.to, terms);
         });
}

namespace {

bool is_on_dropped_circle(const Record& got, const Dropped& dropped, const Number& tolerance) {
  return std::ranges::any_of(dropped.motions, [&](const Record& arc) {
    return arc.kind == RecordKind::arc && arc.plane == got.plane &&
           (arc.rot < 0) == (got.rot < 0) && agree(arc.centre[0], got.centre[0], tolerance) &&
           agree(arc.centre[1], got.centre[1], tolerance);
  });
}

// Whether it is one of the motions that were dropped, off by no more than the tolerance.
bool is_dropped(const Motion& motion, const Dropped& dropped, const JudgeTerms& terms) {
  return std::ranges::any_of(dropped.motions, [&](const Record& record) {
    return record.kind == motion.record.kind && record.block == motion.record.block &&
           same_place(motion.to(), record.to, terms);
  });
}

}  // namespace

bool may_mean_none(const Motion& motion, const Position& here, const Dropped* dropped,
                   const JudgeTerms& terms) {
  const auto stays = [&](const Position& point) {
    return same_place(point, here, terms) ||
           (dropped != nullptr && same_place(point, dropped->stood, terms));
  };
  const Record& got = motion.record;
  const bool stays_there = stays(motion.from) && stays(motion.to()) &&
                           (got.kind != RecordKind::arc3 || stays(via_of(motion)));
  const bool goes_there = dropped != nullptr && may_stand_at(motion.from, here, dropped, terms) &&
                          is_dropped(motion, *dropped, terms);
  if (!stays_there && !goes_there) return false;
  if (!goes_round(motion, terms.tolerance)) return true;
  return got.kind == RecordKind::arc && std::abs(got.rot) == 1 && dropped != nullptr &&
         is_on_dropped_circle(got, *dropped, terms.tolerance);
}

}  // namespace gonogo::oracle
