// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/path.hpp"

#include <algorithm>

namespace gonogo::checker {
namespace {

Truth coordinate_equal(const Position& p, const Position& q, std::size_t axis) {
  if (!p[axis] || !q[axis]) return Truth::unknown;
  return equal(*p[axis], *q[axis]);
}

// The way of a motion along an axis.
Real way(const Motion& motion, std::size_t axis) {
  if (!motion.from[axis] || !motion.to[axis]) return 0;
  return *motion.to[axis] - *motion.from[axis];
}

bool knows_its_start(const Motion& motion) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (motion.to[axis] && !motion.from[axis]) return false;
  }
  return true;
}

Truth goes_on_straight(const Motion& first, const Motion& second) {
  Truth answer = Truth::yes;
  Real forward;
  for (std::size_t i = 0; i < kAxes; ++i) {
    forward = forward + way(first, i) * way(second, i);
    for (std::size_t j = 0; j < i; ++j) {
      answer =
          answer && (way(first, i) * way(second, j) - way(first, j) * way(second, i)).is_zero();
    }
  }
  return answer && forward.is_positive();
}

std::vector<std::size_t> moved_axes(const Motion& motion) {
  std::vector<std::size_t> axes;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (way(motion, axis).is_zero() != Truth::yes) axes.push_back(axis);
  }
  return axes;
}

Truth rapid_goes_on(const Motion& first, const Motion& second) {
  const auto axes = moved_axes(first);
  if (axes.size() != 1 || moved_axes(second) != axes) return Truth::no;
  return (way(first, axes[0]) * way(second, axes[0])).is_positive();
}

// Circles only: whether two pieces of a helix have one pitch is asked of whole turns alone.
Truth arc_goes_on(const Motion& first, const Motion& second) {
  const Record& x = first.record;
  const Record& y = second.record;
  if (x.plane != y.plane || (x.rotation < 0) != (y.rotation < 0)) return Truth::no;
  Truth answer = Truth::yes;
  for (const std::size_t axis : {x.plane.first, x.plane.second}) {
    answer = answer && coordinate_equal(x.centre, y.centre, axis);
  }
  if (answer == Truth::no) return answer;
  const Real radius2 = distance2(x.plane, first.from, x.centre);
  answer = answer && equal(radius2, distance2(x.plane, first.to, x.centre)) &&
           equal(radius2, distance2(x.plane, second.to, x.centre));
  for (const std::size_t axis : {x.plane.third, std::size_t{3}, std::size_t{4}}) {
    const Truth is_flat = way(first, axis).is_zero() && way(second, axis).is_zero();
    if (is_flat != Truth::yes) answer = answer && Truth::unknown;
  }
  return answer;
}

Truth goes_on(const Motion& first, const Motion& second) {
  const Record& x = first.record;
  const Record& y = second.record;
  if (x.kind != y.kind || x.block != y.block || x.per_revolution != y.per_revolution) {
    return Truth::no;
  }
  if (!knows_its_start(first) || !knows_its_start(second)) return Truth::no;
  switch (x.kind) {
    case RecordKind::rapid:
      return rapid_goes_on(first, second);
    case RecordKind::feed:
      return equal(x.feed, y.feed) && goes_on_straight(first, second);
    case RecordKind::thread:
      return equal(x.lead, y.lead) && equal(x.start, y.start) && goes_on_straight(first, second);
    case RecordKind::arc:
      return equal(x.feed, y.feed) && arc_goes_on(first, second);
    case RecordKind::arc3:
      return equal(x.feed, y.feed) && Truth::unknown;
    default:
      return Truth::no;
  }
}

bool join(Motion& first, const Motion& second) {
  if (first.record.kind == RecordKind::arc3) return false;
  if (first.record.kind == RecordKind::arc) {
    const auto rotation = joined_rotation(first, second);
    if (!rotation) return false;
    first.record.rotation = *rotation;
  }
  first.to = second.to;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (second.record.to[axis]) first.record.to[axis] = second.record.to[axis];
  }
  first.is_open = first.is_open || second.is_open;
  return true;
}

// Whether the motion goes nowhere: it stays by `place`, where the last one that counts ended. An
// arc that is closed makes a turn, unless it is so short that its ends agree without being equal.
Truth is_nil(const Motion& motion, const Position& place, const Real& tolerance,
             bool keeps_short_arcs) {
  const Record& record = motion.record;
  if (record.kind == RecordKind::dwell) return record.seconds.is_zero();
  if (!knows_its_start(motion)) return Truth::no;
  const Truth agrees =
      stays_by(motion, motion.from, tolerance) && stays_by(motion, place, tolerance);
  if (record.kind != RecordKind::arc) return agrees;
  if (agrees == Truth::no || keeps_short_arcs) return Truth::no;
  if (record.rotation < -1 || record.rotation > 1) return Truth::no;
  const Plane& plane = record.plane;
  const Truth is_closed = coordinate_equal(motion.from, motion.to, plane.first) &&
                          coordinate_equal(motion.from, motion.to, plane.second);
  if (is_closed == Truth::yes) return Truth::no;
  const Real turn = cross(plane, record.centre, motion.from, motion.to) * Real(record.rotation);
  return agrees && !is_closed && turn.is_positive();
}

class Builder {
 public:
  explicit Builder(const PathTolerances& tolerances) : tolerances_(tolerances) {
    path_.end = place_ = tolerances.start;
  }

