// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/band.hpp"

#include <cmath>
#include <optional>

#include "oracle/region/constants.hpp"

namespace gonogo::oracle::region {
namespace {

const Number kZero;
struct Fit {
  IntervalVector o;  // centre, a point
  Interval radius;
  double away = 0;  // every point of the arc has a point of the stretch so near
};

// The circle through three points, as near as doubles get; nothing where they lie in line.
std::optional<Fit> circle_through(const IntervalVector& a, const IntervalVector& m,
                                  const IntervalVector& b) {
  using Doubles = CGAL::Simple_cartesian<double>;
  const auto seen = [](const IntervalVector& v) {
    return Doubles::Point_2(median(v.x()), median(v.y()));
  };
  if (CGAL::collinear(seen(a), seen(m), seen(b))) return std::nullopt;
  const Doubles::Point_2 o = CGAL::circumcenter(seen(a), seen(m), seen(b));
  if (!std::isfinite(o.x()) || !std::isfinite(o.y())) return std::nullopt;
  Fit circle{IntervalVector(o.x(), o.y()), 0, 0};
  const double radius = median(norm(a - circle.o));
  circle.radius = {radius, radius};
  return circle;
}

// A circle's arc beside a stretch of at most 90 degrees. Seen from the arc's centre c, which is a
// fraction e of the circle's radius R from its centre, the circle lies at the radius
// q = d cos f + R S, S = sqrt(1 - e^2 sin^2 f). The stretch's radius is linear, and the two agree
// at the ends and the middle, so they differ by at most max|q'''| h^3 / (9 sqrt 3), h being half
// the sweep. From S S'' + S'^2 = -e^2 cos 2f: |S'| <= e^2 / 2m, |S''| <= (e^2 + S'^2) / m,
// |S'''| <= (2 e^2 + 3 |S' S''|) / m, with m = sqrt(1 - e^2).
std::optional<Fit> fit(const Arc& arc, const Stretch& stretch) {
  if (!stretch.is_at_most_quarter()) return std::nullopt;
  const IntervalVector nodes[] = {arc.c + stretch.a(), arc.c + middle_of(stretch),
                                  arc.c + stretch.b()};
  auto circle = circle_through(nodes[0], nodes[1], nodes[2]);
  if (!circle) return std::nullopt;
  const Interval d = norm(circle->o - arc.c);
  const Interval e2 = square(d / circle->radius);
  if (!(e2.sup() < 0.9)) return std::nullopt;
  const Interval m = square_root(Interval(1) - e2);
  const Interval s1 = e2 / (2.0 * m);
  const Interval s2 = (e2 + square(s1)) / m;
  const Interval s3 = (2.0 * e2 + 3.0 * s1 * s2) / m;
  const Interval third = d + circle->radius * s3;
  // An angle up to 90 degrees is at most 1.1108 times its chord.
  const Interval h = norm(stretch.ub - stretch.ua) * 0.5555;
  Interval miss = 0;
  for (const IntervalVector& node : nodes) {
    miss = CGAL::max(miss, abs(norm(node - circle->o) - circle->radius));
  }
  // 0.0642 > 1 / (9 sqrt 3). What the nodes miss the circle by counts along slanting rays, and
  // through the interpolation: far less than tenfold divided by m.
  circle->away = (third * h * square(h) * 0.0642 + miss * 10.0 / m).sup();
  return circle;
}

class BandMaker {
 public:
  BandMaker(std::vector<Band>& out, Interval reach, double width)
      : out_(out), reach_(reach), width_(width) {}

  void add_point(const PlanePoint& point) {
    Band band;
    band.c = enclose(point);
    band.outer = reach_;
    band.centre = &point;
    band.radius2 = &kZero;
    add(band);
  }

  void add_round(const Arc& arc) {
    Band band = about(arc.c, whole(arc), arc.ra - reach_, arc.ra + reach_);
    if (arc.full) band.shape = Band::Shape::ring;
    band.centre = &arc.centre;
    band.radius2 = &arc.a2;
    band.sweep = arc.full ? nullptr : &arc.sweep;
    add(band);
  }

  void add_line(const Line& line) {
    Band band = capsule(line.a, line.b, line.u, line.length);
    band.line = &line;
    add(band);
  }

