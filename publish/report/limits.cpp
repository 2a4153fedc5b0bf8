// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <numbers>

#include "oracle/motion/approximate.hpp"
#include "publish/report/figure.hpp"

namespace gonogo::oracle::report {
namespace {

using reference::Number;
using reference::Plane;

constexpr int kLimitSteps = 128;  // a turn
constexpr int kMostPasses = 8;    // of a thread that are drawn

// A plane at a coordinate of its depth axis.
struct Level {
  Plane plane;
  double depth;

  Point3 point(double p, double q) const {
    const reference::PlaneAxes axes = reference::axes_of(plane);
    Point3 at;
    at[axes.p] = p;
    at[axes.q] = q;
    at[axes.d] = depth;
    return at;
  }
};

Limit circle(Limit::Kind kind, const char* text, const Level& level,
             const std::array<Number, 2>& centre, double radius) {
  Limit limit{kind, text, {}};
  const double p = oracle::approximate(centre[0]);
  const double q = oracle::approximate(centre[1]);
  for (int i = 0; i <= kLimitSteps; ++i) {
    const double angle = 2 * std::numbers::pi * i / kLimitSteps;
    limit.points.push_back(level.point(p + radius * std::cos(angle), q + radius * std::sin(angle)));
  }
  return limit;
}

// A rectangle with round corners, turned.
struct Rectangle {
  double p, q, cosine, sine, length, width, corner;
};

Limit rectangle(Limit::Kind kind, const char* text, const Level& level, const Rectangle& shape) {
  Limit limit{kind, text, {}};
  const double half_length = shape.length / 2 - shape.corner;
  const double half_width = shape.width / 2 - shape.corner;
  constexpr int kQuarter = kLimitSteps / 4;
  constexpr std::array<std::array<double, 2>, 4> kCorners = {{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  const auto add = [&](double along, double across) {
    limit.points.push_back(level.point(shape.p + along * shape.cosine - across * shape.sine,
                                       shape.q + along * shape.sine + across * shape.cosine));
  };
  for (int corner = 0; corner < 4; ++corner) {
    const auto& [x, y] = kCorners[static_cast<std::size_t>(corner)];
    for (int i = 0; i <= kQuarter; ++i) {
      const double angle = std::numbers::pi / 2 * (corner + static_cast<double>(i) / kQuarter);
      add(x * half_length + shape.corner * std::cos(angle),
          y * half_width + shape.corner * std::sin(angle));
    }
  }
  limit.points.push_back(limit.points.front());
  return limit;
}

constexpr const char* kPocketBorder = "border of the pocket";
constexpr const char* kReach = "limit of the tool's centre";

struct Draw {
  std::vector<Limit> operator()(const reference::PocketLevel& pocket) const {
    const Level level{pocket.plane, oracle::approximate(pocket.depth)};
    const double radius = oracle::approximate(pocket.pocket_radius);
    const double tool = oracle::approximate(pocket.tool_radius);
    std::vector<Limit> limits = {
        circle(Limit::Kind::border, kPocketBorder, level, pocket.centre, radius),
        circle(Limit::Kind::reach, kReach, level, pocket.centre, radius - tool)};
    limits.front().level = PocketFloor{pocket.block, pocket.plane, level.depth, tool};
    return limits;
  }
  std::vector<Limit> operator()(const reference::HelixPocket& pocket) const {
    const double radius = oracle::approximate(pocket.radius);
    std::vector<Limit> limits;
    for (const Number& depth : {pocket.r_plane, pocket.bottom}) {
      limits.push_back(circle(Limit::Kind::reach, "circle of radius I - D",
                              {pocket.plane, oracle::approximate(depth)}, pocket.centre, radius));
    }
    return limits;
  }
  std::vector<Limit> operator()(const reference::ThreadMilling& thread) const {
    std::vector<Limit> limits;
    for (const Number& depth : {thread.r_plane, thread.bottom}) {
      const Level level{thread.plane, oracle::approximate(depth)};
      for (int pass = 1; pass <= kMostPasses; ++pass) {
        if (Number(pass) > thread.passes()) break;
        limits.push_back(circle(Limit::Kind::reach, "circle of a pass", level, thread.centre,
                                oracle::approximate(thread.radius_of_pass(Number(pass)))));
      }
    }
    return limits;
  }
  std::vector<Limit> operator()(const reference::PocketMilling& pocket) const {
    const Level level{pocket.plane, oracle::approximate(pocket.floor)};
    const double tool = oracle::approximate(pocket.tool_radius);
    Rectangle shape{
        oracle::approximate(pocket.centre[0]),    oracle::approximate(pocket.centre[1]),
        oracle::approximate(pocket.direction[0]), oracle::approximate(pocket.direction[1]),
        oracle::approximate(pocket.length),       oracle::approximate(pocket.width),
        oracle::approximate(pocket.corner_radius)};
    std::vector<Limit> limits = {rectangle(Limit::Kind::border, kPocketBorder, level, shape)};
    limits.front().level = PocketFloor{pocket.block, pocket.plane, level.depth, tool,
                                       oracle::approximate(pocket.reference_plane)};
    shape.length -= 2 * tool;
    shape.width -= 2 * tool;
    shape.corner -= tool;
    limits.push_back(rectangle(Limit::Kind::reach, kReach, level, shape));
    return limits;
  }
  template <typename Other>
  std::vector<Limit> operator()(const Other&) const {
    return {};
  }
};

}  // namespace

std::vector<Limit> limits_of(const reference::Item& item) {
  return std::visit(Draw{}, item);
}

}  // namespace gonogo::oracle::report
