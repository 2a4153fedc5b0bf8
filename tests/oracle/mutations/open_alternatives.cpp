// SPDX-License-Identifier: GPL-3.0-or-later
//
// Other paths through the parts that a manual leaves open.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "alternative.hpp"
#include "open_parts.hpp"
#include "reference/gsk988ta/pocket_paths.hpp"
#include "reference/sinumerik/lcyc75.hpp"

namespace gonogo::mutations {
namespace {

using reference::Axis;
using reference::PlaneAxes;
using reference::Position;
using std::numbers::pi;

// The records of one open part.
struct Part {
  std::size_t begin = 0;
  std::size_t end = 0;
  const reference::Item* item = nullptr;
};

std::optional<Part> any_part(Attempt& attempt, PartKind kind) {
  const Specimen& specimen = attempt.specimen;
  std::vector<Part> parts;
  for (std::size_t i = 0; i < specimen.part.size(); ++i) {
    if (specimen.part[i] != kind) continue;
    const std::size_t number = specimen.part_number[i];
    if (parts.empty() || parts.back().item != &specimen.items[number]) {
      parts.push_back({i, i, &specimen.items[number]});
    }
    parts.back().end = i + 1;
  }
  if (parts.empty()) return std::nullopt;
  return parts[attempt.chance.below(parts.size())];
}

void put_in_place(Attempt& attempt, const Part& part, const std::vector<Record>& records) {
  auto& all = attempt.trace.records;
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(part.begin),
            all.begin() + static_cast<std::ptrdiff_t>(part.end));
  all.insert(all.begin() + static_cast<std::ptrdiff_t>(part.begin), records.begin(), records.end());
}

// A path that the reading names is right where any is.
bool path_of_reading(Attempt& attempt, std::string_view name, std::string_view value) {
  const reference::Reading* reading = reference::find_reading(name);
  if (reading == nullptr || attempt.profile.readings.get(reading->key) != "any") return false;
  if (attempt.specimen.right.end.kind != oracle::RunEnd::Kind::ok) return false;
  reference::Profile named = attempt.profile;
  if (set_reading(named, name, value)) return false;
  const auto records = shown_under(named, attempt.specimen.program);
  if (!records) return false;
  attempt.trace.records = *records;
  return true;
}

bool semicircles(Attempt& attempt) {
  return any_part(attempt, PartKind::level) &&
         path_of_reading(attempt, "gsk.pocket.path", "semicircles");
}

bool concentric(Attempt& attempt) {
  return any_part(attempt, PartKind::level) &&
         path_of_reading(attempt, "gsk.pocket.path", "concentric");
}

// Whether a run-out leaves the part where J says so (J-THR-06). With K up to 30 degrees one of
// twice the depth does.
bool leads_out(const reference::ThreadMilling& thread) {
  const Number& length = thread.runout_length;
  for (Number pass = 1; pass <= thread.passes(); pass += 1) {
    const Number depth = thread.depth_of_pass(pass);
    if (depth > length) return true;
    if (depth * 2 > length || thread.runout_angle > Number(30)) return false;
  }
  return true;
}

// Where no run-out of the kind leads into the thread again: J and K small, K away from it.
bool is_plain_run_out(Attempt& attempt) {
  return std::ranges::all_of(attempt.specimen.items, [](const reference::Item& item) {
    const auto* thread = std::get_if<reference::ThreadMilling>(&item);
    if (thread == nullptr) return true;
    const bool has_room = thread->external || thread->runout_length * 2 < thread->start_radius;
    return has_room && thread->runout_angle <= Number(60) && leads_out(*thread);
  });
}

bool polar_run_out(Attempt& attempt) {
  return any_part(attempt, PartKind::thread) && is_plain_run_out(attempt) &&
         path_of_reading(attempt, "gsk.thread.runout", "polar");
}

bool radial_run_out(Attempt& attempt) {
  return any_part(attempt, PartKind::thread) && is_plain_run_out(attempt) &&
         path_of_reading(attempt, "gsk.thread.runout", "radial");
}

Position turned(Position at, const PlaneAxes& axes, const std::array<Number, 2>& centre,
                double angle) {
  const double p = value_of(at[axes.p] - centre[0]);
  const double q = value_of(at[axes.q] - centre[1]);
  at[axes.p] = centre[0] + number_near(p * std::cos(angle) - q * std::sin(angle));
  at[axes.q] = centre[1] + number_near(p * std::sin(angle) + q * std::cos(angle));
  return at;
}

// A motion turned about an axis.
Record turned(Record record, const Position& to, const PlaneAxes& axes,
              const std::array<Number, 2>& centre, double angle) {
  record.to = turned(to, axes, centre, angle);
  record.axes.add(axes.p);
  record.axes.add(axes.q);
  if (record.kind == RecordKind::arc) {
    Position middle;
    middle[axes.p] = record.centre[0];
    middle[axes.q] = record.centre[1];
    middle = turned(middle, axes, centre, angle);
    record.centre = {middle[axes.p], middle[axes.q]};
  }
  return record;
}

double any_angle(Attempt& attempt) {
  return static_cast<double>(attempt.chance.below(360)) * pi / 180;
}

// The records of a level or a helical pocket, by any angle about its centre.
template <typename Item>
std::vector<Record> turned_part(Attempt& attempt, const Part& part, const Item& item) {
  const double angle = any_angle(attempt);
  std::vector<Record> records;
  for (std::size_t i = part.begin; i < part.end; ++i) {
    records.push_back(turned(attempt.specimen.right.records[i], attempt.specimen.after[i],
                             axes_of(item.plane), item.centre, angle));
  }
  return records;
}

// The finishing circle ends where it begins: the level does not end at the centre.
bool level_from_another_side(Attempt& attempt) {
  const auto part = any_part(attempt, PartKind::level);
  if (!part) return false;
  const auto& level = std::get<reference::PocketLevel>(*part->item);
  put_in_place(attempt, *part, turned_part(attempt, *part, level));
  return true;
}

// With a smaller step than L, which clears as well.
bool level_with_a_smaller_step(Attempt& attempt) {
  const auto part = any_part(attempt, PartKind::level);
  if (!part) return false;
  reference::PocketLevel level = std::get<reference::PocketLevel>(*part->item);
  const Number reach = level.pocket_radius - level.tool_radius;
  if (reach <= attempt.tolerances.tolerance * 64) return false;
  level.step = level.step * Number(3) / 4;
  if ((reach / level.step).ceil() > Number(100)) return false;
  std::vector<Record> records;
  auto path = attempt.chance.once_in(2) ? reference::gsk988ta::concentric_circles(level)
                                        : reference::gsk988ta::semicircles(level);
  while (const Record* record = path.next()) records.push_back(*record);
  put_in_place(attempt, *part, records);
  return true;
}

// A motion of a level to a place on the line through its centre along p; an arc is about it.
Record level_motion(const reference::PocketLevel& level, RecordKind kind, const Number& to) {
  const PlaneAxes axes = axes_of(level.plane);
  Record record;
  record.kind = kind;
  record.block = level.block;
  record.plane = level.plane;
  record.axes = {axes.p, axes.q};
  record.to[axes.p] = level.centre[0] + to;
  record.to[axes.q] = level.centre[1];
  record.feed = level.feed;
  record.feed_mode = level.feed_mode;
  if (kind == RecordKind::arc) {
    record.centre = level.centre;
    record.rot = level.sense;
  }
  return record;
}

// How many rings a step apart reach the border; nothing where that is too small or takes too many.
std::optional<Number> rings_of(const Attempt& attempt, const reference::PocketLevel& level) {
  const Number reach = level.pocket_radius - level.tool_radius;
  const Number rings = (reach / level.step).ceil();
  if (reach <= attempt.tolerances.tolerance * 64 || rings > Number(100)) return std::nullopt;
  return rings;
}

// Half rings on one side, each after a straight way back across the middle; then on the other.
bool level_one_way(Attempt& attempt) {
  const auto part = any_part(attempt, PartKind::level);
  if (!part) return false;
  const auto& level = std::get<reference::PocketLevel>(*part->item);
  const auto rings = rings_of(attempt, level);
  if (!rings) return false;
  std::vector<Record> records;
  for (const Number& side : {Number(1), Number(-1)}) {
    for (Number k = 1; k <= *rings; k += 1) {
      const Number at = side * min(k * level.step, level.pocket_radius - level.tool_radius);
      records.push_back(level_motion(level, RecordKind::feed, at));
      records.push_back(level_motion(level, RecordKind::arc, -at));
    }
  }
  put_in_place(attempt, *part, records);
  return true;
}

// From beside the centre outwards in one arc whose radius grows by no more than the step a turn.
bool level_as_spiral(Attempt& attempt) {
  const auto part = any_part(attempt, PartKind::level);
  if (!part) return false;
  const auto& level = std::get<reference::PocketLevel>(*part->item);
  const auto rings = rings_of(attempt, level);
  if (!rings) return false;
  const Number reach = level.pocket_radius - level.tool_radius;
  std::vector<Record> records;
  records.push_back(level_motion(level, RecordKind::feed, min(level.step, reach) / 4));
  records.push_back(level_motion(level, RecordKind::arc, reach));
  records.back().rot *= static_cast<std::int32_t>(rings->to_int64().value_or(1));
  records.push_back(level_motion(level, RecordKind::arc, reach));
  put_in_place(attempt, *part, records);
  return true;
}

bool helix_from_another_side(Attempt& attempt) {
  const auto part = any_part(attempt, PartKind::helix_pocket);
  if (!part) return false;
  const auto& pocket = std::get<reference::HelixPocket>(*part->item);
  std::vector<Record> records = turned_part(attempt, *part, pocket);
  // It ends at the centre itself.
  records.back().to = attempt.specimen.after[part->end - 1];
  put_in_place(attempt, *part, records);
  return true;
}

// LCYC75 with smaller infeeds than R121, where any levels are right.
bool smaller_infeeds(Attempt& attempt) {
  const auto part = any_part(attempt, PartKind::pocket_milling);
  if (!part) return false;
  reference::PocketMilling pocket = std::get<reference::PocketMilling>(*part->item);
  if (pocket.levels != reference::Levels::open || pocket.finishing) return false;
  pocket.infeed = pocket.infeed * Number(2) / 3;
  std::vector<Record> records;
  auto path = reference::sinumerik::contour_parallel(pocket);
  while (const reference::Item* item = path.next()) records.push_back(std::get<Record>(*item));
  if (records.size() > 300) return false;
  put_in_place(attempt, *part, records);
  return true;
}

// The passes of a thread from another angle: arc, infeed, helix and run-out turned about the axis;
// then up, and away along p alone.
class TurnedThread {
 public:
  TurnedThread(Attempt& attempt, const Part& part)
      : attempt_(attempt),
        part_(part),
        thread_(std::get<reference::ThreadMilling>(*part.item)),
        axes_(axes_of(thread_.plane)),
        angle_(any_angle(attempt)) {}

