// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/gsk988ta/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "reference/clause_literal.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

constexpr std::string_view kSignedWords = "XYZUVWRP";
constexpr std::string_view kUnsignedWords = "ILQDEJK";

bool contains(std::string_view set, char address) {
  return set.find(address) != std::string_view::npos;
}

// GSK-COM-06, the tables of the manual: 999999.999 mm or 99999.9999 inch in ISB, a tenth of that
// with one decimal more in ISC.
Number upper_end(const Profile& profile, Units units) {
  const bool inch = units == Units::inch;
  const bool fine = profile.increment == Increment::isc;
  return Number::decimal(false, std::uint64_t{999'999'999}, (inch ? 4U : 3U) + (fine ? 1U : 0U));
}

}  // namespace

std::uint32_t decimals_of(const Profile& profile, Units units) {
  return (units == Units::inch ? 4U : 3U) + (profile.increment == Increment::isc ? 1U : 0U);
}

const AxisAddresses& addresses_of(Axis axis) {
  for (const AxisAddresses& entry : kAxisAddresses) {
    if (entry.axis == axis) return entry;
  }
  return kAxisAddresses.front();
}

BlockWords::BlockWords(const grammar::Block& block, const Profile& profile, Units units, bool round)
    : WordTable(block), profile_(profile), units_(units), round_(round) {}

std::optional<Number> BlockWords::length(char address) const {
  const grammar::Word* found = word(address);
  if (found == nullptr) return std::nullopt;
  Number value = to_number(found->value);
  if (round_ && found->value.scale > decimals_of(profile_, units_)) {
    // GSK-COM-03, gsk.decimals = nearest: halves away from zero.
    Number scale = 1;
    for (std::uint32_t i = 0; i < decimals_of(profile_, units_); ++i) scale = scale * 10;
    Number magnitude = (abs(value) * scale + Number(1) / 2).floor() / scale;
    value = value.sign() < 0 ? -magnitude : magnitude;
  }
  if (units_ == Units::inch) value = inches(value);
  return value;
}

std::optional<AxisWord> BlockWords::axis_word(Axis axis, bool diameter) const {
  const AxisAddresses& addresses = addresses_of(axis);
  const bool incremental = !has(addresses.absolute);
  const char address = incremental ? addresses.increment : addresses.absolute;
  if (!has(address)) return std::nullopt;
  if (!is_linear(axis)) return AxisWord{incremental, written(address)};
  Number value = length(address).value();
  if (axis == Axis::x && profile_.x_diameter && diameter) value = value / 2;
  return AxisWord{incremental, value};
}

void check_pairs(const BlockWords& words, bool last_wins, std::string_view may_repeat,
                 std::vector<Alarm>& alarms) {
  if (!last_wins) {
    check_repeated_addresses(words, "GSK-COM-07"_clause, alarms, may_repeat);
    for (Alarm& alarm : alarms) {
      if (alarm.alarm == AlarmClass::duplicate_word && alarm.word == 'M') {
        alarm.clause = "GSK-COM-11"_clause;
      }
    }
  }
  check_axis_letters(words, kAxisAddresses, "GSK-COM-09"_clause, alarms);
}

namespace {

// A length or an angle with more decimals than the least increment has. The value counts, not how
// it is written: 1.5000 has one decimal.
bool is_too_fine(const grammar::Word& word, std::uint32_t decimals) {
  if (word.value.scale <= decimals) return false;
  if (!contains(kSignedWords, word.address) && !contains("ILQDEJKCH", word.address)) return false;
  const Number increment = Number::decimal(false, std::uint64_t{1}, decimals);
  const Number increments = to_number(word.value) / increment;
  return increments != increments.floor();
}

}  // namespace

bool has_fine_words(const grammar::Block& block, const Profile& profile, Units units) {
  const std::uint32_t decimals = decimals_of(profile, units);
  return std::ranges::any_of(
      block.words, [&](const grammar::Word& word) { return is_too_fine(word, decimals); });
}

