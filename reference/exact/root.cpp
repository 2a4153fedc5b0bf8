// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/root.hpp"

#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

namespace gonogo::exact {
namespace {

constexpr std::array<unsigned, 25> kSmallPrimes = {2,  3,  5,  7,  11, 13, 17, 19, 23, 29, 31, 37, 41,
                                               43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97};

std::optional<Word> whole_sqrt(Word value) {
  if (value == 0) return 0;
  const mp_limb_t square = value;
  mp_limb_t root = 0;
  if (mpn_sqrtrem(&root, nullptr, &square, 1) != 0) return std::nullopt;
  return root;
}

// take_out_squares() of a word; the primes are constants, so that no division is one.
Word take_out_squares(Word& radicand) {
  if (const std::optional<Word> whole = whole_sqrt(radicand); whole && *whole != 0) {
    radicand = 1;
    return *whole;
  }
  Word square_root = 1;
  Word rest = radicand;
  Word small_part = 1;
  const auto take_out = [&](auto prime) {
    unsigned power = 0;
    for (; rest % prime() == 0; ++power) {
      rest /= prime();
      if (power % 2 == 1) square_root *= prime();
    }
    if (power % 2 == 1) small_part *= prime();
  };
  [&]<std::size_t... place>(std::index_sequence<place...>) {
    (take_out(std::integral_constant<Word, kSmallPrimes[place]>{}), ...);
  }
  (std::make_index_sequence<kSmallPrimes.size()>{});
  if (const std::optional<Word> root = whole_sqrt(rest)) {
    square_root *= *root;
    rest = 1;
  }
  radicand = small_part * rest;
  return square_root;
}

// radicand = square_root^2 * what is left of it. Squares of small primes are taken out, and the
// rest when it is a square: enough for short texts. Equality never relies on it (see unify).
mpz_class take_out_squares(mpz_class& radicand) {
  if (fits_word(radicand)) {
    Word word = low_word(radicand);
    mpz_class square_root = integer_of(take_out_squares(word));
    radicand = integer_of(word);
    return square_root;
  }
  mpz_class square_root = 1;
  mpz_class rest = radicand;
  mpz_class small_part = 1;
  for (const auto prime : kSmallPrimes) {
    unsigned power = 0;
    for (; mpz_divisible_ui_p(rest.get_mpz_t(), prime) != 0; ++power) {
      mpz_divexact_ui(rest.get_mpz_t(), rest.get_mpz_t(), prime);
      if (power % 2 == 1) square_root *= prime;
    }
    if (power % 2 == 1) small_part *= prime;
  }
  if (mpz_perfect_square_p(rest.get_mpz_t()) != 0) {
    square_root *= sqrt(rest);
    rest = 1;
  }
  radicand = small_part * rest;
  return square_root;
}

// The factor of a small number b in b*sqrt(c/d), in lowest terms. False where it is too long.
struct Fraction {
  Word numerator;
  Word denominator;
  bool multiply(std::int64_t millionths) {
    const Word count = magnitude_of(millionths);
    constexpr Word kParts = detail::kUnit;
    const Word common = std::gcd(count, kParts);
    const Word across = std::gcd(count / common, denominator);
    const Word other = std::gcd(numerator, kParts / common);
    return !__builtin_mul_overflow(numerator / other, count / common / across, &numerator) &&
           !__builtin_mul_overflow(denominator / across, kParts / common / other, &denominator);
  }
};

bool is_small(const std::array<Number, 2>& pair) {
  return NumberAccess::node(pair[0]) == nullptr && NumberAccess::node(pair[1]) == nullptr;
}

// a[i] + b[i] * p/q of small numbers where they are small again.
std::optional<std::array<Number, 2>> small_sums(const std::array<Number, 2>& a,
                                                const std::array<Number, 2>& b, Word p, Word q) {
  std::array<Number, 2> sums;
  for (std::size_t i = 0; i < 2; ++i) {
    detail::Wide product = NumberAccess::millionths(b[i]);
    if (__builtin_mul_overflow(product, p, &product) || product % q != 0) return std::nullopt;
    std::int64_t sum = 0;
    if (__builtin_add_overflow(product / q, NumberAccess::millionths(a[i]), &sum)) {
      return std::nullopt;
    }
    sums[i] = Number::millionths(sum);
  }
  return sums;
}

bool is_rational(const Root& x) {
  return sgn(x.b) == 0;
}

// Writes y over the radicand of x. False when sqrt(x.c) and sqrt(y.c) are independent: they are
// commensurable exactly when x.c * y.c is a square.
bool unify(const Root& x, Root& y) {
  if (is_rational(x) || is_rational(y) || x.c == y.c) return true;
  const mpz_class product = x.c * y.c;
  if (mpz_perfect_square_p(product.get_mpz_t()) == 0) return false;
  mpq_class factor(sqrt(product), x.c);  // sqrt(y.c) = sqrt(x.c * y.c) / x.c * sqrt(x.c)
  factor.canonicalize();
  y.b *= factor;
  y.c = x.c;
  return true;
}

Root tidy(Root x) {
  if (is_rational(x)) x.c = 0;
  return x;
}

// The sign of x + d*sqrt(e) where the signs of the two differ: that of the larger square.
int sign_with(const Root& x, const mpq_class& d, const mpz_class& e) {
  const int sign_x = sign_of(x);
  const int sign_d = sgn(d);
  if (sign_x == 0 || sign_x == sign_d) return sign_d;
  const mpq_class square = x.a * x.a + x.b * x.b * x.c - d * d * e;
  const mpq_class cross = 2 * x.a * x.b;
  return sign_x * sign_of(Root{square, cross, x.c});
}

}  // namespace

Root root_of(const Number& value) {
  if (value.form() == Number::Form::root) {
    return static_cast<const RootNode*>(NumberAccess::node(value))->value;
  }
  return {rational_of(value), 0, 0};
}

Number number_of(Root value) {
  if (is_rational(value)) return number_of(std::move(value.a));
  return NumberAccess::adopt(new RootNode(std::move(value)));
}

Root make_root(mpq_class a, mpq_class b, const mpq_class& c) {
  if (sgn(b) == 0 || sgn(c) == 0) return {std::move(a), 0, 0};
  mpz_class inner = c.get_num();
  mpz_class outer = c.get_den();  // sqrt(p/q) = sqrt(p*q)/q
  const mpz_class outer_root = take_out_squares(outer);
  const mpz_class inner_root = take_out_squares(inner);
  mpq_class factor(inner_root, outer_root * outer);
  factor.canonicalize();
  b *= factor;
  inner *= outer;  // coprime, so no square arises
  if (inner == 1) return {a + b, 0, 0};
  return {std::move(a), std::move(b), std::move(inner)};
}

std::optional<std::array<Number, 2>> small_roots(const std::array<Number, 2>& a,
                                                 const std::array<Number, 2>& b, const Number& c,
                                                 const Number& d) {
  if (!is_small(a) || !is_small(b) || !is_small({c, d}) || c.sign() <= 0) return std::nullopt;
  // In lowest terms; sqrt(p/q) = sqrt(p*q)/q, and no square arises in p*q.
  Word inner = static_cast<Word>(NumberAccess::millionths(c));
  Word outer = static_cast<Word>(NumberAccess::millionths(d));
  const Word common = std::gcd(inner, outer);
  inner /= common;
  outer /= common;
  const Word outer_root = take_out_squares(outer);
  const Word inner_root = take_out_squares(inner);
  if (inner == 1 && outer == 1) return small_sums(a, b, inner_root, outer_root);
  std::array<Number, 2> found;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::int64_t factor = NumberAccess::millionths(b[i]);
    if (factor == 0) {
      found[i] = a[i];
      continue;
    }
    Fraction fraction{inner_root, outer_root * outer};
    if (!fraction.multiply(factor)) return std::nullopt;
    mpq_class multiple;
    assign(mpq_numref(multiple.get_mpq_t()), fraction.numerator, factor < 0);
    assign(mpq_denref(multiple.get_mpq_t()), fraction.denominator);
    mpz_class radicand = integer_of(inner) * integer_of(outer);
    found[i] = NumberAccess::adopt(
        new RootNode(NumberAccess::millionths(a[i]), std::move(multiple), std::move(radicand)));
  }
  return found;
}

