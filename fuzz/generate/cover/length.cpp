// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/cover/length.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "fuzz/generate/cover/parameters.hpp"
#include "fuzz/program/text.hpp"

namespace gonogo::cover {

Length Length::parse(std::string_view text) {
  Length length;
  const std::string_view whole = text;
  if (text.ends_with('e')) {
    text.remove_suffix(1);
    const std::size_t sign = text.find_last_of("+-");
    const std::size_t begin = sign == std::string_view::npos ? 0 : sign + 1;
    const std::string count(text.substr(begin));
    length.increments = count.empty() ? 1 : std::strtoll(count.c_str(), nullptr, 10);
    if (begin > 0 && text[sign] == '-') length.increments = -length.increments;
    text = text.substr(0, begin > 0 ? begin - 1 : 0);
  }
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const std::size_t point = std::min(text.find('.'), text.size());
  std::string digits(text.substr(0, point));
  std::string fraction(text.substr(std::min(point + 1, text.size())));
  if (fraction.size() > 3) throw ModelError(fmt::format("{} has more than three decimals.", whole));
  fraction.resize(3, '0');
  digits += fraction;
  if (digits.find_first_not_of("0123456789") != std::string::npos) {
    throw ModelError(fmt::format("{} is no length.", whole));
  }
  length.thousandths = std::strtoll(digits.c_str(), nullptr, 10);
  if (negative) length.thousandths = -length.thousandths;
  return length;
}

std::string Length::text(int decimals) const {
  std::int64_t scale = 1;
  for (int i = 0; i < decimals; ++i) scale *= 10;
  return program::SmallDecimal{thousandths * (scale / 1000) + increments, decimals}.text();
}

int Length::sign() const {
  const std::int64_t decides = thousandths != 0 ? thousandths : increments;
  return decides < 0 ? -1 : decides > 0 ? 1 : 0;
}

}  // namespace gonogo::cover
