// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/idle.hpp"

namespace gonogo::reference::rs274 {
namespace {

bool does_something(const Record& record, const Position& at) {
  if (record.kind == RecordKind::dwell) return record.seconds.sign() != 0;
  if (!is_motion(record.kind)) return true;
  for (const Axis axis : kLinearAxes) {
    if (record.axes.has(axis) && record.to[axis] != at[axis]) return true;
  }
  return false;
}

}  // namespace

Generator<Item> without_idle(Generator<Item> items, Position at) {
  while (const Item* item = items.next()) {
    const auto& record = std::get<Record>(*item);
    if (!does_something(record, at)) continue;
    for (const Axis axis : kLinearAxes) {
      if (record.axes.has(axis)) at[axis] = record.to[axis];
    }
    co_yield *item;
  }
}

}  // namespace gonogo::reference::rs274