  // False when the bands are too many, or the ends known so coarsely that no number of bands would
  // do.
  bool add_spiral(const Arc& arc, const Stretch& all) {
    const auto is_coarse = [this](const Interval& radius) {
      return radius.sup() - radius.inf() > 2 * width_;
    };
    if (is_coarse(all.ra) || is_coarse(all.rb)) return false;
    std::vector<Stretch> open{all};
    while (!open.empty()) {
      if (out_.size() > kMaximumBands) return false;
      const Stretch stretch = open.back();
      open.pop_back();
      if (abs(stretch.rb - stretch.ra).sup() <= width_) {
        add_part(arc, stretch);
        continue;
      }
      if (add_fitted(arc, stretch)) continue;
      const auto parts = halves(stretch);
      add_joint(arc.c + parts[0].b());
      open.insert(open.end(), parts.begin(), parts.end());
    }
    return true;
  }

  void add_joint(const IntervalVector& point) {
    Band band;
    band.c = point;
    band.outer = reach_;
    add(band);
  }

  // A part of a round arc, by its enclosures.
  void add_round_part(const Arc& arc, const Stretch& stretch) {
    add(about(arc.c, stretch, arc.ra - reach_, arc.ra + reach_));
  }

  void add_capsule(const IntervalVector& from, const IntervalVector& to) {
    add(capsule(from, to, unit(to - from), norm(to - from)));
  }

 private:
  // The points as far as the reach allows from every radius of the stretch, along the ray.
  void add_part(const Arc& arc, const Stretch& stretch) {
    const Interval radius = hull(stretch.ra, stretch.rb);
    const Interval least{reach_.inf(), reach_.inf()};
    Band band = about(arc.c, stretch, Interval{radius.sup(), radius.sup()} - least,
                      Interval{radius.inf(), radius.inf()} + least);
    if (stretch.turns > 0) band.shape = Band::Shape::ring;
    band.centre = &arc.centre;
    add(band);
  }

  // The points as far as the reach allows from a circle's arc beside the stretch, through its ends
  // and middle. False when the arc is not within `width` of the stretch.
  bool add_fitted(const Arc& arc, const Stretch& stretch) {
    const auto circle = fit(arc, stretch);
    if (!circle || !(circle->away <= width_)) return false;
    const IntervalVector a = arc.c + stretch.a() - circle->o;
    const IntervalVector b = arc.c + stretch.b() - circle->o;
    const Interval side = determinant(a, b);
    if (side.inf() <= 0 && side.sup() >= 0) return false;
    const Interval reach =
        Interval{reach_.inf(), reach_.inf()} - Interval{circle->away, circle->away};
    const Stretch seen{unit(a), unit(b), circle->radius, circle->radius, 0, side.sup() < 0};
    add(about(circle->o, seen, circle->radius - reach, circle->radius + reach));
    return true;
  }

  static Band about(const IntervalVector& centre, const Stretch& stretch, const Interval& inner,
                    const Interval& outer) {
    Band band;
    band.shape = Band::Shape::sector;
    band.wide = stretch.wide;
    band.c = centre;
    band.inner = inner;
    band.outer = outer;
    band.ua = stretch.ua;
    band.ub = stretch.ub;
    return band;
  }

  Band capsule(const IntervalVector& from, const IntervalVector& to, const IntervalVector& u,
               const Interval& length) const {
    Band band;
    band.shape = Band::Shape::capsule;
    band.c = from;
    band.to = to;
    band.ua = u;
    band.length = length;
    band.outer = reach_;
    return band;
  }

  void add(Band band) {
    band.square_radii();
    out_.push_back(band);
  }

