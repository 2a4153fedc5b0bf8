// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/definition.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "oracle/relation/correspondence.hpp"

namespace gonogo::relation {

using oracle::Decision;
using oracle::VerdictKind;
using reference::ReadingKey;

namespace {

bool is_go(const Answer& answer) {
  return decision(answer.kind) == Decision::go;
}

// R9: the best answer counts.
enum Rank : std::uint8_t { kGo, kUndecided, kAdvice, kNoGo };
Rank rank(const Answer& answer) {
  if (is_go(answer)) return kGo;
  if (decision(answer.kind) == Decision::undecided) return kUndecided;
  return answer.kind == VerdictKind::advice ? kAdvice : kNoGo;
}

// One combination of the readings, one reading of the trace.
struct Judgement {
  Answer answer;
  bool finds_centres = false;
  bool is_beyond_end = false;
  std::vector<ReadingKey> touched;
};

Answer undecided(GapReason reason, std::string message) {
  Answer answer;
  answer.kind = VerdictKind::oracle_gap;
  answer.gap = reason;
  answer.message = std::move(message);
  return answer;
}

// What the curves themselves do lies between what inner and outer reach.
Judgement judge(const reference::Profile& profile, std::string_view program,
                const Tolerances& tolerances, const Outcome& outcome, Manner manner) {
  manner.bias = Bias::inner;
  Correspondence inner(profile, program, tolerances, outcome, manner);
  Judgement judgement{inner.best(), inner.finds_centres(), inner.is_beyond_end(), inner.touched()};
  if (is_go(judgement.answer) || !inner.has_width()) return judgement;
  manner.bias = Bias::outer;
  Correspondence outer(profile, program, tolerances, outcome, manner);
  const Answer answer = outer.best();
  judgement.finds_centres = outer.finds_centres();
  judgement.is_beyond_end = outer.is_beyond_end();
  judgement.touched = outer.touched();
  if (rank(answer) == rank(judgement.answer)) {
    judgement.answer = answer;
    return judgement;
  }
  Answer between = undecided(GapReason::cutting, "The sides are as far apart as the tolerance.");
  between.record = judgement.answer.record;
  between.want = judgement.answer.want;
  between.got = judgement.answer.got;
  judgement.answer = std::move(between);
  return judgement;
}

bool is_departure(const Answer& answer) {
  return decision(answer.kind) == Decision::no_go;
}

// R7: the answer with the excuse: an advice where that is GO, undecided where that is undecided.
void excuse(Answer& answer, const Answer& excused, std::string message) {
  if (rank(excused) == kUndecided) answer = excused;
  if (rank(excused) != kGo && excused.kind != VerdictKind::advice) return;
  answer.kind = VerdictKind::advice;
  answer.message = std::move(message);
}

// R9: the arcs whose ends agree, all of them with their other turn and each alone.
std::vector<std::vector<std::size_t>> other_turns(const reference::Profile& profile,
                                                  const Tolerances& tolerances,
                                                  const Outcome& outcome) {
  reference::Position here = profile.initial.at;
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < outcome.records.size(); ++i) {
    const reference::Record& record = outcome.records[i];
    if (has_two_readings(record, here, tolerances.tolerance)) all.push_back(i);
    if (is_motion(record.kind)) here = end_of(record, here);
  }
  std::vector<std::vector<std::size_t>> turns;
  if (!all.empty()) turns.push_back(all);
  if (all.size() > 1) {
    for (const std::size_t one : all) turns.push_back({one});
  }
  return turns;
}

// R2: takes the arcs at which the trace departs, one after the other, as rounded arcs of the
// reference.
std::optional<Judgement> judge_rounded(const reference::Profile& profile, std::string_view program,
                                       const Tolerances& tolerances, const Outcome& outcome,
                                       const Answer& departure) {
  reference::Position here = profile.initial.at;
  std::vector<bool> may_turn;
  for (const reference::Record& record : outcome.records) {
    may_turn.push_back(ends_agree(record, here, tolerances.tolerance));
    if (is_motion(record.kind)) here = end_of(record, here);
  }
  Manner manner{.turned = {}, .only_rounded = true};
  Judgement judgement{departure, {}, {}, {}};
  while (is_departure(judgement.answer)) {
    const std::size_t record = judgement.answer.record.value_or(may_turn.size());
    if (record >= may_turn.size() || !may_turn[record]) return std::nullopt;
    may_turn[record] = false;
    manner.turned.push_back(record);
    judgement = judge(profile, program, tolerances, outcome, manner);
  }
  return judgement;
}

// Under one assignment: R7 of centres and of ends, and R9 of arcs whose ends agree.
Judgement judge_readings_of_trace(const reference::Profile& profile, std::string_view program,
                                  const Tolerances& tolerances, const Outcome& outcome) {
  Judgement judgement = judge(profile, program, tolerances, outcome, {});
  if (is_departure(judgement.answer) && judgement.finds_centres && !tolerances.strict) {
    const Judgement excused =
        judge(profile, program, tolerances, outcome, {.excuses_centres = true});
    excuse(judgement.answer, excused.answer, "No text says how finely the centre is computed.");
  }
  if (is_departure(judgement.answer) && judgement.is_beyond_end && !tolerances.strict) {
    const Judgement excused = judge(profile, program, tolerances, outcome, {.passes_end = true});
    excuse(judgement.answer, excused.answer, "No text says that the program ends.");
  }
  if (!is_departure(judgement.answer) || tolerances.exact) return judgement;
  const bool says_how_it_rounds = tolerances.resolution || tolerances.binary64;
  if (auto rounded = judge_rounded(profile, program, tolerances, outcome, judgement.answer)) {
    if (!is_go(rounded->answer) || says_how_it_rounds) return *std::move(rounded);
    rounded->answer =
        undecided(GapReason::two_readings, "An arc whose ends agree may be a nil or a full turn.");
    return *std::move(rounded);
  }
  for (const std::vector<std::size_t>& turned : other_turns(profile, tolerances, outcome)) {
    const Judgement other = judge(profile, program, tolerances, outcome, {.turned = turned});
    if (rank(other.answer) > kUndecided) continue;
    judgement.answer =
        undecided(GapReason::two_readings, "An arc whose ends agree may be a nil or a full turn.");
    break;
  }
  return judgement;
}

// The first reading that was asked for and is open.
const reference::Reading* open_reading(const reference::ReadingChoice& choice,
                                       const std::vector<ReadingKey>& touched) {
  for (const ReadingKey key : touched) {
    const reference::Reading& reading = reference::reading(key);
    if (!reading.by_properties && choice.is(key, "any")) return &reading;
  }
  return nullptr;
}

// What an open length may be: how far the subject stands, before and behind its record, from the
// lowest and the highest place that it has been at, along an axis of the record.
std::set<std::string> lengths_shown(const reference::Profile& profile, const Outcome& outcome,
                                    std::size_t number) {
  if (number >= outcome.records.size() || !is_motion(outcome.records[number].kind)) return {};
  reference::Position here = profile.initial.at;
  reference::Position low = here;
  reference::Position high = here;
  for (const reference::Record& record : outcome.records.first(number)) {
    if (!is_motion(record.kind)) continue;
    here = end_of(record, here);
    for (const reference::Axis axis : reference::kLinearAxes) {
      low[axis] = min(low[axis], here[axis]);
      high[axis] = max(high[axis], here[axis]);
    }
  }
  const reference::Record& departing = outcome.records[number];
  const reference::Position to = end_of(departing, here);
  std::set<std::string> lengths;
  for (const reference::Axis axis : reference::kLinearAxes) {
    if (!departing.axes.has(axis)) continue;
    for (const Number& length : {abs(here[axis] - low[axis]), abs(here[axis] - high[axis]),
                                 abs(to[axis] - low[axis]), abs(to[axis] - high[axis])}) {
      if (length.is_rational() && length.sign() != 0) lengths.insert(length.text());
    }
  }
  return lengths;
}

// R5: nothing follows the end.
std::optional<Answer> overrun(const Outcome& outcome) {
  for (std::size_t i = 0; i < outcome.records.size(); ++i) {
    if (outcome.records[i].kind != reference::RecordKind::end) continue;
    if (i + 1 == outcome.records.size() && outcome.alarm == nullptr) break;
    Answer answer;
    answer.kind = VerdictKind::fail_overrun;
    answer.rule = Rule::event;
    answer.record = i + 1;
    answer.message = "Something follows the end of the trace.";
    return answer;
  }
  return std::nullopt;
}

// R3: the first record, or the alarm, without the line that the subject declares.
std::optional<Answer> without_line(const Tolerances& tolerances, const Outcome& outcome) {
  if (!tolerances.compare_blocks) return std::nullopt;
  const auto lacks = [&](const reference::Record& record) {
    if (record.block != 0 || record.kind == reference::RecordKind::end) return false;
    if (record.kind == reference::RecordKind::m) return tolerances.compare_m;
    return record.kind != reference::RecordKind::dwell || record.seconds.sign() != 0;
  };
  const auto first = std::ranges::find_if(outcome.records, lacks);
  const bool is_alarm = first == outcome.records.end();
  if (is_alarm && (outcome.alarm == nullptr || outcome.alarm->block != 0)) return std::nullopt;
  Answer answer;
  answer.kind = VerdictKind::protocol;
  answer.record = static_cast<std::size_t>(first - outcome.records.begin());
  answer.message = is_alarm ? "The alarm has no line." : "The record has no line.";
  return answer;
}

// Whether an answer stands where a line is lacking: it decides before that, or the gauge cannot say
// what the program does there.
bool stands(const Answer& answer, const Answer& lacking, const Outcome& outcome) {
  const bool is_gap = decision(answer.kind) == Decision::undecided;
  if (!is_gap && !is_departure(answer)) return false;
  const bool is_alarm = *lacking.record == outcome.records.size();
  return answer.record.value_or(0) < *lacking.record || (is_gap && is_alarm);
}

bool is_better(const Answer& one, const Answer& other) {
  return rank(one) < rank(other) || (rank(one) == rank(other) && one.record > other.record);
}

// R7: whether the departure shows that its alternative runs the block whose alarm the other answer
// runs over: it comes behind that alarm, or in its block and at no alarm.
bool shows_how_to_run_on(const Answer& departure, const Answer& runs_on) {
  if (departure.block == 0 || departure.block > runs_on.block) return true;
  return departure.block == runs_on.block && departure.rule != Rule::alarm;
}

}  // namespace

