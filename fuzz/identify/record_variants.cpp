// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mistakes that show in what comes out: undone in the subject's records, which the judge then sees.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/identify/variant.hpp"

namespace gonogo::identify {

using reference::FeedMode;

namespace {

using RecordChange = std::function<void(Record&)>;

void add_records(std::string name, RecordChange change, Variants& out) {
  add_outcome(
      std::move(name),
      [change = std::move(change)](const Observation&, KeptOutcome& outcome) {
        for (Record& record : outcome.records) change(record);
      },
      out);
}

// The axes that the centre of an arc lies on.
std::array<Axis, 2> plane_axes(Plane plane) {
  return {axes_of(plane).p, axes_of(plane).q};
}

void scale_axis(Record& record, Axis axis, const Number& factor) {
  record.to[axis] = record.to[axis] * factor;
  record.via[axis] = record.via[axis] * factor;
  if (record.kind != RecordKind::arc) return;
  const auto axes = plane_axes(record.plane);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (axes[i] == axis) record.centre[i] = record.centre[i] * factor;
  }
}

// A mirrored axis turns arcs round in the planes that it is of.
void mirror(Record& record, Axis axis) {
  scale_axis(record, axis, -1);
  const auto axes = plane_axes(record.plane);
  if (record.kind == RecordKind::arc && (axes[0] == axis || axes[1] == axis)) {
    record.rot = -record.rot;
  }
}

void add_senses(Variants& out) {
  add_records(
      "every arc turns the other way", [](Record& record) { record.rot = -record.rot; }, out);
  for (const Plane plane : {Plane::g17, Plane::g18, Plane::g19}) {
    add_records(
        fmt::format("every arc in G{} turns the other way", plane_code(plane)),
        [plane](Record& record) {
          if (record.plane == plane) record.rot = -record.rot;
        },
        out);
  }
  for (const Axis axis : reference::kAllAxes) {
    const char letter = static_cast<char>(reference::letter(axis) - 'a' + 'A');
    add_records(
        fmt::format("{} comes out with the other sign", letter),
        [axis](Record& record) { scale_axis(record, axis, -1); }, out);
    add_records(
        fmt::format("{} comes out mirrored, arcs turned round with it", letter),
        [axis](Record& record) { mirror(record, axis); }, out);
  }
}

// The point between start and end goes to the other arc of the circle: the line from it through the
// middle of the chord meets the circle there, since the two parts of that line and the halves of
// the chord have the same product.
void take_other_side(Record& arc, const Position& from) {
  Position middle;
  Position out;
  Number half;
  Number distance;
  for (const Axis axis : reference::kLinearAxes) {
    middle[axis] = (from[axis] + arc.to[axis]) / 2;
    out[axis] = arc.via[axis] - middle[axis];
    half = half + (arc.to[axis] - middle[axis]) * (arc.to[axis] - middle[axis]);
    distance = distance + out[axis] * out[axis];
  }
  if (distance.sign() == 0) return;
  for (const Axis axis : reference::kLinearAxes) {
    arc.via[axis] = middle[axis] - out[axis] * half / distance;
  }
}

void add_space_arcs(Variants& out) {
  add_outcome(
      "every CIP turns the other way",
      [](const Observation& seen, KeptOutcome& outcome) {
        Position at = seen.profile.initial.at;
        for (Record& record : outcome.records) {
          if (record.kind == RecordKind::arc3) take_other_side(record, at);
          if (is_motion(record.kind)) at = record.to;
        }
      },
      out);
}

struct Slip {
  std::string_view name;
  Number undo;  // what the subject's value is multiplied by
};

std::vector<Slip> unit_slips() {
  return {{"as inches", Number(127) / 5},
          {"as millimetres where they are inches", Number(5) / 127},
          {"as micrometres", Number(1) / 1000},
          {"1000 times too small", Number(1000)}};
}

void scale_lengths(Record& record, const Number& factor) {
  for (const Axis axis : reference::kLinearAxes) scale_axis(record, axis, factor);
}

// Whether only a rotary axis moves, whose feed is degrees.
bool is_rotary(const Record& record) {
  return !record.axes.has(Axis::x) && !record.axes.has(Axis::y) && !record.axes.has(Axis::z);
}

// A number of the records comes out divided by `undo`.
void add_scaled(std::string name, Number Record::*what, const Number& undo, Variants& out) {
  add_records(
      std::move(name), [=](Record& record) { record.*what = record.*what * undo; }, out);
}

void add_units(Variants& out) {
  for (const Slip& slip :
       {Slip{"converted", Number(5) / 127}, {"not converted", Number(127) / 5}}) {
    add_records(
        fmt::format("feeds of A or C alone come out {} from inches", slip.name),
        [slip](Record& record) {
          if (is_rotary(record)) record.feed = record.feed * slip.undo;
        },
        out);
  }
  for (const Slip& slip : unit_slips()) {
    add_records(
        fmt::format("lengths come out {}", slip.name),
        [slip](Record& record) { scale_lengths(record, slip.undo); }, out);
    add_scaled(fmt::format("feeds come out {}", slip.name), &Record::feed, slip.undo, out);
    add_scaled(fmt::format("leads come out {}", slip.name), &Record::lead, slip.undo, out);
  }
  add_records(
      "X comes out as a diameter",
      [](Record& record) { scale_axis(record, Axis::x, Number(1) / 2); }, out);
  add_records(
      "X comes out as half a radius", [](Record& record) { scale_axis(record, Axis::x, 2); }, out);
  for (const auto& [name, undo] :
       {std::pair("a second", Number(60)), std::pair("an hour", Number(1) / 60)}) {
    add_scaled(fmt::format("feeds come out in mm {}", name), &Record::feed, undo, out);
  }
  add_records(
      "mm a minute and mm a revolution are exchanged",
      [](Record& record) {
        record.feed_mode = record.feed_mode == FeedMode::per_minute ? FeedMode::per_revolution
                                                                    : FeedMode::per_minute;
      },
      out);
  for (const auto& [name, undo] :
       {std::pair("milliseconds", Number(1) / 1000),
        std::pair("1000 times too short", Number(1000)), std::pair("half as long", Number(2))}) {
    add_scaled(fmt::format("dwells come out {}", name), &Record::seconds, undo, out);
  }
}

// The line that a subject means which does not count blank lines.
std::uint64_t with_blank_lines(const ProgramText& program, std::uint64_t block) {
  std::uint64_t counted = 0;
  for (std::size_t i = 0; i < program.blocks.size(); ++i) {
    if (program.blocks[i].words.empty()) continue;
    if (++counted == block) return i + 1;
  }
  return block;
}

// The line that a subject means which counts CR and LF each as the end of one.
std::uint64_t with_pairs_as_two(const ProgramText& program, std::uint64_t block) {
  std::uint64_t counted = 0;
  for (std::size_t i = 0; i < program.blocks.size(); ++i) {
    counted += program.blocks[i].end == "\r\n" ? 2U : 1U;
    if (counted >= block) return i + 1;
  }
  return block;
}

void add_block_numbers(Variants& out) {
  const auto renumber =
      [](const std::function<std::uint64_t(const ProgramText&, std::uint64_t)>& to) {
        return [to](const Observation& seen, KeptOutcome& outcome) {
          const ProgramText program(seen.profile, seen.program);
          for (Record& record : outcome.records) record.block = to(program, record.block);
          outcome.end.alarm.block = to(program, outcome.end.alarm.block);
        };
      };
  add_outcome("blank lines are not counted", renumber(with_blank_lines), out);
  add_outcome("CR LF counts as two lines", renumber(with_pairs_as_two), out);
  add_outcome(
      "alarms name the block after",
      [](const Observation&, KeptOutcome& outcome) {
        if (outcome.end.alarm.block > 0) --outcome.end.alarm.block;
      },
      out);
  add_outcome(
      "alarms name the block before",
      [](const Observation&, KeptOutcome& outcome) {
        if (outcome.end.alarm.block > 0) ++outcome.end.alarm.block;
      },
      out);
}

// Gives one motion of each run of a cycle another kind: the place counts from the first motion, or
// from the last one where it is negative.
void change_kind(const Observation& seen, KeptOutcome& outcome, const Motions& motions, int place,
                 RecordKind from, RecordKind to) {
  const ProgramText program(seen.profile, seen.program);
  std::vector<Record>& records = outcome.records;
  for (std::size_t begin = 0; begin < records.size();) {
    std::size_t end = begin;
    const std::uint64_t block = records[begin].block;
    while (end < records.size() && records[end].block == block &&
           reference::is_motion(records[end].kind)) {
      ++end;
    }
    const auto count = static_cast<int>(end - begin);
    const int at = place >= 0 ? place : count + place;
    const bool ours = is_of(program, block, motions) && at >= 0 && at < count;
    if (ours && records[begin + static_cast<std::size_t>(at)].kind == from) {
      Record& record = records[begin + static_cast<std::size_t>(at)];
      record.kind = to;
      // The feed is that of the motions beside it.
      for (std::size_t i = begin; i < end; ++i) {
        if (records[i].kind != RecordKind::feed || i == begin + static_cast<std::size_t>(at))
          continue;
        record.feed = records[i].feed;
        record.feed_mode = records[i].feed_mode;
      }
    }
    begin = std::max(end, begin + 1);
  }
}

void add_kinds(const Motions& motions, Variants& out) {
  constexpr RecordKind kKinds[] = {RecordKind::rapid, RecordKind::feed, RecordKind::thread};
  for (const int place : {0, 1, 2, 3, -1, -2}) {
    for (const RecordKind got : kKinds) {
      for (const RecordKind want : kKinds) {
        if (got == want || want == RecordKind::thread) continue;
        const std::string which = place >= 0    ? fmt::format("motion {}", place + 1)
                                  : place == -1 ? std::string("the last motion")
                                                : std::string("the last motion but one");
        add_outcome(
            fmt::format("{} of {} is a {}, not a {}", which, names_of(motions), name(got),
                        name(want)),
            [=](const Observation& seen, KeptOutcome& outcome) {
              change_kind(seen, outcome, motions, place, got, want);
            },
            out);
      }
    }
  }
}

}  // namespace

void add_record_variants(const Observation& departure, Variants& out) {
  add_senses(out);
  const ProgramText departing(departure.profile, departure.program);
  if (departing.table->find(Kind::circle) != nullptr) add_space_arcs(out);
  add_units(out);
  add_block_numbers(out);
  for (const Motions& motions : motions_concerned(departure)) {
    add_kinds(motions, out);
    add_outcome(
        fmt::format("every arc of {} turns the other way", names_of(motions)),
        [motions](const Observation& seen, KeptOutcome& outcome) {
          const ProgramText program(seen.profile, seen.program);
          for (Record& record : outcome.records) {
            if (is_of(program, record.block, motions)) record.rot = -record.rot;
          }
        },
        out);
  }
}

}  // namespace gonogo::identify
