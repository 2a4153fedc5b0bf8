// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracle/region/pockets.hpp"

namespace gonogo::oracle::region {
namespace {

Number number(std::string_view text) {
  return Number::parse(text).value();
}

PlanePoint here(const Pocket& pocket) {
  return pocket.motions.empty() ? pocket.level.plunge : pocket.motions.back().to;
}

void line_unless_there(Pocket& pocket, const PlanePoint& to) {
  if (!(here(pocket) == to)) line_to(pocket, to);
}

// Where rows run: the border's area less half a step on each side.
RoundedRectangle inset(const Pocket& pocket, const Number& by) {
  const auto shape = eroded(border_of(pocket), by);
  return shape ? *shape : RoundedRectangle{};
}

// Half the width of the shape at q, to the micron below.
Number half_at(const RoundedRectangle& shape, const Number& q) {
  const Number beyond = exact::max(exact::abs(q) - shape.core_q, Number());
  const Number along = exact::sqrt(shape.radius * shape.radius - beyond * beyond);
  return shape.core_p + (along * Number(1'000)).floor() / Number(1'000);
}

}  // namespace

Pocket pocket(std::string_view length, std::string_view width, std::string_view corner,
              std::string_view tool, std::string_view allowance) {
  Pocket result;
  RectangularLevel& level = result.level;
  const Number inset_by = number(allowance);
  level.tool_radius = number(tool);
  level.area =
      rounded_rectangle(number(length) / Number(2) - inset_by, number(width) / Number(2) - inset_by,
                        exact::max(number(corner) - inset_by, level.tool_radius));
  level.sense = 1;
  level.tolerance = number("0.001");
  return result;
}

RoundedRectangle border_of(const Pocket& pocket) {
  return with_radius(pocket.level.area, pocket.level.area.radius - pocket.level.tool_radius);
}

void line_to(Pocket& pocket, const PlanePoint& to) {
  LevelMotion motion;
  motion.from = here(pocket);
  motion.to = to;
  motion.record = pocket.motions.size();
  pocket.motions.push_back(motion);
}

void arc_to(Pocket& pocket, const PlanePoint& to, const PlanePoint& centre, int rot) {
  line_to(pocket, to);
  pocket.motions.back().is_arc = true;
  pocket.motions.back().centre = centre;
  pocket.motions.back().rot = rot;
}

void go_round(Pocket& pocket, const RoundedRectangle& shape, int sense) {
  const Number& p = shape.core_p;
  const Number& q = shape.core_q;
  const Number& r = shape.radius;
  // Mirrored for clockwise.
  const auto at = [sense](const Number& x, const Number& y) {
    return PlanePoint{sense > 0 ? x : -x, y};
  };
  const PlanePoint ends[] = {at(p, -q - r), at(p + r, -q), at(p + r, q),   at(p, q + r),
                             at(-p, q + r), at(-p - r, q), at(-p - r, -q), at(-p, -q - r)};
  const PlanePoint centres[] = {at(p, -q), at(p, q), at(-p, q), at(-p, -q)};
  line_unless_there(pocket, at(Number(), -q - r));
  for (std::size_t k = 0; k < 4; ++k) {
    line_unless_there(pocket, ends[2 * k]);
    if (r.sign() > 0) arc_to(pocket, ends[2 * k + 1], centres[k], sense);
  }
  line_unless_there(pocket, at(Number(), -q - r));
}

void finish(Pocket& pocket) {
  go_round(pocket, border_of(pocket), pocket.level.sense);
}

void zigzag(Pocket& pocket, const Number& step) {
  const RoundedRectangle rows = inset(pocket, step / Number(2));
  const Number top = rows.core_q + rows.radius;
  bool right = false;
  for (Number q = -top;; q = exact::min(q + step, top), right = !right) {
    const Number half = half_at(rows, q);
    line_unless_there(pocket, {right ? half : -half, q});
    line_unless_there(pocket, {right ? -half : half, q});
    if (q == top) break;
  }
  finish(pocket);
}

void contour_parallel(Pocket& pocket, const Number& step) {
  const RoundedRectangle border = border_of(pocket);
  const Number count = (inner_radius(border) / step).floor();
  for (Number k = count; k.sign() > 0; k -= Number(1)) {
    if (const auto shape = eroded(border, k * step)) go_round(pocket, *shape, pocket.level.sense);
  }
  finish(pocket);
}

void trochoidal(Pocket& pocket, const Number& radius, const Number& step) {
  const RoundedRectangle middles = inset(pocket, radius + pocket.level.tolerance * Number(2));
  const Number top = middles.core_q + middles.radius;
  const Number spacing = radius * Number(3);
  for (Number q = -top;; q = exact::min(q + spacing, top)) {
    const Number half = half_at(middles, q);
    for (Number p = -half;; p = exact::min(p + step, half)) {
      line_unless_there(pocket, {p, q - radius});
      arc_to(pocket, {p, q + radius}, {p, q}, 1);
      arc_to(pocket, {p, q - radius}, {p, q}, 1);
      if (p == half) break;
    }
    if (q == top) break;
  }
  finish(pocket);
}

LevelVerdict judge(const Pocket& pocket) {
  return judge_level(pocket.level, pocket.motions);
}

}  // namespace gonogo::oracle::region