std::string_view name(Rule rule) {
  constexpr std::array<std::string_view, 7> kNames = {"", "R2", "R3", "R4", "R5", "R6", "R8"};
  return kNames[static_cast<std::size_t>(rule)];
}

std::string_view name(GapReason reason) {
  constexpr std::array<std::string_view, 8> kNames = {
      "",           "not-covered",  "profile",          "cutting",
      "comparison", "two-readings", "many-assignments", "reading-unfit"};
  return kNames[static_cast<std::size_t>(reason)];
}

namespace {

// The best of all combinations of the open readings that the program asks for; of departures the
// one that comes last.
Answer best_answer(const reference::Profile& profile, std::string_view program,
                   const Tolerances& tolerances, const Outcome& outcome) {
  constexpr std::size_t kMostAssignments = 64;
  std::vector<reference::ReadingChoice> choices = {profile.readings};
  std::optional<Answer> best;
  std::vector<Answer> departures;
  std::vector<reference::ReadingChoice> with_lengths;  // that have been tried
  std::size_t assignments = 0;
  while (!choices.empty()) {
    reference::Profile assigned = profile;
    assigned.readings = choices.back();
    choices.pop_back();
    Judgement judgement;
    try {
      judgement = judge_readings_of_trace(assigned, program, tolerances, outcome);
    } catch (const exact::Undecided& comparison) {
      judgement.answer = undecided(GapReason::comparison, comparison.what());
    }
    if (is_go(judgement.answer)) return judgement.answer;
    if (const reference::Reading* open = open_reading(assigned.readings, judgement.touched)) {
      for (const std::string_view alternative : open->alternatives) {
        choices.push_back(assigned.readings);
        choices.back().set(open->key, alternative);
      }
      continue;
    }
    if (++assignments > kMostAssignments) {
      return undecided(GapReason::many_assignments, "More than 64 combinations of open readings.");
    }
    for (const ReadingKey key : judgement.touched) {
      if (!reference::reading(key).is_length || !profile.readings.is(key, "any")) continue;
      if (!is_departure(judgement.answer) || !judgement.answer.record) continue;
      for (const std::string& length : lengths_shown(profile, outcome, *judgement.answer.record)) {
        reference::ReadingChoice choice = assigned.readings;
        choice.set(key, length);
        if (std::ranges::count(with_lengths, choice) > 0) continue;
        with_lengths.push_back(choice);
        choices.push_back(std::move(choice));
      }
    }
    if (is_departure(judgement.answer)) departures.push_back(judgement.answer);
    if (!best || is_better(judgement.answer, *best)) best = std::move(judgement.answer);
  }
  if (!best->runs_on) return *best;
  const Answer* shown = nullptr;
  for (const Answer& departure : departures) {
    if (!shows_how_to_run_on(departure, *best)) continue;
    if (shown == nullptr || is_better(departure, *shown)) shown = &departure;
  }
  return shown == nullptr ? *best : *shown;
}

}  // namespace

Answer decide(const reference::Profile& profile, std::string_view program,
              const Tolerances& tolerances, const Outcome& outcome) {
  const std::optional<Answer> behind_end = overrun(outcome);
  Answer answer = behind_end ? *behind_end : best_answer(profile, program, tolerances, outcome);
  const std::optional<Answer> lacking = without_line(tolerances, outcome);
  return lacking && !stands(answer, *lacking, outcome) ? *lacking : answer;
}

}  // namespace gonogo::relation
