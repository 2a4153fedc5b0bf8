// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/time_rows.hpp"

#include <fmt/format.h>

#include <optional>

#include "oracle/judge/unit_error.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::array<std::optional<Quantity>, 4> kQuantities = {Quantity::time, Quantity::dwell,
                                                                std::nullopt, std::nullopt};

}  // namespace

std::array<TimePart, 4> parts_of(const CycleTime& time) {
  return {{{"cuts", "s", time.feed_seconds()},
           {"dwells", "s", time.dwell_seconds()},
           {"turns", "rev", time.revolutions()},
           {"traverses", "mm", time.rapid_length()}}};
}

std::string amount_text(const TimePart& part) {
  const std::string rounded = part.amount.decimal_text(3);
  const std::string exact = part.amount.is_rational() ? part.amount.text() : "";
  if (exact.empty() || exact.size() > 16) {
    return fmt::format("{} {} (rounded)", rounded, part.unit);
  }
  const bool is_decimal = exact.find('/') == std::string::npos;
  return is_decimal ? fmt::format("{} {}", exact, part.unit)
                    : fmt::format("{} {} (exactly {})", rounded, part.unit, exact);
}

std::string time_hint(std::size_t part, const Number& want, const Number& got) {
  if (!kQuantities.at(part)) return {};
  // The numbers are rounded one by one.
  return unit_error(*kQuantities.at(part), want, got, want / (kFewestParts * kFewestParts));
}

}  // namespace gonogo::oracle
