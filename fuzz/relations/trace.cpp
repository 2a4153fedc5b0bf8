// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/relations/trace.hpp"

#include <algorithm>

#include "oracle/steps/step_text.hpp"

namespace gonogo::relations {
namespace {

using reference::Axis;
using reference::Record;
using reference::RecordKind;

// The line of the other program; 0: not known, or not there. A line that the first program has not
// stays what it is.
std::uint64_t line_of(std::uint64_t block, const Related& related) {
  return block == 0 || block > related.lines.size() ? block : related.lines[block - 1];
}

// The line that a line of the other program counts as.
std::uint64_t counted(std::uint64_t block, const Related& related) {
  return block == 0 || block > related.counts_as.size() ? block : related.counts_as[block - 1];
}

reference::AxisSet turned_axes(reference::AxisSet axes, std::size_t turns) {
  reference::AxisSet others;
  for (const Axis axis : reference::kAllAxes) {
    const std::size_t to = is_linear(axis) ? (index(axis) + turns) % 3 : index(axis);
    if (axes.has(axis)) others.add(static_cast<Axis>(to));
  }
  return others;
}

// A plane's axes go along with it: what is said along p and q stays.
void turn(Record& record, std::size_t turns) {
  if (turns == 0) return;
  record.axes = turned_axes(record.axes, turns);
  record.via_axes = turned_axes(record.via_axes, turns);
  record.to = turned(record.to, turns);
  record.via = turned(record.via, turns);
  record.plane = turned(record.plane, turns);
}

void rescale(Record& record, const Number& scale) {
  for (const Axis axis : reference::kLinearAxes) {
    record.to[axis] = record.to[axis] * scale;
    record.via[axis] = record.via[axis] * scale;
  }
  for (Number& centre : record.centre) centre = centre * scale;
  record.feed = record.feed * scale;
  record.lead = record.lead * scale;
}

void mirror(Record& record, const Related& related) {
  for (std::size_t i = 0; i < reference::kAxes; ++i) {
    if (!related.mirrored[i]) continue;
    record.to.at[i] = -record.to.at[i];
    record.via.at[i] = -record.via.at[i];
    if (record.kind != RecordKind::arc) continue;
    const reference::PlaneAxes axes = axes_of(record.plane);
    if (i == index(axes.d)) continue;
    record.rot = -record.rot;
    Number& centre = record.centre[i == index(axes.p) ? 0 : 1];
    centre = -centre;
  }
}

// The record that the other program has to give for this one.
Record moved(Record record, const Related& related) {
  record.block = line_of(record.block, related);
  turn(record, related.turned);
  if (related.scale != 1) rescale(record, related.scale);
  mirror(record, related);
  for (const Axis axis : reference::kAllAxes) {
    const std::size_t i = index(axis);
    record.to.at[i] += related.shift[i];
    record.via.at[i] += related.shift[i];
  }
  if (record.kind == RecordKind::arc) {
    const reference::PlaneAxes axes = axes_of(record.plane);
    record.centre[0] += related.shift[index(axes.p)];
    record.centre[1] += related.shift[index(axes.q)];
  }
  return record;
}

bool equal_axes(const reference::Position& a, const reference::Position& b, reference::AxisSet axes,
                const Number& tolerance) {
  return std::ranges::all_of(reference::kAllAxes, [&](Axis axis) {
    return !axes.has(axis) || is_near(a[axis], b[axis], tolerance);
  });
}

// Feeds, and leads, which are feeds too.
bool equal_feeds(const Record& want, const Record& got, Feeds feeds, const Number& tolerance) {
  if (feeds == Feeds::any) return true;
  const Number most = feeds == Feeds::near ? tolerance : Number(0);
  return is_near(want.feed, got.feed, most) && is_near(want.lead, got.lead, most);
}

bool equal(const Record& want, const Record& got, Feeds feeds, const Number& tolerance) {
  const Number exact = 0;
  // An end belongs to no line.
  const bool same_block = want.block == got.block || want.kind == RecordKind::end;
  const bool same = want.kind == got.kind && want.axes == got.axes && same_block &&
                    want.rot == got.rot && want.m == got.m && want.via_axes == got.via_axes &&
                    want.feed_mode == got.feed_mode &&
                    (want.kind != RecordKind::arc || want.plane == got.plane);
  return same && equal_axes(want.to, got.to, want.axes, tolerance) &&
         equal_axes(want.via, got.via, want.via_axes, tolerance) &&
         is_near(want.centre[0], got.centre[0], tolerance) &&
         is_near(want.centre[1], got.centre[1], tolerance) &&
         equal_feeds(want, got, feeds, tolerance) && is_near(want.start, got.start, exact) &&
         is_near(want.seconds, got.seconds, exact);
}

bool is_halved(std::uint64_t line, const Related& related) {
  return std::ranges::find(related.halved, line) != related.halved.end();
}

// The first half of a straight motion that begins at `from`.
Record first_half(Record record, const reference::Position& from) {
  for (const Axis axis : reference::kAllAxes) {
    if (record.axes.has(axis)) record.to[axis] = (from[axis] + record.to[axis]) / 2;
  }
  return record;
}

// The records that the other program is asked for: of a beginning, those of its lines; of a line
// in halves, both.
std::vector<Record> asked_for(const Trace& first, const Related& related) {
  std::vector<Record> records;
  reference::Position at = related.program.profile.initial.at;
  for (const Record& record : first.records) {
    const bool is_end = record.kind == RecordKind::end;
    if (related.is_beginning && (is_end || line_of(record.block, related) == 0)) continue;
    if (is_halved(record.block, related)) records.push_back(moved(first_half(record, at), related));
    records.push_back(moved(record, related));
    for (const Axis axis : reference::kAllAxes) {
      if (record.axes.has(axis)) at[axis] = record.to[axis];
    }
  }
  return records;
}

// Whether each line that is halved is one straight motion, as it is to be: of what is more than
// that, or nothing, no halves are known.
bool has_halves(const Trace& first, const Related& related) {
  return std::ranges::all_of(related.halved, [&](std::uint64_t line) {
    const auto is_there = [&](const Record& record) { return record.block == line; };
    const auto found = std::ranges::find_if(first.records, is_there);
    const bool has_none = found == first.records.end() && first.end.alarm.block != line;
    if (has_none) return true;
    return std::ranges::count_if(first.records, is_there) == 1 &&
           (found->kind == RecordKind::rapid || found->kind == RecordKind::feed);
  });
}

std::string alarm_of(const Trace& trace, std::uint64_t block) {
  if (trace.end.kind != oracle::RunEnd::Kind::alarm) return {};
  oracle::SubjectAlarm alarm = trace.end.alarm;
  alarm.block = block;
  alarm.word = {};
  return oracle::alarm_text(alarm);
}

std::string text_at(const std::vector<Record>& records, std::size_t i) {
  return i < records.size() ? oracle::record_text(records[i]) : std::string();
}

}  // namespace

bool is_near(const Number& a, const Number& b, const Number& tolerance) {
  try {
    return tolerance.sign() == 0 ? a == b : abs(a - b) <= tolerance;
  } catch (const exact::Undecided&) {
    return true;
  }
}

std::optional<Difference> first_difference(const Trace& first, const Trace& other,
                                           const Related& related, const Number& least) {
  // What the first trace is off by is larger in the other.
  const Number tolerance = related.scale == 1 ? least : least * (1 + related.scale);
  if (!has_halves(first, related)) return std::nullopt;
  const std::vector<Record> want = asked_for(first, related);
  std::vector<Record> got = other.records;
  for (Record& record : got) record.block = counted(record.block, related);
  if (related.is_beginning) {
    std::erase_if(got, [](const Record& record) { return record.kind == RecordKind::end; });
  }
  // For the line of a record: where it stands in the first program.
  auto first_line = [&](std::uint64_t line) -> std::uint64_t {
    const auto place = std::ranges::find(related.lines, line);
    return place == related.lines.end() || line == 0
               ? 0
               : static_cast<std::uint64_t>(place - related.lines.begin()) + 1;
  };
  const std::size_t count = std::max(want.size(), got.size());
  for (std::size_t i = 0; i < count; ++i) {
    const bool both = i < want.size() && i < got.size();
    if (both && equal(want[i], got[i], related.feeds, tolerance)) continue;
    const Record& one = i < want.size() ? want[i] : got[i];
    return Difference{i + 1, first_line(one.block), text_at(want, i), text_at(got, i)};
  }
  const std::uint64_t alarm_line = line_of(first.end.alarm.block, related);
  const bool knows_line = first.end.alarm.block != 0;
  std::string asked = alarm_of(first, alarm_line);
  if (related.is_beginning && knows_line && alarm_line == 0) asked.clear();
  const std::string came = alarm_of(other, counted(other.end.alarm.block, related));
  if (asked == came) return std::nullopt;
  return Difference{count + 1, knows_line ? first.end.alarm.block : 0, asked, came};
}

}  // namespace gonogo::relations
