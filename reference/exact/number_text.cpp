// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers as text: for records (append_json), for people (text) and rounded (decimal_text).
#include <array>
#include <stdexcept>

#include "reference/exact/enclosure.hpp"
#include "reference/exact/number.hpp"
#include "reference/exact/rational.hpp"
#include "reference/exact/root.hpp"

namespace gonogo::exact {
namespace {

constexpr std::size_t kMaxLength = 1000;  // of a number in a record
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

// digits / 10^places, with all its places.
std::string point_text(const mpz_class& digits, unsigned long places) {
  std::string text = mpz_class(abs(digits)).get_str();
  if (places > 0) {
    if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
    text.insert(text.size() - places, 1, '.');
  }
  if (sgn(digits) < 0) text.insert(0, 1, '-');
  return text;
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

void append_rational(std::string& out, const Number& value) {
  if (NumberAccess::node(value) == nullptr) {
    append_small(out, NumberAccess::millionths(value));
    return;
  }
  mpq_class scratch;
  const mpq_class& exact = rational_of(value, scratch);
  const auto places = terminating_places(exact);
  // A decimal that is too long for a record gives way to a shorter fraction: 2^-1074.
  if (places && (*places <= kMaxLength || *places <= exact.get_str().size())) {
    const mpz_class digits = exact.get_num() * (power_of_ten(*places) / exact.get_den());
    out += point_text(digits, *places);
  } else {
    out += exact.get_str();
  }
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
    const bool exact_end = enclosure_node(value)->operation == Operation::between &&
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

void append_quoted(std::string& out, const std::string& text) {
  out.append(1, '"').append(text).append(1, '"');
}

}  // namespace

void Number::append_json(std::string& out) const {
  switch (form()) {
    case Form::rational:
      out += '"';
      append_rational(out, *this);
      out += '"';
      return;
    case Form::root: {
      const auto [a, b, c] = root_parts();
      out += "{\"root\":[";
      append_quoted(out, rational_text(a));
      out += ',';
      append_quoted(out, rational_text(b));
      out += ',';
      append_quoted(out, rational_text(c));
      out += "]}";
      return;
    }
    case Form::enclosure: {
      const auto [low, high] = enclosure_text(*this);
      out += "{\"enclosure\":[";
      append_quoted(out, low);
      out += ',';
      append_quoted(out, high);
      out += "]}";
      return;
    }
  }
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
      // Of the middle, where 64 bits behind the last place still leave two answers.
      const auto [low, high] = scaled.bounds(kEnclosureBits);
      digits = rounded(mpq_class((rational_of(low) + rational_of(high)) / 2));
      break;
    }
  }
  return point_text(digits, places);
}

}  // namespace gonogo::exact
