// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "operator.hpp"

namespace gonogo::mutations {

using reference::Axis;

std::optional<std::size_t> Edit::any(const Wanted& wanted) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < specimen.right.records.size(); ++i) {
    if (wanted(i)) found.push_back(i);
  }
  if (found.empty()) return std::nullopt;
  return found[chance.below(found.size())];
}

std::optional<std::size_t> Edit::any_motion() {
  return any([&](std::size_t i) { return is_motion(right(i).kind); });
}

std::optional<std::size_t> Edit::any_of_kind(RecordKind kind) {
  return any([&](std::size_t i) { return right(i).kind == kind; });
}

double Edit::size_of(std::size_t number) const {
  const double way = apart(place_of(specimen.before[number]), place_of(specimen.after[number]));
  const Record& record = right(number);
  if (record.kind != RecordKind::arc) return way;
  const reference::PlaneAxes axes = axes_of(record.plane);
  return std::max(way, plane_radius(axes, place_of(specimen.before[number]),
                                    {value_of(record.centre[0]), value_of(record.centre[1])}));
}

bool Edit::lead_next_to_its_end(std::size_t number) {
  for (std::size_t i = number + 1; i < trace.records.size(); ++i) {
    Record& record = trace.records[i];
    if (!is_motion(record.kind)) continue;
    record.axes = reference::kEveryAxis;
    record.to = specimen.after[i];
    return true;
  }
  return false;
}

Record Edit::motion_to(RecordKind kind, std::uint64_t block, const reference::Position& to) const {
  Record record;
  record.kind = kind;
  record.block = block;
  record.axes = reference::kEveryAxis;
  record.to = to;
  return record;
}

Record Edit::cut_to(const Record& words, std::uint64_t block, const reference::Position& to) const {
  Record cut = motion_to(RecordKind::feed, block, to);
  cut.feed = words.feed;
  cut.feed_mode = words.feed_mode;
  return cut;
}

std::optional<Record> Edit::cutting_words(std::size_t near) const {
  const std::vector<Record>& records = specimen.right.records;
  for (std::size_t away = 0; away < records.size(); ++away) {
    for (const std::size_t i : {near - std::min(near, away), near + away}) {
      if (i < records.size() &&
          (records[i].kind == RecordKind::feed || records[i].kind == RecordKind::arc)) {
        return records[i];
      }
    }
  }
  return std::nullopt;
}

void Edit::insert(std::size_t before, Record record) {
  trace.records.insert(trace.records.begin() + static_cast<std::ptrdiff_t>(before),
                       std::move(record));
}

void Edit::erase(std::size_t number) {
  trace.records.erase(trace.records.begin() + static_cast<std::ptrdiff_t>(number));
}

void Edit::replace(std::size_t begin, std::size_t end, const std::vector<Record>& records) {
  const auto first = trace.records.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = trace.records.begin() + static_cast<std::ptrdiff_t>(end);
  const auto place = trace.records.erase(first, last);
  trace.records.insert(place, records.begin(), records.end());
}

Number Edit::times_tolerance(double factor) const {
  constexpr double kHundredths = 100;
  return specimen.tolerances.tolerance * Number(static_cast<std::int64_t>(factor * kHundredths)) /
         100;
}

Number Edit::off() {
  static const std::array<double, 4> kTolerances = {1.5, 2, 3, 10};
  static const std::array<std::int64_t, 5> kMillionths = {50'000, 100'000, 1'000'000, 3'700'000,
                                                          30'000'000};
  const Number length = chance.once_in(2) ? times_tolerance(chance.one_of(kTolerances))
                                          : Number::millionths(chance.one_of(kMillionths));
  return chance.once_in(2) ? length : -length;
}

Apply to_any_motion(Change change) {
  return [change = std::move(change)](Edit& edit) {
    const auto number = edit.any_motion();
    if (number) change(edit, *number);
    return number.has_value();
  };
}

Apply to_any(RecordKind kind, Change change) {
  return [kind, change = std::move(change)](Edit& edit) {
    const auto number = edit.any_of_kind(kind);
    if (number) change(edit, *number);
    return number.has_value();
  };
}

std::vector<Operator> wrong_operators() {
  std::vector<Operator> all;
  for (auto family :
       {shifting_operators, sequence_operators, word_operators, turning_operators, event_operators,
        m_operators, cycle_operators, pocket_operators, thread_operators}) {
    std::ranges::move(family(), std::back_inserter(all));
  }
  return all;
}

}  // namespace gonogo::mutations
