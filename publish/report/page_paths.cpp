// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/page_paths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "publish/report/curve.hpp"

namespace gonogo::oracle::report {
namespace {

using Cell = std::array<long long, 3>;

constexpr int kRapidMove = 1;
constexpr int kElsewhere = 2;
constexpr int kThreadMove = 4;

Cell cell_of(const Point3& point) {
  constexpr double kUnit = 1e4;  // of a mm
  return {std::llround(point.x * kUnit), std::llround(point.y * kUnit),
          std::llround(point.z * kUnit)};
}

void append_step(Json& out, const Cell& from, const Cell& to) {
  for (std::size_t i = 0; i < 3; ++i) out.push_back(to[i] - from[i]);
}

}  // namespace

Json moves_json(const Path& path, std::size_t steps_of_turn) {
  const std::size_t stride = std::max<std::size_t>(
      1, static_cast<std::size_t>(kStepsPerTurn) / std::max<std::size_t>(1, steps_of_turn));
  Json list = Json::array();
  std::optional<Cell> at;
  for (const Motion& motion : path.motions) {
    Json move = Json::array();
    if (motion.moves()) {
      const Cell first = cell_of(motion.points.front());
      const bool elsewhere = !at || *at != first;
      move.push_back((motion.rapid ? kRapidMove : 0) + (elsewhere ? kElsewhere : 0) +
                     (motion.is_thread() ? kThreadMove : 0));
      if (elsewhere) append_step(move, {}, first);
      Cell last = first;
      for (std::size_t i = 1; i < motion.points.size(); ++i) {
        if (i % stride != 0 && i + 1 != motion.points.size()) continue;
        const Cell next = cell_of(motion.points[i]);
        append_step(move, last, next);
        last = next;
      }
      at = last;
    }
    list.push_back(std::move(move));
  }
  return list;
}

Json limits_json(const std::vector<Limit>& limits) {
  Json list = Json::array();
  for (const Limit& limit : limits) {
    Json points = Json::array();
    Cell last{};
    for (std::size_t i = 0; i < limit.points.size(); ++i) {
      if (i % 2 == 1 && i + 1 != limit.points.size()) continue;
      const Cell next = cell_of(limit.points[i]);
      append_step(points, last, next);
      last = next;
    }
    Json one = {{"kind", limit.kind == Limit::Kind::border ? "border" : "reach"},
                {"text", limit.text},
                {"points", points}};
    if (limit.level) {
      const reference::PlaneAxes axes = reference::axes_of(limit.level->plane);
      one["tool"] = limit.level->tool_radius;
      one["axes"] = Json::array({index(axes.p), index(axes.q)});
    }
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace gonogo::oracle::report
