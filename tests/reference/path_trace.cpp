// SPDX-License-Identifier: GPL-3.0-or-later
#include "path_trace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <tuple>

#include "gsk988ta/metamorphic_trace.hpp"

namespace gonogo::reference::testing {
namespace {

struct PathItemOf {
  PathItem operator()(const Record& record) const {
    PathItem item;
    item.record = record.kind;
    item.block = record.block;
    item.clause = record.clause;
    item.plane = record.plane;
    for (const Axis axis : kAllAxes) {
      item.named[index(axis)] = record.axes.has(axis);
      if (record.axes.has(axis)) item.to[index(axis)] = record.to[axis];
      if (record.via_axes.has(axis) && is_linear(axis)) item.via[index(axis)] = record.via[axis];
    }
    item.centre = record.centre;
    item.rot = record.rot;
    item.feed = record.feed;
    item.feed_mode = record.feed_mode;
    item.seconds = record.seconds;
    return item;
  }
  PathItem operator()(const AlarmReport& report) const {
    PathItem item;
    item.block = report.block;
    for (const Alarm& alarm : report.alarms) item.alarms.emplace_back(alarm.alarm, alarm.clause);
    std::sort(item.alarms.begin(), item.alarms.end());
    return item;
  }
  template <typename Other>
  PathItem operator()(const Other&) const {
    ADD_FAILURE() << "no item of these programs";
    return {};
  }
};

PathItem changed(const PathItem& old, const AxesChange& change) {
  PathItem item = old;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t to = change.axis[i];
    item.named[to] = old.named[i];
    item.to[to] = old.named[i] ? change.coordinate(i, old.to[i]) : 0;
    if (old.record == RecordKind::arc3) item.via[to] = change.coordinate(i, old.via[i]);
  }
  if (old.record != RecordKind::arc) return item;
  const PlaneAxes axes = axes_of(old.plane);
  item.plane = change.plane(old.plane);
  item.rot = old.rot * change.sense(old.plane);
  item.centre = {change.coordinate(index(axes.p), old.centre[0]),
                 change.coordinate(index(axes.q), old.centre[1])};
  if (!change.in_order(old.plane)) std::swap(item.centre[0], item.centre[1]);
  return item;
}

}  // namespace

bool operator==(const PathItem& a, const PathItem& b) {
  const auto exact = [](const PathItem& item) {
    return std::tie(item.kind, item.record, item.block, item.clause, item.plane, item.named,
                    item.rot, item.feed_mode, item.alarms);
  };
  return exact(a) == exact(b) && same_values(a.to, b.to) && same_values(a.via, b.via) &&
         same_values(a.centre, b.centre) && same_value(a.feed, b.feed) &&
         same_value(a.seconds, b.seconds);
}

std::ostream& operator<<(std::ostream& out, const PathTrace& trace) {
  for (const PathItem& item : trace) {
    out << "\n" << item.block << " " << name(item.record) << " " << clause_name(item.clause);
    for (const Axis axis : kAllAxes) {
      if (item.named[index(axis)]) out << " " << letter(axis) << item.to[index(axis)].text();
    }
    if (item.record == RecordKind::arc) {
      out << " plane " << static_cast<int>(item.plane) << " centre " << item.centre[0].text()
          << ", " << item.centre[1].text() << " rot " << item.rot;
    }
    if (item.record == RecordKind::arc3) {
      out << " via " << item.via[0].text() << ", " << item.via[1].text() << ", "
          << item.via[2].text();
    }
    out << " f" << item.feed.text();
    for (const auto& [alarm, clause] : item.alarms) {
      out << " " << name(alarm) << " " << clause_name(clause);
    }
  }
  return out;
}

PathItem path_item(const Item& item) {
  PathItem seen = std::visit(PathItemOf{}, item);
  seen.kind = static_cast<int>(item.index());
  return seen;
}

PathTrace path_trace(const std::string& program, const Profile& profile) {
  PathTrace trace;
  for (const Item& item : expand(program, profile)) trace.push_back(path_item(item));
  return trace;
}

PathTrace changed(PathTrace trace, const AxesChange& change) {
  for (PathItem& item : trace) item = changed(item, change);
  return trace;
}

PathTrace motions_of(PathTrace trace) {
  std::erase_if(trace, [](const PathItem& item) {
    return item.kind != static_cast<int>(Item{Record{}}.index()) || !is_motion(item.record);
  });
  return trace;
}

PathTrace without_blocks(PathTrace trace) {
  for (PathItem& item : trace) item.block = 0;
  return trace;
}

PathTrace without_clauses(PathTrace trace) {
  for (PathItem& item : trace) {
    item.clause = kNoClause;
    for (auto& [alarm, clause] : item.alarms) clause = kNoClause;
  }
  return trace;
}

PathTrace reversed(const PathTrace& trace, const Vector& start) {
  PathTrace motions = without_blocks(motions_of(trace));
  std::array<Number, kAxes> from;
  for (std::size_t i = 0; i < 3; ++i) from[i] = Number(start[i]) / 1'000;
  for (PathItem& item : motions) {
    std::array<Number, kAxes> end = from;
    for (std::size_t i = 0; i < kAxes; ++i) {
      if (!item.named[i]) continue;
      end[i] = item.to[i];
      item.to[i] = from[i];
    }
    item.rot = -item.rot;
    from = end;
  }
  std::reverse(motions.begin(), motions.end());
  return motions;
}

}  // namespace gonogo::reference::testing
