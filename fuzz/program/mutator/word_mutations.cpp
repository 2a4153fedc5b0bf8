// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/mutator/word_mutations.hpp"

#include <array>

namespace gonogo::program {
namespace {

using Lines = std::vector<TextLine>;

// A word anywhere in the program, each as likely as another. Null: there is none.
TextWord* any_word(Dice& dice, Lines& lines) {
  std::vector<TextWord*> words;
  for (TextLine& line : lines) {
    for (TextWord& word : line.words) words.push_back(&word);
  }
  return words.empty() ? nullptr : dice.pick(words);
}

void change_digit(Dice& dice, std::string& number) {
  std::vector<std::size_t> digits;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] >= '0' && number[i] <= '9') digits.push_back(i);
  }
  if (digits.empty()) return;
  char& digit = number[dice.pick(digits)];
  digit = static_cast<char>('0' + (digit - '0' + 1 + static_cast<int>(dice.below(9))) % 10);
}

void change_sign(Dice& dice, std::string& number) {
  if (number.starts_with('-') || number.starts_with('+')) {
    if (dice.one_in(2))
      number.erase(0, 1);
    else
      number.front() = number.front() == '-' ? '+' : '-';
  } else {
    number.insert(0, 1, dice.one_in(4) ? '+' : '-');
  }
}

// Moved, put in, or taken away.
void change_point(Dice& dice, std::string& number) {
  const std::size_t point = number.find('.');
  if (point != std::string::npos) number.erase(point, 1);
  if (point != std::string::npos && dice.one_in(3)) return;
  const std::size_t first = number.starts_with('-') || number.starts_with('+') ? 1 : 0;
  number.insert(first + dice.below(number.size() - first + 1), 1, '.');
}

void add_zeros(Dice& dice, std::string& number) {
  constexpr std::array<std::size_t, 4> kCounts = {1, 1, 3, 20};
  const std::size_t first = number.starts_with('-') || number.starts_with('+') ? 1 : 0;
  const bool behind = dice.one_in(2);
  number.insert(behind ? number.size() : first, dice.pick(kCounts), '0');
}

// Digits beyond the least increment.
void add_decimals(Dice& dice, std::string& number) {
  if (number.find('.') == std::string::npos) number += '.';
  constexpr std::array<std::string_view, 6> kTails = {"5",   "001",  "0001",
                                                      "999", "0005", "00000000000000000001"};
  number += dice.pick(kTails);
}

}  // namespace

void change_spelling(Dice& dice, Lines& lines) {
  for (int tries = 0; tries < 4; ++tries) {
    TextWord* const word = any_word(dice, lines);
    if (word == nullptr) return;
    const std::vector<NumberPlace> places = numbers_of(*word);
    if (places.empty()) continue;
    const NumberPlace& place = dice.pick(places);
    std::string number = word->text.substr(place.begin, place.end - place.begin);
    constexpr std::array kChanges = {change_digit, change_digit, change_sign,
                                     change_point, add_zeros,    add_decimals};
    dice.pick(kChanges)(dice, number);
    word->text.replace(place.begin, place.end - place.begin, number);
    return;
  }
}

void insert_entry(Dice& dice, Lines& lines, std::span<const std::string> entries) {
  if (lines.empty() || entries.empty()) return insert_block(dice, lines, entries);
  std::vector<TextWord>& words = dice.pick(lines).words;
  const auto at = static_cast<std::ptrdiff_t>(dice.below(words.size() + 1));
  words.insert(words.begin() + at, {dice.one_in(4) ? "" : " ", dice.pick(entries)});
}

void replace_by_entry(Dice& dice, Lines& lines, std::span<const std::string> entries) {
  TextWord* const word = any_word(dice, lines);
  if (word == nullptr || entries.empty()) return;
  std::vector<const std::string*> alike;
  const std::string address = address_of(*word);
  for (const std::string& entry : entries) {
    if (!address.empty() && address_of(TextWord{"", entry}) == address) alike.push_back(&entry);
  }
  const bool any = alike.empty() || dice.one_in(4);
  word->text = any ? dice.pick(entries) : *dice.pick(alike);
}

void insert_block(Dice& dice, Lines& lines, std::span<const std::string> entries) {
  if (entries.empty()) return;
  if (!lines.empty() && lines.back().end.empty()) lines.back().end = "\n";
  const auto at = static_cast<std::ptrdiff_t>(dice.below(lines.size() + 1));
  lines.insert(lines.begin() + at, TextLine{{{"", dice.pick(entries)}}, "", "\n"});
}

void change_looks(Dice& dice, Lines& lines) {
  if (lines.empty()) return;
  TextLine& line = dice.pick(lines);
  const std::size_t kind = dice.below(4);
  if (kind == 0) {
    constexpr std::array<const char*, 4> kEnds = {"\n", "\r\n", "\r", ";\n"};
    line.end = dice.pick(kEnds);
  } else if (kind == 1) {
    constexpr std::array<const char*, 4> kRests = {" ", "\t", ";", " (note)"};
    line.rest += dice.pick(kRests);
  } else if (!line.words.empty()) {
    TextWord& word = dice.pick(line.words);
    if (kind == 2) {
      word.gap = word.gap.empty() ? " " : "";
    } else {
      for (char& c : word.text) {
        const bool is_letter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
        if (is_letter) c = static_cast<char>(c ^ 0x20);
      }
    }
  }
}

}  // namespace gonogo::program
