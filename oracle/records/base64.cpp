// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/base64.hpp"

#include <cstdint>

#include "oracle/records/text.hpp"

namespace gonogo::oracle {

std::optional<std::string> decode_base64(std::string_view text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  unsigned waiting = 0;
  for (const char digit : text.substr(0, text.find('='))) {
    const std::size_t value = kDigits.find(digit);
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

}  // namespace gonogo::oracle
