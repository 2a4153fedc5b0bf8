// SPDX-License-Identifier: GPL-3.0-or-later
#include "metamorphic_trace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

namespace gonogo::reference::testing {
namespace {

struct SeenOf {
  Plane plane;

  Seen operator()(const Record& record) const {
    Seen seen;
    seen.record = record.kind;
    seen.block = record.block;
    seen.clause = record.clause;
    const PlaneAxes axes = axes_of(plane);
    const std::array<Axis, 3> pqd = {axes.p, axes.q, axes.d};
    for (std::size_t i = 0; i < 3; ++i) {
      seen.named[i] = record.axes.has(pqd[i]);
      if (seen.named[i]) seen.to[i] = record.to[pqd[i]];
    }
    EXPECT_TRUE(record.kind != RecordKind::arc || record.plane == plane);
    seen.centre = record.centre;
    seen.rot = record.rot;
    seen.feed = record.feed;
    seen.feed_mode = record.feed_mode;
    seen.seconds = record.seconds;
    seen.sizes = {record.lead, record.start};
    return seen;
  }
  Seen operator()(const PocketLevel& level) const {
    Seen seen = open_path(level);
    seen.depths = {level.depth};
    seen.sizes = {level.pocket_radius, level.step, level.tool_radius};
    return seen;
  }
  Seen operator()(const HelixPocket& pocket) const {
    Seen seen = open_path(pocket);
    seen.depths = {pocket.r_plane, pocket.bottom};
    seen.sizes = {pocket.radius, pocket.turns, pocket.flat ? 1 : 0};
    return seen;
  }
  Seen operator()(const ThreadMilling& thread) const {
    Seen seen = open_path(thread);
    seen.depths = {thread.r_plane, thread.bottom, thread.initial_plane};
    seen.sizes = {thread.lead,
                  thread.start_radius,
                  thread.height,
                  thread.infeed,
                  thread.runout_length,
                  thread.runout_angle,
                  thread.external ? 1 : 0,
                  thread.arc_path ? 1 : 0,
                  static_cast<int>(thread.runout)};
    return seen;
  }
  Seen operator()(const AlarmReport& report) const {
    Seen seen;
    seen.block = report.block;
    for (const Alarm& alarm : report.alarms) seen.alarms.emplace_back(alarm.alarm, alarm.clause);
    std::sort(seen.alarms.begin(), seen.alarms.end());
    return seen;
  }
  Seen operator()(const Renaming& renaming) const {
    Seen seen;
    seen.block = renaming.block;
    seen.named = {true, true, true};
    const PlaneAxes axes = axes_of(plane);
    seen.to = {renaming.shift[axes.p], renaming.shift[axes.q], renaming.shift[axes.d]};
    return seen;
  }
  template <typename Other>
  Seen operator()(const Other&) const {
    ADD_FAILURE() << "no item of these programs";
    return {};
  }

 private:
  template <typename Open>
  Seen open_path(const Open& open) const {
    Seen seen;
    seen.block = open.block;
    seen.clause = open.clause;
    EXPECT_EQ(open.plane, plane);
    seen.centre = open.centre;
    seen.rot = open.sense;
    seen.feed = open.feed;
    seen.feed_mode = open.feed_mode;
    return seen;
  }
};

}  // namespace

bool same_value(const Number& a, const Number& b) {
  if (a.form() != Number::Form::enclosure && b.form() != Number::Form::enclosure) return a == b;
  const auto [low, high] = (a - b).bounds(256);
  return low.sign() <= 0 && high.sign() >= 0;
}

bool operator==(const Seen& a, const Seen& b) {
  const auto exact = [](const Seen& seen) {
    return std::tie(seen.kind, seen.record, seen.block, seen.clause, seen.named, seen.rot,
                    seen.feed_mode, seen.alarms);
  };
  return exact(a) == exact(b) && same_values(a.to, b.to) && same_values(a.centre, b.centre) &&
         same_value(a.feed, b.feed) && same_value(a.seconds, b.seconds) &&
         same_values(a.depths, b.depths) && same_values(a.sizes, b.sizes);
}

Trace look(const std::string& program, const Profile& profile, Plane plane, OpenPaths open_paths) {
  Trace trace;
  for (const Item& item : expand(program, profile, open_paths)) {
    Seen seen = std::visit(SeenOf{plane}, item);
    seen.kind = static_cast<int>(item.index());
    trace.push_back(std::move(seen));
  }
  return trace;
}

Trace look(const Model& model, const Writing& writing, OpenPaths open_paths) {
  return look(text(write(model, writing)), machine(model, writing), writing.plane, open_paths);
}

}  // namespace gonogo::reference::testing
