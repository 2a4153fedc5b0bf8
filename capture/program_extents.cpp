// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/program_extents.hpp"

#include <cstdlib>

#include "oracle/motion/round_curve.hpp"

namespace gonogo::oracle {
namespace {

using reference::Axis;
using reference::HelixPocket;
using reference::kAllAxes;
using reference::PlaneAxes;
using reference::PocketLevel;
using reference::PocketMilling;
using reference::ThreadMilling;

class Box {
 public:
  Box(const reference::Profile& profile, std::string_view program, Extents& extents)
      : profile_(profile), program_(program), extents_(extents) {}
  void expand(reference::OpenPaths open_paths);

 private:
  void cover(Axis axis, const Number& at) {
    // Not by min() and max(): enclosures of one value could not be compared.
    const Number there = at - shift_[axis];
    if (there.form() == Number::Form::enclosure) {
      constexpr int kBits = 60;
      const auto [low, high] = there.bounds(kBits);
      if (low < extents_.low[axis]) extents_.low[axis] = low;
      if (high > extents_.high[axis]) extents_.high[axis] = high;
      return;
    }
    if (there < extents_.low[axis]) extents_.low[axis] = there;
    if (there > extents_.high[axis]) extents_.high[axis] = there;
  }
  void cover_about(reference::Plane plane, const std::array<Number, 2>& centre, const Number& reach,
                   const Number& top, const Number& bottom);
  void take(const reference::Item& item);
  void take_record(const Record& record);
  void take_arc(const Motion& arc);
  void take_circle(const Motion& arc3);
  void take_feed(const Number& feed, reference::FeedMode mode);

  const reference::Profile& profile_;
  std::string_view program_;
  Extents& extents_;
  Position at_;
  Position shift_;  // of renamings: extents are in the coordinates of the start
};

void Box::take_feed(const Number& feed, reference::FeedMode mode) {
  if (mode == reference::FeedMode::per_revolution) {
    extents_.per_revolution = true;
  } else if (feed > extents_.largest_feed) {
    extents_.largest_feed = feed;
  }
}

void Box::cover_about(const reference::Plane plane, const std::array<Number, 2>& centre,
                      const Number& reach, const Number& top, const Number& bottom) {
  const PlaneAxes axes = reference::axes_of(plane);
  for (const int side : {-1, 1}) {
    cover(axes.p, centre[0] + reach * side);
    cover(axes.q, centre[1] + reach * side);
  }
  cover(axes.d, top);
  cover(axes.d, bottom);
}

// The four extreme points of the circle, those that the arc sweeps over.
void Box::take_arc(const Motion& arc) {
  const PlaneAxes axes = reference::axes_of(arc.record.plane);
  const PlaneVector start = from_centre(arc.record, arc.from);
  const PlaneVector end = from_centre(arc.record, arc.to());
  const Number radius = sqrt(start.p * start.p + start.q * start.q);
  const bool whole = std::abs(arc.record.rot) > 1 || makes_full_turn(arc);
  const int sense = arc.record.rot < 0 ? -1 : 1;
  for (const Axis axis : {axes.p, axes.q}) {
    for (const int side : {-1, 1}) {
      const PlaneVector pole = axis == axes.p ? PlaneVector{side, 0} : PlaneVector{0, side};
      const std::size_t i = axis == axes.p ? 0 : 1;
      if (whole || compare_angles(start, pole, end, sense) <= 0) {
        cover(axis, arc.record.centre[i] + radius * side);
      }
    }
  }
}

void Box::take_circle(const Motion& arc3) {
  if (const auto flat = as_arc(arc3)) return take_arc(*flat);
  const ThreePoints points(arc3);
  if (!points.circle) return;
  const Number radius = sqrt(points.circle->radius_2);
  for (const Axis axis : reference::kLinearAxes) {
    for (const int side : {-1, 1}) {
      cover(axis, points.circle->centre[reference::index(axis)] + radius * side);
    }
  }
}

void Box::take_record(const Record& record) {
  if (!is_motion(record.kind)) return;
  const Motion motion = motion_from(at_, record, 0);
  extents_.moved = extents_.moved | record.axes;
  at_ = motion.to();
  for (Axis axis : kAllAxes) cover(axis, at_[axis]);
  if (record.kind == RecordKind::arc) {
    const PlaneAxes axes = reference::axes_of(record.plane);
    extents_.moved = extents_.moved | AxisSet{axes.p, axes.q};
    take_arc(motion);
  }
  if (record.kind == RecordKind::arc3) take_circle(motion);
  if (record.kind == RecordKind::thread) extents_.threads = true;
  if (record.kind == RecordKind::feed || is_round(record.kind)) {
    take_feed(record.feed, record.feed_mode);
  }
}

void Box::take(const reference::Item& item) {
  if (const auto* record = std::get_if<Record>(&item)) {
    take_record(*record);
  } else if (const auto* level = std::get_if<PocketLevel>(&item)) {
    cover_about(level->plane, level->centre, level->pocket_radius, level->depth, level->depth);
    take_feed(level->feed, level->feed_mode);
  } else if (const auto* helix = std::get_if<HelixPocket>(&item)) {
    cover_about(helix->plane, helix->centre, helix->radius, helix->r_plane, helix->bottom);
    take_feed(helix->feed, helix->feed_mode);
  } else if (const auto* thread = std::get_if<ThreadMilling>(&item)) {
    // Passes come in from the start radius or go out to it, with a lead-in and a run-out.
    const Number reach = thread->start_radius + thread->height + thread->runout_length * 2;
    cover_about(thread->plane, thread->centre, reach, thread->r_plane, thread->bottom);
    cover_about(thread->plane, thread->centre, reach, thread->initial_plane, thread->bottom);
    take_feed(thread->feed, thread->feed_mode);
  } else if (const auto* pocket = std::get_if<PocketMilling>(&item)) {
    cover_about(pocket->plane, pocket->centre, (pocket->length + pocket->width) / 2,
                pocket->clearance, pocket->floor);
    cover_about(pocket->plane, pocket->centre, 0, pocket->retract, pocket->floor);
    take_feed(pocket->depth_feed, pocket->feed_mode);
    take_feed(pocket->plane_feed, pocket->feed_mode);
  } else if (const auto* renaming = std::get_if<reference::Renaming>(&item)) {
    shift(at_, renaming->shift);
    shift(shift_, renaming->shift);
  } else if (std::holds_alternative<reference::AlarmReport>(item)) {
    extents_.alarms = true;
  } else if (std::holds_alternative<reference::NotCovered>(item)) {
    extents_.not_covered = true;
  }
}

void Box::expand(reference::OpenPaths open_paths) {
  ProgramInput input(program_);
  reference::Expander expander(profile_, input.lines, open_paths);
  at_ = profile_.initial.at;
  shift_ = {};
  while (const reference::Item* item = expander.next()) take(*item);
}

}  // namespace

std::optional<Extents> extents_of(const reference::Profile& profile, std::string_view program) {
  const Assignments assignments = assignments_of(profile, program);
  if (assignments.too_many) return std::nullopt;
  Extents extents;
  extents.low = extents.high = profile.initial.at;
  for (const reference::ReadingChoice& choice : assignments.choices) {
    reference::Profile assigned = profile;
    assigned.readings = choice;
    Box box(assigned, program, extents);
    box.expand(reference::OpenPaths::shown);
    box.expand(reference::OpenPaths::judged);
  }
  return extents;
}

}  // namespace gonogo::oracle