std::optional<Root> add(const Root& x, const Root& y) {
  Root other = y;
  if (!unify(x, other)) return std::nullopt;
  return tidy({x.a + other.a, x.b + other.b, is_rational(x) ? other.c : x.c});
}

std::optional<Root> multiply(const Root& x, const Root& y) {
  Root other = y;
  if (unify(x, other)) {
    const mpz_class c = is_rational(x) ? other.c : x.c;
    return tidy({x.a * other.a + x.b * other.b * c, x.a * other.b + x.b * other.a, c});
  }
  if (sgn(x.a) != 0 || sgn(y.a) != 0) return std::nullopt;
  return make_root(0, x.b * y.b, mpq_class(x.c * y.c));
}

Root inverse(const Root& x) {
  const mpq_class norm = x.a * x.a - x.b * x.b * x.c;  // zero only for x = 0: sqrt(c) irrational
  return {x.a / norm, -x.b / norm, x.c};
}

Root negate(Root x) {
  return {-x.a, -x.b, std::move(x.c)};
}

// sqrt(a + b*sqrt(c)) = sqrt(u) +- sqrt(v) with u, v = (a +- s)/2 where s = sqrt(a^2 - b^2*c) is
// rational, and one root where u or v is a square besides.
std::optional<Root> sqrt_of(const Root& x) {
  if (is_rational(x)) {
    if (auto root = exact_sqrt(x.a)) return Root{*std::move(root), 0, 0};
    return make_root(0, 1, x.a);
  }
  const mpq_class norm = x.a * x.a - x.b * x.b * x.c;
  if (sgn(norm) < 0) return std::nullopt;
  const auto s = exact_sqrt(norm);
  if (!s) return std::nullopt;
  const mpq_class u = (x.a + *s) / 2;
  const mpq_class v = (x.a - *s) / 2;
  if (auto root = exact_sqrt(u)) return make_root(*std::move(root), sgn(x.b), v);
  if (auto root = exact_sqrt(v)) return make_root(sgn(x.b) * *root, 1, u);
  return std::nullopt;
}

