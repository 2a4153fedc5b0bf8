// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/reading.hpp"

#include <algorithm>

#include "reference/catalog/gsk988ta_readings.hpp"
#include "reference/catalog/hnc21t_readings.hpp"
#include "reference/catalog/rs274_readings.hpp"
#include "reference/catalog/sinumerik_readings.hpp"

namespace gonogo::reference {
namespace {

const std::vector<Reading>& table() {
  static const std::vector<Reading> kTable = [] {
    std::vector<Reading> all = catalog::gsk988ta_readings();
    for (const auto& more : {catalog::hnc21t_readings(), catalog::rs274_readings(),
                             catalog::sinumerik_readings()}) {
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  }();
  return kTable;
}

}  // namespace

std::span<const Reading> readings() {
  return table();
}

const Reading& reading(ReadingKey key) {
  return table()[index(key)];
}

const Reading* find_reading(std::string_view name) {
  auto found = std::ranges::find(table(), name, &Reading::name);
  return found == table().end() ? nullptr : &*found;
}

bool Reading::belongs_to(std::string_view name_of_dialect) const {
  return dialect == name_of_dialect || also == name_of_dialect;
}

bool admits(const Reading& reading, std::string_view value) {
  if (reading.is_length) {
    auto number = exact::Number::parse(value);
    return number && number->is_rational() && number->sign() >= 0;
  }
  return value == "any" ||
         std::ranges::find(reading.alternatives, value) != reading.alternatives.end();
}

ReadingChoice::ReadingChoice() {
  for (const Reading& reading : table()) set(reading.key, reading.fallback);
}

ReadingsInUse::ReadingsInUse(const ReadingChoice& choice) : choice_(choice) {
  for (const Reading& reading : table()) {
    std::string_view value = choice.get(reading.key);
    bool shown = value == "any" && !reading.by_properties;
    effective_[index(reading.key)] = shown ? reading.alternatives.front() : value;
  }
}

bool ReadingsInUse::is(ReadingKey key, std::string_view alternative) const {
  touched_[index(key)] = true;
  return effective_[index(key)] == alternative;
}

exact::Number ReadingsInUse::length(ReadingKey key) const {
  touched_[index(key)] = true;
  return exact::Number::parse(choice_.get(key)).value();
}

std::vector<ReadingKey> ReadingsInUse::touched() const {
  std::vector<ReadingKey> keys;
  for (const Reading& reading : table()) {
    if (touched_[index(reading.key)]) keys.push_back(reading.key);
  }
  return keys;
}

}  // namespace gonogo::reference
