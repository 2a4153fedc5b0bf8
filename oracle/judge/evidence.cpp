// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/evidence.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace gonogo::oracle {

using reference::Axis;
using reference::kAllAxes;
using reference::Number;

std::string record_text(const reference::Record& record) {
  std::string text;
  append_json(record, text);
  return text;
}

std::string point_text(const reference::Position& point, reference::AxisSet axes) {
  std::string text = "{";
  for (Axis axis : kAllAxes) {
    if (!axes.has(axis)) continue;
    text += fmt::format("{}\"{}\":", text.size() > 1 ? "," : "", letter(axis));
    point[axis].append_json(text);
  }
  return text + "}";
}

std::string level_text(const reference::PocketLevel& level) {
  const reference::PlaneAxes axes = reference::axes_of(level.plane);
  reference::Position at;
  at[axes.p] = level.centre[0];
  at[axes.q] = level.centre[1];
  at[axes.d] = level.depth;
  std::string text =
      fmt::format("{{\"k\":\"level\",\"b\":{},\"plane\":\"G{}\",\"centre\":{}", level.block,
                  reference::plane_code(level.plane), point_text(at, {axes.p, axes.q, axes.d}));
  for (const auto& [key, value] : {std::pair("pocket_radius", &level.pocket_radius),
                                   std::pair("tool_radius", &level.tool_radius),
                                   std::pair("step", &level.step), std::pair("f", &level.feed)}) {
    text += fmt::format(",\"{}\":", key);
    value->append_json(text);
  }
  text += fmt::format(",\"rot\":\"{}\",\"clause\":\"{}\"}}", level.sense < 0 ? "-" : "+",
                      reference::clause_name(level.clause));
  return text;
}

std::string alarms_text(const reference::AlarmReport& report) {
  std::string classes;
  for (const reference::Alarm& alarm : report.alarms) {
    classes += fmt::format("{}\"{}\"", classes.empty() ? "" : ",", reference::name(alarm.alarm));
  }
  return fmt::format("{{\"k\":\"alarm\",\"b\":{},\"any_of\":[{}]}}", report.block, classes);
}

std::string alarm_text(const SubjectAlarm& alarm) {
  nlohmann::ordered_json text = {{"k", "alarm"}};
  if (alarm.block != 0) text["b"] = alarm.block;
  if (!alarm.alarm_class.empty()) text["class"] = alarm.alarm_class;
  if (!alarm.native.empty()) text["native"] = alarm.native;
  if (alarm.word != 0) text["word"] = std::string(1, alarm.word);
  return text.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string exact_text(const Number& value) {
  std::string text;
  value.append_json(text);
  if (text.size() > 2 && text.front() == '"') text = text.substr(1, text.size() - 2);
  return text;
}

std::string millimetres_text(const Number& value) {
  constexpr int kDecimals = 9;
  std::string text = value.decimal_text(kDecimals);
  while (text.find('.') != std::string::npos && (text.back() == '0' || text.back() == '.')) {
    const bool point = text.back() == '.';
    text.pop_back();
    if (point) break;
  }
  return text;
}

}  // namespace gonogo::oracle
