// SPDX-License-Identifier: GPL-3.0-or-later
#include "changes.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace gonogo::relation {
namespace {

using reference::Axis;
using reference::Number;
using reference::Record;
using reference::RecordKind;

using Records = std::vector<Record>;
using Wanted = bool (*)(const Record&);

bool is_any(const Record& record) {
  return record.kind != RecordKind::end;
}
bool moves(const Record& record) {
  return is_motion(record.kind) && !record.axes.empty();
}
bool is_arc(const Record& record) {
  return record.kind == RecordKind::arc;
}
bool is_m(const Record& record) {
  return record.kind == RecordKind::m;
}

// The place of any record that is wanted; nothing where there is none.
std::optional<std::size_t> any(const Records& records, Wanted wanted, Chance& chance) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (wanted(records[i])) places.push_back(i);
  }
  if (places.empty()) return std::nullopt;
  return chance.one_of(places);
}

bool drop(Records& records, const Number&, Chance& chance) {
  const auto at = any(records, is_any, chance);
  if (at) records.erase(records.begin() + static_cast<std::ptrdiff_t>(*at));
  return at.has_value();
}

bool swap(Records& records, const Number&, Chance& chance) {
  const auto at = any(records, is_any, chance);
  if (!at || *at + 1 >= records.size() || !is_any(records[*at + 1])) return false;
  std::swap(records[*at], records[*at + 1]);
  return true;
}

bool shift(Records& records, const Number& tau, Chance& chance) {
  const auto at = any(records, moves, chance);
  if (!at) return false;
  Record& record = records[*at];
  for (std::size_t tries = 0; tries < 20; ++tries) {
    const Axis axis = chance.one_of(reference::kAllAxes);
    if (!record.axes.has(axis)) continue;
    record.to[axis] += chance.once_in(2) ? tau * 2 : tau * -2;
    return true;
  }
  return false;
}

bool relabel(Records& records, const Number&, Chance& chance) {
  const auto at = any(records, moves, chance);
  if (!at) return false;
  Record& record = records[*at];
  switch (chance.below(3)) {
    case 0:
      ++record.block;
      return true;
    case 1:
      if (record.kind == RecordKind::rapid) {
        record.kind = RecordKind::feed;
        record.feed = 100;
      } else if (record.kind == RecordKind::feed) {
        record.kind = RecordKind::rapid;
      } else {
        return false;
      }
      return true;
    default:
      if (record.kind == RecordKind::rapid) return false;
      (record.kind == RecordKind::thread ? record.lead : record.feed) += Number::millionths(20'000);
      return true;
  }
}

bool reverse(Records& records, const Number&, Chance& chance) {
  const auto at = any(records, is_arc, chance);
  if (at) records[*at].rot = -records[*at].rot;
  return at.has_value();
}

bool turn_more(Records& records, const Number&, Chance& chance) {
  const auto at = any(records, is_arc, chance);
  if (at) records[*at].rot += records[*at].rot < 0 ? -1 : 1;
  return at.has_value();
}

bool move_m(Records& records, const Number&, Chance& chance) {
  const auto at = any(records, is_m, chance);
  if (!at || records.size() < 2) return false;
  const Record record = records[*at];
  records.erase(records.begin() + static_cast<std::ptrdiff_t>(*at));
  const std::size_t low = *at < 3 ? 0 : *at - 3;
  const std::size_t high = std::min(records.size(), *at + 4);
  records.insert(records.begin() + static_cast<std::ptrdiff_t>(low + chance.below(high - low)),
                 record);
  return true;
}

}  // namespace

std::span<const Change> changes() {
  static constexpr std::array kChanges = {Change{"drop", drop},       Change{"swap", swap},
                                          Change{"shift", shift},     Change{"relabel", relabel},
                                          Change{"reverse", reverse}, Change{"turn", turn_more},
                                          Change{"move M", move_m}};
  return kChanges;
}

}  // namespace gonogo::relation
