// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/mutator/program_mutator.hpp"

#include <algorithm>

#include "fuzz/program/mutator/mutate.hpp"
#include "fuzz/program/mutator/word_mutations.hpp"

namespace gonogo::program {
namespace {

using Lines = std::vector<TextLine>;
using Entries = std::span<const std::string>;
constexpr std::size_t kTries = 8;

// Some entries as a program, for the changes that take words and blocks of another one.
std::string program_of(Dice& dice, Entries entries) {
  std::string program;
  for (std::size_t i = 0; i < 4; ++i) program += dice.pick(entries) + "\n";
  return program;
}

// Whole lines from the end, then bytes.
std::string cut_to(std::string text, std::size_t most_bytes) {
  if (text.size() <= most_bytes) return text;
  const std::size_t end = text.find_last_of("\r\n", most_bytes == 0 ? 0 : most_bytes - 1);
  text.resize(end == std::string::npos || end + 1 > most_bytes ? most_bytes : end + 1);
  return text;
}

std::string change_once(Dice& dice, const std::string& text, Entries entries) {
  const std::size_t kind = dice.below(12);
  if (kind < 5) return mutate_text(dice, text, program_of(dice, entries));
  Lines lines = lines_of(text);
  if (kind < 8) {
    change_spelling(dice, lines);
  } else if (kind < 9) {
    insert_entry(dice, lines, entries);
  } else if (kind < 10) {
    replace_by_entry(dice, lines, entries);
  } else if (kind < 11) {
    insert_block(dice, lines, entries);
  } else {
    change_looks(dice, lines);
  }
  return text_of(lines);
}

}  // namespace

std::string mutate_program(std::string_view text, std::size_t most_bytes, std::uint32_t seed,
                           const Dictionary* dictionary) {
  Dice dice(seed);
  const std::span<const Dictionary> all = dictionaries();
  if (dictionary == nullptr) dictionary = &dice.pick(all);
  const Entries entries = dictionary->entries;
  const std::string before(text);
  for (std::size_t i = 0; i < kTries; ++i) {
    std::string after = before;
    const std::size_t steps = dice.one_in(2) ? 1 : 1 + dice.below(4);
    for (std::size_t step = 0; step < steps; ++step) after = change_once(dice, after, entries);
    after = cut_to(std::move(after), most_bytes);
    if (after != before) return after;
  }
  // Nothing fits: a text that fills its room and has nothing to change in it.
  std::string after = cut_to(before, most_bytes);
  if (after.size() < most_bytes) return after + "\n";
  if (!after.empty() && after == before) after.back() = static_cast<char>(after.back() ^ 1);
  return after;
}

std::string cross_programs(std::string_view one, std::string_view other, std::size_t most_bytes,
                           std::uint32_t seed) {
  Dice dice(seed);
  const Lines a = lines_of(one);
  const Lines b = lines_of(other);
  Lines both;
  auto append = [&](const Lines& from, std::size_t begin, std::size_t end) {
    for (; begin < end && begin < from.size(); ++begin) {
      if (!both.empty() && both.back().end.empty()) both.back().end = "\n";
      both.push_back(from[begin]);
    }
  };
  const std::size_t cut = dice.below(a.size() + 1);
  const std::size_t begin = dice.below(b.size() + 1);
  switch (dice.below(3)) {
    case 0:
      append(a, 0, cut);
      append(b, begin, b.size());
      break;
    case 1:
      append(a, 0, cut);
      append(b, begin, begin + 1 + dice.below(4));
      append(a, cut, a.size());
      break;
    default:
      for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
        append(a, i, i + 1);
        append(b, i, i + 1);
      }
  }
  return cut_to(text_of(both), most_bytes);
}

}  // namespace gonogo::program
