// SPDX-License-Identifier: GPL-3.0-or-later
#include "statement.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <regex>

namespace gonogo::mutations {

using oracle::RunEnd;

namespace {

Statement wrong(std::string why) {
  return {Answer::reject, std::move(why)};
}

// Nothing wrong so far.
Statement nothing() {
  return {Answer::same, ""};
}

bool is_alarm(const Trace& trace) {
  return trace.end.kind == RunEnd::Kind::alarm;
}

Statement state_alarm(const Specimen& specimen, const Trace& mutant) {
  if (!is_alarm(specimen.right)) {
    return is_alarm(mutant) ? wrong("an alarm without a fault") : nothing();
  }
  if (!is_alarm(mutant)) return wrong("no alarm");
  const oracle::SubjectAlarm& alarm = mutant.end.alarm;
  if (alarm.block != specimen.right.end.alarm.block) return wrong("an alarm of another block");
  const bool admissible = std::ranges::any_of(specimen.admissible, [&](reference::AlarmClass one) {
    return reference::name(one) == alarm.alarm_class;
  });
  return admissible ? nothing() : wrong("an alarm of another class");
}

struct PassedOn {
  std::int32_t m;
  std::uint64_t block;
  friend bool operator==(const PassedOn&, const PassedOn&) = default;
};

// R5: those of one block whose places no text fixes, by their numbers.
template <typename Function>
void sort_within_blocks(std::vector<Function>& all, auto&& record_of) {
  const auto is_of_block = [&](const Function& a, const Function& b) {
    return !record_of(a).among_motions && !record_of(b).among_motions &&
           record_of(a).block == record_of(b).block;
  };
  for (auto first = all.begin(); first != all.end();) {
    const auto last = std::find_if(first, all.end(),
                                   [&](const Function& one) { return !is_of_block(*first, one); });
    const auto is_before = [&](const Function& a, const Function& b) {
      return record_of(a).m < record_of(b).m;
    };
    // std::stable_sort warns under clang-19.
    for (auto next = first; next != last; ++next) {
      std::rotate(std::upper_bound(first, next, *next, is_before), next, next + 1);
    }
    first = first == last ? first + 1 : last;
  }
}

std::vector<PassedOn> functions_of(const Trace& trace) {
  std::vector<Record> records;
  for (const Record& record : trace.records) {
    if (record.kind == RecordKind::m) records.push_back(record);
  }
  sort_within_blocks(records, std::identity());
  std::vector<PassedOn> all;
  for (const Record& record : records) all.push_back({record.m, record.block});
  return all;
}

// The strokes of its own block on one side of an M function.
struct Side {
  int strokes = 0;
  int cuts = 0;
  int dwells = 0;

