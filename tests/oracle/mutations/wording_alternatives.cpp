// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same motions in other words: rounded, with fewer fields or more, without blocks.
#include <algorithm>
#include <cmath>

#include "alternative.hpp"

namespace gonogo::mutations {
namespace {

using oracle::RunEnd;
using reference::Axis;

void each_length(Record& record, const std::function<Number(const Number&)>& change) {
  for (const Axis axis : reference::kAllAxes) {
    record.to[axis] = change(record.to[axis]);
    record.via[axis] = change(record.via[axis]);
  }
  for (Number& coordinate : record.centre) coordinate = change(coordinate);
}

bool change_numbers(Attempt& attempt, const std::function<Number(const Number&)>& change) {
  for (Record& record : attempt.trace.records) {
    each_length(record, change);
    for (Number* number : {&record.feed, &record.lead, &record.start, &record.seconds}) {
      *number = change(*number);
    }
  }
  return true;
}

// A number that is given in steps, the nearest.
Number rounded(const Number& value, const Number& step) {
  return Number(static_cast<std::int64_t>(std::llround(value_of(value / step)))) * step;
}

bool in_steps(Attempt& attempt, const Number& step) {
  attempt.tolerances.resolution = step;
  for (Record& record : attempt.trace.records) {
    each_length(record, [&](const Number& value) { return rounded(value, step); });
  }
  return true;
}

bool rounded_to_the_resolution(Attempt& attempt) {
  return in_steps(attempt, attempt.specimen.profile.resolution());
}

bool rounded_ten_times_finer(Attempt& attempt) {
  const Number step = attempt.specimen.profile.resolution() / 10;
  attempt.tolerances.tolerance = min(attempt.tolerances.tolerance, step);
  return in_steps(attempt, step);
}

// The nearest double.
Number as_double(const Number& value) {
  int exponent = 0;
  const double fraction = std::frexp(value_of(value), &exponent);
  constexpr int kBits = 53;
  return Number::binary(static_cast<std::int64_t>(std::ldexp(fraction, kBits)), exponent - kBits);
}

bool as_doubles(Attempt& attempt) {
  attempt.tolerances.binary64 = true;
  return change_numbers(attempt, as_double);
}

// All that a subject that computes with intervals can say: a number somewhere in 4e-16 about it.
Number as_enclosure(const Number& value) {
  const auto [low, high] = value.bounds(60);
  const Number reach = Number(2) * Number::decimal(false, 1, 16);
  return Number::between(low - reach, high + reach);
}

bool as_enclosures(Attempt& attempt) {
  return change_numbers(attempt, as_enclosure);
}

bool rounded_feeds(Attempt& attempt) {
  const Number step = Number::millionths(1'000);
  attempt.tolerances.feed_resolution = step;
  for (Record& record : attempt.trace.records) record.feed = rounded(record.feed, step);
  return true;
}

bool all_axes_named(Attempt& attempt) {
  return attempt.replace([&](const Record& record, const reference::Position& from) {
    std::vector<Record> made;
    if (!is_motion(record.kind)) return made;
    made.push_back(record);
    for (const Axis axis : reference::kAllAxes) {
      if (!record.axes.has(axis)) made.back().to[axis] = from[axis];
    }
    made.back().axes = reference::kEveryAxis;
    return made;
  });
}

// Whether two enclosures are of one number nothing tells.
bool surely_equal(const Number& a, const Number& b) {
  try {
    return a == b;
  } catch (const exact::Undecided&) {
    return false;
  }
}

bool only_moved_axes_named(Attempt& attempt) {
  return attempt.replace([&](const Record& record, const reference::Position& from) {
    std::vector<Record> made;
    if (!is_motion(record.kind) || record.kind == RecordKind::arc3) return made;
    made.push_back(record);
    reference::AxisSet named;
    for (const Axis axis : reference::kAllAxes) {
      const bool in_plane =
          record.kind == RecordKind::arc && axis != axes_of(record.plane).d && is_linear(axis);
      if (in_plane || (record.axes.has(axis) && !surely_equal(record.to[axis], from[axis])))
        named.add(axis);
    }
    if (named.empty()) named.add(Axis::x);
    for (const Axis axis : reference::kAllAxes) {
      if (!record.axes.has(axis)) made.back().to[axis] = from[axis];
    }
    made.back().axes = named;
    return made;
  });
}

bool no_clauses(Attempt& attempt) {
  for (Record& record : attempt.trace.records) record.clause = reference::kNoClause;
  return true;
}

bool no_end(Attempt& attempt) {
  return std::erase_if(attempt.trace.records,
                       [](const Record& record) { return record.kind == RecordKind::end; }) > 0;
}

bool end_of_some_axes(Attempt& attempt) {
  if (attempt.trace.records.empty() || attempt.trace.records.back().kind != RecordKind::end) {
    return false;
  }
  attempt.trace.records.back().axes = {Axis::x, Axis::z};
  return true;
}

// J-THR-09: where the R plane is the initial one, the block ends the thread.
bool ends_by_its_block(const reference::Item& item) {
  const auto* thread = std::get_if<reference::ThreadMilling>(&item);
  return thread != nullptr && thread->r_plane == thread->initial_plane;
}

// G50 and G92 are found by the blocks.
bool no_blocks(Attempt& attempt) {
  if (!attempt.specimen.renamings.empty()) return false;
  if (std::ranges::any_of(attempt.specimen.items, ends_by_its_block)) return false;
  attempt.tolerances.compare_blocks = false;
  for (Record& record : attempt.trace.records) record.block = 0;
  attempt.trace.end.alarm.block = 0;
  return true;
}

bool no_m(Attempt& attempt) {
  attempt.tolerances.compare_m = false;
  return std::erase_if(attempt.trace.records,
                       [](const Record& record) { return record.kind == RecordKind::m; }) > 0;
}

bool other_m(Attempt& attempt) {
  attempt.tolerances.compare_m = false;
  Record record;
  record.kind = RecordKind::m;
  record.m = 77;
  record.block = 1;
  attempt.trace.records.insert(attempt.trace.records.begin(), record);
  return true;
}

// R5: the places in its block where the M function `number` may stand, too: the numbers of
// the records that it stands before. None where its block has another one.
std::vector<std::size_t> other_places(const std::vector<Record>& records, std::size_t number) {
  const std::int32_t m = records[number].m;
  const auto is_one_of = [&](std::initializer_list<std::int32_t> numbers) {
    return std::ranges::find(numbers, m) != numbers.end();
  };
  const auto is_of_block = [&](std::size_t i) {
    return records[i].block == records[number].block && records[i].kind != RecordKind::end;
  };
  std::size_t first = number;
  while (first > 0 && is_of_block(first - 1)) --first;
  std::size_t last = number;
  while (last + 1 < records.size() && is_of_block(last + 1)) ++last;
  const auto count = [&](const auto& wanted) {
    return std::count_if(records.begin() + static_cast<std::ptrdiff_t>(first),
                         records.begin() + static_cast<std::ptrdiff_t>(last + 1), wanted);
  };
  const auto functions = count([](const Record& one) { return one.kind == RecordKind::m; });
  const auto dwells = count([](const Record& one) { return one.kind == RecordKind::dwell; });
  const auto motions = count([](const Record& one) { return is_motion(one.kind); });
  const auto cuts =
      motions - count([](const Record& one) { return one.kind == RecordKind::rapid; });
  if (functions > 1 || is_one_of({2, 17, 30})) return {};
  const bool starts = is_one_of({3, 4, 6, 7, 8});
  const bool stops = is_one_of({0, 1, 5, 9});
  std::vector<std::size_t> places;
  for (std::size_t place = first; place <= last + 1; ++place) {
    const bool is_first = place == first;
    const bool is_last = place == last + 1;
    if (place == number || place == number + 1) continue;
    if (cuts > 0 && motions > 1 && !is_first && !is_last) continue;
    if (starts && !is_first && cuts + dwells > 0) continue;
    if (stops && !is_last && cuts > 0) continue;
    places.push_back(place);
  }
  return places;
}

// Before the motions of its block, behind them, or between them.
bool m_elsewhere_in_its_block(Attempt& attempt) {
  if (!attempt.tolerances.compare_blocks)
    return false;  // the records do not say which block is its own
  std::vector<Record>& records = attempt.trace.records;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const Record& record = records[i];
    if (record.kind != RecordKind::m || record.before_cut || record.among_motions) continue;
    const std::vector<std::size_t> places = other_places(records, i);
    if (places.empty()) continue;
    const std::size_t to = attempt.chance.one_of(places);
    const auto at = [&](std::size_t number) {
      return records.begin() + static_cast<std::ptrdiff_t>(number);
    };
    if (to <= i) {
      std::rotate(at(to), at(i), at(i + 1));
    } else {
      std::rotate(at(i), at(i + 1), at(to));
    }
    return true;
  }
  return false;
}

bool other_admissible_class(Attempt& attempt) {
  const auto& classes = attempt.specimen.admissible;
  if (classes.size() < 2) return false;
  attempt.trace.end.alarm.alarm_class =
      reference::name(classes[1 + attempt.chance.below(classes.size() - 1)]);
  return true;
}

bool alarm_at_load(Attempt& attempt) {
  if (attempt.trace.end.kind != RunEnd::Kind::alarm) return false;
  attempt.profile.alarm_timing = reference::AlarmTiming::program;
  attempt.trace.records.clear();
  return true;
}

bool alarm_in_its_block_though_at_load_is_allowed(Attempt& attempt) {
  if (attempt.trace.end.kind != RunEnd::Kind::alarm) return false;
  attempt.profile.alarm_timing = reference::AlarmTiming::program;
  return true;
}

bool looser_tolerance(Attempt& attempt) {
  attempt.tolerances.granted = attempt.tolerances.tolerance * 3;
  attempt.tolerances.tolerance = attempt.tolerances.granted;
  return true;
}

}  // namespace

std::vector<Alternative> wording_alternatives() {
  return {
      {"rounded-to-the-resolution", "the nearest step of the resolution",
       rounded_to_the_resolution},
      {"rounded-ten-times-finer", "the nearest step of a finer resolution",
       rounded_ten_times_finer},
      {"as-doubles", "the nearest double", as_doubles},
      {"as-enclosures", "a number between two that are close", as_enclosures},
      {"rounded-feeds", "the nearest step of the feed resolution", rounded_feeds},
      {"all-axes-named", "axes that do not move", all_axes_named},
      {"only-moved-axes-named", "axes that move alone", only_moved_axes_named},
      {"no-clauses", "no field that is not asked for", no_clauses},
      {"no-end", "no end", no_end},
      {"end-of-some-axes", "an end of some axes", end_of_some_axes},
      {"no-blocks", "no blocks declared", no_blocks},
      {"no-m", "no M functions declared", no_m},
      {"other-m", "M functions where none are compared", other_m},
      {"m-elsewhere-in-its-block", "M functions before or after the motions of their block",
       m_elsewhere_in_its_block},
      {"other-admissible-class", "an alarm by any rule that is broken", other_admissible_class},
      {"alarm-at-load", "an alarm at load", alarm_at_load},
      {"alarm-in-its-block", "an alarm in its block, where it may come at load",
       alarm_in_its_block_though_at_load_is_allowed},
      {"looser-tolerance", "the same under a larger tolerance", looser_tolerance},
  };
}

}  // namespace gonogo::mutations
