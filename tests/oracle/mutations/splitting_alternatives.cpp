// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same path in more motions, or in motions of another form.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "alternative.hpp"

namespace gonogo::mutations {
namespace {

using reference::Axis;
using reference::Position;

constexpr std::size_t kFew = 60;  // records: of longer traces a hundred pieces each are too many

Position end_of(const Record& record, const Position& from) {
  Position to = from;
  for (const Axis axis : reference::kAllAxes) {
    if (record.axes.has(axis)) to[axis] = record.to[axis];
  }
  return to;
}

Position between(const Position& from, const Position& to, std::int64_t part, std::int64_t of) {
  Position at = to;
  for (const Axis axis : reference::kAllAxes) {
    if (from[axis] == to[axis]) continue;
    at[axis] = from[axis] + (to[axis] - from[axis]) * Number(part) / Number(of);
  }
  return at;
}

bool is_line(RecordKind kind) {
  return kind == RecordKind::feed || kind == RecordKind::thread;
}

std::int64_t pieces(Attempt& attempt) {
  static const std::array<std::int64_t, 5> kPieces = {2, 3, 7, 20, 100};
  const std::size_t last = attempt.specimen.right.records.size() > kFew ? 3 : kPieces.size();
  return kPieces[attempt.chance.below(last)];
}

bool is_irrational(const Position& at) {
  return std::ranges::any_of(reference::kAllAxes,
                             [&](const Axis axis) { return !at[axis].is_rational(); });
}

// In equal pieces; none where nothing tells them from the motion's ends, for no subject has such
// numbers, and where many of them are so small that none is progress (J-CYC-02).
std::vector<Record> in_pieces(const Record& record, const Position& from, std::int64_t count,
                              double tolerance) {
  constexpr std::int64_t kFewPieces = 10;
  std::vector<Record> made;
  const Position to = end_of(record, from);
  double length = 0;
  for (const Axis axis : reference::kAllAxes) {
    length = std::max(length, std::abs(value_of(to[axis] - from[axis])));
  }
  const bool is_short = length <= tolerance * static_cast<double>(count);
  if (is_irrational(from) || is_irrational(to) || (is_short && count > kFewPieces)) return made;
  for (std::int64_t i = 1; i <= count; ++i) {
    made.push_back(record);
    made.back().to = between(from, to, i, count);
  }
  return made;
}

bool split_lines(Attempt& attempt) {
  const std::int64_t count = pieces(attempt);
  const double tolerance = attempt.specimen.tolerance();
  return attempt.replace([&](const Record& record, const Position& from) {
    if (!is_line(record.kind)) return std::vector<Record>{};
    return in_pieces(record, from, count, tolerance);
  });
}

std::optional<Stroke> stroke_of(const Record& record, const Position& from) {
  Record alone = record;
  const auto strokes = strokes_of({&alone, 1}, place_of(from), {});
  if (strokes.empty() || !strokes.front().is_round) return std::nullopt;
  Stroke stroke = strokes.front();
  stroke.record = &record;
  return stroke;
}

// Short enough for a piece to say whether it is a turn.
bool has_room(const Stroke& arc, std::int64_t count, double tolerance) {
  const double radius = std::min(arc.from_radius, arc.to_radius);
  return radius * std::abs(arc.sweep) / static_cast<double>(count) > 4 * tolerance &&
         radius > 8 * tolerance && !std::isnan(radius);
}

// Axes that go along with an arc beside its plane and depth are rare, and left.
bool turns_rotary(const Record& record, const Position& from) {
  return (record.axes.has(Axis::a) && record.to[Axis::a] != from[Axis::a]) ||
         (record.axes.has(Axis::c) && record.to[Axis::c] != from[Axis::c]);
}

// An arc that begins at `from`, with where it leads.
struct ArcTo {
  Stroke arc;
  Position from;
  Position to;
};

// The place at a part of its way, near enough; where it leads at the end.
Position place_at(const ArcTo& way, std::int64_t part, std::int64_t of) {
  Position at = way.to;
  if (part == of) return at;
  const Place place = way.arc.at(static_cast<double>(part) / static_cast<double>(of));
  for (const Axis axis : reference::kLinearAxes) at[axis] = number_near(place[index(axis)]);
  return at;
}

bool replace_arcs(Attempt& attempt,
                  const std::function<std::vector<Record>(const Record&, const ArcTo&)>& make) {
  return attempt.replace([&](const Record& record, const Position& from) {
    if (record.kind != RecordKind::arc || turns_rotary(record, from)) return std::vector<Record>{};
    return make(record, {*stroke_of(record, from), from, end_of(record, from)});
  });
}

bool split_arcs(Attempt& attempt) {
  const std::int64_t count = pieces(attempt);
  const double tolerance = attempt.specimen.tolerance();
  return replace_arcs(attempt, [&](const Record& record, const ArcTo& way) {
    std::vector<Record> made;
    const auto turns = static_cast<std::int64_t>(std::abs(way.arc.sweep) / 6) + 1;
    if (!has_room(way.arc, count * turns, tolerance) || turns > 20) return made;
    for (std::int64_t i = 1; i <= count * turns; ++i) {
      made.push_back(record);
      Record& piece = made.back();
      piece.rot = record.rot < 0 ? -1 : 1;
      piece.axes = record.axes;
      piece.to = place_at(way, i, count * turns);
    }
    return made;
  });
}

// Two halves of each full turn.
bool circles_in_halves(Attempt& attempt) {
  const double tolerance = attempt.specimen.tolerance();
  return replace_arcs(attempt, [&](const Record& record, const ArcTo& way) {
    std::vector<Record> made;
    const bool is_circle = std::abs(std::abs(way.arc.sweep) - 2 * std::numbers::pi) < 1e-9;
    if (!is_circle || !has_room(way.arc, 2, tolerance)) return made;
    made.assign(2, record);
    made[0].to = place_at(way, 1, 2);
    made[1].to = way.to;
    return made;
  });
}

bool arcs_through_a_point(Attempt& attempt) {
  const double tolerance = attempt.specimen.tolerance();
  return replace_arcs(attempt, [&](const Record& record, const ArcTo& way) {
    std::vector<Record> made;
    const Axis depth = axes_of(record.plane).d;
    const bool rises = std::abs(value_of(way.to[depth] - way.from[depth])) > 0;
    const bool grows = std::abs(way.arc.from_radius - way.arc.to_radius) > tolerance / 100;
    if (rises || grows || !has_room(way.arc, 8, tolerance)) return made;
    // Not so long that the ends are one point, nor so short that all three lie in line.
    if (std::abs(way.arc.sweep) > 5 || std::abs(way.arc.sweep) < 0.2) return made;
    Record circle = record;
    circle.kind = RecordKind::arc3;
    circle.axes = circle.via_axes = {Axis::x, Axis::y, Axis::z};
    circle.to = way.to;
    circle.via = place_at(way, 1, 2);
    circle.via[depth] = way.to[depth];
    made.push_back(circle);
    return made;
  });
}

// Chords, where the certifier grants them.
bool chords_of_arcs(Attempt& attempt) {
  constexpr std::int64_t kChordMillionths = 10'000;
  constexpr double kChord = 0.009;  // a little less than is granted, mm
  attempt.tolerances.chord = Number::millionths(kChordMillionths);
  const double tolerance = attempt.specimen.tolerance();
  return replace_arcs(attempt, [&](const Record& record, const ArcTo& way) {
    std::vector<Record> made;
    const double sweep = std::abs(way.arc.sweep);
    const double radius = std::max(way.arc.from_radius, way.arc.to_radius);
    if (radius < 0.5 || sweep > 60 || !has_room(way.arc, 1, tolerance)) return made;
    const double step = 2 * std::acos(1 - kChord / radius);
    const auto count = static_cast<std::int64_t>(std::ceil(sweep / step));
    if (count > 400) return made;
    for (std::int64_t i = 1; i <= count; ++i) {
      Record chord = record;
      chord.kind = RecordKind::feed;
      chord.rot = 0;
      chord.to = place_at(way, i, count);
      made.push_back(chord);
    }
    return made;
  });
}

// All axes as far as they go, in several traverses; each leads on along every axis.
bool split_traverses(Attempt& attempt) {
  const std::int64_t count = pieces(attempt);
  const double tolerance = attempt.specimen.tolerance();
  return attempt.replace([&](const Record& record, const Position& from) {
    if (record.kind != RecordKind::rapid) return std::vector<Record>{};
    return in_pieces(record, from, count, tolerance);
  });
}

// Axis by axis, in any order. Not where a cycle begins: which axis goes first is told there.
bool traverses_axis_by_axis(Attempt& attempt) {
  return attempt.replace([&](const Record& record, const Position& from) {
    std::vector<Record> made;
    if (record.kind != RecordKind::rapid) return made;
    const Position to = end_of(record, from);
    std::vector<Axis> axes;
    for (const Axis axis : reference::kAllAxes) {
      if (record.axes.has(axis) && from[axis] != to[axis]) axes.push_back(axis);
    }
    if (axes.size() < 2) return made;
    attempt.chance.shuffle(axes);
    Position here = from;
    for (const Axis axis : axes) {
      here[axis] = to[axis];
      made.push_back(record);
      made.back().axes = {axis};
      made.back().to = here;
    }
    return made;
  });
}

// A traverse of no length before a motion, or a cut of none.
bool motions_of_no_length(Attempt& attempt) {
  return attempt.replace([&](const Record& record, const Position& from) {
    std::vector<Record> made;
    if (!is_motion(record.kind) || attempt.chance.once_in(2)) return made;
    Record nothing;
    nothing.kind = is_line(record.kind) ? record.kind : RecordKind::rapid;
    nothing.block = record.block;
    nothing.axes = reference::kEveryAxis;
    nothing.to = from;
    nothing.feed = record.feed;
    nothing.feed_mode = record.feed_mode;
    nothing.lead = record.lead;
    nothing.start = record.start;
    made = {nothing, record};
    return made;
  });
}

bool dwells_of_no_time(Attempt& attempt) {
  return attempt.replace([&](const Record& record, const Position&) {
    std::vector<Record> made;
    if (!is_motion(record.kind) || attempt.chance.once_in(2)) return made;
    Record dwell;
    dwell.kind = RecordKind::dwell;
    dwell.block = record.block;
    made = {dwell, record};
    return made;
  });
}

}  // namespace

std::vector<Alternative> splitting_alternatives() {
  return {
      {"split-lines", "lines and threads in pieces", split_lines},
      {"split-arcs", "arcs and helices in pieces", split_arcs},
      {"circles-in-halves", "full circles in two halves", circles_in_halves},
      {"arcs-through-a-point", "arcs by an intermediate point", arcs_through_a_point},
      {"chords-of-arcs", "chords that the certifier grants", chords_of_arcs},
      {"split-traverses", "traverses in pieces", split_traverses},
      {"traverses-axis-by-axis", "traverses axis by axis", traverses_axis_by_axis},
      {"motions-of-no-length", "motions of no length", motions_of_no_length},
      {"dwells-of-no-time", "dwells of no time", dwells_of_no_time},
  };
}

}  // namespace gonogo::mutations