  void take(const Stroke& stroke) {
    ++strokes;
    dwells += stroke.is_dwell() ? 1 : 0;
    cuts += !stroke.is_dwell() && stroke.kind() != RecordKind::rapid ? 1 : 0;
  }
};

struct Standing {
  const Record* function = nullptr;
  Place at{};      // of the tool
  int dwells = 0;  // that came before it
  Side before;
  Side behind;
  bool among_others = false;  // a later block stands before it, or an earlier one behind it
};

// Where the M functions of a trace stand among what is surely seen.
std::vector<Standing> standings_in(const Specimen& specimen, const Trace& trace) {
  std::vector<Standing> all;
  std::vector<Stroke> seen = specimen.strokes(trace);
  std::erase_if(seen, [&](const Stroke& one) { return one.is_nil(2 * specimen.tolerance()); });
  for (std::size_t i = 0; i < trace.records.size(); ++i) {
    const Record& record = trace.records[i];
    if (record.kind != RecordKind::m) continue;
    Standing& standing = all.emplace_back();
    standing.function = &record;
    standing.at = specimen.start;
    for (const Stroke& stroke : seen) {
      const bool is_before = stroke.number < i;
      const std::uint64_t block = stroke.record->block;
      if (is_before) standing.at = stroke.unnamed(stroke.to);
      if (is_before && stroke.is_dwell()) ++standing.dwells;
      if (block == record.block) {
        (is_before ? standing.before : standing.behind).take(stroke);
      } else if ((block > record.block) == is_before) {
        standing.among_others = true;
      }
    }
  }
  return all;
}

bool is_one_of(std::int32_t m, std::initializer_list<std::int32_t> numbers) {
  return std::ranges::find(numbers, m) != numbers.end();
}

// Whether it may stand elsewhere in its block than the right one does, and there.
bool breaks_its_block(const Standing& got, const Standing& right) {
  const Record& function = *right.function;
  const bool starts = function.before_cut || is_one_of(function.m, {3, 4, 6, 7, 8});
  const bool stops = is_one_of(function.m, {0, 1, 5, 9});
  const bool is_same_side = (got.before.strokes > 0) == (right.before.strokes > 0) &&
                            (got.behind.strokes > 0) == (right.behind.strokes > 0);
  if (function.among_motions || is_one_of(function.m, {2, 17, 30})) return !is_same_side;
  if (is_same_side) return false;
  if (starts && got.before.cuts + got.before.dwells > 0) return true;
  if (stops && got.behind.cuts > 0) return true;
  const bool is_cycle =
      right.before.cuts + right.behind.cuts > 0 && right.before.strokes + right.behind.strokes > 1;
  return is_cycle && !function.before_cut && got.before.strokes > 0 && got.behind.strokes > 0;
}

// Whether the program has O words, or M98 and M99, that say which line is next: then the number of
// a line says nothing of what comes before what.
bool lines_may_come_again(const Specimen& specimen) {
  if (specimen.profile.dialect != "rs274") return false;
  static const std::regex kChoice(
      R"((^|\n)[ \t]*[oO][^(\n]*(sub|call|if|do|while|repeat|return|break|continue)|[mM]9[89])");
  return std::regex_search(specimen.program, kChoice);
}

Statement state_functions(const Specimen& specimen, const Trace& mutant) {
  if (functions_of(mutant) != functions_of(specimen.right)) {
    // No text says which are passed on by the block that alarms.
    if (is_alarm(specimen.right)) {
      auto without = [&](const Trace& trace) {
        std::vector<PassedOn> all = functions_of(trace);
        std::erase_if(
            all, [&](const PassedOn& one) { return one.block >= specimen.right.end.alarm.block; });
        return all;
      };
      if (without(mutant) == without(specimen.right)) return {Answer::unsure, "M of the alarm"};
    }
    return wrong("other M functions");
  }
  std::vector<Standing> right = standings_in(specimen, specimen.right);
  std::vector<Standing> got = standings_in(specimen, mutant);
  const auto record_of = [](const Standing& one) -> const Record& { return *one.function; };
  sort_within_blocks(right, record_of);
  sort_within_blocks(got, record_of);
  constexpr double kElsewhere = 4;  // tolerances
  for (std::size_t i = 0; i < got.size(); ++i) {
    const bool is_fixed = right[i].function->among_motions;
    const bool is_elsewhere = apart(got[i].at, right[i].at) > kElsewhere * specimen.tolerance() ||
                              got[i].dwells != right[i].dwells;
    if (is_fixed && is_elsewhere) return wrong("an M function at another place");
    if (lines_may_come_again(specimen)) continue;
    if (got[i].among_others) return wrong("an M function out of its block");
    if (breaks_its_block(got[i], right[i])) return wrong("an M function out of its place");
  }
  return nothing();
}

// A motion that is seen, or anything else, behind the `end` record.
Statement state_end(const Specimen& specimen, const Trace& mutant) {
  const auto is_end = [](const Record& record) { return record.kind == RecordKind::end; };
  const auto end = std::ranges::find_if(mutant.records, is_end);
  if (end == mutant.records.end()) return nothing();
  if (end + 1 != mutant.records.end()) return wrong("something after the end");
  if (is_alarm(mutant)) return wrong("an end and an alarm");
  const auto right = std::ranges::find_if(specimen.right.records, is_end);
  if (right == specimen.right.records.end()) return wrong("an end where an alarm is due");
  for (const reference::Axis axis : reference::kAllAxes) {
    if (!end->axes.has(axis)) continue;
    const double off = std::abs(value_of(end->to[axis] - right->to[axis]));
    if (off > 1.02 * specimen.tolerance()) return wrong("another end position");
  }
  return nothing();
}

bool is_same_stroke(const Stroke& a, const Stroke& b) {
  constexpr double kSame = 1e-7;
  return a.kind() == b.kind() && a.record->block == b.record->block && apart(a.to, b.to) < kSame &&
         std::abs(a.sweep - b.sweep) < kSame;
}

bool are_same(const std::vector<Stroke>& a, const std::vector<Stroke>& b) {
  return std::ranges::equal(a, b, is_same_stroke);
}

std::vector<Stroke> without_nil(std::vector<Stroke> strokes, double tolerance) {
  std::erase_if(strokes, [&](const Stroke& one) { return one.is_surely_nil(tolerance); });
  return strokes;
}

// Traverses that follow each other as one to where the last of them ends.
std::vector<Stroke> with_traverses_as_one(const std::vector<Stroke>& strokes) {
  std::vector<Stroke> all;
  for (const Stroke& stroke : strokes) {
    const bool goes_on = !all.empty() && all.back().kind() == RecordKind::rapid &&
                         stroke.kind() == RecordKind::rapid &&
                         all.back().record->block == stroke.record->block;
    if (goes_on) all.pop_back();
    all.push_back(stroke);
  }
  return all;
}

// By which rule a mutant is right that lies along the right path (docs/judging.md, J-PROP-07).
std::string kind_of_equality(const Specimen& specimen, const Trace& mutant,
                             const std::vector<Stroke>& got) {
  std::vector<Stroke> right;
  for (const PathElement& element : specimen.path) {
    right.insert(right.end(), element.strokes.begin(), element.strokes.end());
  }
  if (are_same(got, right)) {
    if (mutant.records.size() != specimen.right.records.size()) {
      return "the same path in other pieces (R1)";
    }
    const auto kinds_differ = !std::ranges::equal(mutant.records, specimen.right.records, {},
                                                  &Record::kind, &Record::kind);
    return kinds_differ ? "an M function elsewhere in its block (R5)"
                        : "the same in other words (R1)";
  }
  const double tau = specimen.tolerance();
  const std::vector<Stroke> seen = without_nil(got, tau);
  const std::vector<Stroke> due = without_nil(right, tau);
  if (are_same(seen, due)) return "nothing moves (R3)";
  if (are_same(with_traverses_as_one(seen), with_traverses_as_one(due))) {
    return "the way of a traverse (R4)";
  }
  return "within the tolerance (R2, R1)";
}

// Where the right path has motions hardly larger than the tolerance, a place may be off by one
// tolerance from another that is dropped within one (R3).
bool has_small_motions(const Specimen& specimen) {
  const double tau = specimen.tolerance();
  return std::ranges::any_of(specimen.path, [&](const PathElement& element) {
    return std::ranges::any_of(element.strokes, [&](const Stroke& one) {
      return !one.is_dwell() && apart(one.from, one.to) <= 2 * tau && !one.meets_itself;
    });
  });
}

constexpr double kSurelyBeyond = 1.2;  // tolerances: what is farther off is wrong
constexpr double kBeyondTwo = 2.4;     // where a place may be off twice
constexpr double kSurelyWithin = 0.98;

// Where an arc begins or ends on its own centre, that end shows no direction (J-PATH-06): in an
// open part the record does not tell what it sweeps. Not where the right trace has such an arc.
bool hides_a_sweep(const Specimen& specimen, const Trace& mutant) {
  constexpr double kNoRadius = 1e-9;
  const auto is_open = [](const PathElement& element) { return element.open != nullptr; };
  const auto has_one = [&](const Trace& trace) {
    return std::ranges::any_of(specimen.strokes(trace), [](const Stroke& one) {
      return one.is_round && std::min(one.from_radius, one.to_radius) < kNoRadius;
    });
  };
  return std::ranges::any_of(specimen.path, is_open) && has_one(mutant) && !has_one(specimen.right);
}

// Motions as they stand and joined: what is dropped between two decides which.
MapResult map_any_way(const Specimen& specimen, const Trace& mutant, const Margin& margin) {
  const std::vector<Stroke> strokes = specimen.strokes(mutant);
  const MapResult result = map_onto(specimen.path, joined(strokes), margin);
  if (result.fit == Fit::along) return result;
  const MapResult apart = map_onto(specimen.path, strokes, margin);
  return apart.fit != Fit::none ? apart : result;
}

Statement state_path(const Specimen& specimen, const Trace& mutant) {
  const double tau = specimen.tolerance();
  const std::vector<Stroke> strokes = joined(specimen.strokes(mutant));
  // A control that checks at load may alarm with no motion at all.
  const bool at_load = specimen.profile.alarm_timing == reference::AlarmTiming::program;
  if (at_load && is_alarm(mutant) && is_alarm(specimen.right) && strokes.empty()) {
    return {Answer::same, "no motion before an alarm at load (R6)"};
  }
  const double beyond = (has_small_motions(specimen) ? kBeyondTwo : kSurelyBeyond) * tau;
  const Margin wide{beyond, 4 * tau, beyond};
  const MapResult weak = map_any_way(specimen, mutant, wide);
  if (weak.fit == Fit::none) {
    if (hides_a_sweep(specimen, mutant)) return {Answer::unsure, "a sweep that is not told"};
    return wrong(weak.broken.empty() ? "off the path" : weak.broken);
  }
  if (weak.fit == Fit::open) return {Answer::unsure, "the path is open there"};
  const Margin narrow{kSurelyWithin * tau, kSurelyWithin * tau, kSurelyWithin * tau, true};
  const MapResult strong = map_onto(specimen.path, strokes, narrow);
  if (strong.fit != Fit::along) return {Answer::unsure, "near the tolerance"};
  return {Answer::same, kind_of_equality(specimen, mutant, strokes)};
}

}  // namespace

Statement state(const Specimen& specimen, const Trace& mutant) {
  Statement unsure;
  Statement same;
  for (auto part : {state_alarm, state_end, state_functions, state_path}) {
    Statement statement = part(specimen, mutant);
    if (statement.answer == Answer::reject) return statement;
    (statement.answer == Answer::unsure ? unsure : same) = statement;
  }
  return unsure.why.empty() ? same : unsure;
}

}  // namespace gonogo::mutations
