// SPDX-License-Identifier: GPL-3.0-or-later
#include "ngc_trace.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

Profile column_linuxcnc() {
  return ngc({{"ngc.cycle.initial", "series"},
              {"ngc.cycle.g91-r", "initial"},
              {"ngc.cycle.sticky", "number"},
              {"ngc.cycle.approach", "initial-level"},
              {"ngc.cycle.initial-kept", "number"},
              {"ngc.cycle.retract-start", "r-plane"},
              {"ngc.cycle.feed", "needed"},
              {"ngc.cycle.alarm-at", "late"},
              {"ngc.g83.retract", "r-plane"},
              {"ngc.g83.return", "rapid"},
              {"ngc.peck.clearance", "ten-thou"},
              {"ngc.peck.d", "barred"},
              {"ngc.peck.dwell", "none"},
              {"ngc.g73.end", "clear"},
              {"ngc.g85.out", "r-plane"},
              {"ngc.tap.p", "last"},
              {"ngc.g74.l", "barred"},
              {"ngc.g33.k", "free"},
              {"ngc.g76.checks", "linuxcnc"},
              {"ngc.g76.slide", "start"},
              {"ngc.g76.entry", "thread"},
              {"ngc.g80-beside", "ignored"},
              {"ngc.bare-motion", "nothing"},
              {"ngc.program-end", "needed"}});
}

Profile column_nist() {
  return ngc({{"ngc.cycle.initial", "block"},
              {"ngc.cycle.g91-r", "current"},
              {"ngc.cycle.sticky", "number"},
              {"ngc.cycle.approach", "current-level"},
              {"ngc.cycle.retract-start", "r-plane"},
              {"ngc.cycle.feed", "free"},
              {"ngc.cycle.alarm-at", "late"},
              {"ngc.g83.retract", "clear"},
              {"ngc.g83.return", "rapid"},
              {"ngc.peck.clearance", "ten-thou"},
              {"ngc.peck.d", "barred"},
              {"ngc.peck.dwell", "none"},
              {"ngc.g85.out", "clear"},
              {"ngc.tap.p", "barred"},
              {"ngc.g80-beside", "alarm"},
              {"ngc.bare-motion", "missing-word"},
              {"ngc.program-end", "needed"}});
}

Profile column_grblhal() {
  return ngc({{"ngc.cycle.initial", "block"},
              {"ngc.cycle.g91-r", "current"},
              {"ngc.cycle.sticky", "level"},
              {"ngc.cycle.approach", "current-level"},
              {"ngc.cycle.retract-start", "initial"},
              {"ngc.cycle.feed", "needed"},
              {"ngc.cycle.alarm-at", "block"},
              {"ngc.g83.retract", "clear"},
              {"ngc.g83.return", "feed"},
              {"ngc.peck.clearance", "tenth-mm"},
              {"ngc.peck.dwell", "quarter"},
              {"ngc.g73.end", "clear"},
              {"ngc.tap.p", "needed"},
              {"ngc.g76.checks", "text"},
              {"ngc.g76.slide", "end"},
              {"ngc.g76.entry", "rapid"}});
}

Profile column_camotics() {
  return ngc({{"ngc.cycle.initial", "block"},
              {"ngc.cycle.g91-r", "absolute"},
              {"ngc.cycle.retract-start", "r-plane"},
              {"ngc.cycle.feed", "free"},
              {"ngc.g85.out", "clear"},
              {"ngc.unused-words", "ignored"}});
}

Profile column_freecad() {
  return ngc({{"ngc.cycle.initial", "block"},
              {"ngc.g83.retract", "r-plane"},
              {"ngc.g83.return", "rapid"},
              {"ngc.peck.clearance", "twentieth"},
              {"ngc.g73.end", "both"},
              {"ngc.unused-words", "ignored"}});
}

}  // namespace gonogo::reference::testing::ngc
