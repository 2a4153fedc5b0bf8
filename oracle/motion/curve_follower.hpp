// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions of the subject along one curve: every combination of what each may be.
#pragma once

#include "oracle/motion/curve.hpp"

namespace gonogo::oracle {

struct MatchResult {
  Departure departure = Departure::none;
  bool done = false;                // the curve is complete
  std::string reason;               // a sentence when it departs
  GapReason gap = GapReason::none;  // of an undecided one

  static MatchResult undecided(GapReason gap, std::string reason) {
    return {Departure::undecided, false, std::move(reason), gap};
  }
};

class CurveFollower {
 public:
  // `tolerances` must outlive it.
  CurveFollower(const Motion& reference, const Tolerances& tolerances,
                std::optional<OpenArc> open = std::nullopt)
      : curve_(reference, tolerances, std::move(open)), tolerances_(tolerances) {}
  CurveFollower(const CurveFollower&) = delete;
  // Tries the next motion of the subject; on a departure nothing is changed.
  MatchResult match(const Motion& subject);
  // How far along a round curve it has come, in turns; an estimate.
  double turns() const { return reached_.front().arc; }

 private:
  Curve curve_;
  const Tolerances& tolerances_;
  std::vector<CurveProgress> reached_{1};
};

// R2: whether two ways along a curve that have come as far as these continue alike.
bool goes_on_alike(const CurveProgress& one, const CurveProgress& other);

}  // namespace gonogo::oracle
