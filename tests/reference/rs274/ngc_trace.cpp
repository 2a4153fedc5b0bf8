// SPDX-License-Identifier: GPL-3.0-or-later
#include "ngc_trace.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace gonogo::reference::testing::ngc {
namespace {

class Tracer {
 public:
  explicit Tracer(const Position& at) : at_(at) {}

  void operator()(const Record& record) {
    switch (record.kind) {
      case RecordKind::m:
        if (record.m != 2) add('M', record.m);
        return;
      case RecordKind::dwell:
        if (record.seconds.sign() != 0) add('D', record.seconds);
        return;
      case RecordKind::end:
        return;
      case RecordKind::thread:
        return move('T', record, record.lead);
      case RecordKind::rapid:
        return move('R', record, 0);
      default:
        return move('F', record, record.feed);
    }
  }
  void operator()(const AlarmReport& report) {
    Lines classes;
    for (const Alarm& alarm : report.alarms) classes.emplace_back(name(alarm.alarm));
    add('!', 0, fmt::format("!b{}:{}", report.block, fmt::join(classes, ",")));
  }
  void operator()(const NotCovered& end) {
    add('?', 0, fmt::format("?b{}:{}", end.block, end.code));
  }
  template <typename Other>
  void operator()(const Other&) {}

  std::vector<TraceStep> take() { return std::move(steps_); }

 private:
  void add(char kind, const Number& value, std::string text = "") {
    steps_.push_back({kind, {at_[Axis::x], at_[Axis::y], at_[Axis::z]}, value, std::move(text)});
  }
  void move(char kind, const Record& record, const Number& value) {
    Position to = at_;
    for (const Axis axis : kAllAxes) {
      if (record.axes.has(axis)) to[axis] = record.to[axis];
    }
    if (to == at_) return;
    at_ = to;
    add(kind, value);
  }

  Position at_;
  std::vector<TraceStep> steps_;
};

std::string text_of_step(const TraceStep& step) {
  if (!step.text.empty()) return step.text;
  if (step.kind == 'D' || step.kind == 'M') return step.kind + step.value.text();
  const std::string lead = step.kind == 'T' ? "@" + step.value.text() : "";
  return fmt::format("{}{},{},{}{}", step.kind, step.at[0].text(), step.at[1].text(),
                     step.at[2].text(), lead);
}

}  // namespace

std::vector<TraceStep> trace_steps(std::string_view program, const Profile& profile) {
  Tracer tracer(profile.initial.at);
  for (const Item& item : expand(program, profile)) std::visit(tracer, item);
  return tracer.take();
}

std::string trace(std::string_view program, const Profile& profile) {
  Lines words;
  for (const TraceStep& step : trace_steps(program, profile)) words.push_back(text_of_step(step));
  return fmt::format("{}", fmt::join(words, " "));
}

Profile column(std::string_view machine) {
  std::ifstream file(fmt::format("{}/examples/profiles/rs274-{}.toml", GONOGO_SOURCE_DIR, machine));
  std::ostringstream text;
  text << file.rdbuf();
  auto profile = profile_from_toml(text.str());
  if (auto* error = std::get_if<ProfileError>(&profile)) {
    throw std::invalid_argument(error->key + ": " + error->message);
  }
  return std::get<Profile>(profile);
}

}  // namespace gonogo::reference::testing::ngc
