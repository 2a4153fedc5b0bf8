// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/open/open_helix.hpp"

#include "oracle/motion/approximate.hpp"
#include "oracle/open/free_step.hpp"

namespace gonogo::oracle {
namespace {

Motion wanted(const HelixShape& shape, const Position& at, const Tolerances& tolerances) {
  const reference::PlaneAxes axes = reference::axes_of(shape.plane);
  Motion want;
  want.record.kind = RecordKind::arc;
  want.record.plane = shape.plane;
  want.record.block = tolerances.compare_blocks ? shape.block : 0;
  want.record.clause = shape.clause;
  want.record.centre = shape.centre;
  want.record.rot =
      shape.sense * static_cast<std::int32_t>(shape.turns.ceil().to_int64().value_or(0));
  want.record.feed = shape.feed;
  want.record.feed_mode = shape.feed_mode;
  want.record.axes = {axes.p, axes.q, axes.d};
  want.from = at;
  want.from[axes.d] = shape.top;
  const PlaneVector end = apply(shape.to_end, shape.from_axis(at));
  want.record.to = want.from;
  // After whole turns the end is the start itself, which sums of enclosures could not tell.
  if (shape.turns.floor() != shape.turns) {
    want.record.to[axes.p] = shape.centre[0] + end.p;
    want.record.to[axes.q] = shape.centre[1] + end.q;
  }
  want.record.to[axes.d] = shape.bottom;
  return want;
}

}  // namespace

PlaneVector HelixShape::from_axis(const Position& at) const {
  const reference::PlaneAxes axes = reference::axes_of(plane);
  return {at[axes.p] - centre[0], at[axes.q] - centre[1]};
}

OpenHelix::OpenHelix(const HelixShape& shape, OpenStart starts, const Position& at,
                     const Tolerances& tolerances)
    : block_(shape.block),
      turns_(shape.turns),
      origin_{shape.centre[0], shape.centre[1]},
      starts_(std::move(starts)),
      want_(wanted(shape, at, tolerances)),
      to_end_(shape.to_end),
      match_(want_, tolerances,
             OpenArc{&starts_, origin_, shape.to_end, {0, 0}, shape.radius, Number(0)}) {}

MatchResult OpenHelix::match(const Motion& motion) {
  MatchResult result = match_.match(motion);
  if (!result.done) return result;
  const reference::PlaneAxes axes = reference::axes_of(want_.record.plane);
  starts_.narrow(to_end_, {motion.to()[axes.p] - origin_.p, motion.to()[axes.q] - origin_.q});
  return result;
}

Verdict OpenHelix::ended(reference::ClauseId clause, const Motion& last, std::string want,
                         std::string message, const Tolerances& tolerances) const {
  Verdict verdict =
      ended_elsewhere(clause, block_, last, want_.to(), std::move(want), std::move(message));
  verdict.rule = RelationRule::place;
  try {
    if (agree(last.to(), want_.to(), tolerances.tolerance)) {
      verdict.message += turns_that_came(turns_, approximate(turns_) - match_.turns());
    }
  } catch (const exact::Undecided&) {
  }
  return verdict;
}

MatchResult OpenHelices::match(const Motion& motion) {
  MatchResult last;
  for (auto each = open_.begin(); each != open_.end();) {
    MatchResult result = each->match(motion);
    const auto here = each++;
    if (result.done && done_.empty()) done_.splice(done_.end(), open_, here);
    if (result.departure == Departure::none) continue;
    dropped_.clear();
    dropped_.splice(dropped_.end(), open_, here);
    if (result.departure == Departure::undecided) undecided_ = result;
    last = std::move(result);
  }
  if (!done_.empty()) return {Departure::none, true, {}};
  if (!open_.empty()) return {};
  // What was not decided comes before what departs.
  return undecided_.value_or(last);
}

bool OpenHelices::add(const HelixShape& shape, OpenStart starts, const Position& at,
                      const Tolerances& tolerances) {
  if (open_.size() >= kMostStarts) return false;
  open_.emplace_back(shape, std::move(starts), at, tolerances);
  return true;
}

std::optional<OpenStart> starts_of_helix(const HelixShape& shape, const Motion& motion,
                                         const Tolerances& tolerances) {
  const Record& record = motion.record;
  const Number& tau = tolerances.tolerance;
  const bool chord = record.kind == RecordKind::feed && tolerances.chord.sign() > 0;
  if (record.kind != RecordKind::arc && !chord) return std::nullopt;
  if (record.kind == RecordKind::arc &&
      (record.plane != shape.plane || (record.rot < 0) != (shape.sense < 0) ||
       !agree(record.centre[0], shape.centre[0], tau) ||
       !agree(record.centre[1], shape.centre[1], tau))) {
    return std::nullopt;
  }
  const Axis d = reference::axes_of(shape.plane).d;
  if (!agree(motion.from[d], shape.top, tau)) return std::nullopt;
  OpenStart starts(shape.radius, tau);
  if (!starts.narrow({}, shape.from_axis(motion.from))) return std::nullopt;
  return starts;
}

}  // namespace gonogo::oracle
