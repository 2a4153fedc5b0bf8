// SPDX-License-Identifier: GPL-3.0-or-later
#include "alternative.hpp"

#include <algorithm>
#include <cmath>

namespace gonogo::mutations {

using reference::Axis;
using reference::Position;

std::vector<Position> Attempt::starts() const {
  std::vector<Position> all;
  Position here = profile.initial.at;
  std::size_t named = 0;
  const auto& renamings = specimen.renamings;
  for (const Record& record : trace.records) {
    // Where blocks are not known, as many records before each as in the right trace.
    for (; named < renamings.size() && record.block > renamings[named].block; ++named) {
      for (const Axis axis : reference::kAllAxes) here[axis] += renamings[named].shift[axis];
    }
    all.push_back(here);
    if (!is_motion(record.kind)) continue;
    for (const Axis axis : reference::kAllAxes) {
      if (record.axes.has(axis)) here[axis] = record.to[axis];
    }
  }
  return all;
}

bool Attempt::replace(const Make& make) {
  const std::vector<Position> from = starts();
  std::vector<Record> records;
  bool changed = false;
  for (std::size_t i = 0; i < trace.records.size(); ++i) {
    std::vector<Record> made = make(trace.records[i], from[i]);
    changed = changed || !made.empty();
    if (made.empty()) made.push_back(trace.records[i]);
    std::ranges::move(made, std::back_inserter(records));
  }
  trace.records = std::move(records);
  return changed;
}

Number number_near(double value) {
  constexpr double kBillion = 1e9;
  return Number::millionths(std::llround(value * kBillion)) / 1000;
}

std::vector<Alternative> all_alternatives() {
  std::vector<Alternative> all;
  for (auto family : {splitting_alternatives, wording_alternatives, open_alternatives}) {
    std::ranges::move(family(), std::back_inserter(all));
  }
  return all;
}

}  // namespace gonogo::mutations
