// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/relations/related_lines.hpp"

#include <algorithm>
#include <numeric>

namespace gonogo::fuzz {
namespace {

// Whether it can stand before the head of a program.
bool is_before_blocks(const TextLine& line) {
  return line.words.empty() || line.words.front().text.find_first_of("%O(;") == 0;
}

}  // namespace

std::vector<std::uint64_t> same_lines(std::size_t count) {
  std::vector<std::uint64_t> lines(count);
  std::iota(lines.begin(), lines.end(), 1);
  return lines;
}

std::optional<Related> with_block_before(const GeneratedProgram& program, std::string block) {
  std::vector<TextLine> lines = lines_of(program.text);
  const auto first = std::ranges::find_if_not(lines, is_before_blocks);
  if (first == lines.end() || first->words.front().text.front() == '/') return std::nullopt;
  Related related;
  related.lines = same_lines(lines.size());
  for (std::size_t i = static_cast<std::size_t>(first - lines.begin()); i < lines.size(); ++i) {
    ++related.lines[i];
  }
  lines.insert(first, TextLine{{{"", std::move(block)}}, "", "\n"});
  related.program = {program.profile, text_of(lines)};
  return related;
}

bool holds(const TextLine& line, std::string_view code) {
  return std::ranges::any_of(line.words,
                             [&](const TextWord& word) { return code_of(word) == code; });
}

bool holds_any(const std::vector<TextLine>& lines, std::initializer_list<std::string_view> codes) {
  return std::ranges::any_of(lines, [&](const TextLine& line) {
    return std::ranges::any_of(codes, [&](std::string_view code) { return holds(line, code); });
  });
}

namespace {

bool has_word(const std::vector<TextLine>& lines, bool (*is_it)(const std::string&)) {
  return std::ranges::any_of(lines, [&](const TextLine& line) {
    return std::ranges::any_of(line.words, [&](const TextWord& word) { return is_it(word.text); });
  });
}

}  // namespace

bool has_bare_g(const std::vector<TextLine>& lines) {
  return has_word(lines, [](const std::string& text) { return text == "G" || text == "g"; });
}

namespace {

// G91.0001, which may count as G91 (ngc.whole).
bool is_nearly_a_code(const TextWord& word) {
  const std::string code = code_of(word);
  const std::size_t point = code.find('.');
  return point != std::string::npos && code.size() - point > 2;
}

}  // namespace

bool has_unclear_words(const std::vector<TextLine>& lines) {
  const bool has_near_codes = std::ranges::any_of(lines, [](const TextLine& line) {
    return std::ranges::any_of(line.words, is_nearly_a_code);
  });
  return has_near_codes || has_bare_g(lines) || has_word(lines, [](const std::string& text) {
           const bool goes_on =
               std::string_view("=+-*/").find(text.back()) != std::string_view::npos;
           const bool is_part_of_a_number = text[0] == '.' || (text[0] >= '0' && text[0] <= '9');
           return text.starts_with("=") || is_part_of_a_number ||
                  (goes_on && text != "/");  // a block that may be left out
         });
}

bool is_left_out(const TextLine& line, const reference::Profile& profile) {
  return profile.block_skip && !line.words.empty() && line.words.front().text.front() == '/';
}

}  // namespace gonogo::fuzz
