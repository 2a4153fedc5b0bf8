// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/border.hpp"

#include <algorithm>
#include <cmath>

namespace gonogo::oracle::region {
namespace {

// How far beside the border a hole is looked for, mm.
constexpr double kBeside = 1e-9;

bool meets_disc(const Band& band, const Disc& disc) {
  const Interval limit = enclose(disc.radius);
  if (band.shape == Band::Shape::disc) return norm(band.c).hi < (limit + band.outer).lo;
  const Interval middle = (band.inner + band.outer) * Interval{0.5, 0.5};
  const Interval half = (band.outer - band.inner) * Interval{0.5, 0.5};
  return norm(band.c + middle * band.ua).hi < (limit + half).lo;
}

}  // namespace

BorderFilter::BorderFilter(std::span<const Band> bands, const Grid& grid, const Disc& disc)
    : bands_(bands),
      grid_(grid),
      disc_(disc),
      radius2_(square(enclose(disc.radius))),
      rough_radius_(enclose(disc.radius).middle()),
      budget_(kPiecesPerBand * bands.size() + kPiecesOnTop) {
  for (const Band& band : bands) meets_ = meets_ || meets_disc(band, disc);
}

bool BorderFilter::find_hole() {
  while (complete_) {
    if (pieces_.empty() && !start_next_border()) return false;
    if (pieces_.empty()) continue;
    const Piece piece = pieces_.back();
    pieces_.pop_back();
    if (budget_-- == 0 || open_.size() > kMaximumOpenSpots) {
      complete_ = false;
      return false;
    }
    if (examine(piece)) return true;
  }
  return false;
}

bool BorderFilter::start_next_border() {
  if (next_ >= 2 * bands_.size()) return false;
  band_ = static_cast<std::uint32_t>(next_ / 2);
  outer_ = next_ % 2 == 0;
  ++next_;
  const Band& band = bands_[band_];
  if (!outer_ && !band.has_hole()) return true;
  r_ = outer_ ? band.outer : Interval{std::max(band.inner.lo, 0.0), band.inner.hi};
  if (!surrounds_disc(band)) start_pieces(band);
  return true;
}

// Pieces of at most 90 degrees.
void BorderFilter::start_pieces(const Band& band) {
  if (band.shape != Band::Shape::sector) {
    const IntervalVector corners[] = {exactly(1, 0), exactly(0, 1), exactly(-1, 0), exactly(0, -1)};
    for (std::size_t k = 0; k < 4; ++k) pieces_.push_back({corners[k], corners[(k + 1) % 4]});
    return;
  }
  if (!band.wide && dot(band.ua, band.ub).lo >= 0) {
    pieces_.push_back({band.ua, band.ub});
    return;
  }
  const IntervalVector m = middle_direction(band.ua, band.ub, band.wide);
  for (const Piece& half : {Piece{band.ua, m}, Piece{m, band.ub}}) {
    const IntervalVector quarter = middle_direction(half.ua, half.ub, false);
    pieces_.push_back({half.ua, quarter});
    pieces_.push_back({quarter, half.ub});
  }
}

// The whole border circle lies round the disc, perhaps touching it. Exactly.
bool BorderFilter::surrounds_disc(const Band& band) const {
  if (!band.radius2 || !((r_ - norm(band.c)).hi >= rough_radius_ - 1e-6)) return false;
  // r >= |c| + k, r the radius of the middle line.
  const Number k = outer_ ? disc_.radius - disc_.reach : disc_.radius + disc_.reach;
  const Number& r2 = *band.radius2;
  const Number c2 = norm_squared(*band.centre);
  const Number k2 = k * k;
  const Number rest = k.sign() >= 0 ? r2 - c2 - k2 : c2 - r2 - k2;
  // k >= 0: r2 - c2 - k2 >= 2 k |c|.  k < 0: c2 - r2 - k2 <= 2 |k| r.
  if (k.sign() >= 0) return rest.sign() >= 0 && rest * rest >= Number(4) * k2 * c2;
  return rest.sign() <= 0 || rest * rest <= Number(4) * k2 * r2;
}

// large's radius = small's + twice the reach, about one centre.
bool BorderFilter::abut_exactly(const Band& small, const Band& large) const {
  if (!small.radius2 || !large.radius2 || !(*small.centre == *large.centre)) return false;
  const Number gap = Number(2) * disc_.reach;
  const Number rest = *large.radius2 - *small.radius2 - gap * gap;  // 2 gap * small's radius
  return rest.sign() >= 0 && rest * rest == Number(4) * gap * gap * *small.radius2;
}

// Whether the other band begins on the very circle that this one ends on.
bool BorderFilter::is_between(const Piece& piece, std::uint32_t other) const {
  const Band& band = bands_[band_];
  const Band& next = bands_[other];
  if (outer_ ? !next.has_hole() : !band.has_hole()) return false;
  const double radius = outer_ ? next.inner.middle() : next.outer.middle();
  if (!(std::fabs(radius - r_.middle()) < 1e-9)) return false;
  if (!(norm(band.c - next.c).lo < 1e-9)) return false;
  if (!lies_within_sweep(on_border(piece), next)) return false;
  return outer_ ? abut_exactly(band, next) : abut_exactly(next, band);
}

void BorderFilter::remember(std::uint32_t other, std::size_t place) {
  std::rotate(recent_.begin(), recent_.begin() + static_cast<std::ptrdiff_t>(place),
              recent_.begin() + static_cast<std::ptrdiff_t>(place) + 1);
  recent_.front() = static_cast<std::int64_t>(other) - static_cast<std::int64_t>(band_);
}

// Whether a likely neighbour covers the piece, or so much of it that its halves are worth a try
// before all the bands near it are looked at.
BorderFilter::Cover BorderFilter::try_recent(const Piece& piece, double x, double y, double size) {
  Cover cover = Cover::unknown;
  for (std::size_t place = 0; place < recent_.size(); ++place) {
    const std::int64_t index = static_cast<std::int64_t>(band_) + recent_[place];
    if (index < 0 || index >= static_cast<std::int64_t>(bands_.size())) continue;
    const auto other = static_cast<std::uint32_t>(index);
    const double outside = rough_distance(bands_[other], x, y);
    if (other == band_ || !(outside < 0)) continue;
    if (lies_inside(on_border(piece), bands_[other])) {
      remember(other, place);
      return Cover::yes;
    }
    if (-outside > kShortestPiece && size > -outside) cover = Cover::worth_halving;
  }
  return cover;
}

bool BorderFilter::try_near(const Piece& piece, double x, double y) {
  for (const std::uint32_t other : grid_.near(x, y)) {
    if (other == band_ || !(rough_distance(bands_[other], x, y) < 1e-9)) continue;
    if (lies_inside(on_border(piece), bands_[other]) || is_between(piece, other)) {
      remember(other, recent_.size() - 1);
      return true;
    }
  }
  return false;
}

bool BorderFilter::seems_hole(double x, double y) const {
  if (x * x + y * y >= rough_radius_ * rough_radius_) return false;
  for (const std::uint32_t other : grid_.near(x, y)) {
    if (rough_distance(bands_[other], x, y) <= 0) return false;
  }
  return true;
}

bool BorderFilter::examine(const Piece& piece) {
  if (lies_outside(on_border(piece), radius2_)) return false;
  const IntervalVector& c = bands_[band_].c;
  const IntervalVector m = middle_direction(piece.ua, piece.ub, false);
  const double mx = m.x.middle();
  const double my = m.y.middle();
  const double x = c.x.middle() + r_.middle() * mx;
  const double y = c.y.middle() + r_.middle() * my;
  const double size = norm(r_ * (piece.ub - piece.ua)).hi;
  const Cover cover = try_recent(piece, x, y, size);
  if (cover == Cover::yes || (cover == Cover::unknown && try_near(piece, x, y))) return false;
  if (cover == Cover::worth_halving) {
    halve(piece, m);
    return false;
  }
  const double beside = outer_ ? kBeside : -kBeside;
  hole_ = {x + beside * mx, y + beside * my, size};
  if (seems_hole(hole_.x, hole_.y)) {
    open_.push_back(hole_);  // until the caller has proved it
    return true;
  }
  if (!(size > kShortestPiece)) {
    open_.push_back({x, y, size});
    return false;
  }
  halve(piece, m);
  return false;
}

void BorderFilter::halve(const Piece& piece, const IntervalVector& middle) {
  pieces_.push_back({piece.ua, middle});
  pieces_.push_back({middle, piece.ub});
}

}  // namespace gonogo::oracle::region
