// SPDX-License-Identifier: GPL-3.0-or-later
//
// The filter of the coverage question: it walks the borders of the bands, not the area.
//
// Let U be the union of the bands (closed) and Q the area, a rounded rectangle. Suppose that some
// band's inside meets the inside of Q, and that every point of a band's border in the inside of Q,
// save finitely many, is in the inside of U. Then U covers Q. For let V be the inside of Q less U,
// an open set, and F the finite set of exceptions. A border point of V in the inside of Q lies on
// the border of U, so on a band's border, so in F. Hence V is open and closed in the inside of Q
// less F, which is connected, Q being convex: V is empty or all of it. Not all of it, since a
// band's inside meets the inside of Q. So V is empty, and U, being closed, covers the closure of
// the inside of Q.
//
// A strip, Q less what was cleared before, is a ring or worse, and need not be connected. But the
// path covers the strip when the path and the cleared set K together cover Q: so K is a band like
// the others, its border is walked with theirs, and Q stays as it is. A point that refutes this is
// in Q, outside K and beyond the path's reach: in the strip.
//
// A point is in the inside of U when it is in the inside of another band, or where two bands of one
// circle, or of parallel lines, lie on either side of it. The straight edges of sectors need no
// walk: they are diameters of the discs about the ends, or of the capsules of lines that end there.
#pragma once

#include <array>
#include <span>
#include <variant>
#include <vector>

#include "oracle/region/grid.hpp"
#include "oracle/region/piece.hpp"
#include "oracle/region/target.hpp"

namespace gonogo::oracle::region {

// A place on a border, or just beside it. Doubles: a hint.
struct Spot {
  double x = 0;
  double y = 0;
  double size = 0;  // of the piece of border about it
};

// A piece of a band's border, with the band on its left; of the circle of its hole, on its right.
struct BorderPiece {
  // Which border: circles about the outside (caps and corners too) and of a hole, the straight
  // edges of a capsule to the left and the right of its line, those of a rectangle.
  enum class Side : std::uint8_t { outer, hole, left, right, edge } side = Side::outer;
  std::variant<CirclePiece, LinePiece> curve;
};

class BorderFilter {
 public:
  // All arguments must outlive the filter.
  BorderFilter(std::span<const Band> bands, const Grid& grid, const Target& target);

  // Walks on until a spot just beside a border seems uncovered (true), or to the end (false).
  bool find_hole();
  const Spot& hole() const { return hole_; }

  // After the walk: nothing was open, and the theorem above applies.
  bool covered() const { return complete_ && meets_ && open_.empty(); }
  // After the walk: only these spots are open.
  bool only_open_spots() const { return complete_ && meets_; }
  const std::vector<Spot>& open() const { return open_; }

 private:
  using Side = BorderPiece::Side;
  enum class Cover { yes, worth_halving, unknown };
  // The middle of a piece, the way out of the band there, and the piece's length.
  struct Middle {
    double x, y;
    double nx, ny;
    double size;
  };

  bool start_next_border();
  Middle middle_of(const BorderPiece& piece) const;
  bool lies_outside_area(const BorderPiece& piece) const;
  bool is_inside(const BorderPiece& piece, const Band& band) const;
  bool is_between(const BorderPiece& piece, std::uint32_t other) const;
  Cover try_band(const BorderPiece& piece, std::uint32_t other, const Middle& at) const;
  Cover try_recent(const BorderPiece& piece, const Middle& at);
  bool try_near(const BorderPiece& piece, const Middle& at);
  void remember(std::uint32_t other, std::size_t place);
  bool seems_hole(double x, double y) const;
  bool examine(const BorderPiece& piece);
  void halve(const BorderPiece& piece);

  std::span<const Band> bands_;
  const Grid& grid_;
  const Target& target_;
  EnclosedRectangle area_;

  std::size_t next_ = 0;  // twice the band, plus one for its hole
  std::uint32_t band_ = 0;
  std::vector<BorderPiece> pieces_;
  // How far on in the list the bands stand that covered pieces lately, the latest first. Paths
  // are regular: the same neighbours cover the next border.
  std::array<std::int64_t, 8> recent_{1, -1, 2, -2, 3, -3, 4, -4};
  // And which bands did: the contour covers the ends of many passes.
  std::array<std::uint32_t, 8> bands_lately_{};

  std::size_t budget_;
  bool complete_ = true;
  bool meets_ = false;
  std::vector<Spot> open_;
  Spot hole_;
};

}  // namespace gonogo::oracle::region
