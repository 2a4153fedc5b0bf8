// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/mutator/dictionary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <stdexcept>

#include "fuzz/program/dictionary_texts.hpp"
#include "fuzz/program/lines.hpp"
#include "fuzz/program/mutator/dictionary_entries.hpp"
#include "reference/dialect.hpp"

namespace gonogo::program {
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

std::vector<std::string> read_built_in(std::string_view name) {
  const auto file = std::ranges::find(kDictionaryTexts, name, &DictionaryText::name);
  auto read = read_dictionary(file->text);
  if (!std::holds_alternative<std::vector<std::string>>(read)) {
    throw std::logic_error("a built-in dictionary cannot be read");
  }
  return std::get<std::vector<std::string>>(std::move(read));
}

// The files of a dialect, beside that of numbers: its own, and that of its maker.
bool is_file_of(std::string_view file, std::string_view dialect) {
  return file == "numbers" || dialect.starts_with(file);
}

std::vector<Dictionary> read_all() {
  std::vector<Dictionary> all;
  for (const reference::Dialect& dialect : reference::dialects()) {
    Dictionary& dictionary = all.emplace_back(Dictionary{dialect.name, {}});
    std::vector<std::string> entries = entries_of(*dialect.descriptor);
    for (const DictionaryText& file : kDictionaryTexts) {
      if (!is_file_of(file.name, dialect.name)) continue;
      const std::vector<std::string> more = read_built_in(file.name);
      entries.insert(entries.end(), more.begin(), more.end());
    }
    std::set<std::string> seen;
    for (std::string& entry : entries) {
      if (seen.insert(entry).second) dictionary.entries.push_back(std::move(entry));
    }
  }
  return all;
}

// A byte that an entry cannot hold as it is.
bool is_escaped(char c) {
  return c < ' ' || c > '~';
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

std::string dictionary_text(std::string_view dialect) {
  std::set<std::string> lines;
  for (const Dictionary& dictionary : dictionaries()) {
    if (dictionary.dialect != dialect && find_dictionary(dialect) != nullptr) continue;
    for (const std::string& entry : dictionary.entries) {
      std::string line = "\"";
      for (const char c : entry) {
        if (c == '"' || c == '\\') line += '\\';
        line += is_escaped(c) ? fmt::format("\\x{:02X}", static_cast<unsigned char>(c))
                              : std::string(1, c);
      }
      lines.insert(line + "\"\n");
    }
  }
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

const Dictionary* find_dictionary(std::string_view dialect) {
  const auto found = std::ranges::find(dictionaries(), dialect, &Dictionary::dialect);
  return found == dictionaries().end() ? nullptr : &*found;
}

}  // namespace gonogo::program
