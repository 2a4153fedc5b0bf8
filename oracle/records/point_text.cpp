// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/point_text.hpp"

#include <fmt/format.h>

namespace gonogo::oracle {

using reference::Number;

namespace {

std::optional<Number> text_at(const nlohmann::ordered_json& list, std::size_t place) {
  const bool is_there = list.is_array() && place < list.size() && list[place].is_string();
  return is_there ? Number::parse(list[place].get<std::string>()) : std::nullopt;
}

}  // namespace

std::optional<Number> number_of(const nlohmann::ordered_json& json) {
  if (json.is_string()) return Number::parse(json.get<std::string>());
  if (!json.is_object()) return std::nullopt;
  if (const auto root = json.find("root"); root != json.end()) {
    const auto a = text_at(*root, 0);
    const auto b = text_at(*root, 1);
    const auto c = text_at(*root, 2);
    return a && b && c && c->sign() >= 0 ? std::optional(Number::root(*a, *b, *c)) : std::nullopt;
  }
  const nlohmann::ordered_json bounds = json.value("enclosure", nlohmann::ordered_json::array());
  const auto low = text_at(bounds, 0);
  const auto high = text_at(bounds, 1);
  return low && high && *low <= *high ? std::optional(Number::between(*low, *high)) : std::nullopt;
}

std::string point_for_people(const std::string& point) {
  const nlohmann::ordered_json axes = nlohmann::ordered_json::parse(point, nullptr, false);
  if (!axes.is_object()) return point;
  std::string text;
  bool says_more = false;
  for (const auto& [axis, value] : axes.items()) {
    const std::optional<Number> number = number_of(value);
    if (!number) return point;
    const std::string decimal = millimetres_text(*number);
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", axis, decimal);
    says_more = says_more || !value.is_string() || value.get<std::string>() != decimal;
  }
  return says_more ? fmt::format("{} = {}", point, text) : point;
}

std::string millimetres_text(const Number& value) {
  std::string text = value.decimal_text(9);
  while (text.find('.') != std::string::npos && (text.back() == '0' || text.back() == '.')) {
    const bool point = text.back() == '.';
    text.pop_back();
    if (point) break;
  }
  return text;
}

}  // namespace gonogo::oracle
