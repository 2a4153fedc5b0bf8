// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/path_piece.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {
namespace {

using reference::Axis;
using reference::index;
using reference::kAllAxes;
using reference::kAxes;

// Along round motions places are counted in millionths of a millimetre.
Number place_of(double value) {
  constexpr double kMillion = 1e6;
  return Number::millionths(std::llround(value * kMillion));
}

double box_margin(const Motion& motion, double length) {
  // Round motions bulge out of the box of their ends by no more than they are long.
  return is_round(motion.record.kind) ? length : 0;
}

}  // namespace

bool Stretch::go_on_from(const std::array<Number, kAxes>& reached) {
  for (std::size_t i = 0; i < kAxes; ++i) {
    if (high[i] < reached[i]) return false;
    if (low[i] < reached[i]) low[i] = reached[i];
  }
  return true;
}

PathPiece::PathPiece(Motion motion, std::string text, double fastest)
    : motion_(std::move(motion)), text_(std::move(text)) {
  measure(fastest);
}

std::unique_ptr<PathPiece> PathPiece::dwelling(const Record& record, const Position& at) {
  std::unique_ptr<PathPiece> piece(new PathPiece);
  piece->kind_ = PieceKind::dwell;
  piece->text_ = record_text(record);
  piece->motion_ = {record, at, 0};
  piece->motion_.record.to = at;
  return piece;
}

std::unique_ptr<PathPiece> PathPiece::at_rest(const Position& at) {
  std::unique_ptr<PathPiece> piece(new PathPiece);
  piece->kind_ = PieceKind::stand;
  piece->motion_.from = piece->motion_.record.to = at;
  return piece;
}

std::unique_ptr<PathPiece> PathPiece::undecided(GapReason reason, std::string why) {
  std::unique_ptr<PathPiece> piece(new PathPiece);
  piece->gap_ = reason;
  piece->text_ = std::move(why);
  return piece;
}

void PathPiece::measure(double fastest) {
  double linear_2 = 0;
  double rotary = 0;
  for (Axis axis : kAllAxes) {
    const std::size_t i = index(axis);
    travel_[i] = motion_.to()[axis] - motion_.from[axis];
    direction_[i] = travel_[i].sign();
    const double way = estimate(travel_[i]);
    if (reference::is_linear(axis)) linear_2 += way * way;
    if (!reference::is_linear(axis)) rotary = std::max(rotary, std::abs(way));
    if (std::abs(way) > std::abs(estimate(travel_[longest_]))) longest_ = i;
  }
  length_ = linear_2 > 0 ? std::sqrt(linear_2) : rotary;
  switch (motion_.record.kind) {
    case RecordKind::rapid:
      kind_ = PieceKind::traverse;
      break;
    case RecordKind::arc:
    case RecordKind::arc3:
      kind_ = PieceKind::round;
      round_ = std::make_unique<RoundTube>(motion_);
      length_ = round_->length();
      break;
    default:
      kind_ = PieceKind::line;
      break;
  }
  const double longest = std::abs(estimate(travel_[longest_]));
  scale_ = longest > 0 ? length_ / longest : 1;
  has_feed_ = motion_.record.kind != RecordKind::rapid &&
              motion_.record.kind != RecordKind::thread &&
              motion_.record.feed_mode == reference::FeedMode::per_minute;
  speed_ = has_feed_ ? estimate(motion_.record.feed) / kSecondsAMinute : fastest;
  const double margin = box_margin(motion_, length_);
  for (Axis axis : kAllAxes) {
    const double a = estimate(motion_.from[axis]);
    const double b = estimate(motion_.to()[axis]);
    low_[index(axis)] = std::min(a, b) - (reference::is_linear(axis) ? margin : 0);
    high_[index(axis)] = std::max(a, b) + (reference::is_linear(axis) ? margin : 0);
  }
}

bool PathPiece::near(const SamplePoint& sample, double half) const {
  const double reach = half + Tube::kUnsure;
  for (std::size_t i = 0; i < kAxes; ++i) {
    if (sample.near[i] < low_[i] - reach || sample.near[i] > high_[i] + reach) return false;
  }
  return true;
}

// The points of the line that agree with the sample, counted along its longest axis. Exact.
std::optional<Stretch> PathPiece::line_stretch(const SamplePoint& sample, const Tube& tube) const {
  Stretch stretch;
  stretch.high[0] = abs(travel_[longest_]);
  const Number& whole = travel_[longest_];
  for (Axis axis : kAllAxes) {
    const std::size_t i = index(axis);
    if (direction_[i] == 0) {
      if (!agree(sample.exact[axis], motion_.from[axis], tube.tolerance)) return std::nullopt;
      continue;
    }
    const Number offset = sample.exact[axis] - motion_.from[axis];
    // Along its own axis first, where `direction` times the offset grows with the way.
    Number low = offset * direction_[i] - tube.tolerance;
    Number high = low + tube.tolerance * 2;
    if (i != longest_) {
      const Number slope = abs(whole) / abs(travel_[i]);
      low = low * slope;
      high = high * slope;
    }
    if (low > stretch.low[0]) stretch.low[0] = low;
    if (high < stretch.high[0]) stretch.high[0] = high;
    if (stretch.high[0] < stretch.low[0]) return std::nullopt;
  }
  return stretch;
}

