// SPDX-License-Identifier: GPL-3.0-or-later
//
// The structured mutator of the fuzz target of files, as the engines call it. JSON, TOML and CSV
// are lines of words with values behind ':' and '='; changed byte by byte hardly one of them would
// still be read. The first byte, which chooses the reader, stays.
#include <algorithm>
#include <array>
#include <cctype>
#include <random>
#include <string>

#include "fuzz/targets/file_readers.hpp"
#include "fuzz/targets/fixed_stream.hpp"
#include "fuzz/targets/target.hpp"

namespace gonogo::fuzz {
namespace {

// Values at the limits of what a reader may expect, as JSON and nearly all as TOML.
constexpr std::array<std::string_view, 40> kValues = {"0",
                                                      "1",
                                                      "-1",
                                                      "2",
                                                      "1.5",
                                                      "-0",
                                                      "1e999",
                                                      "18446744073709551615",
                                                      "18446744073709551616",
                                                      "-9223372036854775808",
                                                      "9223372036854775808",
                                                      "\"\"",
                                                      "\"0\"",
                                                      "\"-1\"",
                                                      "\"1.5\"",
                                                      "\"1e1000\"",
                                                      "\"1/3\"",
                                                      "\"1/0\"",
                                                      "\"nan\"",
                                                      "\"any\"",
                                                      "\"\\u0000\"",
                                                      "\"\\ud800\"",
                                                      "\"\xff\"",
                                                      "\"*\"",
                                                      "\"[\"",
                                                      "\"..\"",
                                                      "null",
                                                      "true",
                                                      "false",
                                                      "nan",
                                                      "inf",
                                                      "{}",
                                                      "[]",
                                                      "[[]]",
                                                      "[1]",
                                                      "[\"\"]",
                                                      "[{}]",
                                                      "{\"a\":1}",
                                                      "{\"root\":[\"0\",\"1\",\"2\"]}",
                                                      "{\"lo\":\"0\",\"hi\":\"1\"}"};

struct Range {
  std::size_t from = 0;
  std::size_t to = 0;
};

class FileMutator {
 public:
  FileMutator(std::string text, unsigned int seed) : text_(std::move(text)), random_(seed) {}
  void change();
  const std::string& text() const { return text_; }

 private:
  std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }
  std::string_view value() { return kValues[below(kValues.size())]; }
  static bool is_of_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_.+-").find(c) != std::string_view::npos;
  }
  // From a word on, or from a mark, so many of them.
  Range words(std::size_t count);
  // The line that has a place of the text, with its end.
  Range line();
  // What stands behind some ':' or '=', with all that lies between its brackets.
  Range place_of_value();
  std::string cut(Range range) const { return text_.substr(range.from, range.to - range.from); }
  void put(Range range, std::string_view text) {
    text_.replace(range.from, range.to - range.from, text);
  }

  std::string text_;
  std::mt19937 random_;
};

Range FileMutator::words(std::size_t count) {
  Range range{below(text_.size()), 0};
  while (range.from > 0 && is_of_word(text_[range.from]) && is_of_word(text_[range.from - 1]))
    --range.from;
  range.to = range.from;
  for (; count > 0 && range.to < text_.size(); --count) {
    const bool is_word = is_of_word(text_[range.to++]);
    while (is_word && range.to < text_.size() && is_of_word(text_[range.to])) ++range.to;
  }
  return range;
}

Range FileMutator::line() {
  const std::size_t at = below(text_.size());
  const std::size_t before = at == 0 ? std::string::npos : text_.rfind('\n', at - 1);
  const std::size_t end = text_.find('\n', at);
  return {before == std::string::npos ? 0 : before + 1,
          end == std::string::npos ? text_.size() : end + 1};
}

Range FileMutator::place_of_value() {
  std::size_t at = text_.find_first_of(":=", below(text_.size()));
  if (at == std::string::npos) at = text_.find_first_of(":=");
  if (at == std::string::npos) return words(1);
  Range range{++at, 0};
  std::size_t depth = 0;
  bool in_text = false;
  for (; at < text_.size() && text_[at] != '\n'; ++at) {
    const char c = text_[at];
    if (c == '"') in_text = !in_text;
    if (c == '\\') ++at;
    if (in_text) continue;
    if (c == '{' || c == '[') ++depth;
    const bool closes = c == '}' || c == ']';
    if (depth == 0 && (c == ',' || closes)) break;
    if (closes) --depth;
  }
  range.to = std::min(at, text_.size());
  return range;
}

void FileMutator::change() {
  switch (below(10)) {
    case 0:
      return put(words(1 + below(6)), "");
    case 1: {
      const std::string copy = cut(words(1 + below(12)));
      return put(words(0), copy);
    }
    case 2:
      return put(words(1), value());
    case 3:
      return put(words(0), value());
    case 4: {
      const std::string copy = cut(words(1));
      return put(words(1), copy);
    }
    case 5:
      return put(line(), "");
    case 6: {
      const std::string copy = cut(line());
      return put(line(), copy + copy);
    }
    case 7: {
      const std::string copy = cut(place_of_value());
      return put(place_of_value(), copy);
    }
    default:
      return put(place_of_value(), value());
  }
}

std::string changed(std::string_view input, unsigned int seed) {
  const std::string choice(input.substr(0, 1));
  FileMutator mutator(std::string(input.substr(choice.size())), seed);
  mutator.change();
  return (choice.empty() ? "a" : choice) + mutator.text();
}

}  // namespace
}  // namespace gonogo::fuzz

// NOLINTNEXTLINE(readability-non-const-parameter): the engine says what it is called with.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  gonogo::fuzz::run_stream_if_asked(*argc, *argv);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed) {
  using namespace gonogo::fuzz;
  if (LLVMFuzzerMutate != nullptr && is_turn_of_engine(seed))
    return LLVMFuzzerMutate(data, size, most);
  std::string text = changed(text_of(data, size), seed);
  text.resize(std::min(text.size(), most));
  std::ranges::copy(text, data);
  return text.size();
}

// The head of one file with the end of another.
extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* one, std::size_t one_size,
                                                 const std::uint8_t* other, std::size_t other_size,
                                                 std::uint8_t* out, std::size_t most,
                                                 unsigned int seed) {
  using namespace gonogo::fuzz;
  std::mt19937 random(seed);
  const std::string_view head =
      text_of(one, one_size).substr(0, one_size == 0 ? 0 : 1 + random() % one_size);
  const std::string_view end =
      text_of(other, other_size).substr(other_size == 0 ? 0 : random() % other_size);
  std::string text = std::string(head) + std::string(end);
  text.resize(std::min(text.size(), most));
  std::ranges::copy(text, out);
  return text.size();
}
