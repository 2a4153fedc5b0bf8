// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/curve_follower.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/motion/places.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {

bool goes_on_alike(const CurveProgress& one, const CurveProgress& other) {
  return (one.undecided_because == nullptr) == (other.undecided_because == nullptr) &&
         std::abs(one.arc - other.arc) < kEstimate;
}

namespace {

void add(CurveProgress progress, std::vector<CurveProgress>& reached) {
  const bool known = std::ranges::any_of(
      reached, [&](const CurveProgress& other) { return goes_on_alike(progress, other); });
  if (!known) reached.push_back(std::move(progress));
}

}  // namespace

MatchResult CurveFollower::match(const Motion& subject) {
  std::vector<CurveProgress> reached;
  CurveAnswer departure;
  const bool is_none =
      is_round(curve_.motion().record.kind) && stays_at(curve_.motion().from, subject, tolerances_);
  for (const CurveProgress& from : reached_) {
    CurveAnswer answer = curve_.follow(from, subject);
    for (CurveWay& way : answer.ways) {
      if (way.done && way.progress.undecided_because != nullptr) {
        departure = CurveAnswer::undecided(way.progress.gap, way.progress.undecided_because);
        continue;
      }
      if (!way.done) {
        add(std::move(way.progress), reached);
        continue;
      }
      reached_ = {std::move(way.progress)};
      return {Departure::none, true, {}};
    }
    // An arc as small as the tolerance may be a piece of the curve, or nothing at all.
    if (is_none && !answer.departs()) add(from, reached);
    // What is open comes before what departs.
    if (answer.departs() && departure.departure != Departure::undecided) {
      departure = std::move(answer);
    }
  }
  if (reached.empty())
    return {departure.departure, false, std::move(departure.reason), departure.gap};
  if (reached.size() > kMostWays) {
    return MatchResult::undecided(GapReason::cap_ways,
                                  "The motions may be pieces of the curve in too many ways.");
  }
  reached_ = std::move(reached);
  return {};
}

}  // namespace gonogo::oracle
