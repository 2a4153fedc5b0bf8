// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/reading.hpp"

#include <algorithm>

#include "reference/catalog/gsk988ta_readings.hpp"
#include "reference/catalog/hnc21t_readings.hpp"
#include "reference/catalog/rs274_cycle_readings.hpp"
#include "reference/catalog/rs274_readings.hpp"
#include "reference/catalog/sinumerik_readings.hpp"

namespace gonogo::reference {
namespace {

const std::vector<Reading>& table() {
  static const std::vector<Reading> kTable = [] {
    std::vector<Reading> all = catalog::gsk988ta_readings();
    for (const auto& more : {catalog::hnc21t_readings(), catalog::rs274_readings(),
                             catalog::rs274_cycle_readings(), catalog::sinumerik_readings()}) {
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
  if (reading.is_length && value != "any") {
    auto number = exact::Number::parse(value);
    return number && number->is_rational() && number->sign() >= 0;
  }
  return value == "any" ||
         std::ranges::find(reading.alternatives, value) != reading.alternatives.end();
}

ReadingChoice::Place ReadingChoice::place_of(const Reading& reading, std::string_view value) {
  if (value == "any") return kAny;
  auto found = std::ranges::find(reading.alternatives, value);
  if (found != reading.alternatives.end()) {
    return static_cast<Place>(kFirst + (found - reading.alternatives.begin()));
  }
  return value == reading.fallback ? kFallback : kOwnText;
}

ReadingChoice::ReadingChoice() {
  static const std::array<Place, kReadings> kDefaults = [] {
    std::array<Place, kReadings> places{};
    for (const Reading& reading : table()) {
      places[index(reading.key)] = place_of(reading, reading.fallback);
    }
    return places;
  }();
  places_ = kDefaults;
}

std::string_view ReadingChoice::get(ReadingKey key) const {
  const Place place = places_[index(key)];
  if (place == kAny) return "any";
  if (place == kOwnText) return std::ranges::find(texts_, key, &OwnText::first)->second;
  const Reading& its = reading(key);
  return place == kFallback ? its.fallback : its.alternatives[place - kFirst];
}

void ReadingChoice::set(ReadingKey key, std::string_view value) {
  const Place place = place_of(reading(key), value);
  places_[index(key)] = place;
  auto own = std::ranges::lower_bound(texts_, key, {}, &OwnText::first);
  if (own != texts_.end() && own->first == key) own = texts_.erase(own);
  if (place == kOwnText) texts_.emplace(own, key, value);
}

ReadingChoice ReadingChoice::shown() const {
  static const std::array<bool, kReadings> kOpen = [] {
    std::array<bool, kReadings> open{};
    for (const Reading& reading : table()) open[index(reading.key)] = !reading.by_properties;
    return open;
  }();
  ReadingChoice choice = *this;
  for (std::size_t i = 0; i < kReadings; ++i) {
    if (kOpen[i] && choice.places_[i] == kAny) choice.places_[i] = kFirst;
  }
  return choice;
}

bool ReadingsInUse::is(ReadingKey key, std::string_view alternative) const {
  touch(key);
  return shown_.is(key, alternative);
}

exact::Number ReadingsInUse::length(ReadingKey key) const {
  touch(key);
  return exact::Number::parse(shown_.get(key)).value();
}

std::vector<ReadingKey> ReadingsInUse::touched() const {
  std::vector<ReadingKey> keys;
  for (const Reading& reading : table()) {
    if (touched_[index(reading.key)]) keys.push_back(reading.key);
  }
  return keys;
}

}  // namespace gonogo::reference
