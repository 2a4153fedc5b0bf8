// SPDX-License-Identifier: GPL-3.0-or-later
#include "relations/trace.hpp"

#include <algorithm>

#include "oracle/judge/step_text.hpp"

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

bool equal(const Record& want, const Record& got, const Number& tolerance) {
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
         is_near(want.centre[1], got.centre[1], tolerance) && is_near(want.feed, got.feed, exact) &&
         is_near(want.lead, got.lead, exact) && is_near(want.start, got.start, exact) &&
         is_near(want.seconds, got.seconds, exact);
}

// The records that the other program is asked for: of a beginning, those of its lines.
std::vector<Record> asked_for(const Trace& first, const Related& related) {
  std::vector<Record> records;
  for (const Record& record : first.records) {
    const bool is_end = record.kind == RecordKind::end;
    if (related.is_beginning && (is_end || line_of(record.block, related) == 0)) continue;
    records.push_back(moved(record, related));
  }
  return records;
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
                                           const Related& related, const Number& tolerance) {
  const std::vector<Record> want = asked_for(first, related);
  std::vector<Record> got = other.records;
  if (related.is_beginning) {
    std::erase_if(got, [](const Record& record) { return record.kind == RecordKind::end; });
  }
  // Of the line of a record: where it stands in the first program.
  auto first_line = [&](std::uint64_t line) -> std::uint64_t {
    const auto place = std::ranges::find(related.lines, line);
    return place == related.lines.end() || line == 0
               ? 0
               : static_cast<std::uint64_t>(place - related.lines.begin()) + 1;
  };
  const std::size_t count = std::max(want.size(), got.size());
  for (std::size_t i = 0; i < count; ++i) {
    const bool both = i < want.size() && i < got.size();
    if (both && equal(want[i], got[i], tolerance)) continue;
    const Record& one = i < want.size() ? want[i] : got[i];
    return Difference{i + 1, first_line(one.block), text_at(want, i), text_at(got, i)};
  }
  const std::uint64_t alarm_line = line_of(first.end.alarm.block, related);
  const bool knows_line = first.end.alarm.block != 0;
  std::string asked = alarm_of(first, alarm_line);
  if (related.is_beginning && knows_line && alarm_line == 0) asked.clear();
  const std::string came = alarm_of(other, other.end.alarm.block);
  if (asked == came) return std::nullopt;
  return Difference{count + 1, knows_line ? first.end.alarm.block : 0, asked, came};
}

}  // namespace gonogo::relations
