// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/border.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/region/border_pieces.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle::region {
namespace {

bool meets_area(const Band& band, const EnclosedRectangle& area) {
  const auto near = [&area](const IntervalVector& point, Interval size) {
    return square_root(squared_distance_to_core(area, point)).sup() < (area.radius + size).inf();
  };
  switch (band.shape) {
    case Band::Shape::disc:
    case Band::Shape::capsule:
      return near(band.c, band.outer);
    case Band::Shape::rectangle:
      return true;  // about the middle, both of them
    default:
      break;
  }
  const Interval middle = (band.inner + band.outer) * 0.5;
  const Interval half = (band.outer - band.inner) * 0.5;
  return near(band.c + middle * band.ua, half);
}

// Puts the value in front of those before that place, for the one that stands there.
template <class Lately, class Value>
void bring_to_front(Lately& lately, std::size_t place, Value value) {
  const auto one = lately.begin() + static_cast<std::ptrdiff_t>(place);
  std::rotate(lately.begin(), one, one + 1);
  lately.front() = value;
}

}  // namespace

BorderFilter::BorderFilter(std::span<const Band> bands, const Grid& grid, const Target& target)
    : bands_(bands),
      grid_(grid),
      target_(target),
      area_(enclose(target.area)),
      budget_(kPiecesPerUnit * bands.size() + kPiecesOnTop) {
  for (const Band& band : bands) meets_ = meets_ || meets_area(band, area_);
}

