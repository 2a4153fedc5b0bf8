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

std::string amount_text(const TimePart& part) {
  constexpr int kDecimals = 3;
  constexpr std::size_t kShort = 16;
  const std::string rounded = part.amount.decimal_text(kDecimals);
  const std::string exact = part.amount.is_rational() ? part.amount.text() : "";
  if (exact.empty() || exact.size() > kShort) {
    return fmt::format("{} {} (rounded)", rounded, part.unit);
  }
  const bool is_decimal = exact.find('/') == std::string::npos;
  return is_decimal ? fmt::format("{} {}", exact, part.unit)
                    : fmt::format("{} {} (exactly {})", rounded, part.unit, exact);
}

std::string time_hint(std::size_t part, const Number& want, const Number& got) {
  if (!kQuantities.at(part)) return {};
  // Of numbers that are rounded one by one.
  constexpr int kClose = 100'000;
  return unit_error(*kQuantities.at(part), want, got, want / kClose);
}

}  // namespace gonogo::oracle
