// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers as text: for records (append_json), for people (text) and rounded (decimal_text).
#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include "reference/exact/enclosure.hpp"
#include "reference/exact/number.hpp"
#include "reference/exact/rational.hpp"
#include "reference/exact/root.hpp"

namespace gonogo::exact {
namespace {

// Enclosures are written on a grid of 1e-20 from bounds 2^-64 apart: at most 1e-15 together.
constexpr int kEnclosurePlaces = 20;
constexpr int kEnclosureBits = 64;

void append_small(std::string& out, std::int64_t count) {
  std::array<char, 24> buffer;
  char* const end = buffer.data() + buffer.size();
  char* begin = end;
  const auto bits = static_cast<std::uint64_t>(count);
  const std::uint64_t magnitude = count < 0 ? 0 - bits : bits;
  std::uint64_t whole = magnitude / detail::kUnit;
  std::uint64_t fraction = magnitude % detail::kUnit;
  if (fraction != 0) {
    int places = 6;
    for (; fraction % 10 == 0; fraction /= 10) --places;
    for (; places > 0; --places, fraction /= 10) *--begin = static_cast<char>('0' + fraction % 10);
    *--begin = '.';
  }
  do {
    *--begin = static_cast<char>('0' + whole % 10);
    whole /= 10;
  } while (whole != 0);
  if (count < 0) *--begin = '-';
  out.append(begin, static_cast<std::size_t>(end - begin));
}

// The digits with so many of them behind the point.
std::string with_point(std::string text, unsigned long places) {
  if (places == 0) return text;
  if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
  return text.insert(text.size() - places, 1, '.');
}

// digits / 10^places, with all its places.
std::string point_text(const mpz_class& digits, unsigned long places) {
  return (sgn(digits) < 0 ? "-" : "") + with_point(mpz_class(abs(digits)).get_str(), places);
}

// The places that a terminating decimal needs; nothing when the value is none.
std::optional<unsigned long> terminating_places(const mpq_class& value) {
  const unsigned long twos = mpz_scan1(value.get_den_mpz_t(), 0);
  mpz_class rest = value.get_den() >> twos;
  if (rest == 1) return twos;
  const mpz_class five = 5;
  const unsigned long fives = mpz_remove(rest.get_mpz_t(), rest.get_mpz_t(), five.get_mpz_t());
  if (rest != 1) return std::nullopt;
  return std::max(twos, fives);
}

// digits * 10^exponent, with the digits that it needs and an exponent that is read.
std::string scientific_text(mpz_class digits, long exponent) {
  const mpz_class ten = 10;
  exponent +=
      static_cast<long>(mpz_remove(digits.get_mpz_t(), digits.get_mpz_t(), ten.get_mpz_t()));
  const long told = std::clamp(exponent, -kMostExponent, kMostExponent);
  if (exponent > told) digits *= power_of_ten(static_cast<unsigned long>(exponent - told));
  const auto places = static_cast<unsigned long>(std::max(0L, told - exponent));
  return point_text(digits, places) + "e" + std::to_string(told);
}

// The same to the base of two. REQUIRES: a denominator that is a power of it.
std::string binary_text(const mpq_class& value) {
  mpz_class digits = abs(value.get_num());
  const mp_bitcnt_t twos = mpz_scan1(digits.get_mpz_t(), 0);
  const long exponent =
      static_cast<long>(twos) - static_cast<long>(mpz_scan1(value.get_den_mpz_t(), 0));
  const long told = std::clamp(exponent, -kMostExponent, kMostExponent);
  digits >>= twos;
  if (exponent > told) digits <<= static_cast<mp_bitcnt_t>(exponent - told);
  const auto bits = static_cast<mp_bitcnt_t>(std::max(0L, told - exponent));
  digits <<= (4 - bits % 4) % 4;
  return (sgn(value) < 0 ? "-0x" : "0x") + with_point(digits.get_str(16), (bits + 3) / 4) + "p" +
         std::to_string(told);
}

// What is too long for a record as a decimal: as a fraction, with an exponent, with a power of two;
// the first that can be read back, else the shortest.
std::string long_rational_text(const mpq_class& value, std::optional<unsigned long> places) {
  std::string text = value.get_str();
  const auto prefer = [&](std::string other) {
    if (text.size() > kMostCharacters && other.size() < text.size()) text = std::move(other);
  };
  if (places) {
    prefer(scientific_text(value.get_num() * (power_of_ten(*places) / value.get_den()),
                           -static_cast<long>(*places)));
  }
  if (mpz_popcount(value.get_den_mpz_t()) == 1) prefer(binary_text(value));
  return text;
}

void append_rational(std::string& out, const Number& value) {
  if (NumberAccess::node(value) == nullptr) {
    append_small(out, NumberAccess::millionths(value));
    return;
  }
  mpq_class scratch;
  const mpq_class& exact = rational_of(value, scratch);
  const auto places = terminating_places(exact);
  std::string text;
  if (places && *places <= kMostCharacters) {
    text = point_text(exact.get_num() * (power_of_ten(*places) / exact.get_den()), *places);
  }
  const bool fits = !text.empty() && text.size() <= kMostCharacters;
  out += fits ? text : long_rational_text(exact, places);
}

std::string rational_text(const Number& value) {
  std::string text;
  append_rational(text, value);
  return text;
}

// The nearest decimal not above (`up` false) or not below the value, on the grid of enclosures.
Number on_grid(const Number& value, bool up) {
  const Number scale = number_of(power_of_ten(kEnclosurePlaces));
  return (up ? (value * scale).ceil() : (value * scale).floor()) / scale;
}

std::array<std::string, 2> enclosure_text(const Number& value) {
  auto [low, high] = value.bounds(kEnclosureBits);
  for (Number* end : {&low, &high}) {
    const EnclosureNode* node = enclosure_node(value);
    const bool exact_end = node != nullptr && node->operation == Operation::between &&
                           terminating_places(rational_of(*end)).has_value();
    if (!exact_end) *end = on_grid(*end, end == &high);
  }
  return {rational_text(low), rational_text(high)};
}

// Rounded to nearest, ties away from zero.
mpz_class rounded(const mpq_class& value) {
  const mpq_class half(1, 2);
  return sgn(value) < 0 ? ceil_of(mpq_class(value - half)) : floor_of(mpq_class(value + half));
}

// {"key":["1","2"]}
template <std::size_t Count>
void append_object(std::string& out, std::string_view key,
                   const std::array<std::string, Count>& texts) {
  out.append("{\"").append(key).append("\":[");
  for (std::size_t i = 0; i < Count; ++i) {
    out.append(i == 0 ? "\"" : ",\"").append(texts[i]).append(1, '"');
  }
  out += "]}";
}

}  // namespace

void Number::append_json(std::string& out) const {
  const auto fits = [](const std::string& text) { return text.size() <= kMostCharacters; };
  if (form() == Form::rational) {
    const std::size_t begin = out.size();
    out += '"';
    append_rational(out, *this);
    out += '"';
    if (out.size() - begin - 2 <= kMostCharacters) return;
    out.resize(begin);
  } else if (form() == Form::root) {
    const auto [a, b, c] = root_parts();
    const std::array<std::string, 3> parts = {rational_text(a), rational_text(b), rational_text(c)};
    if (std::ranges::all_of(parts, fits)) return append_object(out, "root", parts);
  }
  // An exact value that no reader takes, for it is too long, is enclosed.
  append_object(out, "enclosure", enclosure_text(*this));
}

std::string Number::text() const {
  if (form() == Form::rational) return rational_text(*this);
  if (form() == Form::enclosure) {
    const auto [low, high] = enclosure_text(*this);
    return "[" + low + ", " + high + "]";
  }
  const auto [a, b, c] = root_parts();
  std::string text;
  const bool negative = b.sign() < 0;
  if (a.sign() != 0) {
    text = rational_text(a) + (negative ? " - " : " + ");
  } else if (negative) {
    text = "-";
  }
  const Number factor = abs(b);
  if (factor != Number(1)) text += rational_text(factor) + "*";
  return text + "sqrt(" + rational_text(c) + ")";
}

std::string Number::decimal_text(int decimals) const {
  if (decimals < 0) throw std::invalid_argument("exact: decimals must not be negative");
  const auto places = static_cast<unsigned long>(decimals);
  const Number scaled = *this * number_of(power_of_ten(places));
  mpz_class digits;
  switch (form()) {
    case Form::rational:
      digits = rounded(rational_of(scaled));
      break;
    case Form::root:  // irrational: no ties
      digits = floor_of(root_of(scaled + millionths(500'000)));
      break;
    case Form::enclosure: {
      // Digits of the middle, where 64 bits behind the last place still leave two answers.
      const auto [low, high] = scaled.bounds(kEnclosureBits);
      digits = rounded(mpq_class((rational_of(low) + rational_of(high)) / 2));
      break;
    }
  }
  return point_text(digits, places);
}

}  // namespace gonogo::exact