bool BorderFilter::find_hole() {
  while (complete_) {
    if (pieces_.empty() && !start_next_border()) return false;
    if (pieces_.empty()) continue;
    const BorderPiece piece = pieces_.back();
    pieces_.pop_back();
    if (budget_-- == 0 || open_.size() > kMostSpots) {
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
  const bool hole = next_ % 2 != 0;
  ++next_;
  append_border(bands_[band_], hole, target_, area_, pieces_);
  return true;
}

BorderFilter::Middle BorderFilter::middle_of(const BorderPiece& piece) const {
  if (const auto* line = std::get_if<LinePiece>(&piece.curve)) {
    const double dx = median(line->b.x() - line->a.x());
    const double dy = median(line->b.y() - line->a.y());
    const double length = std::sqrt(dx * dx + dy * dy);
    const double unit = length > 0 ? length : 1;  // a line of no length has no side
    return {median(line->a.x()) + dx / 2, median(line->a.y()) + dy / 2, dy / unit, -dx / unit,
            length};
  }
  const auto& arc = std::get<CirclePiece>(piece.curve);
  const IntervalVector m = middle_direction(arc.ua, arc.ub, false);
  const double mx = median(m.x());
  const double my = median(m.y());
  const double r = median(arc.r);
  const double out = piece.side == Side::hole ? -1 : 1;
  return {median(arc.c.x()) + r * mx, median(arc.c.y()) + r * my, out * mx, out * my,
          norm(arc.r * (arc.ub - arc.ua)).sup()};
}

bool BorderFilter::lies_outside_area(const BorderPiece& piece) const {
  return std::visit([this](const auto& curve) { return lies_outside(curve, area_); }, piece.curve);
}

bool BorderFilter::is_inside(const BorderPiece& piece, const Band& band) const {
  return std::visit([&band](const auto& curve) { return lies_inside(curve, band); }, piece.curve);
}

// Whether the other band begins on the very circle or line that this one ends on.
bool BorderFilter::is_between(const BorderPiece& piece, std::uint32_t other) const {
  const Band& band = bands_[band_];
  const Band& next = bands_[other];
  if (const auto* line = std::get_if<LinePiece>(&piece.curve)) {
    if (piece.side == Side::edge || next.shape != Band::Shape::capsule) return false;
    for (const IntervalVector& end : {line->a, line->b}) {
      const IntervalVector offset = end - next.c;
      const Interval along = scalar_product(next.ua, offset);
      if (!(along.inf() > 0 && along.sup() < next.length.inf())) return false;
      const double aside = std::fabs(median(determinant(next.ua, offset)));
      if (!(std::fabs(aside - median(next.outer)) < kBeside)) return false;
    }
    return abut_exactly(band, piece.side, next, target_.reach);
  }
  const bool outer = piece.side == Side::outer;
  if (next.shape == Band::Shape::capsule || band.shape == Band::Shape::capsule) return false;
  if (outer ? !next.has_hole() : !band.has_hole()) return false;
  const auto& arc = std::get<CirclePiece>(piece.curve);
  const double radius = outer ? median(next.inner) : median(next.outer);
  if (!(std::fabs(radius - median(arc.r)) < kBeside)) return false;
  if (!(norm(band.c - next.c).inf() < kBeside)) return false;
  if (!lies_within_sweep(arc, next)) return false;
  return outer ? abut_exactly(band, next, target_.reach) : abut_exactly(next, band, target_.reach);
}

void BorderFilter::remember(std::uint32_t other, std::size_t place) {
  bring_to_front(recent_, place,
                 static_cast<std::int64_t>(other) - static_cast<std::int64_t>(band_));
}

// Whether the band covers the piece, or so much of it that its halves are worth a try before all
// the bands near it are looked at.
BorderFilter::Cover BorderFilter::try_band(const BorderPiece& piece, std::uint32_t other,
                                           const Middle& at) const {
  if (other == band_ || other >= bands_.size()) return Cover::unknown;
  const double outside = rough_distance(bands_[other], at.x, at.y);
  if (!(outside < 0)) return Cover::unknown;
  if (is_inside(piece, bands_[other])) return Cover::yes;
  return -outside > kShort && at.size > -outside ? Cover::worth_halving : Cover::unknown;
}

BorderFilter::Cover BorderFilter::try_recent(const BorderPiece& piece, const Middle& at) {
  Cover cover = Cover::unknown;
  const auto covers = [&](std::uint32_t other) {
    const Cover by_it = try_band(piece, other, at);
    if (by_it != Cover::unknown) cover = by_it;
    return by_it == Cover::yes;
  };
  for (std::size_t place = 0; place < recent_.size(); ++place) {
    const std::int64_t index = static_cast<std::int64_t>(band_) + recent_[place];
    if (index < 0 || index >= static_cast<std::int64_t>(bands_.size())) continue;
    if (!covers(static_cast<std::uint32_t>(index))) continue;
    remember(static_cast<std::uint32_t>(index), place);
    return cover;
  }
  for (std::size_t place = 0; place < bands_lately_.size(); ++place) {
    const std::uint32_t other = bands_lately_[place];
    if (!covers(other)) continue;
    bring_to_front(bands_lately_, place, other);
    return cover;
  }
  return cover;
}

bool BorderFilter::try_near(const BorderPiece& piece, const Middle& at) {
  for (const std::uint32_t other : grid_.near(at.x, at.y)) {
    if (other == band_ || !(rough_distance(bands_[other], at.x, at.y) < kBeside)) continue;
    if (is_inside(piece, bands_[other]) || is_between(piece, other)) {
      remember(other, recent_.size() - 1);
      bring_to_front(bands_lately_, bands_lately_.size() - 1, other);
      return true;
    }
  }
  return false;
}

bool BorderFilter::seems_hole(double x, double y) const {
  if (rough_distance(area_, x, y) >= 0) return false;
  for (const std::uint32_t other : grid_.near(x, y)) {
    if (rough_distance(bands_[other], x, y) <= kUnsure) return false;
  }
  return true;
}

bool BorderFilter::examine(const BorderPiece& piece) {
  if (lies_outside_area(piece)) return false;
  const Middle at = middle_of(piece);
  const Cover cover = try_recent(piece, at);
  if (cover == Cover::yes || (cover == Cover::unknown && try_near(piece, at))) return false;
  if (cover == Cover::worth_halving) {
    halve(piece);
    return false;
  }
  hole_ = {at.x + kBeside * at.nx, at.y + kBeside * at.ny, at.size};
  if (seems_hole(hole_.x, hole_.y)) {
    open_.push_back(hole_);  // until the caller has proved it
    return true;
  }
  if (!(at.size > kShort)) {
    open_.push_back({at.x, at.y, at.size});
    return false;
  }
  halve(piece);
  return false;
}

void BorderFilter::halve(const BorderPiece& piece) {
  if (const auto* line = std::get_if<LinePiece>(&piece.curve)) {
    const IntervalVector middle = Interval(0.5) * (line->a + line->b);
    const LinePiece halves[] = {{line->a, middle}, {middle, line->b}};
    for (const LinePiece& half : halves) pieces_.push_back({piece.side, half});
    return;
  }
  const auto arc = std::get<CirclePiece>(piece.curve);
  const IntervalVector middle = middle_direction(arc.ua, arc.ub, false);
  pieces_.push_back({piece.side, CirclePiece{arc.c, arc.r, arc.ua, middle}});
  pieces_.push_back({piece.side, CirclePiece{arc.c, arc.r, middle, arc.ub}});
}

}  // namespace gonogo::oracle::region
