// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/mutator/dictionary.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>

#include "fuzz/dictionary_texts.hpp"
#include "fuzz/program_lines.hpp"

namespace gonogo::fuzz {
namespace {

// The byte that stands at the beginning of `rest`, which is cut off.
std::optional<char> take_byte(std::string_view& rest) {
  const char first = rest.front();
  rest.remove_prefix(1);
  if (first == '"') return std::nullopt;
  if (first != '\\') return first;
  if (rest.starts_with('\\') || rest.starts_with('"')) {
    const char escaped = rest.front();
    rest.remove_prefix(1);
    return escaped;
  }
  if (rest.size() < 3 || rest.front() != 'x') return std::nullopt;
  unsigned value = 0;
  const char* const end = rest.data() + 3;
  if (std::from_chars(rest.data() + 1, end, value, 16).ptr != end) return std::nullopt;
  rest.remove_prefix(3);
  return static_cast<char>(value);
}

std::optional<std::string> read_entry(std::string_view line) {
  if (line.size() < 3 || line.front() != '"' || line.back() != '"') return std::nullopt;
  std::string_view rest = line.substr(1, line.size() - 2);
  std::string entry;
  while (!rest.empty()) {
    const std::optional<char> byte = take_byte(rest);
    if (!byte) return std::nullopt;
    entry += *byte;
  }
  if (entry.size() > kLongestEntry) return std::nullopt;
  return entry;
}

std::vector<Dictionary> read_all() {
  std::vector<Dictionary> all;
  for (const DictionaryText& file : kDictionaryTexts) {
    auto read = read_dictionary(file.text);
    if (!std::holds_alternative<std::vector<std::string>>(read)) {
      throw std::logic_error("a built-in dictionary cannot be read");
    }
    all.push_back({file.dialect, std::get<std::vector<std::string>>(std::move(read))});
  }
  return all;
}

}  // namespace

std::variant<std::vector<std::string>, std::size_t> read_dictionary(std::string_view text) {
  std::vector<std::string> entries;
  std::size_t number = 0;
  for (const ProgramLine& line : program_lines(text)) {
    ++number;
    if (line.text.empty() || line.text.front() == '#') continue;
    std::optional<std::string> entry = read_entry(line.text);
    if (!entry) return number;
    entries.push_back(std::move(*entry));
  }
  return entries;
}

std::span<const Dictionary> dictionaries() {
  static const std::vector<Dictionary> kAll = read_all();
  return kAll;
}

const Dictionary* find_dictionary(std::string_view dialect) {
  const auto found = std::ranges::find(dictionaries(), dialect, &Dictionary::dialect);
  return found == dictionaries().end() ? nullptr : &*found;
}

}  // namespace gonogo::fuzz
