// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which values the readings may still have. Readings that depend on one another stand in one group
// with the rows of values that are left; groups are independent of each other, so that 2^30
// combinations are thirty short lists until a program makes some of them dependent.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "reference/reading.hpp"

namespace gonogo::identify {

using reference::Reading;
using reference::ReadingKey;

// The place of a value among the reading's alternatives.
using ReadingValue = std::uint8_t;

// Values of some readings; the others do not matter. Sorted by key.
using PartialAssignment = std::vector<std::pair<ReadingKey, ReadingValue>>;

class Candidates {
 public:
  struct Group {
    std::vector<ReadingKey> keys;  // sorted
    std::vector<std::vector<ReadingValue>> rows;

    // Whether the row agrees with the partial combination, whose keys are all of the group.
    bool agrees(const std::vector<ReadingValue>& row, const PartialAssignment& with) const;
  };

  // A reading with `values` values.
  void add(ReadingKey key, std::size_t values);

  // The readings that `keys` are tied to, as one group of at most `most` rows. Nothing: more.
  std::optional<Group> joined(std::span<const ReadingKey> keys, std::size_t most) const;
  // Keeps what agrees with one of the partial combinations. False, with nothing changed, where
  // nothing would be left. REQUIRES: joined(keys, most) gives a group.
  bool keep(std::span<const ReadingKey> keys, std::span<const PartialAssignment> left,
            std::size_t most);

  // The values that the reading may still have, in order.
  std::vector<ReadingValue> values(ReadingKey key) const;
  // The logarithm to base 2 of the number of combinations left; for people.
  double bits() const;

 private:
  std::vector<std::size_t> groups_of(std::span<const ReadingKey> keys) const;
  void put_apart(Group group);

  std::vector<Group> groups_;
};

}  // namespace gonogo::identify
