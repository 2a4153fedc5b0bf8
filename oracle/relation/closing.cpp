// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a correspondence ends: at the end of both sides, at an alarm (R6), by what no text states
// (R7), at what the reference does not cover (R9), or by a departure.
#include <fmt/format.h>

#include <algorithm>

#include "oracle/relation/correspondence.hpp"
#include "oracle/relation/unreadable_block.hpp"
#include "reference/silent_end.hpp"

namespace gonogo::relation {

using oracle::Decision;
using oracle::VerdictKind;
using reference::AlarmReport;
using reference::NotCovered;
using reference::Record;
using reference::RecordKind;

namespace {

std::string text_of(const Event& event) {
  if (event.item == nullptr) return "the end of the trace";
  std::string text;
  if (const auto* record = std::get_if<Record>(&*event.item)) {
    append_json(*record, text);
  } else if (const auto* report = std::get_if<AlarmReport>(&*event.item)) {
    for (const reference::AdmittedClass& one : admitted_classes(*report)) {
      text += fmt::format("{}{}", text.empty() ? "alarm " : " or ", name(one.alarm));
    }
  } else if (event.part == Part::free_step) {
    text = "a path that the manual leaves open";
  } else if (event.part == Part::renaming) {
    text = "another name of the position";
  } else {
    text = "what is not covered";
  }
  return text;
}

std::string text_of(const oracle::SubjectAlarm& alarm) {
  return fmt::format("alarm {}{}", alarm.alarm_class.empty() ? alarm.native : alarm.alarm_class,
                     alarm.block == 0 ? "" : fmt::format(" in line {}", alarm.block));
}

// On the axis where the ends are farthest apart.
std::string distance_of(const Event& want, const Event& got) {
  Number farthest;
  for (const reference::Axis axis : reference::kAllAxes) {
    farthest = max(farthest, abs(want.to[axis] - got.to[axis]));
  }
  return farthest.decimal_text(6);
}

// How good an answer is: R7 and R9 excuse, but a path that agrees needs no excuse.
int rank(VerdictKind kind) {
  if (kind == VerdictKind::advice) return 2;
  switch (decision(kind)) {
    case Decision::go:
      return 0;
    case Decision::undecided:
      return 1;
    default:
      return 3;
  }
}

// R6: how often the line of an alarm names the M function, as far as its text says.
std::size_t times_named(std::string_view line, std::int32_t number) {
  const std::string digits = std::to_string(number);
  std::size_t times = 0;
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (line[at] != 'M' && line[at] != 'm') continue;
    std::size_t begin = line.find_first_not_of(" \t+0", at + 1);
    if (begin == std::string_view::npos) begin = line.size();
    const std::size_t end = std::min(line.find_first_not_of("0123456789", begin), line.size());
    const std::string_view found = line.substr(begin, end - begin);
    // What is calculated may be any.
    const bool is_calculated = begin < line.size() && std::string_view("[#=R(").find(line[begin]) !=
                                                          std::string_view::npos;
    if (is_calculated || found == digits || (found.empty() && number == 0)) ++times;
  }
  return times;
}

}  // namespace

void Correspondence::offer(Answer answer) {
  if (!best_ || rank(answer.kind) < rank(best_->kind)) best_ = std::move(answer);
}

Answer Correspondence::at_place(const Place& place, VerdictKind kind, Rule rule,
                                std::string message) {
  const Event& want = reference(place).at(place.i);
  const Event& got = subject(place).at(place.j);
  Answer answer;
  answer.kind = kind;
  answer.rule = rule;
  answer.record = got.record;
  answer.block = want.block;
  answer.want = text_of(want);
  const bool alarms = got.item == nullptr && outcome_.alarm != nullptr;
  answer.got = alarms ? text_of(*outcome_.alarm) : text_of(got);
  if (want.is_motion() && got.is_motion()) answer.distance = distance_of(want, got);
  if (want.item != nullptr) {
    if (const auto* record = std::get_if<Record>(&*want.item)) answer.clause = record->clause;
    if (const auto* report = std::get_if<AlarmReport>(&*want.item)) {
      answer.clause = best_supported(*report).clause;
      answer.block = report->block;
    }
  }
  answer.message = std::move(message);
  return answer;
}