  void take(const Record& record, std::size_t place) {
    if (record.kind == RecordKind::m) {
      path_.functions.push_back(record);
      path_.behind.push_back(path_.motions.size());
      return;
    }
    forget_after_renaming(record);
    Motion motion;
    motion.record = record;
    motion.from = path_.end;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (record.to[axis]) path_.end[axis] = record.to[axis];
    }
    motion.to = path_.end;
    motion.place = place;
    motion.is_open = tolerances_.is_open && tolerances_.is_open(record);
    const Truth nil = is_nil(motion, place_, tolerances_.tolerance, tolerances_.keeps_short_arcs);
    if (nil == Truth::unknown) path_.is_doubtful = true;
    const bool is_dropped = nil == Truth::yes && !is_more_of_line(motion);
    if (is_dropped) {
      path_.drops = true;
    } else {
      append(std::move(motion));
    }
    parts_ = is_dropped;
  }
  Path finish() { return std::move(path_); }

 private:
  void forget_after_renaming(const Record& record) {
    const bool is_before = record.block != 0 && record.block <= tolerances_.renaming;
    if (tolerances_.renaming == 0 || is_before) return;
    // Programs are not read here, so that any later line may rename it again.
    path_.is_doubtful = true;
    path_.end = place_ = Position();
  }
  // However short, it makes the line before it longer.
  bool is_more_of_line(const Motion& motion) const {
    const RecordKind kind = motion.record.kind;
    const bool is_straight =
        kind == RecordKind::rapid || kind == RecordKind::feed || kind == RecordKind::thread;
    return is_straight && !parts_ && !path_.motions.empty() &&
           goes_on(path_.motions.back(), motion) == Truth::yes;
  }
  void append(Motion motion) {
    if (motion.record.kind != RecordKind::dwell) place_ = motion.to;
    if (!path_.motions.empty()) {
      const Truth joins = goes_on(path_.motions.back(), motion);
      if (joins == Truth::yes && join(path_.motions.back(), motion)) {
        if (!path_.behind.empty() && path_.behind.back() == path_.motions.size()) {
          path_.joins_over_function = true;
        }
        // The other side may have kept what parts the two here.
        if (parts_) path_.is_doubtful = true;
        return;
      }
      if (joins != Truth::no) path_.is_doubtful = true;
    }
    path_.motions.push_back(std::move(motion));
  }

  const PathTolerances& tolerances_;
  bool parts_ = false;  // the last motion was dropped
  Position place_;      // where the last motion that was not dropped ended
  Path path_;
};

Real in_plane(const Position& p, const Position& centre, std::size_t axis) {
  return *p[axis] - *centre[axis];
}

}  // namespace

Truth agree(const Position& p, const Position& q, const Real& tolerance) {
  Truth answer = Truth::yes;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (p[axis] && q[axis]) answer = answer && within(*p[axis], *q[axis], tolerance);
  }
  return answer;
}

Truth stays_by(const Motion& motion, const Position& place, const Real& reach) {
  const Truth ends = agree(motion.from, place, reach) && agree(motion.to, place, reach);
  return motion.record.kind == RecordKind::arc3 ? ends && agree(motion.record.via, place, reach)
                                                : ends;
}

Real distance2(const Plane& plane, const Position& p, const Position& q) {
  const Real first = *p[plane.first] - *q[plane.first];
  const Real second = *p[plane.second] - *q[plane.second];
  return first * first + second * second;
}

Real cross(const Plane& plane, const Position& centre, const Position& p, const Position& q) {
  return in_plane(p, centre, plane.first) * in_plane(q, centre, plane.second) -
         in_plane(p, centre, plane.second) * in_plane(q, centre, plane.first);
}

Real dot(const Plane& plane, const Position& centre, const Position& p, const Position& q) {
  return in_plane(p, centre, plane.first) * in_plane(q, centre, plane.first) +
         in_plane(p, centre, plane.second) * in_plane(q, centre, plane.second);
}

namespace {

// The turn from p to q in the sense of the rotation, in (0, 360]: its half turn (0: below 180, 1:
// from 180 on; 2: a whole turn). Nothing: undecided.
std::optional<int> half_turn(const Motion& arc, const Position& p, const Position& q) {
  const Plane& plane = arc.record.plane;
  Real side = cross(plane, arc.record.centre, p, q);
  if (arc.record.rotation < 0) side = -side;
  if (side.is_positive() == Truth::yes) return 0;
  if (side.is_negative() == Truth::yes) return 1;
  if (side.is_zero() != Truth::yes) return std::nullopt;
  const Real along = dot(plane, arc.record.centre, p, q);
  if (along.is_negative() == Truth::yes) return 1;
  return along.is_positive() == Truth::yes ? std::optional<int>(2) : std::nullopt;
}

}  // namespace

std::optional<long> joined_rotation(const Motion& first, const Motion& second) {
  const auto to_middle = half_turn(first, first.from, first.to);
  const auto to_end = half_turn(first, first.from, second.to);
  const auto between = half_turn(first, first.to, second.to);
  if (!to_middle || !to_end || !between) return std::nullopt;
  // The two turns make more than one whole when the end comes before the middle, or at it: then
  // from the middle to the end it is not the rest of the way.
  bool is_beyond = *to_end < *to_middle;
  if (*to_end == *to_middle) is_beyond = *between != 0;
  const long sense = first.record.rotation < 0 ? -1 : 1;
  const long turns = sense * (first.record.rotation + second.record.rotation);
  return sense * (is_beyond ? turns : turns - 1);
}

Path make_path(const std::vector<Record>& records, const PathTolerances& tolerances) {
  Builder builder(tolerances);
  for (std::size_t i = 0; i < records.size(); ++i) builder.take(records[i], i);
  return builder.finish();
}

}  // namespace gonogo::checker
