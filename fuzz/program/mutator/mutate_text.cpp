// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <set>

#include "fuzz/program/mutator/mutate.hpp"
#include "reference/dialect.hpp"

namespace gonogo::program {
namespace {

constexpr std::size_t kMostLines = 24;
constexpr std::int64_t kLargest = 9'999'999;
using Lines = std::vector<TextLine>;
using Offset = Lines::difference_type;

// Whole values that stand at the limits of many ranges.
constexpr std::array<std::int64_t, 16> kLimits = {
    0, 1, 2, -1, 45, 90, 180, 360, 1000, 3937, 4000, 9999, 10'000, 99'999, 100'000, 1'000'000};

// The addresses of one letter that a dialect has.
const std::string& letters() {
  static const std::string kLetters = [] {
    std::set<char> all;
    const auto take = [&](const reference::CodeWord& word) {
      if (word.address.size() == 1) all.insert(word.address.front());
    };
    for (const reference::Dialect& dialect : reference::dialects()) {
      std::ranges::for_each(dialect.descriptor->everywhere, take);
      for (const reference::Code& code : dialect.descriptor->codes) {
        for (const auto& list : code.words) std::ranges::for_each(list, take);
      }
    }
    return std::string(all.begin(), all.end());
  }();
  return kLetters;
}

// What ends a program in some dialect.
std::string program_end() {
  const reference::Descriptor& table = *reference::dialects().front().descriptor;
  return std::string(table.find(reference::Kind::program_end)->name);
}

class TextMutator {
 public:
  TextMutator(Dice& dice, const std::string& text, const std::string& other)
      : dice_(dice), lines_(lines_of(text)), other_(lines_of(other)) {}

  void step() {
    if (lines_.empty()) return insert_line();
    const std::size_t kind = dice_.below(20);
    if (kind < 4) {
      change_lines(kind);
    } else if (kind < 5) {
      insert_line();
    } else if (kind < 8) {
      change_words(kind - 5);
    } else if (kind < 9) {
      insert_word();
    } else if (kind < 10) {
      exchange_address();
    } else if (kind < 12) {
      exchange_code();
    } else {
      change_value();
    }
  }

  std::string text() {
    if (lines_.size() > kMostLines) lines_.resize(kMostLines);
    return text_of(lines_);
  }

 private:
  Offset place(std::size_t count) { return static_cast<Offset>(dice_.below(count)); }

  void change_lines(std::size_t kind) {
    const Offset at = place(lines_.size());
    if (kind == 0) {
      lines_.erase(lines_.begin() + at);
    } else if (kind == 1) {
      lines_.insert(lines_.begin() + at, TextLine(lines_[static_cast<std::size_t>(at)]));
    } else if (kind == 2) {
      std::swap(dice_.pick(lines_), dice_.pick(lines_));
    } else if (!other_.empty()) {
      // On with the end of another program.
      lines_.erase(lines_.begin() + at, lines_.end());
      lines_.insert(lines_.end(), other_.begin() + place(other_.size()), other_.end());
    }
  }

  void insert_line() {
    Lines& from = other_.empty() || dice_.one_in(3) ? lines_ : other_;
    if (from.empty()) return lines_.push_back({{{"", program_end()}}, "", "\n"});
    TextLine line = dice_.pick(from);
    if (line.end.empty()) line.end = "\n";
    if (!lines_.empty() && lines_.back().end.empty()) lines_.back().end = "\n";
    lines_.insert(lines_.begin() + place(lines_.size() + 1), std::move(line));
  }

  TextLine* line_with_words(Lines& lines) {
    for (int tries = 0; tries < 4 && !lines.empty(); ++tries) {
      TextLine& line = dice_.pick(lines);
      if (!line.words.empty()) return &line;
    }
    return nullptr;
  }

  void change_words(std::size_t kind) {
    TextLine* line = line_with_words(lines_);
    if (line == nullptr) return;
    const auto at = place(line->words.size());
    if (kind == 0) {
      line->words.erase(line->words.begin() + at);
    } else if (kind == 1) {
      line->words.insert(line->words.begin() + at,
                         TextWord(line->words[static_cast<std::size_t>(at)]));
      line->words[static_cast<std::size_t>(at) + 1].gap = " ";
    } else {
      std::swap(dice_.pick(line->words), dice_.pick(line->words));
    }
  }

  // A word of another block or program.
  void insert_word() {
    TextLine* to = line_with_words(lines_);
    TextLine* from = line_with_words(dice_.one_in(2) ? other_ : lines_);
    if (to == nullptr || from == nullptr) return;
    TextWord word = dice_.pick(from->words);
    word.gap = " ";
    to->words.insert(to->words.begin() + place(to->words.size() + 1), std::move(word));
  }

  void exchange_address() {
    TextLine* line = line_with_words(lines_);
    if (line == nullptr) return;
    TextWord& word = dice_.pick(line->words);
    const std::string address = address_of(word);
    if (address.size() != 1 || !code_of(word).empty()) return;
    word.text.front() = dice_.pick(letters());
  }

  // A code becomes another one that the two programs have, or a neighbour.
  void exchange_code() {
    TextLine* line = line_with_words(lines_);
    if (line == nullptr) return;
    std::vector<TextWord*> codes;
    for (TextWord& word : line->words) {
      if (!code_of(word).empty()) codes.push_back(&word);
    }
    if (codes.empty()) return;
    TextWord& code = *dice_.pick(codes);
    TextLine* from = line_with_words(dice_.one_in(2) ? other_ : lines_);
    if (from != nullptr && !dice_.one_in(3)) {
      const TextWord& word = dice_.pick(from->words);
      if (!code_of(word).empty()) code.text = word.text;
    } else if (const auto number = value_of(code)) {
      const std::int64_t next = number->value + (dice_.one_in(2) ? 1 : -1);
      code.text = address_of(code) + std::to_string(std::abs(next));
    }
  }

  // A word of the block that has a value and is no code.
  TextWord* word_with_value(TextLine& line) {
    std::vector<TextWord*> words;
    for (TextWord& word : line.words) {
      if (code_of(word).empty() && value_of(word)) words.push_back(&word);
    }
    return words.empty() ? nullptr : dice_.pick(words);
  }

  void change_value() {
    TextLine* line = line_with_words(lines_);
    TextWord* word = line == nullptr ? nullptr : word_with_value(*line);
    if (word == nullptr) return;
    const std::vector<NumberPlace> places = numbers_of(*word);
    const NumberPlace& place = dice_.pick(places);
    const SmallDecimal next = other_value(place.number, *line);
    if (next.value > kLargest * 10'000 || next.value < -kLargest * 10'000) return;
    word->text.replace(place.begin, place.end - place.begin, next.text());
  }

  SmallDecimal other_value(SmallDecimal number, TextLine& line) {
    const std::int64_t sign = number.value < 0 ? -1 : 1;
    switch (dice_.below(10)) {
      case 0:
        return {-number.value, number.scale};
      case 1:
        return {dice_.pick(kLimits), 0};
      case 2:
        return {number.value * 2, number.scale};
      case 3:
        return {number.value / 2, number.scale};
      case 4:
        return {number.value + (dice_.one_in(2) ? 1 : -1), number.scale};
      case 5:
        return {sign * static_cast<std::int64_t>(dice_.below(100)), 0};
      default:
        return beside_another(number, line);
    }
  }

  // What another word says, or an increment beside it, or some part or multiple of it.
  SmallDecimal beside_another(SmallDecimal number, TextLine& line) {
    TextLine* from = dice_.below(4) != 0 ? &line : line_with_words(lines_);
    TextWord* word = from == nullptr ? nullptr : word_with_value(*from);
    if (word == nullptr) return number;
    SmallDecimal value = *value_of(*word);
    if (dice_.one_in(3)) {
      value.value *= 2;
    } else if (dice_.one_in(2)) {
      value = {value.value * 5, value.scale + 1};
    }
    if (dice_.one_in(4)) value.value = -value.value;
    if (dice_.one_in(3)) {
      const auto [finer, unit] = same_scale(value, {1, 3});
      value = {finer + (dice_.one_in(2) ? unit : -unit), std::max(value.scale, 3)};
    }
    return value;
  }

  Dice& dice_;
  Lines lines_;
  Lines other_;
};

// One character put in, changed or cut out.
void spoil(Dice& dice, std::string& text) {
  constexpr std::string_view kBytes = "GMXZNF0159.-+=()/%;# \t\n\r\xE5@";
  const std::size_t at = dice.below(text.size() + 1);
  const char byte = kBytes[dice.below(kBytes.size())];
  if (at == text.size() || dice.one_in(3)) {
    text.insert(at, 1, byte);
  } else if (dice.one_in(2)) {
    text[at] = byte;
  } else {
    text.erase(at, 1);
  }
}

}  // namespace

std::string mutate_text(Dice& dice, const std::string& text, const std::string& other) {
  TextMutator mutator(dice, text, other);
  const std::size_t steps = std::array<std::size_t, 4>{1, 1, 2, 4}[dice.below(4)];
  for (std::size_t i = 0; i < steps; ++i) mutator.step();
  std::string result = mutator.text();
  if (dice.one_in(16)) spoil(dice, result);
  return result;
}

}  // namespace gonogo::program
