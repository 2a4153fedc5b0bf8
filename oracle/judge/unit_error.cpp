// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/unit_error.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "oracle/region/constants.hpp"

namespace gonogo::oracle {
namespace {

// got = want * times / by.
struct Factor {
  Quantity quantity;
  int times;
  int by;
  std::string_view amount;
  std::string_view question;
};

constexpr auto kFactors = std::to_array<Factor>({
    {Quantity::feed, 60, 1, "60 times", "mm/min taken for mm/s"},
    {Quantity::feed, 1, 60, "a 60th of", "mm/s put out for mm/min"},
    {Quantity::feed, 127, 5, "127/5 times", "mm taken for inches"},
    {Quantity::feed, 5, 127, "5/127 of", "inches not converted to mm"},
    {Quantity::feed, 1000, 1, "1000 times", "mm taken for metres"},
    {Quantity::feed, 1, 1000, "a 1000th of", "metres put out for mm"},
    {Quantity::feed, 2, 1, "twice", "a radius counted as a diameter"},
    {Quantity::feed, 1, 2, "half", "halved as a diameter is"},
    {Quantity::rotary_feed, 60, 1, "60 times", "degrees/min taken for degrees/s"},
    {Quantity::rotary_feed, 1, 60, "a 60th of", "degrees/s put out for degrees/min"},
    {Quantity::rotary_feed, 127, 5, "127/5 times", "degrees taken for inches"},
    {Quantity::rotary_feed, 5, 127, "5/127 of", "degrees converted to inches"},
    {Quantity::rotary_feed, 360, 1, "360 times", "degrees taken for turns"},
    {Quantity::rotary_feed, 1, 360, "a 360th of", "turns put out for degrees"},
    {Quantity::lead, 127, 5, "127/5 times", "mm taken for inches"},
    {Quantity::lead, 5, 127, "5/127 of", "inches not converted to mm"},
    {Quantity::lead, 2, 1, "twice", "a radius counted as a diameter"},
    {Quantity::lead, 1, 2, "half", "halved as a diameter is"},
    {Quantity::time, 1, 60, "a 60th of", "feeds in mm/min taken for mm/s"},
    {Quantity::time, 60, 1, "60 times", "feeds in mm/s put out for mm/min"},
    {Quantity::time, 5, 127, "5/127 of", "feeds in mm taken for inches"},
    {Quantity::time, 127, 5, "127/5 times", "feeds in inches not converted to mm"},
    {Quantity::time, 2, 1, "twice", "feeds halved as a diameter is"},
    {Quantity::time, 1, 2, "half", "feeds counted as diameters"},
    {Quantity::dwell, 1000, 1, "1000 times", "ms taken for s"},
    {Quantity::dwell, 1, 1000, "a 1000th of", "s taken for ms"},
    {Quantity::dwell, 60, 1, "60 times", "s taken for min"},
    {Quantity::dwell, 1, 60, "a 60th of", "min put out for s"},
    {Quantity::dwell, 2, 1, "twice", "a radius counted as a diameter"},
    {Quantity::dwell, 1, 2, "half", "halved as a diameter is"},
});

bool is_off_by(const Factor& factor, const Number& want, const Number& got,
               const Number& tolerance) {
  const Number expected = want * factor.times / factor.by;
  // A coarser number is near several factors.
  return tolerance * kFewestParts <= expected && abs(got - expected) <= tolerance;
}

}  // namespace

std::string unit_error(Quantity quantity, const Number& want, const Number& got,
                       const Number& tolerance) {
  try {
    if (want.sign() <= 0 || got.sign() <= 0) return {};
    for (const Factor& factor : kFactors) {
      if (factor.quantity != quantity || !is_off_by(factor, want, got, tolerance)) continue;
      return fmt::format(" It is {} what is due: {}?", factor.amount, factor.question);
    }
  } catch (const exact::Undecided&) {
  }
  return {};
}

}  // namespace gonogo::oracle