  // False where the way along p would not lead out.
  bool make() {
    here_ = attempt_.specimen.before[part_.begin];
    for (std::size_t i = part_.begin; i < part_.end; ++i) {
      const Record& record = attempt_.specimen.right.records[i];
      if (record.kind != RecordKind::rapid) {
        if (!cut(record, i)) return false;
      } else if (record.axes.has(axes_.d)) {
        Record up = record;
        here_[axes_.d] = attempt_.specimen.after[i][axes_.d];
        up.to = here_;
        records_.push_back(up);
      } else {
        away(record);
      }
    }
    put_in_place(attempt_, part_, records_);
    return true;
  }

 private:
  bool cut(const Record& record, std::size_t i) {
    Record piece = turned(record, attempt_.specimen.after[i], axes_, thread_.centre, angle_);
    const bool is_entry = record.kind == RecordKind::arc && !record.axes.has(axes_.d) &&
                          reference::clause_name(record.clause) == "GSK-G114-06";
    if (is_entry) {
      // A semicircle on the chord, from wherever the tool is.
      piece.centre = {(here_[axes_.p] + piece.to[axes_.p]) / 2,
                      (here_[axes_.q] + piece.to[axes_.q]) / 2};
      if (apart(place_of(here_), place_of(piece.to)) < 0.05) return false;
    }
    // Without an arc of its own a pass would begin by a chord.
    const bool is_infeed =
        record.kind == RecordKind::feed && reference::clause_name(record.clause) == "GSK-G114-06";
    if (is_infeed && (records_.empty() || records_.back().kind != RecordKind::arc)) {
      Record arc = record;
      arc.kind = RecordKind::arc;
      arc.plane = thread_.plane;
      arc.rot = thread_.sense;
      Position start = attempt_.specimen.before[i];
      start[axes_.p] = thread_.centre[0] + thread_.start_radius;
      start[axes_.q] = thread_.centre[1];
      arc = turned(arc, start, axes_, thread_.centre, angle_);
      arc.centre = {(here_[axes_.p] + arc.to[axes_.p]) / 2, (here_[axes_.q] + arc.to[axes_.q]) / 2};
      if (apart(place_of(here_), place_of(arc.to)) < 0.05) return false;
      here_ = arc.to;
      records_.push_back(arc);
    }
    for (const Axis axis : reference::kAllAxes) {
      if (axis == axes_.p || axis == axes_.q || piece.axes.has(axis)) continue;
      piece.to[axis] = here_[axis];
    }
    here_ = piece.to;
    records_.push_back(piece);
    return true;
  }