void check_decimals(const BlockWords& words, const Profile& profile, Units units,
                    std::vector<Alarm>& alarms) {
  const std::uint32_t decimals = decimals_of(profile, units);
  for (const grammar::Word& word : words.block().words) {
    if (!is_too_fine(word, decimals)) continue;
    alarms.push_back(
        {AlarmClass::value_out_of_range, "GSK-COM-03"_clause, word.address, word.where,
         fmt::format("{} has more decimals than the least increment.", text_of(word))});
  }
}

void check_ranges(const BlockWords& words, const Code& cycle, CycleFamily family, bool last_wins,
                  const Profile& profile, Units units, std::vector<Alarm>& alarms) {
  const Number upper = upper_end(profile, units);
  for (const grammar::Word& word : words.block().words) {
    if (last_wins && words.word(word.address) != &word) continue;        // GSK-COM-07
    if (family == CycleFamily::helix && word.address == 'L') continue;   // check_turns
    if (family == CycleFamily::thread && word.address == 'K') continue;  // check_run_out_angle
    const bool unsigned_p = family == CycleFamily::thread && word.address == 'P';
    const bool takes_sign = contains(kSignedWords, word.address) && !unsigned_p;
    if (!takes_sign && !unsigned_p && !contains(kUnsignedWords, word.address)) continue;
    const bool bad_sign = !takes_sign && word.value.negative;
    if (!bad_sign && abs(to_number(word.value)) <= upper) continue;
    // GSK-COM-10: of a word without effect no text gives a range.
    const ClauseId clause = cycle.takes(word.address) ? "GSK-COM-06"_clause : "GSK-COM-10"_clause;
    alarms.push_back({AlarmClass::value_out_of_range, clause, word.address, word.where,
                      bad_sign
                          ? fmt::format("{} has a sign, but the word takes none.", text_of(word))
                          : fmt::format("{} lies beyond {}.", text_of(word), upper.text())});
  }
}

void check_turns(const BlockWords& words, std::vector<Alarm>& alarms) {
  const grammar::Word* word = words.word('L');
  if (word == nullptr) return;
  const Number turns = to_number(word->value);
  if (turns != turns.floor()) {
    alarms.push_back({AlarmClass::not_an_integer, "GSK-G112-01"_clause, 'L', word->where,
                      fmt::format("{} is no whole number of turns.", text_of(*word))});
  }
  if (turns < Number(1) || turns > Number(99'999)) {
    alarms.push_back({AlarmClass::value_out_of_range, "GSK-G112-01"_clause, 'L', word->where,
                      fmt::format("{} lies outside 1 to 99999 turns.", text_of(*word))});
  }
}

void check_run_out_angle(const BlockWords& words, bool full_turn, const Profile& profile,
                         Units units, std::vector<Alarm>& alarms) {
  const grammar::Word& word = *words.word('K');
  const Number upper = full_turn ? Number(360) : upper_end(profile, units);
  if (!word.value.negative && to_number(word.value) <= upper) return;
  alarms.push_back({AlarmClass::value_out_of_range, "GSK-G114-13"_clause, 'K', word.where,
                    fmt::format("{} lies outside 0 to {} degrees.", text_of(word), upper.text())});
}

void check_feed_word(const BlockWords& words, std::vector<Alarm>& alarms) {
  check_feed_sign(words, "GSK-COM-08"_clause, alarms);
}

void check_code_groups(const BlockWords& words, const BlockCodes& codes,
                       std::vector<Alarm>& alarms) {
  if (codes.motion < 0 || codes.cycle < 110) return;
  const grammar::Word* word = words.word('G');
  alarms.push_back(
      {AlarmClass::conflicting_words, "GSK-MOD-09"_clause, 'G', word->where,
       fmt::format("G{:02} and G{} exclude each other in a block.", codes.motion, codes.cycle)});
}

}  // namespace gonogo::reference::gsk988ta
