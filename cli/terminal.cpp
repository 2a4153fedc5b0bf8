// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

namespace gonogo::cli {

std::size_t columns_of_terminal(int descriptor) {
  winsize size{};
  const bool is_known = ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? size.ws_col : 80;
}

namespace {

constexpr std::size_t kMostIndent = 34;

// Characters that take a column: neither colour nor the further bytes of a UTF-8 character.
std::size_t width_of(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\033') {
      i = std::min(text.find('m', i), text.size() - 1);
    } else if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) {
      ++width;
    }
  }
  return width;
}

// Where words begin that stand two or more blanks behind what is before them.
std::vector<std::size_t> columns_in(std::string_view line) {
  std::vector<std::size_t> columns;
  for (std::size_t at = line.find("  "); at != std::string_view::npos; at = line.find("  ", at)) {
    at = line.find_first_not_of(' ', at);
    if (at == std::string_view::npos) break;
    columns.push_back(at);
  }
  return columns;
}

bool is_kept(std::string_view line, const std::vector<std::size_t>& columns) {
  const std::size_t first = line.find_first_not_of(' ');
  const std::string_view text = line.substr(std::min(first, line.size()));
  const std::size_t past_number = text.find_first_not_of("0123456789 ");
  const bool is_block = past_number != std::string_view::npos && text[past_number] == '|';
  const bool is_program = first == 4;
  const bool is_command =
      text.starts_with("again ") || text.starts_with("next ") || text.starts_with("gonogo ");
  return is_block || is_program || is_command || columns.size() > 3;
}

void append_wrapped(std::string_view line, std::size_t columns, std::string& out) {
  if (width_of(line) <= columns) {
    out += line;
    return;
  }
  const std::vector<std::size_t> starts = columns_in(line);
  if (is_kept(line, starts)) {
    out += line;
    return;
  }
  const std::size_t first = std::min(line.find_first_not_of(' '), line.size());
  // The last column of the line, where that leaves room for words.
  std::size_t indent = first + 2;
  for (const std::size_t start : starts) {
    if (start > first && start <= std::min(kMostIndent, columns / 2)) indent = start;
  }
  std::size_t begin = 0;
  std::size_t width = 0;
  while (begin < line.size()) {
    std::size_t end = line.find(' ', std::max(begin, width == 0 ? first : begin) + 1);
    end = std::min(end, line.size());
    const std::string_view word = line.substr(begin, end - begin);
    if (width > indent && width + width_of(word) > columns) {
      out += "\n" + std::string(indent, ' ');
      width = indent;
      const std::size_t blank = word.find_first_not_of(' ');
      out += word.substr(std::min(blank, word.size()));
      width += width_of(word.substr(std::min(blank, word.size())));
    } else {
      out += word;
      width += width_of(word);
    }
    begin = end;
  }
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t columns) {
  std::string out;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    append_wrapped(text.substr(begin, end - begin), columns, out);
    if (end < text.size()) out += '\n';
    begin = end + 1;
  }
  return out;
}

namespace {

// In the order of Tone.
constexpr std::array<std::string_view, 4> kCodes = {"1;32", "1;31", "1;33", "1"};

std::string begin_of_tone(Tone tone) {
  return fmt::format("\x1b[{}m", kCodes[static_cast<std::size_t>(tone)]);
}

}  // namespace

// https://no-color.org: any value that is not empty.
bool wants_colour(int descriptor) {
  const char* refused = std::getenv("NO_COLOR");
  if (refused != nullptr && *refused != '\0') return false;
  const char* terminal = std::getenv("TERM");
  if (terminal == nullptr || std::string_view(terminal) == "dumb") return false;
  return ::isatty(descriptor) == 1;
}

std::string in_tone(std::string_view text, Tone tone, bool colour) {
  if (!colour) return std::string(text);
  return fmt::format("{}{}\x1b[0m", begin_of_tone(tone), text);
}

std::size_t length_of_tone(std::string_view text) {
  constexpr std::string_view kEnd = "\x1b[0m";
  for (const Tone tone : {Tone::good, Tone::bad, Tone::unsure, Tone::strong}) {
    const std::string begin = begin_of_tone(tone);
    if (text.starts_with(begin)) return begin.size();
  }
  return text.starts_with(kEnd) ? kEnd.size() : 0;
}

Tone tone_of(std::string_view decision) {
  if (decision.starts_with("GO")) return Tone::good;
  return decision.starts_with("NO-GO") ? Tone::bad : Tone::unsure;
}

}  // namespace gonogo::cli
