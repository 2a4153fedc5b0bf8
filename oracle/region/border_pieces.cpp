// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/border_pieces.hpp"

#include "oracle/region/constants.hpp"

namespace gonogo::oracle::region {
namespace {

using Side = BorderPiece::Side;

class BorderMaker {
 public:
  BorderMaker(const Band& band, const Target& target, const EnclosedRectangle& area,
              std::vector<BorderPiece>& out)
      : band_(band), target_(target), area_(area), out_(out) {}

  void circle(bool hole);
  void capsule();
  void rectangle();

 private:
  void arc(Side side, const IntervalVector& c, Interval r, const IntervalVector& ua,
           const IntervalVector& ub) {
    out_.push_back({side, CirclePiece{c, r, ua, ub}});
  }
  void line(Side side, const IntervalVector& a, const IntervalVector& b) {
    out_.push_back({side, LinePiece{a, b}});
  }
  void cap(const PlanePoint& end, const IntervalVector& c, const IntervalVector& n,
           const IntervalVector& u);
  bool surrounds_area(const PlanePoint& centre, const Number& radius2, const Number& beyond,
                      double gap) const;
  bool follows_corner(const Number& reach) const;
  bool edge_is_outside(Side side, const IntervalVector& normal) const;

  const Band& band_;
  const Target& target_;
  const EnclosedRectangle& area_;
  std::vector<BorderPiece>& out_;
};

// The whole circle of radius sqrt(radius2) + beyond lies round the area, perhaps touching it.
// Exactly. `gap`: about how much larger its radius is than the distance to its centre.
bool BorderMaker::surrounds_area(const PlanePoint& centre, const Number& radius2,
                                 const Number& beyond, double gap) const {
  if (!(gap >= median(area_.radius) - kShort)) return false;
  // For each corner o of the core: r >= |c - o| + k, r the root of radius2.
  const Number k = target_.area.radius - beyond;
  const Number k2 = k * k;
  for (const Corner& corner : corners_of(target_.area)) {
    const Number c2 = norm_squared(centre - corner.at);
    const Number rest = k.sign() >= 0 ? radius2 - c2 - k2 : c2 - radius2 - k2;
    // k >= 0: r2 - c2 - k2 >= 2 k |c|.  k < 0: c2 - r2 - k2 <= 2 |k| r.
    const bool holds = k.sign() >= 0 ? rest.sign() >= 0 && rest * rest >= Number(4) * k2 * c2
                                     : rest.sign() <= 0 || rest * rest <= Number(4) * k2 * radius2;
    if (!holds) return false;
  }
  return true;
}

// A sector about a corner of the core, reaching as far as the area does there.
bool BorderMaker::follows_corner(const Number& reach) const {
  if (!band_.sweep || band_.sweep->wide) return false;
  const PlanePoint& a = band_.sweep->a;
  const PlanePoint& b = band_.sweep->b;
  if (!((band_.outer - area_.radius).sup() >= -kShort)) return false;
  for (const Corner& corner : corners_of(target_.area)) {
    if (!(*band_.centre == corner.at)) continue;
    const auto away = [&](const PlanePoint& direction) {
      return leads_away(target_.area, corner.sp, corner.sq, direction);
    };
    if (!away(a) || !away(b)) continue;
    // The ends of a half circle lead away from both ends of a core that is a line across them.
    if (cross(a, b).sign() == 0 && !away({-a.q, a.p})) continue;
    const Number rest = target_.area.radius - reach;
    return rest.sign() <= 0 || *band_.radius2 >= rest * rest;
  }
  return false;
}

void BorderMaker::circle(bool hole) {
  if (hole && !band_.has_hole()) return;
  const Interval r =
      hole ? Interval{std::max(band_.inner.inf(), 0.0), band_.inner.sup()} : band_.outer;
  if (band_.radius2) {
    const Number beyond = hole ? -target_.reach : target_.reach;
    const double gap = (r - norm(band_.c)).sup();
    if (surrounds_area(*band_.centre, *band_.radius2, beyond, gap)) return;
    if (!hole && follows_corner(target_.reach)) return;
  }
  const Side side = hole ? Side::hole : Side::outer;
  if (band_.shape != Band::Shape::sector) {
    const IntervalVector axes[] = {IntervalVector(1, 0), IntervalVector(0, 1),
                                   IntervalVector(-1, 0), IntervalVector(0, -1)};
    for (std::size_t k = 0; k < 4; ++k) arc(side, band_.c, r, axes[k], axes[(k + 1) % 4]);
    return;
  }
  if (!band_.wide && scalar_product(band_.ua, band_.ub).inf() >= 0) {
    arc(side, band_.c, r, band_.ua, band_.ub);
    return;
  }
  const IntervalVector m = middle_direction(band_.ua, band_.ub, band_.wide);
  const IntervalVector first = middle_direction(band_.ua, m, false);
  const IntervalVector last = middle_direction(m, band_.ub, false);
  arc(side, band_.c, r, band_.ua, first);
  arc(side, band_.c, r, first, m);
  arc(side, band_.c, r, m, last);
  arc(side, band_.c, r, last, band_.ub);
}

// The edge lies outside the area, perhaps touching it. Exactly: no point of the area lies farther
// along the edge's normal than h = core_p |n.p| + core_q |n.q| + radius.
bool BorderMaker::edge_is_outside(Side side, const IntervalVector& normal) const {
  const Interval along = scalar_product(normal, band_.c) + band_.outer;
  const Interval support = area_.core_p * abs(normal.x()) + area_.core_q * abs(normal.y());
  const Interval room = along - support - area_.radius;
  if (!(room.sup() >= -kShort)) return false;
  if (room.inf() >= 0) return true;
  const Line& line = *band_.line;
  const PlanePoint d = line.to - line.from;
  Number from = cross(d, line.from);  // its place along the normal, times the length of d
  if (side == Side::right) from = -from;
  const Number need =
      target_.area.core_p * exact::abs(d.q) + target_.area.core_q * exact::abs(d.p) - from;
  // (reach - radius) |d| >= need.
  const Number k = target_.reach - target_.area.radius;
  const Number left = k * k * norm_squared(d);
  const Number right = need * need;
  if (k.sign() >= 0) return need.sign() <= 0 || left >= right;
  return need.sign() <= 0 && left <= right;
}

// The half circle about an end from -n by u to n.
void BorderMaker::cap(const PlanePoint& end, const IntervalVector& c, const IntervalVector& n,
                      const IntervalVector& u) {
  const double gap = (band_.outer - norm(c)).sup();
  if (surrounds_area(end, Number(), target_.reach, gap)) return;
  arc(Side::outer, c, band_.outer, -n, u);
  arc(Side::outer, c, band_.outer, u, n);
}

void BorderMaker::capsule() {
  const IntervalVector& u = band_.ua;
  const IntervalVector n = u.perpendicular(CGAL::COUNTERCLOCKWISE);
  const IntervalVector aside = band_.outer * n;
  if (!edge_is_outside(Side::right, -n)) line(Side::right, band_.c - aside, band_.to - aside);
  if (!edge_is_outside(Side::left, n)) line(Side::left, band_.to + aside, band_.c + aside);
  cap(band_.line->to, band_.to, n, u);
  cap(band_.line->from, band_.c, -n, -u);
}

void BorderMaker::rectangle() {
  const EnclosedRectangle& shape = band_.rectangle();
  const IntervalVector axes[] = {IntervalVector(1, 0), IntervalVector(0, 1), IntervalVector(-1, 0),
                                 IntervalVector(0, -1)};
  const IntervalVector corners[] = {{shape.core_p, shape.core_q},
                                    {-shape.core_p, shape.core_q},
                                    {-shape.core_p, -shape.core_q},
                                    {shape.core_p, -shape.core_q}};
  for (std::size_t k = 0; k < 4; ++k) {
    const IntervalVector& c = corners[k];
    const IntervalVector& next = corners[(k + 1) % 4];
    const IntervalVector& out = axes[(k + 1) % 4];
    arc(Side::outer, c, shape.radius, axes[k], out);
    const Interval side = k % 2 == 0 ? shape.core_p : shape.core_q;
    if (side.sup() > 0) line(Side::edge, c + shape.radius * out, next + shape.radius * out);
  }
}

}  // namespace

void append_border(const Band& band, bool hole, const Target& target, const EnclosedRectangle& area,
                   std::vector<BorderPiece>& out) {
  BorderMaker maker(band, target, area, out);
  switch (band.shape) {
    case Band::Shape::capsule:
      if (!hole) maker.capsule();
      return;
    case Band::Shape::rectangle:
      if (!hole) maker.rectangle();
      return;
    default:
      maker.circle(hole);
  }
}

bool abut_exactly(const Band& small, const Band& large, const Number& reach) {
  if (!small.radius2 || !large.radius2 || !(*small.centre == *large.centre)) return false;
  const Number gap = Number(2) * reach;
  // large's radius = small's + the gap.
  const Number rest = *large.radius2 - *small.radius2 - gap * gap;  // 2 gap * small's radius
  return rest.sign() >= 0 && rest * rest == Number(4) * gap * gap * *small.radius2;
}

bool abut_exactly(const Band& capsule, BorderPiece::Side side, const Band& other,
                  const Number& reach) {
  const PlanePoint d = capsule.line->to - capsule.line->from;
  if (cross(d, other.line->to - other.line->from).sign() != 0) return false;
  const Number aside = cross(d, other.line->from - capsule.line->from);
  if (aside.sign() != (side == BorderPiece::Side::left ? 1 : -1)) return false;
  return aside * aside == Number(4) * reach * reach * norm_squared(d);
}

}  // namespace gonogo::oracle::region
