// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/labels.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/region/constants.hpp"
#include "reference/exact/rational.hpp"

namespace gonogo::oracle {
namespace {

// The last place of a decimal as a number; nothing where it is no decimal.
std::optional<Number> last_place(const Number& value) {
  if (!value.is_rational()) return std::nullopt;
  mpq_class scratch;
  const mpq_class& exact = exact::rational_of(value, scratch);
  mpz_class rest = exact.get_den();
  const mp_bitcnt_t twos = mpz_scan1(rest.get_mpz_t(), 0);
  mpz_fdiv_q_2exp(rest.get_mpz_t(), rest.get_mpz_t(), twos);
  const mpz_class five = 5;
  const mp_bitcnt_t fives = mpz_remove(rest.get_mpz_t(), rest.get_mpz_t(), five.get_mpz_t());
  if (rest != 1) return std::nullopt;
  return Number::decimal(false, 1, static_cast<std::uint32_t>(std::max(twos, fives)));
}

// R3. Two units in the last place of a double lie between 2^-52 and 2^-51 of the value.
bool is_near_double(const Number& got, const Number& exact) {
  return agree(got, exact, abs(exact) * Number::binary(1, 1 - kUlpBits));
}

}  // namespace

// R3. Where no resolution is declared a decimal is taken as what it says: the value rounded to its
// own last place, and none coarser than the profile's increment.
bool stands_for(const Number& got, const Number& exact, const std::optional<Number>& resolution,
                const Tolerances& tolerances) {
  if (visible_sign(got - exact) == 0) return true;
  const bool may_be_double = tolerances.binary64 || (!tolerances.exact && !resolution);
  if (may_be_double && is_near_double(got, exact)) return true;
  if (resolution) return agree(got * 2, exact * 2, *resolution);
  if (!agree(got * 2, exact * 2, tolerances.increment)) return false;
  const std::optional<Number> step = last_place(got);
  return step && agree(got * 2, exact * 2, *step);
}

bool feeds_agree(const Record& want, const Record& got, const Tolerances& tolerances) {
  return feeds_agree(want.feed, want.feed_mode, got, tolerances);
}

bool feeds_agree(const Number& want, reference::FeedMode mode, const Record& got,
                 const Tolerances& tolerances) {
  return mode == got.feed_mode &&
         stands_for(got.feed, want, tolerances.feed_resolution, tolerances);
}

bool leads_agree(const Record& want, const Record& got, const Tolerances& tolerances) {
  return stands_for(got.lead, want.lead, tolerances.resolution, tolerances);
}

bool start_angles_agree(const Record& want, const Record& got, const Tolerances& tolerances) {
  const auto turns =
      static_cast<std::int64_t>(std::llround(estimate(got.start - want.start) / 360));
  return stands_for(got.start, want.start + Number(turns) * 360, tolerances.resolution, tolerances);
}

bool times_agree(const Record& want, const Record& got, const Tolerances& tolerances) {
  return stands_for(got.seconds, want.seconds, tolerances.resolution, tolerances);
}

bool may_be_no_dwell(const Record& dwell, const Tolerances& tolerances) {
  return stands_for(Number(0), dwell.seconds, tolerances.resolution, tolerances);
}

}  // namespace gonogo::oracle
