// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/calculated_words.hpp"

#include <algorithm>
#include <string>

#include "reference/range.hpp"

namespace gonogo::reference::rs274 {
namespace {

constexpr int kDecimalsOfMessages = 6;

// The decimal that the text is; nothing where it is none.
std::optional<grammar::Decimal> decimal_of(std::string text) {
  grammar::Decimal decimal;
  decimal.negative = text.starts_with('-');
  if (decimal.negative) text.erase(0, 1);
  const std::size_t point = text.find('.');
  if (point != std::string::npos) {
    text.erase(point, 1);
    decimal.scale = static_cast<std::uint32_t>(text.size() - point);
  }
  if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos) {
    return std::nullopt;
  }
  text.erase(0, std::min(text.find_first_not_of('0'), text.size() - 1));
  constexpr std::size_t kMostOfMagnitude = 18;
  if (text.size() <= kMostOfMagnitude) {
    decimal.magnitude = std::stoull(text);
  } else {
    decimal.long_digits = std::move(text);
  }
  return decimal;
}

}  // namespace

bool CalculatedWords::take(const grammar::Block& block, Calculator& calculator, BlockOutput& out) {
  block_ = block;
  values_.assign(block_.words.size(), std::nullopt);
  for (std::size_t i = 0; i < block_.words.size(); ++i) {
    grammar::Word& word = block_.words[i];
    if (word.terms.count == 0) continue;
    const std::optional<Number> value = calculator.value(block, word.terms);
    if (!value) return false;
    constexpr std::string_view kNumbers = "GMT";
    if (kNumbers.find(word.address) == std::string_view::npos && is_beyond_range(*value)) {
      out.beyond_range = word.where;
    }
    std::optional<grammar::Decimal> decimal;
    if (value->is_rational()) decimal = decimal_of(value->text());
    if (!decimal) {
      values_[i] = *value;
      decimal = decimal_of(value->decimal_text(kDecimalsOfMessages));
    }
    word.value = decimal.value_or(grammar::Decimal{});
  }
  return true;
}

}  // namespace gonogo::reference::rs274
