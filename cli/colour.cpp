// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/colour.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

namespace gonogo::cli {
namespace {

std::string_view code_of(Tone tone) {
  switch (tone) {
    case Tone::good:
      return "1;32";
    case Tone::bad:
      return "1;31";
    case Tone::unsure:
      return "1;33";
    default:
      return "1";
  }
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
  return fmt::format("\x1b[{}m{}\x1b[0m", code_of(tone), text);
}

std::size_t length_of_tone(std::string_view text) {
  constexpr std::string_view kEnd = "\x1b[0m";
  for (const Tone tone : {Tone::good, Tone::bad, Tone::unsure, Tone::strong}) {
    const std::string begin = fmt::format("\x1b[{}m", code_of(tone));
    if (text.starts_with(begin)) return begin.size();
  }
  return text.starts_with(kEnd) ? kEnd.size() : 0;
}

Tone tone_of(std::string_view decision) {
  if (decision.starts_with("GO")) return Tone::good;
  return decision.starts_with("NO-GO") ? Tone::bad : Tone::unsure;
}

}  // namespace gonogo::cli