// R6: an M function may be missing where its block alarms behind it.
void Correspondence::leave_out_of_alarm(const Place& place) {
  ReferenceSide& sides = reference(place);
  const Record& want = sides.at(place.i).source();
  std::size_t i = place.i;
  while (sides.at(i).part == Part::stop && sides.at(i).source().block == want.block) ++i;
  if (want.kind != RecordKind::m || sides.at(i).part != Part::close) return;
  const auto* report = std::get_if<AlarmReport>(&*sides.at(i).item);
  if (report == nullptr || report->block != want.block) return;
  Place next = place;
  ++next.i;
  reach_corner(next);
}

// R6: the M functions that have not come are of the block that alarms, or there are none.
bool Correspondence::is_due_of_block(const Place& place, std::uint64_t block) {
  ReferenceSide& sides = reference(place);
  for (std::size_t m = place.m; m < sides.m_functions(place.i); ++m) {
    if (sides.m_block(m) != block) return false;
  }
  return true;
}

void Correspondence::close(const Place& place) {
  const Event& want = reference(place).at(place.i);
  const Event& got = subject(place).at(place.j);
  if (want.part == Part::close) {
    const bool is_over = got.part == Part::close && (got.item != nullptr || !outcome_.alarm);
    is_beyond_end_ = is_beyond_end_ || (is_silent_end(*want.item) && !is_over);
    if (const auto* outside = std::get_if<NotCovered>(&*want.item)) {
      Answer gap = at_place(place, VerdictKind::oracle_gap, Rule::none, outside->message);
      gap.gap = outside->code == reference::kLackingProfile ? GapReason::profile_lacks
                                                            : GapReason::not_covered;
      return offer(std::move(gap));
    }
    const auto* report = std::get_if<AlarmReport>(&*want.item);
    if (report != nullptr && is_due_of_block(place, report->block)) {
      return close_at_alarm(place, *report);
    }
    if (report == nullptr && place.m == reference(place).m_functions(place.i)) {
      if (got.part != Part::close || got.item != nullptr || outcome_.alarm == nullptr) {
        return close_at_end(place, want.source());
      }
    }
  }
  if (got.part == Part::close && got.item == nullptr && outcome_.alarm != nullptr) {
    close_by_alarm(place);
  }
}

void Correspondence::close_at_end(const Place& place, const Record& end) {
  const Event& got = subject(place).at(place.j);
  if (got.part != Part::close) return;
  if (got.item != nullptr) {
    const Record& closed = got.source();
    // Nothing comes behind the end (definition.cpp), and it names places that agree.
    for (const reference::Axis axis : reference::kAllAxes) {
      if (!closed.axes.has(axis)) continue;
      if (abs(rational_near(closed.to[axis] - end.to[axis])) > tolerances_.tolerance) return;
    }
  }
  Answer answer = at_place(place, VerdictKind::pass_tolerance, Rule::none, "");
  answer.clause = reference::kNoClause;
  offer(std::move(answer));
}

namespace {

// R7: no text says the class of an alarm of the block, and this is another class for it.
bool is_other_name(const AlarmReport& report, std::string_view alarm_class) {
  return std::ranges::any_of(report.alarms, [&](const reference::Alarm& alarm) {
    return reference::is_silent(alarm.clause) &&
           reference::share_a_name(reference::clause(alarm.clause).other_names, alarm_class);
  });
}

}  // namespace

// R6: no text says whether an M function of the alarming block comes; besides those that are due it
// comes at most as often as it is named.
bool Correspondence::is_of_alarm(const Place& place, const AlarmReport& report) {
  ReferenceSide& sides = reference(place);
  const Record& got = subject(place).at(place.j).source();
  const auto is_same = [&](const Record& one) {
    return one.kind == RecordKind::m && one.m == got.m &&
           (!tolerances_.compare_blocks || one.block == report.block);
  };
  std::size_t due = 0;
  for (std::size_t m = 0; m < sides.m_functions(place.i); ++m) {
    if (is_same(sides.m_function(m))) ++due;
  }
  for (std::size_t i = 0; i < place.i; ++i) {
    if (sides.at(i).part == Part::stop && is_same(sides.at(i).source())) ++due;
  }
  const auto came = static_cast<std::size_t>(std::ranges::count_if(outcome_.records, is_same));
  return is_same(got) && came <= times_named(sides.failed_words(), got.m) + due;
}

