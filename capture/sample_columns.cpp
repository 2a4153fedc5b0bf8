// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/sample_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gonogo::oracle {
namespace {

using reference::Number;

struct Unit {
  std::string_view name;
  int numerator;
  int denominator;
  int decimals;
  bool is_time;
  bool of_x_alone;
};

constexpr auto kUnits = std::to_array<Unit>({
    {"s", 1, 1, 0, true, false},
    {"ms", 1, 1'000, 3, true, false},
    {"us", 1, 1'000'000, 6, true, false},
    {"mm", 1, 1, 0, false, false},
    {"deg", 1, 1, 0, false, false},
    {"in", 254, 10, 0, false, false},
    {"inch", 254, 10, 0, false, false},
    {"um", 1, 1'000, 0, false, false},
    {"diameter", 1, 2, 0, false, true},
    {"in-diameter", 127, 10, 0, false, true},
});

bool is_axis(SampleField field) {
  return field >= SampleField::x && field <= SampleField::c;
}

}  // namespace

std::optional<SampleField> sample_field(std::string_view name) {
  constexpr auto kNames =
      std::to_array<std::pair<std::string_view, SampleField>>({{"t", SampleField::time},
                                                               {"time", SampleField::time},
                                                               {"x", SampleField::x},
                                                               {"y", SampleField::y},
                                                               {"z", SampleField::z},
                                                               {"a", SampleField::a},
                                                               {"c", SampleField::c},
                                                               {"f", SampleField::feed},
                                                               {"block", SampleField::block},
                                                               {"line", SampleField::block},
                                                               {"motion", SampleField::motion},
                                                               {"alarm", SampleField::alarm}});
  const auto* found =
      std::ranges::find(kNames, name, &std::pair<std::string_view, SampleField>::first);
  if (found == kNames.end()) return std::nullopt;
  return found->second;
}

bool set_unit(SampleColumn& column, std::string_view unit) {
  const auto* found = std::ranges::find(kUnits, unit, &Unit::name);
  if (found == kUnits.end()) return false;
  const bool fits = found->is_time ? column.field == SampleField::time : is_axis(column.field);
  if (!fits || (found->of_x_alone && column.field != SampleField::x)) return false;
  column.scale = Number(found->numerator) / Number(found->denominator);
  column.decimals = found->decimals;
  return true;
}

std::string_view unit_in_brackets(std::string_view name) {
  const std::size_t open = name.rfind('[');
  if (open == std::string_view::npos || name.back() != ']') return {};
  return name.substr(open + 1, name.size() - open - 2);
}

std::optional<std::string> read_columns(const std::string& text, SampleColumns& columns) {
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t comma = rest.find(',');
    const std::string_view each = rest.substr(0, comma);
    rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
    const std::size_t equals = each.find('=');
    const auto field = sample_field(each.substr(0, equals));
    if (equals == std::string_view::npos || !field) {
      return fmt::format(
          "\"{}\" is not of the form x=NAME with t, x, y, z, a, c, f, line, motion or alarm before "
          "the equals sign.",
          each);
    }
    SampleColumn column;
    column.field = *field;
    std::string_view name = each.substr(equals + 1);
    const std::size_t colon = name.rfind(':');
    const std::string_view unit =
        colon == std::string_view::npos ? unit_in_brackets(name) : name.substr(colon + 1);
    column.name = std::string(name.substr(0, colon));
    const bool needs_unit = colon != std::string_view::npos;
    if (!unit.empty() && !set_unit(column, unit) && needs_unit) {
      return fmt::format(
          "The unit \"{}\" of {} is not known. Write s, ms or us of a time; mm, um, in or deg of "
          "an "
          "axis; diameter or in-diameter of X.",
          unit, name);
    }
    if (std::ranges::any_of(columns, [&](const SampleColumn& other) {
          return other.field == column.field || other.name == column.name;
        })) {
      return fmt::format("\"{}\" stands twice.", each);
    }
    columns.push_back(std::move(column));
  }
  return std::nullopt;
}

}  // namespace gonogo::oracle
