// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "oracle/records/text.hpp"
#include "publish/evidence/certificate_files.hpp"
#include "publish/report/escape.hpp"

namespace gonogo::oracle::evidence {
namespace {

bool is_letter_or_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_name_character(char c) {
  return is_letter_or_digit(c) || c == '.' || c == '-' || c == '_';
}

bool is_punctuation(char c) {
  return c > ' ' && c < '\x7f' && !is_letter_or_digit(c);
}

// The length of the longest row of backticks.
std::size_t longest_ticks(std::string_view text) {
  std::size_t longest = 0;
  std::size_t here = 0;
  for (char c : text) {
    here = c == '`' ? here + 1 : 0;
    longest = std::max(longest, here);
  }
  return longest;
}

}  // namespace

std::string xml_attribute(std::string_view text) {
  std::string out;
  for (char c : report::markup_text(text)) {
    const bool is_blank = c == '\n' || c == '\r' || c == '\t';
    out += is_blank ? fmt::format("&#{};", static_cast<int>(c)) : std::string(1, c);
  }
  return out;
}

std::string markdown_text(std::string_view bytes) {
  const std::string text = visible(bytes, Lines::kept);
  // Punctuation that stands inside words and numbers is markup nowhere.
  constexpr std::string_view kPlain = ".,:;/='\"()%?";
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (static_cast<unsigned char>(c) < ' ') {
      out += ' ';
      continue;
    }
    const bool in_word = c == '-' && i > 0 && is_letter_or_digit(text[i - 1]);
    if (is_punctuation(c) && !in_word && kPlain.find(c) == std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string markdown_code(std::string_view bytes) {
  const std::string text = visible(bytes, Lines::kept);
  std::string plain;
  for (char c : text) {
    plain += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  const std::string ticks(longest_ticks(plain) + 1, '`');
  const std::string space = ticks.size() > 1 ? " " : "";
  return ticks + space + plain + space + ticks;
}

std::string markdown_fence(std::string_view bytes) {
  const std::string text = visible(bytes, Lines::kept);
  const std::string ticks(std::max<std::size_t>(3, longest_ticks(text) + 1), '`');
  std::string out = ticks + "\n";
  out += text;
  if (!text.ends_with('\n')) out += '\n';
  return out + ticks + "\n";
}

std::string file_stem(std::string_view id) {
  constexpr std::size_t kLongest = 120;
  constexpr std::size_t kKept = 60;
  const bool safe = !id.empty() && id.size() <= kLongest && is_letter_or_digit(id.front()) &&
                    std::ranges::all_of(id, is_name_character);
  if (safe) return std::string(id);
  std::string kept;
  for (char c : id.substr(0, kKept)) kept += is_name_character(c) ? c : '_';
  if (kept.empty() || !is_letter_or_digit(kept.front())) kept.insert(0, "case");
  return kept + "-" + sha256_of_text(id).substr(0, 16);
}

}  // namespace gonogo::oracle::evidence
