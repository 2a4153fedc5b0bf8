// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/path.hpp"

#include <algorithm>

#include "oracle/motion/approximate.hpp"
#include "publish/report/curve.hpp"

namespace gonogo::oracle::report {
namespace {

using reference::Axis;
using reference::Position;
using reference::Record;
using reference::RecordKind;

// Far beyond every machine, and small enough that differences of squares stay finite.
constexpr double kFar = 1e9;

double coordinate(const reference::Number& value) {
  return std::clamp(oracle::approximate(value), -kFar, kFar);
}

std::string json_of(const Record& record) {
  std::string text;
  append_json(record, text);
  return text;
}

}  // namespace

Point3 approximate(const Position& position) {
  return {coordinate(position[Axis::x]), coordinate(position[Axis::y]),
          coordinate(position[Axis::z])};
}

PathSampler::PathSampler(const Position& start, std::size_t max_segments)
    : at_(start), here_(approximate(start)), segments_left_(max_segments) {}

std::vector<Point3> PathSampler::sample(const Record& record, const Point3& to) const {
  switch (record.kind) {
    case RecordKind::arc: {
      const ArcShape shape{
          record.plane, {coordinate(record.centre[0]), coordinate(record.centre[1])}, record.rot};
      return sample_arc(here_, to, shape, segments_left_);
    }
    case RecordKind::arc3: {
      Position via = at_;
      for (Axis axis : reference::kAllAxes) {
        if (record.via_axes.has(axis)) via[axis] = record.via[axis];
      }
      return sample_circle(here_, approximate(via), to, segments_left_);
    }
    default:
      return {here_, to};
  }
}

bool PathSampler::add(const Record& record, std::string text) {
  const bool motion = is_motion(record.kind);
  if (path_.motions.size() >= kMaxRecords || (motion && segments_left_ == 0)) {
    path_.cut = true;
    return false;
  }
  Motion& drawn = path_.motions.emplace_back();
  drawn.kind = name(record.kind);
  drawn.rapid = record.kind == RecordKind::rapid;
  drawn.block = record.block;
  drawn.clause = reference::clause_name(record.clause);
  drawn.text = text.empty() ? json_of(record) : std::move(text);
  if (!motion) {
    drawn.points = {here_};
    return true;
  }
  Position end = at_;
  for (Axis axis : reference::kAllAxes) {
    if (record.axes.has(axis)) end[axis] = record.to[axis];
  }
  const Point3 to = approximate(end);
  drawn.points = sample(record, to);
  at_ = end;
  segments_left_ -= std::min(segments_left_, drawn.points.size() - 1);
  here_ = to;
  return true;
}

void PathSampler::add_names(std::uint64_t block, const reference::CyclePlaces& places) {
  Names& names = path_.names.emplace_back();
  names.block = block;
  for (const auto& [letter, axis] : places.axes) names.axes.emplace(letter, "XYZAC"[index(axis)]);
  const auto add = [](auto& known, const auto& is_there, auto named) {
    const auto same = std::ranges::find_if(known, is_there);
    if (same == known.end()) {
      known.push_back(std::move(named));
    } else {
      same->name += ", " + named.name;
    }
  };
  for (const reference::NamedPlace& place : places.places) {
    const Point3 at = approximate(place.at);
    const std::string name(place.name);
    if (!place.across) {
      add(
          names.points, [&](const NamedPoint& point) { return point.at == at; },
          NamedPoint{name, at});
      continue;
    }
    const char axis = "XYZAC"[index(*place.across)];
    const double level = axis == 'X' ? at.x : axis == 'Y' ? at.y : at.z;
    add(
        names.planes,
        [&](const NamedPlane& plane) { return plane.axis == axis && plane.at == level; },
        NamedPlane{name, axis, level});
  }
}

void PathSampler::rename(const reference::Position& shift) {
  for (std::size_t i = 0; i < reference::kAxes; ++i) at_.at[i] += shift.at[i];
  here_ = approximate(at_);
}

void PathSampler::add_end(std::string_view kind, std::uint64_t block, std::string_view clause,
                          std::string text) {
  Motion& drawn = path_.motions.emplace_back();
  drawn.kind = kind;
  drawn.block = block;
  drawn.clause = clause;
  drawn.text = std::move(text);
  drawn.points = {here_};
}

Names names_in(const Path& path, std::uint64_t block) {
  const auto of_block = [&](const Names& names) { return block == 0 || names.block == block; };
  const auto found = std::ranges::find_if(path.names, of_block);
  return found != path.names.end() ? *found : Names();
}

}  // namespace gonogo::oracle::report