  // Along p to where the polar radius is that of the safe position; of a bore, to the axis along p.
  void away(const Record& record) {
    Record out = record;
    const double p = value_of(here_[axes_.p] - thread_.centre[0]);
    const double safe = value_of(thread_.start_radius + thread_.runout_length);
    out.to = here_;
    out.to[axes_.p] = thread_.external ? thread_.centre[0] + number_near(p < 0 ? -safe : safe)
                                       : thread_.centre[0];
    here_ = out.to;
    records_.push_back(out);
  }

  Attempt& attempt_;
  const Part& part_;
  const reference::ThreadMilling& thread_;
  const PlaneAxes axes_;
  const double angle_;
  Position here_;
  std::vector<Record> records_;
};

bool thread_from_another_angle(Attempt& attempt) {
  const auto part = any_part(attempt, PartKind::thread);
  if (!part || !is_plain_run_out(attempt)) return false;
  const auto& thread = std::get<reference::ThreadMilling>(*part->item);
  if (thread.arc_path || thread.runout != reference::ThreadRunOut::open) return false;
  // What follows in other blocks starts where the thread ends: of the last block alone.
  const auto& records = attempt.specimen.right.records;
  if (records.back().kind != RecordKind::end) return false;
  for (std::size_t i = part->end; i < records.size(); ++i) {
    if (is_motion(records[i].kind) && records[i].block != thread.block) return false;
  }
  // A bore is left to a place beside its axis: no farther from it than the safe radius is deep.
  if (!thread.external) return false;
  if (!TurnedThread(attempt, *part).make()) return false;
  attempt.trace.records.pop_back();  // the end is elsewhere, and may be left out
  return true;
}

}  // namespace

std::vector<Alternative> open_alternatives() {
  return {
      {"semicircles", "GSK-G110-09: semicircles", semicircles},
      {"concentric", "GSK-G110-09: concentric circles", concentric},
      {"level-from-another-side", "GSK-G110-09: the same from another side",
       level_from_another_side},
      {"level-with-a-smaller-step", "GSK-G110-09: a smaller step than L",
       level_with_a_smaller_step},
      {"level-one-way", "GSK-G110-09: half rings, all one way", level_one_way},
      {"level-as-spiral", "GSK-G110-09: a spiral", level_as_spiral},
      {"helix-from-another-side", "GSK-G112-04: the side of the entry", helix_from_another_side},
      {"polar-run-out", "GSK-G114-11: the polar run-out", polar_run_out},
      {"radial-run-out", "GSK-G114-11: the radial run-out", radial_run_out},
      {"thread-from-another-angle", "GSK-G114-10: the angle of the start",
       thread_from_another_angle},
      {"smaller-infeeds", "SIE-LC75-06: any levels", smaller_infeeds},
  };
}

}  // namespace gonogo::mutations