int sign_of(const Root& x) {
  const int sign_a = sgn(x.a);
  const int sign_b = sgn(x.b);
  if (sign_b == 0 || sign_a == sign_b) return sign_a;
  if (sign_a == 0) return sign_b;
  const mpq_class square_a = x.a * x.a;
  const mpq_class square_b = x.b * x.b * x.c;
  return cmp(square_a, square_b) > 0 ? sign_a : sign_b;
}

int compare(const Root& x, const Root& y) {
  const Root minus = negate(y);
  if (const auto difference = add(x, minus)) return sign_of(*difference);
  return sign_with({x.a + minus.a, x.b, x.c}, minus.b, minus.c);
}

mpz_class floor_of(const Root& x) {
  if (is_rational(x)) return floor_of(x.a);
  // x = (p + q*sqrt(c)) / d in integers, and floor(t/d) = floor(floor(t)/d) for d > 0.
  mpz_class d;
  mpz_lcm(d.get_mpz_t(), x.a.get_den_mpz_t(), x.b.get_den_mpz_t());
  const mpz_class p = x.a.get_num() * (d / x.a.get_den());
  const mpz_class q = x.b.get_num() * (d / x.b.get_den());
  const mpz_class below = sqrt(mpz_class(q * q * x.c));  // below the root: it is irrational
  const mpz_class whole = sgn(q) > 0 ? mpz_class(p + below) : mpz_class(p - below - 1);
  mpz_class floor;
  mpz_fdiv_q(floor.get_mpz_t(), whole.get_mpz_t(), d.get_mpz_t());
  return floor;
}

}  // namespace gonogo::exact
