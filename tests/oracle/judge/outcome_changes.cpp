// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracle/judge/outcome_changes.hpp"

#include <cmath>
#include <numbers>

namespace gonogo::oracle {
namespace {

using reference::kAllAxes;
using reference::PlaneAxes;

Number six_decimals(double value) {
  return Number::millionths(std::llround(value * 1e6));
}

Position between(const Motion& motion, int part, int of) {
  Position point;
  for (Axis axis : kAllAxes) {
    const Number way = motion.to()[axis] - motion.from[axis];
    point[axis] = motion.from[axis] + way * part / of;
  }
  return point;
}

// Its two ends, centre and turns in doubles, which six decimals are written of.
Position on_arc(const Motion& arc, double part) {
  const PlaneAxes axes = reference::axes_of(arc.record.plane);
  const PlaneVector a = from_centre(arc.record, arc.from);
  const PlaneVector b = from_centre(arc.record, arc.to());
  const double turns = approximate_turns(arc);
  const double start = std::atan2(estimate(a.q), estimate(a.p));
  const double first = std::hypot(estimate(a.p), estimate(a.q));
  const double last = std::hypot(estimate(b.p), estimate(b.q));
  const double radius = first + part * (last - first);
  const double sense = arc.record.rot < 0 ? -1 : 1;
  const double angle = start + sense * part * turns * 2 * std::numbers::pi;
  Position point;
  for (Axis axis : kAllAxes) {
    const double from = estimate(arc.from[axis]);
    point[axis] = six_decimals(from + part * (estimate(arc.to()[axis]) - from));
  }
  point[axes.p] = six_decimals(estimate(arc.record.centre[0]) + radius * std::cos(angle));
  point[axes.q] = six_decimals(estimate(arc.record.centre[1]) + radius * std::sin(angle));
  return point;
}

Record with_end(Record record, const Position& to) {
  record.to = to;
  for (Axis axis : reference::kLinearAxes) record.axes.add(axis);
  return record;
}

// Whether its ends agree in its plane: it may mean a full turn or none.
bool closes(const Motion& arc, const Number& within) {
  const PlaneAxes axes = reference::axes_of(arc.record.plane);
  return agree(arc.from[axes.p], arc.to()[axes.p], within) &&
         agree(arc.from[axes.q], arc.to()[axes.q], within);
}

void split_arc(const Motion& arc, double part, const Number& least, std::vector<Record>& records) {
  const double turns = approximate_turns(arc);
  const double first = part * turns;
  const double second = turns - first;
  // Parts that are nearly whole turns are not told from nil by points of six decimals, nor do
  // points of a small circle lie well on it.
  constexpr double kClear = 0.05;
  constexpr double kSmall = 0.05;  // mm
  const Number kNearly = Number::millionths(10'000);
  const PlaneVector start = from_centre(arc.record, arc.from);
  const Position middle = on_arc(arc, part);
  const bool small = std::hypot(estimate(start.p), estimate(start.q)) < kSmall ||
                     agree(arc.from, middle, least) || agree(middle, arc.to(), least) ||
                     (closes(arc, kNearly) && (least.sign() > 0 || !closes(arc, 0)));
  if (small || std::abs(first - std::round(first)) < kClear ||
      std::abs(second - std::round(second)) < kClear) {
    records.push_back(arc.record);
    return;
  }
  const int sense = arc.record.rot < 0 ? -1 : 1;
  records.push_back(with_end(arc.record, middle));
  records.back().rot = sense * static_cast<std::int32_t>(std::ceil(first));
  records.push_back(arc.record);
  records.back().rot = sense * static_cast<std::int32_t>(std::ceil(second));
}

void split_line(const Motion& line, const Number& least, generate::Choices& choices,
                std::vector<Record>& records) {
  constexpr int kPieces = 8;
  if (agree(line.from, between(line, 1, kPieces), least)) {
    records.push_back(line.record);
    return;
  }
  for (int piece = 1; piece < kPieces; ++piece) {
    if (choices.one_in(3)) records.push_back(with_end(line.record, between(line, piece, kPieces)));
  }
  records.push_back(line.record);
}

// Hands out each record with where it starts.
void each_motion(const Outcome& outcome, Position at, const auto& take) {
  for (const Record& record : outcome.records) {
    const Motion motion = motion_from(at, record, 0);
    take(motion, is_motion(record.kind));
    if (is_motion(record.kind)) at = motion.to();
  }
}

Number multiple(const Number& value, const Number& unit) {
  return (value / unit + Number::millionths(500'000)).floor() * unit;
}

}  // namespace

Outcome split(const Outcome& outcome, const Position& start, const Number& least,
              generate::Choices& choices) {
  Outcome result{{}, outcome.end};
  each_motion(outcome, start, [&](const Motion& motion, bool moves) {
    const RecordKind kind = motion.record.kind;
    if (!moves || kind == RecordKind::arc3) {
      result.records.push_back(motion.record);
    } else if (kind == RecordKind::arc) {
      split_arc(motion, 0.1 * static_cast<double>(1 + choices.below(9)), least, result.records);
    } else {
      split_line(motion, least, choices, result.records);
    }
  });
  return result;
}

Outcome joined(const Outcome& outcome, const Position& start) {
  Outcome result{{}, outcome.end};
  std::optional<Motion> last;
  each_motion(outcome, start, [&](const Motion& motion, bool moves) {
    if (moves && last && join(*last, motion)) {
      result.records.back() = last->record;
      return;
    }
    last.reset();
    if (moves) last = motion;
    result.records.push_back(motion.record);
  });
  return result;
}

namespace {

void round_to(const Number& resolution, Position& point) {
  for (Axis axis : kAllAxes) point[axis] = multiple(point[axis], resolution);
}

}  // namespace

Outcome rounded(const Outcome& outcome, const Position& start, const Number& resolution) {
  Outcome result{{}, outcome.end};
  each_motion(outcome, start, [&](const Motion& exact, bool) {
    Motion motion = exact;
    round_to(resolution, motion.from);
    round_to(resolution, motion.record.to);
    round_to(resolution, motion.record.via);
    for (Number& centre : motion.record.centre) centre = multiple(centre, resolution);
    const std::int32_t rot = motion.record.rot;
    // Ends that are the same now would say one turn more than is made.
    const bool says_more = exact.record.kind == RecordKind::arc && std::abs(rot) > 1 &&
                           closes(motion, 0) && approximate_turns(exact) < std::abs(rot) - 0.5;
    if (says_more) motion.record.rot += rot < 0 ? 1 : -1;
    result.records.push_back(motion.record);
  });
  return result;
}

Outcome with_nothing_added(const Outcome& outcome, const Position& start,
                           generate::Choices& choices) {
  Outcome result{{}, outcome.end};
  each_motion(outcome, start, [&](const Motion& motion, bool moves) {
    if (moves && choices.one_in(3)) {
      Record nothing = motion.record;
      if (choices.one_in(3)) {
        nothing.kind = RecordKind::dwell;
        nothing.seconds = 0;
      } else {
        nothing = with_end(nothing, motion.from);
        nothing.kind = choices.one_in(2) ? RecordKind::rapid : RecordKind::feed;
      }
      result.records.push_back(nothing);
    }
    result.records.push_back(motion.record);
  });
  return result;
}

Outcome renumbered(const Outcome& outcome, generate::Choices& choices) {
  Outcome result = outcome;
  for (Record& record : result.records) record.block = choices.below(20);
  if (choices.one_in(2)) result.end.alarm.block = choices.below(20);
  return result;
}

}  // namespace gonogo::oracle