void Correspondence::close_at_alarm(const Place& place, const AlarmReport& report) {
  const Event& got = subject(place).at(place.j);
  if (got.part == Part::stop && got.source().kind == RecordKind::m && is_of_alarm(place, report)) {
    Place next = place;
    ++next.j;
    return reach_corner(next);
  }
  const bool is_block = outcome_.alarm != nullptr &&
                        (!tolerances_.compare_blocks || outcome_.alarm->block == report.block);
  const bool is_class = outcome_.alarm != nullptr && admits(report, outcome_.alarm->alarm_class);
  const bool alarms = got.part == Part::close && got.item == nullptr && outcome_.alarm != nullptr;
  // R7: the other answer to an alarm that no text states is to run on from its block, without it.
  const bool is_before = tolerances_.compare_blocks && reference(place).is_in_order() &&
                         got.part != Part::close && got.block < report.block;
  // An alarm behind it is another one, which the program has without the block.
  const auto runs_on = [&] {
    if (is_before || (alarms && is_block)) return false;
    return outcome_.alarm == nullptr || alarms_without(profile_, program_, report, *outcome_.alarm);
  };
  if (reference::is_silent(best_supported(report).clause) && !tolerances_.strict && runs_on()) {
    Answer advice = at_place(place, VerdictKind::advice, Rule::alarm, "No text states the alarm.");
    advice.block = report.block;
    advice.runs_on = true;
    offer(std::move(advice));
  }
  if (!alarms) return;
  const auto alarms_before = [&] {
    return alarms_before_fault(profile_, program_, report, outcome_.alarm->alarm_class);
  };
  if (!is_block) return;
  if (!is_class && is_other_name(report, outcome_.alarm->alarm_class) && !tolerances_.strict) {
    offer(at_place(place, VerdictKind::advice, Rule::alarm, "No text says which alarm it is."));
  }
  if (!is_class) close_by_alarm(place);
  if (!is_class && !alarms_before()) return;
  Answer answer = at_place(place, VerdictKind::pass_tolerance, Rule::none, "");
  answer.clause = reference::kNoClause;
  offer(std::move(answer));
}

// R7: a block runs on by a rule that no text states, and the alarm is what the other answer would
// be; all that is due before the block has come, and nothing of it.
void Correspondence::close_by_alarm(const Place& place) {
  if (tolerances_.strict) return;
  ReferenceSide& sides = reference(place);
  const oracle::SubjectAlarm& alarm = *outcome_.alarm;
  const std::size_t known = sides.m_functions(place.i);
  for (const Acceptance& accepted : sides.acceptances()) {
    const bool is_other_answer =
        reference::share_a_name(reference::clause(accepted.clause).refusals, alarm.alarm_class);
    if (accepted.event != place.i || !is_other_answer) continue;
    if (tolerances_.compare_blocks && alarm.block != accepted.block) continue;
    const bool is_due = place.m < known && sides.m_block(place.m) != accepted.block &&
                        sides.is_overdue(place.m, place.i + 1);
    if (is_due) continue;
    Answer advice = at_place(place, VerdictKind::advice, Rule::alarm,
                             "No text says whether the block runs on.");
    advice.clause = accepted.clause;
    offer(std::move(advice));
  }
}

// R6: a control that checks at load alarms with no event before.
bool Correspondence::is_alarm_at_load() {
  const bool has_acted = std::ranges::any_of(outcome_.records, [&](const Record& record) {
    return tolerances_.compare_m || record.kind != RecordKind::m;
  });
  if (profile_.alarm_timing != reference::AlarmTiming::program || outcome_.alarm == nullptr ||
      has_acted) {
    return false;
  }
  ReferenceSide& sides = *pairs_.front().reference;
  std::size_t last = 0;
  while (sides.at(last).part != Part::close) ++last;
  if (!std::holds_alternative<AlarmReport>(*sides.at(last).item)) return false;
  close_at_alarm({0, last, 0, sides.m_functions(last)},
                 std::get<AlarmReport>(*sides.at(last).item));
  return best_.has_value();
}