std::optional<Stretch> PathPiece::traverse_stretch(const SamplePoint& sample,
                                                   const Tube& tube) const {
  Stretch stretch;
  for (Axis axis : kAllAxes) {
    const std::size_t i = index(axis);
    if (direction_[i] == 0) {
      if (!agree(sample.exact[axis], motion_.from[axis], tube.tolerance)) return std::nullopt;
      continue;
    }
    const Number offset = sample.exact[axis] - motion_.from[axis];
    const Number way = offset * direction_[i];
    const Number whole = abs(travel_[i]);
    stretch.low[i] = way - tube.tolerance;
    stretch.high[i] = way + tube.tolerance;
    if (stretch.low[i] < 0) stretch.low[i] = 0;
    if (stretch.high[i] > whole) stretch.high[i] = whole;
    if (stretch.high[i] < stretch.low[i]) return std::nullopt;
  }
  return stretch;
}

void PathPiece::stretches(const SamplePoint& sample, const Tube& tube,
                          std::vector<Stretch>& out) const {
  if (kind_ == PieceKind::open) {
    out.emplace_back();
    return;
  }
  if (kind_ == PieceKind::dwell || kind_ == PieceKind::stand) {
    if (agree(sample.exact, motion_.from, tube.tolerance)) out.emplace_back();
    return;
  }
  if (!near(sample, tube.half)) return;
  if (kind_ == PieceKind::round) {
    std::vector<RoundTube::Span> spans;
    round_->spans(sample, tube, spans);
    const double unit = round_->whole() > 0 ? length_ / round_->whole() : 0;
    for (const RoundTube::Span& span : spans) {
      Stretch& stretch = out.emplace_back();
      stretch.low[0] = place_of(span.low * unit);
      stretch.high[0] = place_of(span.high * unit);
    }
    return;
  }
  auto stretch =
      kind_ == PieceKind::line ? line_stretch(sample, tube) : traverse_stretch(sample, tube);
  if (stretch) out.push_back(*std::move(stretch));
}

double PathPiece::along(const Number& coordinate) const {
  const double value = quick(coordinate);
  return kind_ == PieceKind::line ? value * scale_ : value;
}

double PathPiece::before(const Stretch& stretch) const {
  if (kind_ != PieceKind::traverse) return along(stretch.low[0]);
  double most = 0;
  for (std::size_t i = 0; i < kAxes; ++i) most = std::max(most, quick(stretch.low[i]));
  return most;
}

double PathPiece::after(const Stretch& stretch) const {
  if (kind_ == PieceKind::traverse) {
    double most = 0;
    for (std::size_t i = 0; i < kAxes; ++i) {
      most = std::max(most, quick(abs(travel_[i]) - stretch.high[i]));
    }
    return most;
  }
  return std::max(0.0, length_ - along(stretch.high[0]));
}

double PathPiece::time() const {
  if (kind_ == PieceKind::dwell) return estimate(motion_.record.seconds);
  return speed_ > 0 ? length_ / speed_ : 0;
}

// The least t of the greatest difference of an axis along the line: the difference is convex and
// piecewise linear, so its minimum lies at an end, at a zero of one axis or where two are equal.
Number PathPiece::line_deviation(const Position& point) const {
  std::vector<Number> places = {0, 1};
  auto offset = [&](std::size_t i) { return point.at[i] - motion_.from.at[i]; };
  for (std::size_t i = 0; i < kAxes; ++i) {
    if (direction_[i] != 0) places.push_back(offset(i) / travel_[i]);
    for (std::size_t j = 0; j < i; ++j) {
      for (const int sign : {-1, 1}) {
        const Number slope = travel_[i] - travel_[j] * sign;
        if (slope.sign() != 0) places.push_back((offset(i) - offset(j) * sign) / slope);
      }
    }
  }
  std::optional<Number> least;
  for (const Number& place : places) {
    if (place < 0 || place > 1) continue;
    Number most = 0;
    for (std::size_t i = 0; i < kAxes; ++i) most = max(most, abs(offset(i) - place * travel_[i]));
    if (!least || most < *least) least = most;
  }
  return *least;
}

double PathPiece::off(const SamplePoint& sample) const {
  double most = 0;
  if (kind_ == PieceKind::round) return round_->off(sample);
  const double whole = quick(travel_[longest_]);
  double part = 0;
  if (kind_ == PieceKind::line && whole != 0) {
    part = std::clamp((sample.near[longest_] - quick(motion_.from.at[longest_])) / whole, 0.0, 1.0);
  }
  for (std::size_t i = 0; i < kAxes; ++i) {
    const double from = quick(motion_.from.at[i]);
    if (kind_ == PieceKind::traverse) {
      most = std::max({most, low_[i] - sample.near[i], sample.near[i] - high_[i]});
    } else {
      most = std::max(most, std::abs(sample.near[i] - from - part * quick(travel_[i])));
    }
  }
  return most;
}

Number PathPiece::deviation(const Position& point) const {
  if (kind_ == PieceKind::round) return round_->deviation(point);
  if (kind_ == PieceKind::line) return line_deviation(point);
  Number most = 0;
  for (Axis axis : kAllAxes) {
    const Number& a = motion_.from[axis];
    const Number& b = motion_.to()[axis];
    most = max(most, max(min(a, b) - point[axis], point[axis] - max(a, b)));
  }
  return most;
}

}  // namespace gonogo::oracle
