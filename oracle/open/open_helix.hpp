// SPDX-License-Identifier: GPL-3.0-or-later
//
// A helix that may begin anywhere on its circle. Where tangential motions run into it, only later
// motions show its beginning: every possible start is followed until it is ruled out.
#pragma once

#include <list>
#include <optional>

#include "oracle/motion/curve_follower.hpp"
#include "oracle/records/verdict.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {

// What a helix has wherever it begins.
struct HelixShape {
  std::uint64_t block = 0;
  reference::ClauseId clause = reference::kNoClause;
  reference::Plane plane = reference::Plane::g18;
  std::array<Number, 2> centre;  // along p and q
  Number radius;
  Number top;     // coordinate of d where it begins
  Number bottom;  // and where it ends
  Number turns;   // above 0
  int sense = -1;
  Number feed;
  reference::FeedMode feed_mode = reference::FeedMode::per_minute;
  Similarity to_end;  // from its start to its end: the part of a turn

  PlaneVector from_axis(const Position& at) const;
};

// That of a thread or of a helical pocket, of so many turns.
template <typename Item>
HelixShape helix_of(const Item& item, reference::ClauseId clause, const Number& radius,
                    const Number& turns) {
  return {item.block,  clause, item.plane, item.centre, radius,         item.r_plane,
          item.bottom, turns,  item.sense, item.feed,   item.feed_mode, {}};
}

// One place where the helix may have begun.
class OpenHelix {
 public:
  // `starts` agree with `at`, where the subject stands. `tolerances` must outlive it.
  OpenHelix(const HelixShape& shape, OpenStart starts, const Position& at,
            const Tolerances& tolerances);
  OpenHelix(const OpenHelix&) = delete;
  MatchResult match(const Motion& motion);
  const OpenStart& starts() const { return starts_; }
  OpenStart& starts() { return starts_; }
  const Motion& want() const { return want_; }
  // The helix has ended with `last`, as what follows shows: elsewhere, or after fewer turns.
  Verdict ended(reference::ClauseId clause, const Motion& last, std::string want,
                std::string message, const Tolerances& tolerances) const;

 private:
  std::uint64_t block_;  // also where lines are not compared
  Number turns_;
  PlaneVector origin_;
  OpenStart starts_;
  Motion want_;
  Similarity to_end_;
  CurveFollower match_;
};

// All places where it may have begun.
class OpenHelices {
 public:
  // Follows a motion along each of them and drops those from which it departs. `done`: one of them
  // is complete, see `take_done`. A departure: none is left; it is that of the last one dropped.
  MatchResult match(const Motion& motion);
  // False: there are too many to be followed.
  [[nodiscard]] bool add(const HelixShape& shape, OpenStart starts, const Position& at,
                         const Tolerances& tolerances);
  bool empty() const { return open_.empty(); }
  // The one that was followed farthest. REQUIRES: there was one.
  const OpenHelix& farthest() const { return open_.empty() ? dropped_.front() : open_.front(); }
  // The complete one.
  std::list<OpenHelix> take_done() { return std::move(done_); }

 private:
  std::list<OpenHelix> open_;
  std::list<OpenHelix> done_;
  std::list<OpenHelix> dropped_;          // the last one
  std::optional<MatchResult> undecided_;  // of one that was dropped
};

// Whether a motion that starts at the top may be the first piece of the helix, by kind, plane,
// centre and sense. If so: the starts that agree with it.
std::optional<OpenStart> starts_of_helix(const HelixShape& shape, const Motion& motion,
                                         const Tolerances& tolerances);

}  // namespace gonogo::oracle
