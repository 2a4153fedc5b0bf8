// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the milling cycles G110 to G117 have in common: where a block mills, and the words that
// their modes retain. GSK-CYC-01: what a cycle puts out is all that it does.
#pragma once

#include <span>

#include "reference/gsk988ta/machine.hpp"

namespace gonogo::reference::gsk988ta {

// Where one block mills; mm as true lengths.
struct MillingSite {
  std::uint64_t block = 0;
  Plane plane = Plane::g18;
  PlaneAxes axes{};
  Position centre;     // of the plane, and other axes that are commanded
  AxisSet positioned;  // the axes that are positioned with it: every commanded one but d
  Number initial_plane;
  Number r_plane;
  Number bottom;
  Number travel;  // bottom - r_plane; exact also where the planes are only enclosed
  Number feed;
  FeedMode feed_mode = FeedMode::per_minute;

  Number depth() const { return abs(travel); }
  // The coordinate so far below the R plane, towards the bottom.
  Number below_r_plane(const Number& length) const {
    return travel.sign() < 0 ? r_plane - length : r_plane + length;
  }
  std::array<Number, 2> plane_centre() const { return {centre[axes.p], centre[axes.q]}; }

  Record motion(RecordKind kind, ClauseId clause) const;
  Record rapid_depth(ClauseId clause, const Number& depth) const;
  // Back to the initial plane, where no text prints the speed: at feed, or a traverse.
  Record return_at(bool at_feed, ClauseId clause) const;
  Record feed_depth(ClauseId clause, const Number& depth) const;
  Record rapid_to_centre(ClauseId clause, AxisSet which) const;
  // A motion in the plane to a point of it.
  Record feed_to(ClauseId clause, const std::array<Number, 2>& to) const;
  Record arc_to(ClauseId clause, const std::array<Number, 2>& to,
                const std::array<Number, 2>& middle, std::int32_t rot) const;
};

// GSK-G110-14: whether the block mills: it names all three axes of the plane, or under
// gsk.missing-axis = current at least the depth.
bool names_site(const BlockContext& block);
// GSK-G110-01: the site, with `r` from the initial to the R plane. `depth_from_initial`: an
// increment of the depth word counts from the initial plane. REQUIRES: names_site.
MillingSite place_site(BlockContext& block, const Number& r, bool depth_from_initial = false);
// GSK-MOD-03: R of the block, or the one that the mode retains.
Number r_of_pocket(const BlockContext& block);
// GSK-G110-14 under gsk.missing-axis = position: the plane axes that are there are positioned.
void position_only(BlockContext& block);

// The planes of a site that is milled.
void name_planes(const BlockContext& block, const MillingSite& site);

// GSK-G110-04: R must not lead away from the bottom; R = 0 agrees with all, and so does no depth.
void check_direction(BlockContext& block, const MillingSite& site, ClauseId clause);
// GSK-G110-17: a site without depth is an alarm or needs no feed; any other needs one.
void check_depth(BlockContext& block, const MillingSite& site);

// A word that a mode retains, or that a block gives.
struct NeededWord {
  char address;
  const std::optional<Number>& value;
  std::optional<ClauseId> positive = std::nullopt;             // of its own, that it is above zero
  std::optional<ReadingAlternative> zero_runs = std::nullopt;  // under which zero is no alarm
};
// Missing words; in a block that mills also those that are not above zero.
void check_needed(BlockContext& block, std::span<const NeededWord> words, bool mills,
                  ClauseId missing, ClauseId positive);
// GSK-G110-03, GSK-G112-02: I > D.
void check_tool_radius(BlockContext& block, ClauseId clause);
// GSK-MOD-07: what the mode retains, where the units have changed.
void carry_milling(const BlockContext& block);
// GSK-MOD-02: I, L, Q, D, R and P that the mode takes in from every block, milling or not.
void latch_pocket_words(BlockContext& block);
// Whether this block needs the words of the mode: it enters the mode, or mills.
bool is_entry(const BlockContext& block);

}  // namespace gonogo::reference::gsk988ta
