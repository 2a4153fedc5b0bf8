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
  for (const std::string_view code : {"1;32", "1;31", "1;33", "1", "0"}) {
    const std::string whole = fmt::format("\x1b[{}m", code);
    if (text.starts_with(whole)) return whole.size();
  }
  return 0;
}

Tone tone_of(std::string_view decision) {
  if (decision.starts_with("GO")) return Tone::good;
  return decision.starts_with("NO-GO") ? Tone::bad : Tone::unsure;
}

}  // namespace gonogo::cli
