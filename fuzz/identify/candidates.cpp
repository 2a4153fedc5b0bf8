// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace gonogo::identify {
namespace {

using Group = Candidates::Group;
using Row = std::vector<ReadingValue>;

// The rows of the group with only those columns that are, or are not, the one given; each once.
std::set<Row> columns(const Group& group, std::size_t column, bool only) {
  std::set<Row> rows;
  for (const Row& row : group.rows) {
    Row part;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if ((i == column) == only) part.push_back(row[i]);
    }
    rows.insert(std::move(part));
  }
  return rows;
}

Group product(const Group& a, const Group& b) {
  // Keys stay sorted: each takes its values from the side that it comes from.
  std::vector<std::pair<ReadingKey, std::pair<bool, std::size_t>>> from;
  for (std::size_t i = 0; i < a.keys.size(); ++i) from.push_back({a.keys[i], {true, i}});
  for (std::size_t i = 0; i < b.keys.size(); ++i) from.push_back({b.keys[i], {false, i}});
  std::ranges::sort(from);
  Group both;
  for (const auto& [key, place] : from) both.keys.push_back(key);
  for (const Row& x : a.rows) {
    for (const Row& y : b.rows) {
      Row& row = both.rows.emplace_back();
      for (const auto& [key, place] : from) {
        row.push_back(place.first ? x[place.second] : y[place.second]);
      }
    }
  }
  return both;
}

}  // namespace

bool Group::agrees(const Row& row, const PartialAssignment& with) const {
  return std::ranges::all_of(with, [&](const auto& entry) {
    const auto found = std::ranges::lower_bound(keys, entry.first);
    return row[static_cast<std::size_t>(found - keys.begin())] == entry.second;
  });
}

void Candidates::add(ReadingKey key, std::size_t values) {
  Group group{{key}, {}};
  for (std::size_t i = 0; i < values; ++i) group.rows.push_back({static_cast<ReadingValue>(i)});
  groups_.push_back(std::move(group));
}

std::vector<std::size_t> Candidates::groups_of(std::span<const ReadingKey> keys) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const bool has = std::ranges::any_of(groups_[i].keys, [&](ReadingKey key) {
      return std::ranges::find(keys, key) != keys.end();
    });
    if (has) found.push_back(i);
  }
  return found;
}

std::optional<Group> Candidates::joined(std::span<const ReadingKey> keys, std::size_t most) const {
  const std::vector<std::size_t> places = groups_of(keys);
  std::size_t rows = 1;
  for (const std::size_t place : places) {
    rows *= groups_[place].rows.size();
    if (rows > most) return std::nullopt;
  }
  Group all{{}, {{}}};
  for (const std::size_t place : places) all = product(all, groups_[place]);
  return all;
}

bool Candidates::keep(std::span<const ReadingKey> keys, std::span<const PartialAssignment> left,
                      std::size_t most) {
  Group group = joined(keys, most).value();
  std::erase_if(group.rows, [&](const Row& row) {
    return std::ranges::none_of(left, [&](const auto& one) { return group.agrees(row, one); });
  });
  if (group.rows.empty()) return false;
  std::vector<std::size_t> places = groups_of(keys);
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    groups_.erase(groups_.begin() + static_cast<std::ptrdiff_t>(*place));
  }
  put_apart(std::move(group));
  return true;
}

// A reading whose values do not depend on the rest becomes a group of its own again.
void Candidates::put_apart(Group group) {
  for (std::size_t i = 0; i < group.keys.size() && group.keys.size() > 1;) {
    const std::set<Row> own = columns(group, i, true);
    const std::set<Row> rest = columns(group, i, false);
    if (own.size() * rest.size() != group.rows.size()) {
      ++i;
      continue;
    }
    groups_.push_back({{group.keys[i]}, {own.begin(), own.end()}});
    group.keys.erase(group.keys.begin() + static_cast<std::ptrdiff_t>(i));
    group.rows.assign(rest.begin(), rest.end());
  }
  groups_.push_back(std::move(group));
}

std::vector<ReadingValue> Candidates::values(ReadingKey key) const {
  std::set<ReadingValue> values;
  for (const Group& group : groups_) {
    const auto found = std::ranges::find(group.keys, key);
    if (found == group.keys.end()) continue;
    const auto column = static_cast<std::size_t>(found - group.keys.begin());
    for (const Row& row : group.rows) values.insert(row[column]);
  }
  return {values.begin(), values.end()};
}

double Candidates::bits() const {
  double bits = 0;
  for (const Group& group : groups_) bits += std::log2(static_cast<double>(group.rows.size()));
  return bits;
}

}  // namespace gonogo::identify