namespace {

struct OtherAlarm {
  VerdictKind kind;
  std::string_view message;
};

// R6: `due` is null where no alarm is; `got` the subject's, where it has one. `comes_here`: nothing
// stands between the place where the sides part and it.
OtherAlarm other_alarm(const AlarmReport* due, const oracle::SubjectAlarm* got, bool comes_here,
                       bool compares_lines) {
  if (due == nullptr) return {VerdictKind::fail_alarm_spurious, "No alarm is due."};
  if (got == nullptr) return {VerdictKind::fail_alarm_missing, "The alarm that is due is missing."};
  if (!comes_here) {
    return {VerdictKind::fail_alarm_late, "The subject goes on before the alarm that is due."};
  }
  if (compares_lines && got->block < due->block) {
    return {VerdictKind::fail_alarm_spurious, "The alarm comes in a line before the due one."};
  }
  if (compares_lines && got->block > due->block) {
    return {VerdictKind::fail_alarm_late, "The alarm comes in a line behind the due one."};
  }
  if (got->alarm_class.empty()) {
    return {VerdictKind::unmapped_alarm, "The alarm has no class; the alarm map must give one."};
  }
  return {VerdictKind::fail_alarm_class, "The alarm is of another class."};
}

// R3: whether both sides dwell there, in one block: then only their times differ.
bool is_dwell_of(const Event& want, const Event& got, const Tolerances& tolerances) {
  if (want.part != Part::stop || got.part != Part::stop) return false;
  const Record& due = want.source();
  const Record& came = got.source();
  return due.kind == RecordKind::dwell && came.kind == RecordKind::dwell &&
         (!tolerances.compare_blocks || due.block == came.block);
}

}  // namespace

// The rule that is broken at the farthest place.
Answer Correspondence::departure() {
  const Event& want = reference(farthest_).at(farthest_.i);
  const Event& got = subject(farthest_).at(farthest_.j);
  const auto departs = [&](VerdictKind kind, Rule rule, std::string message) {
    return at_place(farthest_, kind, rule, std::move(message));
  };
  if (!broken_.empty() && broken_record_ >= farthest_record_) {
    return at_place(broken_at_, VerdictKind::fail_region, Rule::free_step, std::string(broken_));
  }
  if (lacks_m_) {
    return departs(VerdictKind::fail_order, Rule::event, "An M function was due before.");
  }
  const bool ends_by_alarm =
      outcome_.alarm != nullptr && got.part == Part::close && got.item == nullptr;
  const auto* due = want.part == Part::close ? std::get_if<AlarmReport>(&*want.item) : nullptr;
  if (due != nullptr || ends_by_alarm) {
    const auto [kind, message] =
        other_alarm(due, outcome_.alarm, ends_by_alarm, tolerances_.compare_blocks);
    return departs(kind, Rule::alarm, std::string(message));
  }
  if (want.part == Part::free_step) {
    return departs(VerdictKind::fail_geometry, Rule::free_step,
                   "The step is not what its clause describes.");
  }
  const Likeness likeness = want.is_motion() && got.is_motion()
                                ? compare(*want.label, *got.label, tolerances_)
                                : Likeness::other;
  if (!is_farthest_corner_ && likeness != Likeness::number &&
      (want.is_motion() || got.is_motion())) {
    const bool is_traverse = want.part == Part::traverse && got.part == Part::traverse;
    return departs(VerdictKind::fail_geometry, is_traverse ? Rule::traverse : Rule::place,
                   "A motion ends elsewhere.");
  }
  if (want.part == Part::close && got.is_motion()) {
    return departs(VerdictKind::fail_overrun, Rule::event, "The program is at its end.");
  }
  if (want.part == Part::close && got.part == Part::close) {
    return departs(VerdictKind::fail_geometry, Rule::place, "The end is not that of the program.");
  }
  if (is_dwell_of(want, got, tolerances_)) {
    return departs(VerdictKind::fail_feed, Rule::label, "The time of a dwell differs.");
  }
  if (!want.is_motion() || !got.is_motion()) {
    return departs(VerdictKind::fail_order, Rule::event, "An event is due here, or elsewhere.");
  }
  switch (likeness) {
    case Likeness::number:
      return departs(VerdictKind::fail_feed, Rule::label, "A number differs.");
    case Likeness::other:
      return departs(VerdictKind::fail_geometry, Rule::label,
                     "The motion is of another kind or line.");
    case Likeness::same:
      break;
  }
  return departs(VerdictKind::fail_geometry,
                 want.part == Part::traverse ? Rule::traverse : Rule::place,
                 "The motion leads elsewhere.");
}

}  // namespace gonogo::relation
