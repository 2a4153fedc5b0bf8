// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/cycle_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "oracle/judge/unit_error.hpp"
#include "oracle/region/constants.hpp"
#include "reference/exact/radians.hpp"

namespace gonogo::oracle {
namespace {

Number square(const Number& number) {
  return number * number;
}

Number chord(const Motion& motion) {
  Number sum;
  for (const Axis axis : reference::kLinearAxes)
    sum += square(motion.to()[axis] - motion.from[axis]);
  return sqrt(sum);
}

bool turns_axes(const Motion& motion) {
  return std::ranges::any_of(std::array{Axis::a, Axis::c},
                             [&](Axis axis) { return motion.to()[axis] != motion.from[axis]; });
}

// Degrees, above zero, in the arc's own sense.
Number sweep(const Motion& arc) {
  const PlaneVector from = from_centre(arc.record, arc.from);
  const PlaneVector to = from_centre(arc.record, arc.to());
  const int turns = std::abs(arc.record.rot) - 1;
  const int full = 360;
  if (same_direction(from, to)) return Number(full) * (turns + 1);
  Number angle = angle_degrees(to.p, to.q) - angle_degrees(from.p, from.q);
  if (arc.record.rot < 0) angle = -angle;
  return (angle.sign() < 0 ? angle + full : angle) + Number(full) * turns;
}

bool has_no_length(const PlaneVector& radius) {
  return radius.p.sign() == 0 && radius.q.sign() == 0;
}

// Nothing: it is not known here, as of an arc that begins or ends in its own centre. A radius is
// that at the start.
std::optional<Number> length_of(const Motion& motion) {
  if (motion.record.kind == RecordKind::arc3) {
    const std::optional<Motion> chord_or_arc = as_arc(straightened(motion));
    return chord_or_arc ? length_of(*chord_or_arc) : std::nullopt;
  }
  if (motion.record.kind != RecordKind::arc) return chord(motion);
  const PlaneVector from = from_centre(motion.record, motion.from);
  if (has_no_length(from) || has_no_length(from_centre(motion.record, motion.to())))
    return std::nullopt;
  const Axis depth = reference::axes_of(motion.record.plane).d;
  const Number radius_2 = square(from.p) + square(from.q);
  const Number height = motion.to()[depth] - motion.from[depth];
  const Number angle = exact::radians(sweep(motion));
  return sqrt(square(angle) * radius_2 + square(height));
}

// The lead of a thread counts along the axis that moves most.
Number travel(const Motion& motion) {
  Number most;
  for (const Axis axis : reference::kLinearAxes) {
    most = max(most, abs(motion.to()[axis] - motion.from[axis]));
  }
  return most;
}

}  // namespace

void EnclosedSum::add(const Number& term) {
  const auto [low, high] = term.bounds(kEstimateBits);
  low_ += low;
  high_ += high;
}

Number EnclosedSum::value() const {
  return Number::between(low_, high_);
}

void CycleTime::take_motion(const Motion& motion) {
  const Record& record = motion.record;
  const bool is_thread = record.kind == RecordKind::thread;
  const auto length = turns_axes(motion) ? std::nullopt
                      : is_thread        ? std::optional(travel(motion))
                                         : length_of(motion);
  const Number& feed = is_thread ? record.lead : record.feed;
  if (!length) {
    ++left_out_;
  } else if (record.kind == RecordKind::rapid) {
    rapid_.add(*length);
  } else if (feed.sign() > 0) {
    const bool per_turn = is_thread || record.feed_mode == reference::FeedMode::per_revolution;
    EnclosedSum& sum = per_turn ? turns_ : feed_;
    sum.add(*length * (per_turn ? 1 : 60) / feed);
  }
}

void CycleTime::take(const Record& record) {
  if (record.kind == RecordKind::dwell) dwell_.add(record.seconds);
  if (!reference::is_motion(record.kind)) return;
  const Motion motion = motion_from(at_, record, 0);
  at_ = motion.to();
  try {
    take_motion(motion);
  } catch (const exact::Undecided&) {
    ++left_out_;
  }
}

void CycleTime::leave_out(const Record& record) {
  if (reference::is_motion(record.kind)) at_ = motion_from(at_, record, 0).to();
}

namespace {

constexpr std::array<std::optional<Quantity>, 4> kQuantities = {Quantity::time, Quantity::dwell,
                                                                std::nullopt, std::nullopt};

}  // namespace

std::array<TimePart, 4> parts_of(const CycleTime& time) {
  return {{{"cuts", "s", time.feed_seconds()},
           {"dwells", "s", time.dwell_seconds()},
           {"turns", "rev", time.revolutions()},
           {"traverses", "mm", time.rapid_length()}}};
}

std::string amount_text(const TimePart& part) {
  const std::string rounded = part.amount.decimal_text(3);
  const std::string exact = part.amount.is_rational() ? part.amount.text() : "";
  if (exact.empty() || exact.size() > 16) {
    return fmt::format("{} {} (rounded)", rounded, part.unit);
  }
  const bool is_decimal = exact.find('/') == std::string::npos;
  return is_decimal ? fmt::format("{} {}", exact, part.unit)
                    : fmt::format("{} {} (exactly {})", rounded, part.unit, exact);
}

std::string time_hint(std::size_t part, const Number& want, const Number& got) {
  if (!kQuantities.at(part)) return {};
  // The numbers are rounded one by one.
  return unit_error(*kQuantities.at(part), want, got, want / (kFewestParts * kFewestParts));
}

}  // namespace gonogo::oracle
