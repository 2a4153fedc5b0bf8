// SPDX-License-Identifier: GPL-3.0-or-later
//
// PocketMillingJudge's part for places: which depths a level may have, where the centre is, and
// what stays inside.
#include "oracle/judge/curve_match.hpp"
#include "oracle/judge/pocket_milling_judge.hpp"
#include "oracle/region/gouge.hpp"

namespace gonogo::oracle {

using reference::Levels;

namespace {

constexpr int kBlurBits = 45;

// A rational number no more than 2^-kBlurBits from one that is only enclosed. One that cannot be
// enclosed so closely stays as it is.
Number sharp(const Number& value) {
  if (value.form() != Number::Form::enclosure) return value;
  const std::array<Number, 2> bounds = value.bounds(kBlurBits + 4);
  if (bounds[1] - bounds[0] > Number::binary(1, -kBlurBits)) return value;
  const Number scale = Number::binary(1, kBlurBits + 4);
  return (bounds[0] * scale).floor() / scale;
}

}  // namespace

bool PocketMillingJudge::is_floor(const Number& depth) const {
  return agree(depth, item_.floor, terms_.tolerance);
}

// SIE-LC75-06: the depth of level `place` (from 1) where the reading names it.
Number PocketMillingJudge::depth_of(const Number& place) const {
  const Number from = item_.levels_from_clearance ? item_.clearance : item_.reference_plane;
  if (item_.levels == Levels::max_rest) return max(from - place * item_.infeed, item_.floor);
  const Number depth = from - item_.floor;
  return from - place * depth / (depth / item_.infeed).ceil();
}

// Which of the named levels lies at a depth; nothing when none does, or none has a name.
std::optional<Number> PocketMillingJudge::place_of(const Number& depth) const {
  if (item_.levels == Levels::open) return std::nullopt;
  const Number from = item_.levels_from_clearance ? item_.clearance : item_.reference_plane;
  const Number count = ((from - item_.floor) / item_.infeed).ceil();
  if (is_floor(depth)) return count;
  const Number step =
      item_.levels == Levels::max_rest ? item_.infeed : (from - item_.floor) / count;
  const Number half = Number(1) / Number(2);
  const Number place = ((from - depth) / step + half).floor();
  const bool found =
      place.sign() > 0 && place <= count && agree(depth_of(place), depth, terms_.tolerance);
  return found ? std::optional(place) : std::nullopt;
}

// SIE-LC75-06. Of finishing, levels that have nothing to clear may be left out: those in the air,
// and where there is no strip all but the last.
bool PocketMillingJudge::is_named(const Number& depth) const {
  const std::optional<Number> place = place_of(depth);
  if (!place || *place < next_level_) return false;
  if (*place == next_level_) return true;
  if (!item_.finishing) return false;
  return !has_strip() || depth_of(*place - 1) >= item_.reference_plane - terms_.tolerance;
}

bool PocketMillingJudge::admits_depth(const Number& depth) const {
  const Number& tau = terms_.tolerance;
  if (depth < item_.floor - tau || depth >= last_depth_ - tau) return false;
  // Where the tool can only go down, levels leave no trace.
  if (is_point() && is_floor(depth)) return true;
  // SIE-LC75-11
  if (item_.one_level && first_ && is_floor(depth)) return true;
  if (is_named(depth)) return true;
  if (item_.levels != Levels::open && !item_.one_level) return false;
  if (item_.finishing && !has_strip()) return true;
  const Number& above = first_ ? item_.reference_plane : last_depth_;
  return depth >= above - item_.infeed - tau;
}

bool PocketMillingJudge::is_point() const {
  return reach_.core_p.sign() == 0 && reach_.core_q.sign() == 0 &&
         reach_.radius <= terms_.tolerance;
}

bool PocketMillingJudge::above_centre(const Position& at) const {
  return agree(at[axes_.p], item_.centre[0], terms_.tolerance) &&
         agree(at[axes_.q], item_.centre[1], terms_.tolerance);
}

bool PocketMillingJudge::has_feed(const Motion& motion, const Number& feed) const {
  Record terms;
  terms.feed = feed;
  terms.feed_mode = item_.feed_mode;
  return feeds_agree(terms, motion.record, terms_);
}

void PocketMillingJudge::take_slack_of(const Motion& motion) {
  const auto is_enclosed = [](const Number& value) {
    return value.form() == Number::Form::enclosure;
  };
  const Record& record = motion.record;
  const bool blurs = is_enclosed(record.to[axes_.p]) || is_enclosed(record.to[axes_.q]) ||
                     is_enclosed(motion.from[axes_.p]) || is_enclosed(motion.from[axes_.q]) ||
                     is_enclosed(record.centre[0]) || is_enclosed(record.centre[1]);
  if (!blurs || is_blurred_) return;
  is_blurred_ = true;
  slack_ += Number::binary(1, -kBlurBits + 2);  // of two coordinates, either as far off as that
}

region::PlanePoint PocketMillingJudge::own(const Position& at) const {
  return region::into(frame_, {sharp(at[axes_.p]), sharp(at[axes_.q])});
}

region::LevelMotion PocketMillingJudge::own(const Motion& motion) const {
  region::LevelMotion part;
  part.is_arc = motion.record.kind == RecordKind::arc;
  part.from = {sharp(motion.from[axes_.p]), sharp(motion.from[axes_.q])};
  part.to = {sharp(motion.to()[axes_.p]), sharp(motion.to()[axes_.q])};
  if (part.is_arc) part.centre = {sharp(motion.record.centre[0]), sharp(motion.record.centre[1])};
  part.rot = motion.record.rot;
  part.record = motion.number;
  return region::into(frame_, part);
}

std::optional<bool> PocketMillingJudge::stays_in(const Motion& motion,
                                                 const region::RoundedRectangle& area) const {
  const region::LevelMotion part = own(motion);
  const auto reach = [&](const Number& margin) {
    const region::RoundedRectangle limit = region::with_radius(area, area.radius + margin);
    if (part.is_arc && !(part.from == part.centre) && !(part.to == part.centre)) {
      return region::reach_of_arc(region::make_arc(part, {}), limit).kind;
    }
    const auto start = region::reach_of_point(part.from, limit).kind;
    const auto end = region::reach_of_point(part.to, limit).kind;
    return start == region::Reach::Kind::inside ? end : start;
  };
  if (reach(terms_.tolerance - slack_) == region::Reach::Kind::inside) return true;
  if (reach(terms_.tolerance + slack_) == region::Reach::Kind::outside) return false;
  return std::nullopt;
}

}  // namespace gonogo::oracle
