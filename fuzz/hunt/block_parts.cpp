// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/block_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

#include "fuzz/program/features.hpp"

namespace gonogo::hunt {

using program::TextBlock;
using program::TextWord;

namespace {

constexpr std::string_view kBlock = "block ";

bool has(std::string_view text, bool (*is_it)(unsigned char)) {
  return std::ranges::any_of(text, [&](char c) { return is_it(static_cast<unsigned char>(c)); });
}

bool has_only_digits(std::string_view text) {
  return !has(text, [](unsigned char c) { return std::isdigit(c) == 0; });
}

// The part of and of an address alone; what is calculated or has an index has another name.
bool is_plain_number(std::string_view text) {
  if (text.find_first_of("=(") != std::string_view::npos) return true;
  const std::size_t end_of_address = text.find_first_of("0123456789.+- \t");
  if (end_of_address == std::string_view::npos) return true;
  std::string_view number = text.substr(end_of_address);
  number.remove_prefix(std::min(number.find_first_not_of(" \t"), number.size()));
  if (number.starts_with('-') || number.starts_with('+')) number.remove_prefix(1);
  return std::ranges::count(number, '.') <= 1 &&
         number.find_first_not_of("0123456789.") == std::string_view::npos;
}

// Whether digits stand behind the point.
bool has_fraction(std::string_view text) {
  const std::size_t point = text.find('.');
  return point != std::string_view::npos && point + 1 < text.size();
}

// How the word is written, where that is not the plainest way.
void add_spelling(const TextWord& word, bool is_code, Parts& parts) {
  const std::string& text = word.text;
  const auto add = [&](bool is_so, const char* way) {
    if (is_so) parts.insert(std::string("spelling ") + way);
  };
  add(has(text, [](unsigned char c) { return std::islower(c) != 0; }), "small letters");
  add(has(text, [](unsigned char c) { return c == ' ' || c == '\t'; }), "blanks in a word");
  add(text.find('+') != std::string::npos, "+");
  add(text.find('=') != std::string::npos, "=");
  add(text.find('(') != std::string::npos, "brackets");
  const std::size_t number = text.find_first_of("0123456789.");
  if (number == std::string::npos) return add(true, "no number");
  const std::size_t point = text.find('.');
  add(text[number] == '.', "no digit before the point");
  add(point == text.size() - 1, "no digit behind the point");
  add(!is_code && !is_plain_number(text), "odd numbers");
  add(is_code && text[number] == '0' && number + 1 < text.size() &&
          std::isdigit(static_cast<unsigned char>(text[number + 1])) != 0,
      "zeros before a code");
}

// Digits that belong to the word before them: 2 of "M 0 2".
bool is_loose_number(const TextWord& word) {
  if (program::is_word(word) || word.text.empty()) return false;
  const auto first = static_cast<unsigned char>(word.text.front());
  return std::isdigit(first) != 0 || first == '.' || first == '-';
}

// What is no word: a comment, the number of a block.
void add_text(const TextBlock& block, const TextWord& word, Parts& parts) {
  if (is_loose_number(word)) {
    parts.insert("spelling blanks in a number");
    return;
  }
  const auto first = static_cast<unsigned char>(word.text.empty() ? ' ' : word.text.front());
  parts.insert(std::string("text ") + static_cast<char>(std::toupper(first)));
  if (std::isalpha(first) == 0) return;
  const bool is_whole = has_only_digits(std::string_view(word.text).substr(1));
  if (!is_whole) parts.insert("spelling odd numbers of blocks");  // N1.5
  if (&word != block.words.data()) parts.insert("spelling numbers of blocks behind words");
}

void add_word(const TextBlock& block, const TextWord& word, Parts& parts) {
  if (has(word.text, [](unsigned char c) { return c > 127; })) parts.insert("text bytes");
  if (!program::is_word(word)) return add_text(block, word, parts);
  const std::string& code = block.code_of(word);
  add_spelling(word, !code.empty(), parts);
  // Nobody knows which code M 0 2 is.
  const TextWord* const next = &word + 1;
  const bool is_last = next == block.words.data() + block.words.size();
  if (!code.empty() && !is_last && is_loose_number(*next)) {
    parts.insert("spelling blanks in a code");
    return;
  }
  const std::string address = program::address_of(word);
  parts.insert(code.empty() ? "word " + address : "code " + code);
  if (code.empty() && has_fraction(word.text)) parts.insert("fraction " + address);
}

constexpr const char* kOtherOrder = "spelling words in another order";

// Codes, ways along axes, what else there is, as most programs are written.
std::pair<int, std::string> rank_of(const TextBlock& block, const TextWord& word) {
  const std::string address = program::address_of(word);
  if (!program::is_word(word) && address == "N") return {0, ""};
  if (address == "G") return {1, ""};
  if (!block.code_of(word).empty()) return {2, ""};
  const bool is_axis = address.size() == 1 &&
                       std::string_view("XYZABCUVW").find(address[0]) != std::string_view::npos;
  if (is_axis) return {address[0] >= 'X' ? 3 : 4, address};
  return {address == "F" || address == "S" || address == "T" ? 6 : 5,
          address == "F" ? "" : address};
}

bool is_usual_order(const TextBlock& block) {
  return std::ranges::is_sorted(block.words, {},
                                [&](const TextWord& word) { return rank_of(block, word); });
}

// Those of one rank stay as they stand.
std::vector<const TextWord*> words_in_usual_order(const TextBlock& block) {
  std::vector<const TextWord*> words;
  for (const TextWord& word : block.words) words.push_back(&word);
  std::ranges::sort(words, {}, [&](const TextWord* word) {
    return std::pair(rank_of(block, *word), word - block.words.data());
  });
  return words;
}

// How the gaps of the block are, where they are not one blank between two words.
Parts gap_parts(const TextBlock& block) {
  Parts parts;
  const auto is_tab = [](unsigned char c) { return c == '\t'; };
  const auto add = [&](bool is_so, const char* way) {
    if (is_so) parts.insert(std::string("spelling ") + way);
  };
  add(has(block.rest, is_tab), "tab");
  if (block.words.empty()) {
    add(!block.rest.empty(), "blanks alone");
    return parts;
  }
  add(!block.rest.empty(), "blanks behind the words");
  add(!block.words.front().gap.empty(), "blanks before the words");
  for (const TextWord& word : block.words) {
    add(has(word.gap, is_tab), "tab");
    if (&word == block.words.data() || !program::is_word(word)) continue;
    add(word.gap.empty(), "no blanks between words");
    add(word.gap.size() > 1, "several blanks");
  }
  return parts;
}

program::TextLine with_plain_gaps(const TextBlock& block) {
  program::TextLine line{block.words, {}, block.end};
  for (TextWord& word : line.words) {
    const bool is_first = &word == line.words.data();
    if (is_first) word.gap.clear();
    if (!is_first && (program::is_word(word) || !word.gap.empty())) word.gap = " ";
  }
  return line;
}

program::TextLine in_usual_order(const TextBlock& block) {
  const std::vector<const TextWord*> words = words_in_usual_order(block);
  program::TextLine line{{}, block.rest, block.end};
  for (std::size_t i = 0; i < words.size(); ++i) {
    line.words.push_back({block.words[i].gap, words[i]->text});
  }
  return line;
}

// What stands in the block together; codes first.
void add_together(const TextBlock& block, Parts& parts) {
  Parts codes;
  Parts addresses;
  Parts names;
  bool is_twice = false;
  for (const TextWord& word : block.words) {
    if (!program::is_word(word)) continue;
    const std::string& code = block.code_of(word);
    (code.empty() ? addresses : codes).insert(code.empty() ? program::address_of(word) : code);
    is_twice = !names.insert(code.empty() ? program::name_of(word) : code).second || is_twice;
  }
  if (is_twice) parts.insert("text words that stand twice");
  if (codes.empty() && addresses.empty()) return;
  std::vector<std::string> together(codes.begin(), codes.end());
  together.insert(together.end(), addresses.begin(), addresses.end());
  parts.insert(fmt::format("{}{}", kBlock, fmt::join(together, "+")));
  if (codes.empty()) parts.insert("text blocks without a code");
  if (codes.size() > 1) parts.insert("text several codes in a block");
}

// A word without the fraction of its number; one that is no address and number stays as it is.
std::string in_whole_number(const std::string& word) {
  constexpr std::string_view kNumber = "+-.0123456789";
  const std::size_t number = word.find_first_of(kNumber);
  if (number == std::string::npos || word.find_first_not_of(kNumber, number) != std::string::npos) {
    return word;
  }
  const std::string written = word.substr(number, word.find('.', number) - number);
  const std::size_t first = written.find_first_of("123456789");
  return word.substr(0, number) + (written.starts_with('-') ? "-" : "") +
         (first == std::string::npos ? "1" : written.substr(first));
}

}  // namespace

int rank_of_part(std::string_view part) {
  constexpr std::array<std::string_view, kBlockRank> kLater = {"feature ", "fraction ", kBlock};
  const auto* const found =
      std::ranges::find_if(kLater, [&](std::string_view kind) { return part.starts_with(kind); });
  return found == kLater.end() ? 0 : static_cast<int>(found - kLater.begin()) + 1;
}

Parts parts_of_word(const TextBlock& block, const TextWord& word) {
  Parts parts;
  add_word(block, word, parts);
  return parts;
}

Parts parts_of_block(const TextBlock& block, const reference::Descriptor& table) {
  Parts parts = gap_parts(block);
  for (const TextWord& word : block.words) add_word(block, word, parts);
  if (!is_usual_order(block)) parts.insert(kOtherOrder);
  add_together(block, parts);
  if (!block.words.empty() && block.end.starts_with('\r')) {
    parts.insert(block.end.size() == 1 ? "text CR" : "text CR LF");
  }
  for (const std::string& feature : program::features_of_part(table, block)) {
    parts.insert("feature " + feature);
  }
  return parts;
}

std::string rewritten(const TextBlock& block,
                      const std::function<bool(const std::string& part)>& admits) {
  if (!std::ranges::all_of(gap_parts(block), admits)) {
    return program::line_text(with_plain_gaps(block));
  }
  if (!is_usual_order(block) && !admits(kOtherOrder)) {
    return program::line_text(in_usual_order(block));
  }
  return program::line_text(block);
}

std::string plainly(const TextBlock& block, Numbers numbers) {
  std::string text;
  for (const TextWord* word : words_in_usual_order(block)) {
    if (!program::is_word(*word)) continue;
    if (!text.empty()) text += ' ';
    const std::string& code = block.code_of(*word);
    std::string plain;
    for (const char c : code.empty() ? word->text : code) {
      if (c != ' ' && c != '\t')
        plain += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    text += code.empty() && numbers == Numbers::whole ? in_whole_number(plain) : plain;
  }
  return text + "\n";
}

}  // namespace gonogo::hunt
