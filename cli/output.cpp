// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "cli/terminal.hpp"

namespace gonogo::cli {

namespace {

// "::" at the beginning of a line, and "##[" anywhere in it, with a mark of their own.
std::string without_commands(std::string_view line) {
  const std::size_t first = std::min(line.find_first_not_of(" \t"), line.size());
  std::string out(line);
  if (line.substr(first).starts_with("::")) out.insert(first, "\\");
  for (const std::string_view command : {"##[", "##vso["}) {
    for (std::size_t at = out.find(command); at != std::string::npos;
         at = out.find(command, at + 2)) {
      out.insert(at + 1, "\\");
    }
  }
  return out;
}

// With the codes of colours that in_tone() puts, where they are wanted.
std::string visible_beside_colour(std::string_view text, bool colour) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = colour ? text.find('\x1b') : text.size();
    out += oracle::visible(text.substr(0, end), oracle::Lines::kept);
    text.remove_prefix(std::min(end, text.size()));
    if (text.empty()) break;
    const std::size_t code = length_of_tone(text);
    out += code > 0 ? std::string(text.substr(0, code)) : oracle::visible(text.substr(0, 1));
    text.remove_prefix(std::max<std::size_t>(code, 1));
  }
  return out;
}

}  // namespace

std::string people_text(std::string_view text, bool colour) {
  const std::string shown = visible_beside_colour(text, colour);
  std::string out;
  for (std::size_t begin = 0; begin < shown.size();) {
    const std::size_t end = std::min(shown.find('\n', begin), shown.size());
    out += without_commands(std::string_view(shown).substr(begin, end - begin));
    if (end < shown.size()) out += '\n';
    begin = end + 1;
  }
  return out;
}

std::string message_text(std::string_view text) {
  std::string out;
  for (const char c : people_text(text, false)) {
    const bool begins_line = !out.empty() && out.back() == '\n';
    if (begins_line && c != ' ' && c != '\n') out += "  ";
    out += c;
  }
  return out;
}

void complain_each(std::string_view messages) {
  const std::string words = people_text(messages, false);
  std::fwrite(words.data(), 1, words.size(), stderr);
}

void Output::flush() {
  std::string_view rest = text_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int reason = errno;
      text_.clear();
      throw OutputError(fmt::format("The output cannot be written: {}.", std::strerror(reason)),
                        reason == EPIPE);
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  text_.clear();
}

void Output::tell() {
  const bool on_terminal = ::isatty(descriptor_) == 1;
  text_ = people_text(text_, on_terminal);
  if (on_terminal) text_ = wrapped(text_, columns_of_terminal(descriptor_));
  flush();
}

}  // namespace gonogo::cli
