// SPDX-License-Identifier: GPL-3.0-or-later
//
// R8 for threads: places and pieces, seen from the axis of the thread.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "oracle/relation/free_step.hpp"

namespace gonogo::relation {

class ThreadSite {
 public:
  ThreadSite(const reference::ThreadMilling& thread, const Followed& way);

  // What a piece has that no step allows, of axes and words; empty: nothing.
  std::string_view words_of(const Event& piece, bool may_traverse) const;

  Offset offset_of(const Position& place) const {
    return {place[axes_.p] - middle_.p, place[axes_.q] - middle_.q};
  }
  // REQUIRES: an arc.
  Offset centre_of(const Event& piece) const {
    const std::array<Number, 2>& centre = piece.source().centre;
    return Offset{rational_near(centre[0]), rational_near(centre[1])} - middle_;
  }
  Number height_of(const Position& place) const { return (place[axes_.d] - bottom_) * up_; }
  bool is_at_top(const Position& place, const Number& width) const {
    return abs(place[axes_.d] - top_) <= slack_.axis(width);
  }
  bool is_at_bottom(const Position& place) const {
    return abs(height_of(place)) <= tolerances_.tolerance * 17 / 8;
  }
  // Whether a place is on a circle; whether any point is deeper in the material, or farther out.
  static bool is_on(const Offset& at, const Number& radius, const Number& off);
  bool is_deeper(const Offset& from, const Offset& to, const Number& radius,
                 const Number& off) const;
  bool is_deeper(const Event& piece, const Number& radius) const;
  bool is_beyond(const Event& piece, const Number& radius) const;
  // For pass 0: that of the uncut part. The circle to which the ways behind the run-out keep.
  Number radius_of_pass(std::int64_t number) const;
  Number kept_of(std::int64_t number) const;
  // R9: whether the run-out of the reading leads into the material by itself. Where the reading is
  // open the polar one decides: where that does, the straight ones do.
  bool is_unfit(std::int64_t number) const;
  bool is_safe(const Position& place) const;
  // Whether a line that began elsewhere goes on in another direction.
  bool turns_aside(const Offset& begin, const Offset& from, const Offset& to) const;
  // R3: whether straight cuts from one place to the next are granted chords of one arc, of no more
  // than a turn. Three of the places, far apart, give its circle.
  bool are_chords(const std::vector<Offset>& places) const;
  // Where J and K lead from the end of a helix; in a bore also through its axis.
  std::vector<Offset> ends_of_run_out(const Offset& from) const;
  // J-THR-05: how far from the axis of a bolt the run-out leads: to its end; beyond half a turn, to
  // the point across from where the arc that leaves the helix tangentially begins.
  Number farthest_of_run_out(const Number& radius) const;
  // From the bottom up, never down; in the material no higher than the groove rises over K.
  std::string_view broken_height(const Event& piece) const;

  const reference::ThreadMilling& thread_;
  const Tolerances& tolerances_;
  Slack slack_;
  Position begin_place_;
  reference::PlaneAxes axes_;
  Offset middle_;
  Number top_;
  Number bottom_;
  int up_;
  int free_;  // outward or inward
  Number start_;
  Number run_out_;
  Number angle_;  // K within a turn
  Number lead_;

 private:
  bool are_chords_about(const Offset& centre, const std::vector<Offset>& places) const;
};

// Arcs that all turn one way, no more than once, without a corner of more than a quarter of a turn
// between two of them. `directions_` counts the quarters that their directions go round.
class Arcs {
 public:
  explicit Arcs(const ThreadSite& site) : site_(site) {}
  std::string_view take(const Event& piece);

 private:
  const ThreadSite& site_;
  int sense_ = 0;
  Offset arm_;  // from the centre of the last to its end
  Winding directions_{1, 0};
};

}  // namespace gonogo::relation
