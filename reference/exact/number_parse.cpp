// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers as they are written in a record (docs/protocol.md, "Numbers"):
//   decimal  [+-] digits [. digits] [e [+-] digits]     "12." and ".5" too
//   rational [+-] digits / digits
//   hex      [+-] 0x hexdigits [. hexdigits] [p [+-] digits]
#include <gmpxx.h>

#include "reference/exact/number.hpp"
#include "reference/exact/rational.hpp"

namespace gonogo::exact {
namespace {

constexpr std::size_t kMaxWordDigits = 19;  // fit in 64 bits

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_hex_digit(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

bool is_letter(char c, char lower) {
  return (c | 0x20) == lower;
}

// Takes a sign off the front; true for minus.
bool take_sign(std::string_view& text) {
  if (text.empty() || (text.front() != '+' && text.front() != '-')) return false;
  const bool negative = text.front() == '-';
  text.remove_prefix(1);
  return negative;
}

template <typename IsDigit>
std::string_view take_digits(std::string_view& text, IsDigit digit) {
  std::size_t length = 0;
  while (length < text.size() && digit(text[length])) ++length;
  const std::string_view digits = text.substr(0, length);
  text.remove_prefix(length);
  return digits;
}

// digits [. digits], of which at least one digit.
struct Mantissa {
  std::string_view whole;
  std::string_view fraction;
  std::string joined() const { return std::string(whole).append(fraction); }
};

template <typename IsDigit>
std::optional<Mantissa> take_mantissa(std::string_view& text, IsDigit digit) {
  Mantissa mantissa{take_digits(text, digit), {}};
  if (!text.empty() && text.front() == '.') {
    text.remove_prefix(1);
    mantissa.fraction = take_digits(text, digit);
  }
  if (mantissa.whole.empty() && mantissa.fraction.empty()) return std::nullopt;
  return mantissa;
}

// The whole rest of the text: nothing, or the letter, a sign and digits.
std::optional<int> exponent_of(std::string_view text, char letter) {
  if (text.empty()) return 0;
  if (!is_letter(text.front(), letter)) return std::nullopt;
  text.remove_prefix(1);
  const bool negative = take_sign(text);
  const std::string_view digits = take_digits(text, is_digit);
  if (digits.empty() || !text.empty()) return std::nullopt;
  int value = 0;
  for (const char c : digits) {
    value = value * 10 + (c - '0');
    if (value > kMostExponent) return std::nullopt;
  }
  return negative ? -value : value;
}

Number long_decimal(bool negative, const Mantissa& mantissa, int exponent) {
  mpz_class digits(mantissa.joined(), 10);
  if (negative) digits = -digits;
  const long scale = static_cast<long>(mantissa.fraction.size()) - exponent;
  if (scale <= 0)
    return number_of(mpz_class(digits * power_of_ten(static_cast<unsigned long>(-scale))));
  mpq_class value(digits, power_of_ten(static_cast<unsigned long>(scale)));
  value.canonicalize();
  return number_of(std::move(value));
}

std::optional<Number> parse_decimal(bool negative, std::string_view text) {
  const auto mantissa = take_mantissa(text, is_digit);
  if (!mantissa) return std::nullopt;
  const auto exponent = exponent_of(text, 'e');
  if (!exponent) return std::nullopt;
  return long_decimal(negative, *mantissa, *exponent);
}

std::optional<Number> parse_hex(bool negative, std::string_view text) {
  const auto mantissa = take_mantissa(text, is_hex_digit);
  if (!mantissa) return std::nullopt;
  const auto exponent = exponent_of(text, 'p');
  if (!exponent) return std::nullopt;
  mpq_class value(mpz_class(mantissa->joined(), 16));
  if (negative) value = -value;
  const long shift = *exponent - 4 * static_cast<long>(mantissa->fraction.size());
  if (shift >= 0) {
    mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(shift));
  } else {
    mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-shift));
  }
  return number_of(std::move(value));
}

std::optional<Number> parse_fraction(bool negative, std::string_view text, std::size_t slash) {
  std::string_view numerator = text.substr(0, slash);
  std::string_view denominator = text.substr(slash + 1);
  const std::string p(take_digits(numerator, is_digit));
  const std::string q(take_digits(denominator, is_digit));
  if (p.empty() || q.empty() || !numerator.empty() || !denominator.empty()) return std::nullopt;
  mpq_class value(mpz_class(p, 10), mpz_class(q, 10));
  if (value.get_den() == 0) return std::nullopt;
  value.canonicalize();
  if (negative) value = -value;
  return number_of(std::move(value));
}

// digits [. digits] of a length that fits in a word, in one pass: nearly every number there is.
// Nothing says only that the long way has to be taken.
std::optional<Number> parse_short_decimal(bool negative, std::string_view text) {
  if (text.empty() || text.size() > kMaxWordDigits) return std::nullopt;
  std::uint64_t magnitude = 0;
  std::size_t point = text.size();
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_digit(text[i])) {
      magnitude = magnitude * 10 + static_cast<std::uint64_t>(text[i] - '0');
    } else if (text[i] == '.' && point == text.size() && text.size() > 1) {
      point = i;
    } else {
      return std::nullopt;
    }
  }
  const std::size_t places = point == text.size() ? 0 : text.size() - point - 1;
  return Number::decimal(negative, magnitude, static_cast<std::uint32_t>(places));
}

}  // namespace

std::optional<Number> Number::parse(std::string_view text) {
  if (text.size() > kMostCharacters) return std::nullopt;
  const bool negative = take_sign(text);
  if (auto value = parse_short_decimal(negative, text)) return value;
  if (text.size() > 2 && text[0] == '0' && is_letter(text[1], 'x')) {
    return parse_hex(negative, text.substr(2));
  }
  const std::size_t slash = text.find('/');
  if (slash != std::string_view::npos) return parse_fraction(negative, text, slash);
  return parse_decimal(negative, text);
}

}  // namespace gonogo::exact
