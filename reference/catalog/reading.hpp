// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tables of readings are made of.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "reference/clause.hpp"

namespace gonogo::reference {

// The place of a reading in the table of all.
enum class ReadingKey : std::uint8_t {};

// The alternatives of a reading, six at most; the default, or the one that is shown, first.
class Alternatives {
 public:
  using value_type = std::string_view;
  using const_iterator = const std::string_view*;
  consteval Alternatives() = default;
  consteval Alternatives(std::initializer_list<std::string_view> values) : size_(values.size()) {
    std::copy(values.begin(), values.end(), values_.begin());
  }
  constexpr const_iterator begin() const { return values_.data(); }
  constexpr const_iterator end() const { return values_.data() + size_; }
  constexpr std::size_t size() const { return size_; }
  constexpr std::string_view front() const { return values_[0]; }
  constexpr std::string_view back() const { return values_[size_ - 1]; }
  constexpr const std::string_view& operator[](std::size_t place) const { return values_[place]; }

 private:
  std::array<std::string_view, 6> values_{};
  std::size_t size_ = 0;
};

struct Reading {
  std::string_view name;              // "gsk.pocket.end"
  Alternatives alternatives;          // without "any"
  std::string_view fallback = "any";  // the default: an alternative, a length or "any"
  bool by_properties = false;         // "any" is judged by what the path does, not by paths
  bool is_length = false;             // any decimal (mm) is an alternative
  ClauseId clause = kNoClause;
  std::string_view text;  // what the choice is about
  // What the tables below add: the dialect, a second one that has the reading, and the place.
  std::string_view dialect = {};
  std::string_view also = {};
  ReadingKey key = {};

  bool belongs_to(std::string_view name_of_dialect) const;
};

namespace catalog {

template <std::size_t kCount>
consteval std::array<Reading, kCount> of_dialect(std::string_view dialect,
                                                 std::array<Reading, kCount> table) {
  for (Reading& reading : table) reading.dialect = dialect;
  return table;
}

template <std::size_t kCount>
consteval std::array<Reading, kCount> of_dialect(std::string_view dialect, std::string_view also,
                                                 std::array<Reading, kCount> table) {
  for (Reading& reading : table) {
    reading.dialect = dialect;
    reading.also = also;
  }
  return table;
}

}  // namespace catalog
}  // namespace gonogo::reference
