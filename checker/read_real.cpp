// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers from text.
#include "checker/real.hpp"

namespace gonogo::checker {
namespace {

constexpr std::size_t kLongest = 1000;  // characters of a number
constexpr long kLargestExponent = 5000;

[[noreturn]] void refuse(std::string_view text) {
  throw Fault("\"" + std::string(text) + "\" is no number as the formats write it.");
}

int digit_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return 99;
}

Rational power(int base, long exponent) {
  mpz_class value;
  mpz_ui_pow_ui(value.get_mpz_t(), static_cast<unsigned long>(base),
                static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? Rational(1, value) : Rational(value);
}

// A cursor over the characters of a number.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text), rest_(text) {}

  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  bool take_any(std::string_view either) {
    if (rest_.empty() || either.find(rest_.front()) == std::string_view::npos) return false;
    rest_.remove_prefix(1);
    return true;
  }
  // At least one; appended to `value` in the base.
  long digits(int base, mpz_class& value) {
    long count = 0;
    while (!rest_.empty() && digit_value(rest_.front()) < base) {
      value = value * base + digit_value(rest_.front());
      rest_.remove_prefix(1);
      ++count;
    }
    return count;
  }
  long exponent() {
    const bool minus = take('-');
    if (!minus) take('+');
    mpz_class value;
    if (digits(10, value) == 0 || value > kLargestExponent) refuse(text_);
    return minus ? -value.get_si() : value.get_si();
  }
  bool at_end() const { return rest_.empty(); }

 private:
  std::string_view text_;
  std::string_view rest_;
};

}  // namespace

Rational parse_rational(std::string_view text) {
  if (text.empty() || text.size() > kLongest) refuse(text.substr(0, 40));
  Reader reader(text);
  const bool minus = reader.take('-');
  const bool is_hex =
      text.substr(minus ? 1 : 0, 2) == "0x" || text.substr(minus ? 1 : 0, 2) == "0X";
  if (is_hex) {
    reader.take('0');
    reader.take_any("xX");
  }
  const int base = is_hex ? 16 : 10;
  mpz_class whole;
  long count = reader.digits(base, whole);
  Rational value(whole);
  if (!is_hex && count > 0 && reader.take('/')) {
    mpz_class below;
    if (reader.digits(10, below) == 0 || below == 0 || !reader.at_end()) refuse(text);
    value = Rational(minus ? mpz_class(-whole) : whole, below);
    value.canonicalize();
    return value;
  }
  if (reader.take('.')) {
    const long decimals = reader.digits(base, whole);
    if (decimals == 0) refuse(text);
    count += decimals;
    value = Rational(whole) * power(base, -decimals);
  }
  if (count == 0) refuse(text);
  if (reader.take_any(is_hex ? "pP" : "eE")) value *= power(is_hex ? 2 : 10, reader.exponent());
  if (!reader.at_end()) refuse(text);
  value.canonicalize();
  return minus ? Rational(-value) : value;
}

Real read_real(const Json& value) {
  if (value.is(Json::Kind::text)) return parse_rational(value.text);
  if (!value.is(Json::Kind::object) || value.members.size() != 1) {
    throw Fault("A number is a text, a root or an enclosure, and stands in quotes.");
  }
  const auto& [name, list] = value.members.front();
  std::vector<Rational> parts;
  for (const std::string& text : list.texts()) parts.push_back(parse_rational(text));
  if (name == "root" && parts.size() == 3 && parts[2] >= 0) {
    return Real::root(parts[0], parts[1], parts[2]);
  }
  if (name == "enclosure" && parts.size() == 2 && parts[0] <= parts[1]) {
    if (parts[1] - parts[0] > power(10, -15)) throw Fault("An enclosure is wider than 1e-15.");
    return Real::enclosure(parts[0], parts[1]);
  }
  throw Fault("A number is neither a root of three parts nor an enclosure of two in order.");
}

}  // namespace gonogo::checker
