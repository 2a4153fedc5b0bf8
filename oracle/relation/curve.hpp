// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions as curves, cut into straight pieces. A piece says how far the points of the curve may lie
// from it; a line is one piece, with no such distance.
#pragma once

#include <array>
#include <optional>

#include "reference/record.hpp"

namespace gonogo::relation {

using exact::Number;
using reference::Axis;
using reference::Position;

// A rational that differs from the number by less than 2^-60 mm.
Number rational_near(const Number& number);
Position rational_near(const Position& position);

// Where a record's motion that starts at `from` ends.
Position end_of(const reference::Record& record, const Position& from);

// A place on the raster of a millionth of a millimetre, finer where tau is small; how far it may be
// from the place that it stands for.
struct Rastered {
  Position at;
  Number width;
};
Rastered rastered(const Position& position, const Number& tau);

struct Chord {
  Position from;
  Position to;
  Number width;
};

// A curve about a centre, from angle 0 to `degrees`:
//   centre + (u cos t + w sin t) (1 + growth * part) + drift * part, part = t / degrees.
// Arcs, helices, spirals and circles in space are of this form.
struct Turning {
  Position centre;
  Position u;
  Position w;      // a quarter turn from u, as long as it
  Number degrees;  // > 0
  Number radius;   // not below any radius of the curve
  Number growth;   // of the radius, as a part of that at the start
  Position drift;  // along the axes that do not turn
};

// Whether an arc may be read as another, because its ends agree within tau: as a nil turn where its
// numbers say a full one, or the reverse.
enum class Turn : std::uint8_t { as_written, the_other };
bool ends_agree(const reference::Record& arc, const Position& from, const Number& tau);
// The same for an arc that ends beside its start: its own turns are not sure.
bool has_two_readings(const reference::Record& record, const Position& from, const Number& tau);

// Gives the pieces of a motion one at a time: an arc of a thousand million turns has many.
class Cutter {
 public:
  Cutter(const reference::Record& record, const Position& from, const Number& tau, Turn turn);
  std::optional<Chord> next();
  // Whether it is an arc whose points lie within tau of its chord.
  bool is_flat() const { return is_flat_; }

 private:
  Chord chord_to(const Position& point, const Number& width);

  Number tau_;
  Position to_;
  std::optional<Position> via_;     // of three points in line
  std::optional<Turning> turning_;  // none: a line
  bool is_flat_ = false;
  std::int64_t steps_of_turn_ = 0;
  std::int64_t step_ = 0;  // that come next
  Number steps_;           // of the whole curve, not a whole number
  Rastered here_;
  bool is_done_ = false;
};

}  // namespace gonogo::relation
