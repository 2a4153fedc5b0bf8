// SPDX-License-Identifier: GPL-3.0-or-later
//
// The filter of the coverage question: it walks the borders of the bands, not the area.
//
// Let U be the union of the bands (closed) and Q the disc. Suppose that some band's inside meets
// the inside of Q, and that every point of a band's border in the inside of Q, save finitely many,
// is in the inside of U. Then U covers Q. For let V be the inside of Q less U, an open set, and F
// the finite set of exceptions. A border point of V in the inside of Q lies on the border of U, so
// on a band's border, so in F. Hence V is open and closed in the inside of Q less F, which is
// connected: V is empty or all of it. Not all of it, since a band's inside meets the inside of Q.
// So V is empty, and U, being closed, covers the closure of the inside of Q.
//
// A point is in the inside of U when it is in the inside of another band, or where two bands of one
// circle lie on either side of it. The straight edges of sectors need no walk: they are diameters
// of the discs about the ends.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "oracle/region/coverage.hpp"
#include "oracle/region/grid.hpp"
#include "oracle/region/piece.hpp"

namespace gonogo::oracle::region {

// A place on a border, or just beside it. Doubles: a hint.
struct Spot {
  double x = 0;
  double y = 0;
  double size = 0;  // of the piece of border about it
};

// Pieces of border looked at, for each band and on top.
inline constexpr std::size_t kPiecesPerBand = 400;
inline constexpr std::size_t kPiecesOnTop = 100'000;
// A shorter piece that is still open is left to exact arithmetic, mm.
inline constexpr double kShortestPiece = 1e-6;
inline constexpr std::size_t kMaximumOpenSpots = 400;

class BorderFilter {
 public:
  // All arguments must outlive the filter.
  BorderFilter(std::span<const Band> bands, const Grid& grid, const Disc& disc);

  // Walks on until a spot just beside a border seems uncovered (true), or to the end (false).
  bool find_hole();
  const Spot& hole() const { return hole_; }

  // After the walk: nothing was open, and the theorem above applies.
  bool covered() const { return complete_ && meets_ && open_.empty(); }
  // After the walk: only these spots are open.
  bool only_open_spots() const { return complete_ && meets_; }
  const std::vector<Spot>& open() const { return open_; }

 private:
  struct Piece {
    IntervalVector ua;
    IntervalVector ub;
  };

  enum class Cover { yes, worth_halving, unknown };

  bool start_next_border();
  void start_pieces(const Band& band);
  bool surrounds_disc(const Band& band) const;
  bool is_between(const Piece& piece, std::uint32_t other) const;
  CirclePiece on_border(const Piece& piece) const {
    return {bands_[band_].c, r_, piece.ua, piece.ub};
  }
  Cover try_recent(const Piece& piece, double x, double y, double size);
  bool try_near(const Piece& piece, double x, double y);
  void remember(std::uint32_t other, std::size_t place);
  bool seems_hole(double x, double y) const;
  bool examine(const Piece& piece);
  void halve(const Piece& piece, const IntervalVector& middle);
  bool abut_exactly(const Band& small, const Band& large) const;

  std::span<const Band> bands_;
  const Grid& grid_;
  const Disc& disc_;
  Interval radius2_;
  double rough_radius_;

  std::size_t next_ = 0;  // twice the band, plus one for its hole
  std::uint32_t band_ = 0;
  bool outer_ = true;
  Interval r_;  // radius of the border
  std::vector<Piece> pieces_;
  // How far on in the list the bands stand that covered pieces lately, the latest first. Paths
  // are regular: the same neighbours cover the next border.
  std::array<std::int64_t, 8> recent_{1, -1, 2, -2, 3, -3, 4, -4};

  std::size_t budget_;
  bool complete_ = true;
  bool meets_ = false;
  std::vector<Spot> open_;
  Spot hole_;
};

}  // namespace gonogo::oracle::region
