// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/reading.hpp"

#include <algorithm>

#include "reference/reading_literal.hpp"

namespace gonogo::reference {
std::span<const Reading> readings() {
  return catalog::kReadings;
}

const Reading& reading(ReadingKey key) {
  return catalog::kReadings[index(key)];
}

const Reading* find_reading(std::string_view name) {
  auto found = std::ranges::find(catalog::kReadings, name, &Reading::name);
  return found == catalog::kReadings.end() ? nullptr : &*found;
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
  static const std::array<Place, kMostReadings> kDefaults = [] {
    std::array<Place, kMostReadings> places{};
    for (const Reading& reading : catalog::kReadings) {
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
  put(key, place);
  if (place != kOwnText) return;
  texts_.emplace(std::ranges::lower_bound(texts_, key, {}, &OwnText::first), key, value);
}

void ReadingChoice::put(ReadingKey key, Place place) {
  places_[index(key)] = place;
  std::erase_if(texts_, [&](const OwnText& own) { return own.first == key; });
}

ReadingChoice ReadingChoice::shown() const {
  static const std::array<bool, kReadings> kOpen = [] {
    std::array<bool, kReadings> open{};
    for (const Reading& reading : catalog::kReadings)
      open[index(reading.key)] = !reading.by_properties;
    return open;
  }();
  ReadingChoice choice = *this;
  for (std::size_t i = 0; i < kReadings; ++i) {
    if (kOpen[i] && choice.places_[i] == kAny) choice.places_[i] = kFirst;
  }
  return choice;
}

exact::Number ReadingsInUse::length(ReadingKey key) const {
  touch(key);
  return exact::Number::parse(shown_.get(key)).value();
}

std::vector<ReadingKey> ReadingsInUse::touched() const {
  std::vector<ReadingKey> keys;
  for (const Reading& reading : catalog::kReadings) {
    if (touched_[index(reading.key)]) keys.push_back(reading.key);
  }
  return keys;
}

}  // namespace gonogo::reference
