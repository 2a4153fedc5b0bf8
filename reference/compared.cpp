// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/compared.hpp"

#include <algorithm>
#include <vector>

namespace gonogo::reference {
namespace {

constexpr std::size_t kLongestExact = 14;  // digits that are shown
constexpr std::size_t kLongestWhole = 40;
constexpr int kFewestDecimals = 4;
constexpr int kMostDecimals = 16;

struct ValueText {
  std::string digits;
  std::string rounded;
  bool is_exact = false;
};

std::string without_trailing_zeros(std::string decimal) {
  decimal.erase(decimal.find_last_not_of('0') + 1);
  if (decimal.back() == '.') decimal.pop_back();
  return decimal == "-0" ? "0" : decimal;
}

ValueText text_of_value(const exact::Number& value, int decimals) {
  std::string rounded = without_trailing_zeros(value.decimal_text(decimals));
  if (value.is_rational()) {
    std::string text = value.text();
    const bool is_whole = text.find_first_of("./") == std::string::npos;
    const std::size_t longest = is_whole ? kLongestWhole : kLongestExact;
    if (text.size() <= longest && text.find('/') == std::string::npos) {
      return {std::move(text), std::move(rounded), true};
    }
  }
  return {rounded, rounded, false};
}

// Whether a rounded text is that of another value, rounded as well.
bool hides_a_difference(const std::vector<ValueText>& texts) {
  for (auto one = texts.begin(); one != texts.end(); ++one) {
    for (auto other = texts.begin(); other != one; ++other) {
      if (one->rounded == other->rounded && !(one->is_exact && other->is_exact)) return true;
    }
  }
  return false;
}

}  // namespace

std::string with_values(std::string_view sentence, std::initializer_list<exact::Number> values) {
  std::vector<ValueText> texts;
  for (int decimals = kFewestDecimals; decimals <= kMostDecimals; decimals += 4) {
    texts.clear();
    for (const exact::Number& value : values) texts.push_back(text_of_value(value, decimals));
    if (!hides_a_difference(texts)) break;
  }
  std::string text;
  for (const ValueText& value : texts) {
    const std::size_t place = sentence.find("{}");
    text += sentence.substr(0, place);
    if (!value.is_exact) text += "about ";
    text += value.digits;
    sentence.remove_prefix(place + 2);
  }
  return text.append(sentence);
}

}  // namespace gonogo::reference
