// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "grammar/parser.hpp"

namespace gonogo::reference {
namespace {

constexpr std::uint32_t bit_of(const grammar::Word& word) {
  return std::uint32_t{1} << static_cast<unsigned>(word.address - '@');
}

}  // namespace

std::string text_of(const grammar::Word& word) {
  std::string text(1, word.address);
  grammar::print(word.value, text);
  return text;
}

bool repeats_address(const grammar::Block& block, std::string_view may_repeat) {
  std::uint32_t seen = 0;
  for (const grammar::Word& word : block.words) {
    const bool may = may_repeat.find(word.address) != std::string_view::npos;
    if ((seen & bit_of(word)) != 0 && !may) return true;
    seen |= bit_of(word);
  }
  return false;
}

std::optional<grammar::Span> WordTable::place_of(const WordName& name) const {
  const std::string_view text = name.text();
  if (text.size() != 1 || !has(text[0])) return std::nullopt;
  return word(text[0])->where;
}

grammar::Span WordTable::behind() const {
  if (block_.words.empty()) return {};
  const std::uint32_t end = block_.words.back().where.end;
  return {end, end};
}

void check_repeated_addresses(const WordTable& words, ClauseId clause, std::vector<Alarm>& alarms,
                              std::string_view may_repeat) {
  std::uint32_t seen = 0;
  for (const grammar::Word& word : words.block().words) {
    if ((seen & bit_of(word)) != 0 && may_repeat.find(word.address) == std::string_view::npos) {
      alarms.push_back({AlarmClass::duplicate_word, clause, word.address, word.where,
                        fmt::format("The address {} stands twice in the block.", word.address)});
    }
    seen |= bit_of(word);
  }
}

void check_axis_letters(const WordTable& words, std::span<const AxisAddresses> axes,
                        ClauseId clause, std::vector<Alarm>& alarms) {
  for (const AxisAddresses& addresses : axes) {
    if (!words.has(addresses.absolute) || !words.has(addresses.increment)) continue;
    const grammar::Word& increment = *words.word(addresses.increment);
    const grammar::Word& absolute = *words.word(addresses.absolute);
    const grammar::Word& later =
        increment.where.begin > absolute.where.begin ? increment : absolute;
    alarms.push_back(
        {AlarmClass::conflicting_words, clause, later.address, later.where,
         fmt::format("{} and {} command the same axis.", addresses.absolute, addresses.increment)});
  }
}

void check_feed_sign(const WordTable& words, ClauseId clause, std::vector<Alarm>& alarms) {
  const grammar::Word* word = words.word('F');
  if (word == nullptr || words.written('F').sign() >= 0) return;
  alarms.push_back({AlarmClass::value_sign, clause, 'F', word->where,
                    fmt::format("The feed {} is negative.", text_of(*word))});
}

void sort_by_place(std::vector<Alarm>& alarms) {
  // std::stable_sort warns under clang-19.
  std::vector<std::pair<std::uint32_t, std::size_t>> order;
  for (const Alarm& alarm : alarms) order.emplace_back(alarm.where.begin, order.size());
  if (std::ranges::is_sorted(order)) return;
  std::ranges::sort(order);
  std::vector<Alarm> sorted;
  sorted.reserve(alarms.size());
  for (const auto& [begin, place] : order) sorted.push_back(std::move(alarms[place]));
  alarms = std::move(sorted);
}

}  // namespace gonogo::reference
