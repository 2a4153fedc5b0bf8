// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/steps/step_text.hpp"

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

Verdict verdict_on(VerdictKind kind, const reference::Record& got, std::size_t number,
                   std::string message) {
  Verdict verdict;
  verdict.kind = kind;
  verdict.block = got.block;
  verdict.record = number;
  verdict.got = record_text(got);
  verdict.message = std::move(message);
  return verdict;
}

Verdict undecided_verdict(const exact::Undecided& undecided) {
  return gap_verdict(GapReason::comparison,
                     fmt::format("A comparison could not be decided: {}.", undecided.what()));
}

}  // namespace gonogo::oracle
