// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/relations/operation_path.hpp"

#include <algorithm>

#include "oracle/steps/step_text.hpp"

namespace gonogo::relations {
namespace {

using reference::Axis;
using reference::Position;
using reference::Record;
using reference::RecordKind;

bool same_place(const Position& a, const Position& b, const Number& tolerance) {
  return std::ranges::all_of(reference::kAllAxes,
                             [&](Axis axis) { return is_near(a[axis], b[axis], tolerance); });
}

bool same(const Leg& a, const Leg& b, const Number& tolerance) {
  const Record& x = a.record;
  const Record& y = b.record;
  if (x.kind != y.kind || !same_place(a.to, b.to, tolerance)) return false;
  if (x.kind == RecordKind::dwell) return is_near(x.seconds, y.seconds, 0);
  const bool is_fed = x.kind == RecordKind::feed || x.kind == RecordKind::arc;
  if (is_fed && (!is_near(x.feed, y.feed, 0) || x.feed_mode != y.feed_mode)) return false;
  return x.kind != RecordKind::arc ||
         (x.plane == y.plane && x.rot == y.rot && is_near(x.centre[0], y.centre[0], tolerance) &&
          is_near(x.centre[1], y.centre[1], tolerance));
}

}  // namespace

std::vector<Leg> legs_of(const Trace& trace, const Position& start) {
  std::vector<Leg> legs;
  Position at = start;
  for (const Record& record : trace.records) {
    Leg leg{record, at, at};
    if (record.kind == RecordKind::dwell) {
      if (!is_near(record.seconds, 0, 0)) legs.push_back(std::move(leg));
      continue;
    }
    if (!is_motion(record.kind)) continue;
    for (const Axis axis : reference::kAllAxes) {
      if (record.axes.has(axis)) leg.to[axis] = record.to[axis];
    }
    at = leg.to;
    const bool is_nil = same_place(leg.from, leg.to, 0) && record.kind != RecordKind::arc;
    if (!is_nil) legs.push_back(std::move(leg));
  }
  return legs;
}

std::optional<PathDifference> first_difference(const std::vector<Leg>& first,
                                               const std::vector<Leg>& second,
                                               const Number& tolerance) {
  for (std::size_t i = 0; i < std::max(first.size(), second.size()); ++i) {
    const Leg* const want = i < first.size() ? &first[i] : nullptr;
    const Leg* const got = i < second.size() ? &second[i] : nullptr;
    if (want != nullptr && got != nullptr && same(*want, *got, tolerance)) continue;
    return PathDifference{i + 1,
                          want == nullptr ? std::string() : oracle::record_text(want->record),
                          got == nullptr ? std::string() : oracle::record_text(got->record),
                          got == nullptr ? 0 : got->record.block};
  }
  return std::nullopt;
}

}  // namespace gonogo::relations
