// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/text.hpp"

#include <fmt/format.h>
#include <simdjson.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace gonogo::oracle {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
constexpr std::string_view kBase64 =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

bool is_continuation(unsigned char byte) {
  return (byte & 0xC0U) == 0x80;
}

// Length of the well-formed character at the start of `text`; 0: there is none.
std::size_t character_length(std::string_view text) {
  auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = at(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation(at(i))) return 0;
  }
  // No overlong forms, no surrogates, nothing above U+10FFFF.
  const unsigned char second = at(1);
  if (lead == 0xE0 && second < 0xA0) return 0;
  if (lead == 0xED && second > 0x9F) return 0;
  if (lead == 0xF0 && second < 0x90) return 0;
  if (lead == 0xF4 && second > 0x8F) return 0;
  return length;
}

}  // namespace

bool is_utf8(std::string_view text) {
  return simdjson::validate_utf8(text.data(), text.size());
}

void append_json_string(std::string_view text, std::string& out) {
  constexpr std::string_view kHex = "0123456789abcdef";
  out += '"';
  for (char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (byte < 0x20 || byte == 0x7F) {
      out += "\\u00";
      out += kHex[byte >> 4];
      out += kHex[byte & 15U];
    } else {
      out += c;
    }
  }
  out += '"';
}

std::string base64(std::string_view bytes) {
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      group = group << 8 | (j < count ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      out += j <= count ? kBase64[group >> (18 - 6 * j) & 63U] : '=';
    }
  }
  return out;
}

std::optional<std::string> decode_base64(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  unsigned waiting = 0;
  for (const char digit : text.substr(0, text.find('='))) {
    const std::size_t value = kBase64.find(digit);
    if (value == std::string_view::npos) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    waiting += 6;
    if (waiting < 8) continue;
    waiting -= 8;
    bytes += static_cast<char>(bits >> waiting & 0xFFU);
  }
  // Only one text stands for given bytes: padding and unused bits are checked by writing it again.
  if (base64(bytes) != text) return std::nullopt;
  return bytes;
}

std::string readable(std::string_view bytes) {
  if (is_utf8(bytes)) return std::string(bytes);
  std::string out;
  while (!bytes.empty()) {
    const std::size_t length = character_length(bytes);
    if (length == 0) {
      out += kReplacement;
    } else {
      out += bytes.substr(0, length);
    }
    bytes.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

namespace {

// The code point of a well-formed character.
std::uint32_t code_point(std::string_view character) {
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  const std::size_t length = character.size();
  std::uint32_t code = length == 1 ? at(0) : at(0) & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) code = code << 6 | (at(i) & 0x3FU);
  return code;
}

// Controls of the first and the second table, marks of direction, what has no width, line and
// paragraph ends.
bool is_hidden(std::uint32_t code) {
  constexpr std::array<std::pair<std::uint32_t, std::uint32_t>, 9> kRanges = {{{0, 0x1F},
                                                                               {0x7F, 0x9F},
                                                                               {0xAD, 0xAD},
                                                                               {0x61C, 0x61C},
                                                                               {0x200B, 0x200F},
                                                                               {0x2028, 0x202E},
                                                                               {0x2060, 0x206F},
                                                                               {0xFEFF, 0xFEFF},
                                                                               {0xE0000, 0xE007F}}};
  return std::ranges::any_of(
      kRanges, [&](const auto& range) { return range.first <= code && code <= range.second; });
}

std::string written_out(std::uint32_t code) {
  if (code == '\n') return "\\n";
  if (code == '\r') return "\\r";
  if (code == '\t') return "\\t";
  return fmt::format("\\u{{{:x}}}", code);
}

bool is_plain(char c) {
  return c >= ' ' && c <= '~';
}

bool is_plain_in_shell(char c) {
  constexpr std::string_view kPlain = "_@%+=:,./-";
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         kPlain.find(c) != std::string_view::npos;
}

}  // namespace

std::string visible(std::string_view bytes, Lines lines) {
  if (std::ranges::all_of(bytes, is_plain)) return std::string(bytes);
  std::string out;
  const std::string text = readable(bytes);
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view character = rest.substr(0, character_length(rest));
    const std::uint32_t code = code_point(character);
    const bool stays = !is_hidden(code) || (lines == Lines::kept && (code == '\n' || code == '\t'));
    out += stays ? std::string(character) : written_out(code);
    rest.remove_prefix(character.size());
  }
  return out;
}

std::string excerpt(std::string_view bytes, std::size_t limit) {
  bytes = bytes.substr(0, bytes.find_last_not_of("\r\n") + 1);
  if (bytes.size() <= limit) return visible(bytes);
  while (limit > 0 && is_continuation(static_cast<unsigned char>(bytes[limit]))) --limit;
  return visible(bytes.substr(0, limit)) + "...";
}

namespace {

std::string escaped_in_shell(std::string_view word) {
  std::string out;
  while (!word.empty()) {
    const std::string_view character = word.substr(0, character_length(word));
    const std::uint32_t code = code_point(character);
    if (is_hidden(code)) {
      out += code < 0x80 ? fmt::format("\\x{:02x}", code) : fmt::format("\\U{:08x}", code);
    } else {
      if (character == "'" || character == "\\") out += '\\';
      out += character;
    }
    word.remove_prefix(character.size());
  }
  return out;
}

}  // namespace

std::string shell_quoted(std::string_view word) {
  if (!word.empty() && std::ranges::all_of(word, is_plain_in_shell)) return std::string(word);
  // What would move the cursor or break the line has a spelling of its own in the shells of today.
  if (visible(word) != word && is_utf8(word)) return "$'" + escaped_in_shell(word) + "'";
  std::string out = "'";
  for (char c : word) {
    if (c == '\'') {
      out += "'\\''";
    } else {
      out += c;
    }
  }
  return out += '\'';
}

std::string date_text(std::chrono::system_clock::time_point time) {
  using std::chrono::floor;
  const auto day = floor<std::chrono::days>(time);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss clock(floor<std::chrono::minutes>(time - day));
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02} UTC", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock.hours().count(), clock.minutes().count());
}

}  // namespace gonogo::oracle
