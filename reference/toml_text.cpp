// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/toml_text.hpp"

#include <algorithm>
#include <memory>

namespace gonogo::reference {
namespace {

constexpr std::size_t kMostParts = 16;  // of a key

// What follows the string that `text` begins with.
std::string_view behind_string(std::string_view text) {
  const char quote = text.front();
  const std::string long_quote(3, quote);
  const bool is_long = text.starts_with(long_quote);
  const std::string_view end = is_long ? std::string_view(long_quote) : text.substr(0, 1);
  text.remove_prefix(end.size());
  while (!text.empty() && !text.starts_with(end)) {
    if (!is_long && text.front() == '\n') return text;  // no string: the parser says so
    const bool escapes = quote == '"' && text.front() == '\\';
    text.remove_prefix(escapes && text.size() > 1 ? 2 : 1);
  }
  text.remove_prefix(std::min(end.size(), text.size()));
  return text;
}

// Points between two of the bytes that end a key or a value, strings and comments aside.
void check_keys(std::string_view text, std::string_view path) {
  std::size_t points = 0;
  toml::source_position at{1, 1};
  while (!text.empty()) {
    const char c = text.front();
    if (c == '"' || c == '\'') {
      const std::string_view rest = behind_string(text);
      const std::string_view passed = text.substr(0, text.size() - rest.size());
      at.line += static_cast<toml::source_index>(std::ranges::count(passed, '\n'));
      text = rest;
      continue;
    }
    if (c == '#') {
      text.remove_prefix(std::min(text.find('\n'), text.size()));
      continue;
    }
    if (c == '\n') ++at.line;
    if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) points = 0;
    if (c == '.' && ++points >= kMostParts) {
      throw toml::parse_error("A key has more than 16 parts", at,
                              std::make_shared<const std::string>(path));
    }
    text.remove_prefix(1);
  }
}

}  // namespace

toml::table parse_toml(std::string_view text, std::string_view path) {
  check_keys(text, path);
  return toml::parse(text, path);
}

namespace {

constexpr std::size_t kMostShown = 100;  // bytes of a line

// The line with a caret under the column, which counts from 1; nothing of a long one.
std::string marked_line(std::string_view text, std::size_t number, std::size_t column) {
  for (std::size_t line = 1; line < number; ++line) {
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    if (text.empty()) return {};
  }
  const std::string line(text.substr(0, text.find_first_of("\r\n")));
  if (line.empty() || line.size() > kMostShown || column > line.size() + 1) return {};
  return "\n  " + line + "\n  " + std::string(column - 1, ' ') + "^";
}

}  // namespace

std::string toml_fault(std::string_view text, const toml::parse_error& error) {
  const toml::source_position& at = error.source().begin;
  const std::string_view what = error.description();
  std::string said(what);
  if (what.find("redefine") != std::string_view::npos) {
    said = "The key or table stands twice. Keep one of them.";
  } else if (what.starts_with("Error while parsing")) {
    said =
        "This is no TOML. A line is a key, = and a value: a text in quotes, a number, true or "
        "false, or a list in [ ].";
  }
  return "line " + std::to_string(at.line) + ", column " + std::to_string(at.column) + ": " + said +
         marked_line(text, at.line, at.column);
}

}  // namespace gonogo::reference
