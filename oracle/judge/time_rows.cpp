// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/time_rows.hpp"

#include <fmt/format.h>

#include <optional>

#include "oracle/judge/unit_error.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::array<std::optional<Quantity>, kTimeParts> kQuantities = {
    Quantity::time, Quantity::dwell, std::nullopt, std::nullopt};

}  // namespace

std::array<TimePart, kTimeParts> parts_of(const CycleTime& time) {
  return {{{"cuts", "s", time.feed_seconds()},
           {"dwells", "s", time.dwell_seconds()},
           {"turns", "rev", time.revolutions()},
           {"traverses", "mm", time.rapid_length()}}};
}

std::string amount_text(const Number& amount) {
  constexpr int kDecimals = 3;
  constexpr std::size_t kShort = 16;
  const std::string rounded = amount.decimal_text(kDecimals);
  if (!amount.is_rational()) return rounded + " (rounded)";
  const std::string exact = amount.text();
  if (exact.size() > kShort) return rounded + " (rounded)";
  const bool is_decimal = exact.find('/') == std::string::npos;
  return is_decimal ? exact : fmt::format("{} (exactly {})", rounded, exact);
}

std::string time_hint(std::size_t part, const Number& want, const Number& got) {
  if (!kQuantities.at(part)) return {};
  // Of numbers that are rounded one by one.
  constexpr int kClose = 100'000;
  return unit_error(*kQuantities.at(part), want, got, want / kClose);
}

}  // namespace gonogo::oracle
