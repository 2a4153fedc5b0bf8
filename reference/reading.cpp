// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/reading.hpp"

#include <algorithm>

namespace gonogo::reference {
namespace {

const std::vector<Reading>& table() {
  static const std::vector<Reading> kTable = {
      {ReadingKey::g94_rewrite,
       "gsk.g94.rewrite",
       "gsk988ta",
       {"keep", "clear"},
       "keep",
       false,
       false,
       "GSK-G94-06"_clause,
       "R when G94 is written again without it: kept, or cleared"},
      {ReadingKey::g94_after_00,
       "gsk.g94.after-00",
       "gsk988ta",
       {"stays", "cancelled"},
       "stays",
       false,
       false,
       "GSK-G94-07"_clause,
       "G94 itself after a code of group 00 that clears its words: it stays, or is cancelled"},
      {ReadingKey::g94_empty_block,
       "gsk.g94.empty-block",
       "gsk988ta",
       {"none", "repeat"},
       "none",
       false,
       false,
       "GSK-G94-12"_clause,
       "a block of words without axis and R while G94 is in force: no cycle, or the cycle again"},
      {ReadingKey::pocket_path,
       "gsk.pocket.path",
       "gsk988ta",
       {"semicircles", "concentric"},
       "any",
       true,
       false,
       "GSK-G110-09"_clause,
       "the path that clears a layer: judged by what it clears, or one of two given paths"},
      {ReadingKey::pocket_end,
       "gsk.pocket.end",
       "gsk988ta",
       {"initial", "r-plane"},
       "initial",
       false,
       false,
       "GSK-G110-13"_clause,
       "where the tool ends: at the initial or at the R plane"},
      {ReadingKey::pocket_p_omitted,
       "gsk.pocket.p-omitted",
       "gsk988ta",
       {"0"},
       "0",
       false,
       true,
       "GSK-G110-11"_clause,
       "the clearance where P is omitted, mm"},
      {ReadingKey::pocket_pair,
       "gsk.pocket.pair",
       "gsk988ta",
       {"shared", "each"},
       "shared",
       false,
       false,
       "GSK-MOD-01"_clause,
       "I L Q D between G110 and G111: shared, or to be given again on each change"},
      {ReadingKey::pocket_r,
       "gsk.pocket.R",
       "gsk988ta",
       {"per-block", "modal"},
       "per-block",
       false,
       false,
       "GSK-MOD-03"_clause,
       "R and P: for their block, or retained in the mode"},
      {ReadingKey::missing_axis,
       "gsk.missing-axis",
       "gsk988ta",
       {"skip", "position"},
       "skip",
       false,
       false,
       "GSK-G110-14"_clause,
       "a block that lacks one of the three axes: nothing moves, or its plane axes are positioned"},
      {ReadingKey::zero_depth,
       "gsk.zero-depth",
       "gsk988ta",
       {"no-cut", "alarm"},
       "no-cut",
       false,
       false,
       "GSK-G110-17"_clause,
       "a pocket without depth: positioned over, or an alarm"},
      {ReadingKey::x_depth,
       "gsk.x-depth",
       "gsk988ta",
       {"diameter", "radius"},
       "diameter",
       false,
       false,
       "GSK-G110-18"_clause,
       "X and U as depth words of G19: diameters, or true lengths"},
      {ReadingKey::decimals,
       "gsk.decimals",
       "gsk988ta",
       {"keep", "nearest", "alarm"},
       "keep",
       false,
       false,
       "GSK-COM-03"_clause,
       "more decimals than the least increment: kept, rounded to nearest, or an alarm"},
      {ReadingKey::duplicate,
       "gsk.duplicate",
       "gsk988ta",
       {"alarm", "last"},
       "alarm",
       false,
       false,
       "GSK-COM-07"_clause,
       "an address or group of codes twice: an alarm, or the last one wins"},
  };
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
