// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/raster.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace gonogo::relation {

namespace {

__extension__ using Wide = __int128;

constexpr int kBits = 28;  // of a coordinate: products of four stay below 128 bits

Wide square_of(const Point& a) {
  return Wide{a.p} * a.p + Wide{a.q} * a.q;
}
Point minus(const Point& a, const Point& b) {
  return {a.p - b.p, a.q - b.q};
}

}  // namespace

bool is_within(const Point& place, const Stroke& stroke, std::int64_t reach) {
  const auto is_off = [reach](std::int64_t at, std::int64_t a, std::int64_t b) {
    return at < std::min(a, b) - reach || at > std::max(a, b) + reach;
  };
  if (reach < 0 || is_off(place.p, stroke.from.p, stroke.to.p) ||
      is_off(place.q, stroke.from.q, stroke.to.q)) {
    return false;
  }
  const Wide reach_2 = Wide{reach} * reach;
  const Point way = minus(stroke.to, stroke.from);
  const Point off = minus(place, stroke.from);
  const Wide along = Wide{way.p} * off.p + Wide{way.q} * off.q;
  if (along <= 0) return square_of(off) <= reach_2;
  const Wide length_2 = square_of(way);
  if (along >= length_2) return square_of(minus(place, stroke.to)) <= reach_2;
  const Wide across = Wide{way.p} * off.q - Wide{way.q} * off.p;
  return across * across <= reach_2 * length_2;
}

Raster::Raster(const Number& extent) {
  int bits = 40;
  const Number most = Number::binary(1, kBits);
  while (bits > 0 && extent * Number::binary(1, bits) > most) --bits;
  scale_ = Number::binary(1, bits);
}

std::int64_t Raster::length(const Number& number) const {
  return (number * scale_).floor().to_int64().value();
}

bool Box::meets(const Point& at, std::int64_t half) const {
  const std::int64_t p = std::max<std::int64_t>(std::abs(at.p) - half - (half_p - corner), 0);
  const std::int64_t q = std::max<std::int64_t>(std::abs(at.q) - half - (half_q - corner), 0);
  return Wide{p} * p + Wide{q} * q <= Wide{corner} * corner;
}

bool Box::has(const Point& at, std::int64_t half) const {
  return half_p >= 0 && half_q >= 0 && meets({std::abs(at.p) + half, std::abs(at.q) + half}, 0);
}

namespace {

bool meets(const Region& region, const Point& at, std::int64_t half) {
  return region.outer.meets(at, half) && !(region.inner && region.inner->has(at, half));
}
bool meets(const Stadium& stadium, const Point& at, std::int64_t half) {
  return is_within(at, stadium.stroke, stadium.reach + half * 3 / 2 + 1);
}

// What strokes may be off leaves open what is smaller than half of it. Where next to nothing may be
// off, halving has to end all the same: so often a square is held against a stroke.
constexpr std::int64_t kMostTrials = 1 << 25;

template <typename Area>
Said said_of(const Cover& cover, const Area& area, const Point& at, std::int64_t half,
             std::int64_t& trials, std::span<const Stroke> path) {
  if (!meets(area, at, half) || (cover.cleared && cover.cleared->has(at, half))) return Said::yes;
  const std::int64_t diagonal = half * 3 / 2 + 1;
  std::vector<Stroke> candidates;
  candidates.reserve(path.size());
  trials -= static_cast<std::int64_t>(path.size()) + 1;
  bool is_reached = cover.cleared && cover.cleared->has(at, 0);
  for (const Stroke& stroke : path) {
    if (!is_within(at, stroke, cover.reach + cover.slack + diagonal)) continue;
    if (is_within(at, stroke, cover.reach - cover.slack - diagonal)) return Said::yes;
    is_reached = is_reached || is_within(at, stroke, cover.reach + cover.slack);
    candidates.push_back(stroke);
  }
  if (!is_reached && meets(area, at, 0)) return Said::no;
  if (half <= std::max(cover.raster, cover.slack / 2) || trials < 0) return Said::near;
  const std::int64_t quarter = (half + 1) / 2;
  Said all = Said::yes;
  for (const Point& part : {Point{-quarter, -quarter}, Point{quarter, -quarter},
                            Point{-quarter, quarter}, Point{quarter, quarter}}) {
    const Said said = said_of(cover, area, {at.p + part.p, at.q + part.q}, quarter, trials,
                              std::span<const Stroke>(candidates));
    if (said == Said::no) return said;
    if (said == Said::near) all = said;
  }
  return all;
}

}  // namespace

Said Cover::of(const Region& region) const {
  const std::int64_t half = std::max(region.outer.half_p, region.outer.half_q);
  std::int64_t trials = kMostTrials;
  return half < 0 ? Said::yes : said_of(*this, region, {}, half, trials, path);
}

Said Cover::of(const Stadium& stadium) const {
  const auto [from, to] = stadium.stroke;
  const std::int64_t half =
      std::max(std::abs(to.p - from.p), std::abs(to.q - from.q)) / 2 + stadium.reach + 1;
  std::int64_t trials = kMostTrials;
  return said_of(*this, stadium, {(from.p + to.p) / 2, (from.q + to.q) / 2}, half, trials, path);
}

}  // namespace gonogo::relation
