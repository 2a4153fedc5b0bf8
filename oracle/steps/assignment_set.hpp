// SPDX-License-Identifier: GPL-3.0-or-later
//
// The combinations of open readings that one run of the reference stands for.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "reference/profile.hpp"

namespace gonogo::oracle {

// A reading is open when the profile says "any" for it and it is not judged by properties. The set
// holds each way to choose one value for every open reading.
class AssignmentSet {
 public:
  // All that the profile leaves open.
  explicit AssignmentSet(const reference::Profile& profile);

  // The readings of the dialect that may be open.
  std::span<const reference::ReadingKey> openable() const { return *openable_; }
  bool leaves_open() const;
  // The values of an open reading; a run takes the first. Empty for a reading that is not open.
  std::span<const std::string_view> values(reference::ReadingKey key) const;
  // What a run takes.
  reference::ReadingChoice taken() const;

  // The set with that value of the reading alone; without it. REQUIRES: it is one of its values.
  AssignmentSet with(reference::ReadingKey key, std::string_view value) const;
  void leave_out(reference::ReadingKey key, std::string_view value);

  // Each combination; a reading that has all its values left stays open in it.
  std::vector<reference::ReadingChoice> choices() const;
  // The readings of which not all are left.
  std::vector<reference::ReadingKey> settled() const;

 private:
  struct Left {
    reference::ReadingKey key;
    std::vector<std::string_view> values;
  };
  const Left* find(reference::ReadingKey key) const;
  std::vector<std::string_view>& left_of(reference::ReadingKey key);

  reference::ReadingChoice choice_;
  const std::vector<reference::ReadingKey>* openable_;
  std::vector<Left> left_;  // where not all are left
};

}  // namespace gonogo::oracle