  std::vector<Band>& out_;
  Interval reach_;
  double width_;
};

// The points about which the path has a disc.
std::vector<PlanePoint> points_of(const Path& path) {
  std::vector<PlanePoint> points = path.points;
  const auto add = [&points](const PlanePoint& end) {
    // Neighbours share their joint.
    const std::size_t known = points.size();
    if (known > 0 && points[known - 1] == end) return;
    if (known > 1 && points[known - 2] == end) return;
    points.push_back(end);
  };
  for (const Arc& arc : path.arcs) {
    if (arc.full) continue;
    if (!arc.capped_a) add(arc.end_a());
    if (!arc.capped_b) add(arc.end_b());
  }
  for (const Line& line : path.lines) {
    if (line.length.inf() > kShort) continue;
    add(line.from);
    add(line.to);
  }
  return points;
}

}  // namespace

std::optional<Bands> make_bands(const Path& path, const Number& reach, double width) {
  std::optional<Bands> result(std::in_place);
  result->points = points_of(path);
  BandMaker maker(result->bands, enclose(reach), width);
  for (const PlanePoint& point : result->points) maker.add_point(point);
  for (const Line& line : path.lines) {
    if (line.length.inf() > kShort) maker.add_line(line);
  }
  for (const Arc& arc : path.arcs) {
    if (arc.round) {
      maker.add_round(arc);
    } else if (!maker.add_spiral(arc, whole(arc))) {
      return std::nullopt;
    }
  }
  return result;
}

bool append_stretch(const Arc& arc, const Stretch& stretch, Interval reach, double width,
                    std::vector<Band>& out) {
  const std::size_t first = out.size();
  BandMaker maker(out, reach, width);
  if (arc.round) {
    maker.add_round_part(arc, stretch);
  } else if (!maker.add_spiral(arc, stretch)) {
    return false;
  }
  for (std::size_t i = first; i < out.size(); ++i) out[i].centre = nullptr;
  return true;
}

void append_line(const IntervalVector& from, const IntervalVector& to, Interval reach,
                 std::vector<Band>& out) {
  BandMaker maker(out, reach, 0);
  if (norm(to - from).inf() > kShort) {
    maker.add_capsule(from, to);
  } else {
    maker.add_joint(from);
    maker.add_joint(to);
  }
}

Band disc_about(const IntervalVector& point, Interval reach) {
  std::vector<Band> one;
  BandMaker(one, reach, 0).add_joint(point);
  return one.front();
}

void add_cleared(Bands& bands, const Cleared& cleared) {
  Band band;
  band.shape = Band::Shape::rectangle;
  band.outer = cleared.enclosed.radius;
  band.outer2 = cleared.enclosed.radius2;
  band.cleared = &cleared;
  bands.bands.push_back(band);
}

namespace {

double distance_to_line(const Band& band, double x, double y) {
  const double dx = x - median(band.c.x());
  const double dy = y - median(band.c.y());
  const double ux = median(band.ua.x());
  const double uy = median(band.ua.y());
  const double along = std::clamp(dx * ux + dy * uy, 0.0, band.length.sup());
  const double px = dx - along * ux;
  const double py = dy - along * uy;
  return std::sqrt(px * px + py * py);
}

}  // namespace

double rough_distance(const Band& band, double x, double y) {
  if (band.shape == Band::Shape::capsule) return distance_to_line(band, x, y) - band.outer.inf();
  if (band.shape == Band::Shape::rectangle) return rough_distance(band.rectangle(), x, y);
  const double dx = x - median(band.c.x());
  const double dy = y - median(band.c.y());
  const double d = std::sqrt(dx * dx + dy * dy);
  const double outside =
      band.has_hole() ? std::max(d - band.outer.inf(), band.inner.sup() - d) : d - band.outer.inf();
  if (band.shape != Band::Shape::sector) return outside;
  const double ax = median(band.ua.x());
  const double ay = median(band.ua.y());
  const double bx = median(band.ub.x());
  const double by = median(band.ub.y());
  const double left_of_a = ax * dy - ay * dx;
  const double right_of_b = dx * by - dy * bx;
  const bool in = band.wide ? left_of_a > 0 || right_of_b > 0 : left_of_a > 0 && right_of_b > 0;
  if (in) return outside;
  // To the nearer of the two straight edges.
  const auto edge = [&](double ux, double uy) {
    const double low = band.has_hole() ? band.inner.sup() : 0.0;
    const double along = std::clamp(dx * ux + dy * uy, low, std::max(low, band.outer.inf()));
    return std::hypot(dx - along * ux, dy - along * uy);
  };
  return std::max(1e-300, std::min(edge(ax, ay), edge(bx, by)));
}

}  // namespace gonogo::oracle::region
