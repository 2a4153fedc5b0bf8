// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/step_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

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

namespace {

// A number of a point as `append_json` writes it; nothing of one that is too long to be read.
std::optional<Number> number_of(const nlohmann::ordered_json& json) {
  const auto part = [](const nlohmann::ordered_json& text) {
    return Number::parse(text.get<std::string>());
  };
  if (json.is_string()) return part(json);
  if (const auto root = json.find("root"); root != json.end()) {
    const auto a = part(root->at(0));
    const auto b = part(root->at(1));
    const auto c = part(root->at(2));
    return a && b && c ? std::optional(Number::root(*a, *b, *c)) : std::nullopt;
  }
  const nlohmann::ordered_json& bounds = json.at("enclosure");
  const auto low = part(bounds.at(0));
  const auto high = part(bounds.at(1));
  return low && high ? std::optional(Number::between(*low, *high)) : std::nullopt;
}

}  // namespace

std::string point_for_people(const std::string& point) {
  if (point.empty()) return point;
  std::string text;
  bool says_more = false;
  const auto axes = nlohmann::ordered_json::parse(point);
  for (const auto& [axis, value] : axes.items()) {
    const std::optional<Number> number = number_of(value);
    if (!number) return point;
    const std::string decimal = millimetres_text(*number);
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", axis, decimal);
    says_more = says_more || !value.is_string() || value.get<std::string>() != decimal;
  }
  return says_more ? fmt::format("{} = {}", point, text) : point;
}

namespace {

using NamedNumber = std::pair<std::string_view, const Number*>;

// What pockets and threads have in common: block, plane, centre with the depth, numbers, sense.
std::string item_text(std::string_view kind, const auto& item, const Number& depth,
                      std::initializer_list<NamedNumber> numbers) {
  const reference::PlaneAxes axes = reference::axes_of(item.plane);
  reference::Position at;
  at[axes.p] = item.centre[0];
  at[axes.q] = item.centre[1];
  at[axes.d] = depth;
  std::string text =
      fmt::format("{{\"k\":\"{}\",\"b\":{},\"plane\":\"G{}\",\"centre\":{}", kind, item.block,
                  reference::plane_code(item.plane), point_text(at, {axes.p, axes.q, axes.d}));
  for (const auto& [key, value] : numbers) {
    text += fmt::format(",\"{}\":", key);
    value->append_json(text);
  }
  text += fmt::format(",\"rot\":\"{}\",\"clause\":\"{}\"}}", item.sense < 0 ? "-" : "+",
                      reference::clause_name(item.clause));
  return text;
}

}  // namespace

std::string level_text(const reference::PocketLevel& level) {
  return item_text("level", level, level.depth,
                   {{"pocket_radius", &level.pocket_radius},
                    {"tool_radius", &level.tool_radius},
                    {"step", &level.step},
                    {"f", &level.feed}});
}

std::string thread_text(const reference::ThreadMilling& thread, const Number& pass) {
  const Number radius = thread.radius_of_pass(pass);
  const Number passes = thread.passes();
  return item_text("thread-pass", thread, thread.bottom,
                   {{"pass", &pass},
                    {"passes", &passes},
                    {"radius", &radius},
                    {"r_plane", &thread.r_plane},
                    {"lead", &thread.lead},
                    {"f", &thread.feed}});
}

std::string helix_text(const reference::HelixPocket& pocket) {
  const Number turns = pocket.turns;
  return item_text("helix-pocket", pocket, pocket.bottom,
                   {{"r_plane", &pocket.r_plane},
                    {"radius", &pocket.radius},
                    {"turns", &turns},
                    {"f", &pocket.feed}});
}

std::string pocket_text(const reference::PocketMilling& pocket) {
  return item_text(pocket.finishing ? "pocket-finish" : "pocket-rough", pocket, pocket.floor,
                   {{"length", &pocket.length},
                    {"width", &pocket.width},
                    {"corner_radius", &pocket.corner_radius},
                    {"tool_radius", &pocket.tool_radius},
                    {"infeed", &pocket.infeed},
                    {"depth_f", &pocket.depth_feed},
                    {"f", &pocket.plane_feed}});
}

namespace {

template <typename... Cases>
struct Overload : Cases... {
  using Cases::operator()...;
};

}  // namespace

std::string step_text(const ReferenceStep& step) {
  return std::visit(
      Overload{[](const Motion& motion) { return record_text(motion.record); },
               [](const reference::Record& record) { return record_text(record); },
               [](const reference::PocketLevel& level) { return level_text(level); },
               [](const reference::HelixPocket& pocket) { return helix_text(pocket); },
               [](const reference::ThreadMilling& thread) { return thread_text(thread, 1); },
               [](const reference::PocketMilling& pocket) { return pocket_text(pocket); },
               [](const reference::AlarmReport& report) { return alarms_text(report); },
               [](const auto&) { return std::string(); }},
      step);
}

reference::ClauseId clause_of(const ReferenceStep& step) {
  return std::visit(Overload{[](const Motion& motion) { return motion.record.clause; },
                             [](const reference::Record& record) { return record.clause; },
                             [](const reference::PocketLevel& level) { return level.clause; },
                             [](const reference::HelixPocket& pocket) { return pocket.clause; },
                             [](const reference::ThreadMilling& thread) { return thread.clause; },
                             [](const reference::PocketMilling& pocket) { return pocket.clause; },
                             [](const auto&) { return reference::kNoClause; }},
                    step);
}

std::uint64_t block_of(const ReferenceStep& step) {
  return std::visit(Overload{[](const Motion& motion) { return motion.record.block; },
                             [](const auto& item) { return item.block; }},
                    step);
}

std::string alarms_text(const reference::AlarmReport& report) {
  std::string classes;
  for (const reference::AdmittedClass& one : reference::admitted_classes(report)) {
    classes += fmt::format("{}\"{}\"", classes.empty() ? "" : ",", reference::name(one.alarm));
  }
  return fmt::format("{{\"k\":\"alarm\",\"b\":{},\"any_of\":[{}]}}", report.block, classes);
}

std::string alarm_text(const SubjectAlarm& alarm) {
  nlohmann::ordered_json text = {{"k", "alarm"}};
  if (alarm.block != 0) text["b"] = alarm.block;
  if (!alarm.alarm_class.empty()) text["class"] = alarm.alarm_class;
  if (!alarm.native.empty()) text["native"] = alarm.native;
  if (!alarm.word.empty()) text["word"] = alarm.word.text();
  return text.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string exact_text(const Number& value) {
  std::string text;
  value.append_json(text);
  if (text.size() > 2 && text.front() == '"') text = text.substr(1, text.size() - 2);
  return text;
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
