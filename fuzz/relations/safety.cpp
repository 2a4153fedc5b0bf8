// SPDX-License-Identifier: GPL-3.0-or-later
//
// What no path may do. The stock of a mill lies below Z0; that of a lathe is a bar along -Z. The
// tool is a point, so that only what a cut has passed through is free.
#include <fmt/format.h>

#include <algorithm>
#include <deque>

#include "oracle/steps/step_text.hpp"
#include "fuzz/relations/operation_path.hpp"

namespace gonogo::relations {
namespace {

using reference::Axis;
using reference::Position;
using reference::RecordKind;

std::string place_text(const Position& at) {
  return fmt::format("X{} Y{} Z{}", at[Axis::x].decimal_text(6), at[Axis::y].decimal_text(6),
                     at[Axis::z].decimal_text(6));
}

bool same_along(const Leg& leg, Axis axis) {
  return leg.from[axis] == leg.to[axis];
}
const Number& lower(const Leg& leg, Axis axis) {
  return min(leg.from[axis], leg.to[axis]);
}

class Breaches {
 public:
  // The first of each rule is kept.
  void add(Rule rule, std::size_t leg, const Leg* at, const Position& witness) {
    if (std::ranges::find(found_, rule, &Breach::rule) != found_.end()) return;
    found_.push_back({rule, leg + 1, at == nullptr ? 0 : at->record.block,
                      at == nullptr ? std::string() : oracle::record_text(at->record),
                      place_text(witness)});
  }
  std::vector<Breach> take() { return std::move(found_); }

 private:
  std::vector<Breach> found_;
};

// A place in the plane where a mill has cut, or is to.
struct Column {
  PlanePoint at;
  std::optional<Number> floor;  // Z of the deepest cut
  std::vector<Number> stops;    // Z at which motions have ended since the last cut downwards
  const Operation* hole = nullptr;
};

class Mill {
 public:
  Mill(const OperationList& list, const Number& tolerance) : tolerance_(tolerance) {
    for (const Operation& operation : list.operations) {
      bottom_ = min(bottom_, operation.depth);
      for (const PlanePoint& place : operation.places) column(place).hole = &operation;
    }
  }

  void take(std::size_t i, const Leg& leg, Breaches& found) {
    if (!is_motion(leg.record.kind)) return;
    Column& column = this->column({leg.to[Axis::x], leg.to[Axis::y]});
    const bool is_vertical = same_along(leg, Axis::x) && same_along(leg, Axis::y);
    if (!is_vertical) leave(i, &leg, leg.from, found);
    if (leg.record.kind == RecordKind::rapid) {
      traverse(i, leg, is_vertical, column, found);
    } else {
      cut(i, leg, is_vertical, column, found);
    }
    column.stops.push_back(leg.to[Axis::z]);
  }

  void end(std::size_t legs, const Position& at, Breaches& found) {
    leave(legs, nullptr, at, found);
    for (const Column& each : columns_) {
      if (each.hole == nullptr) continue;
      const Number& depth = each.hole->depth;
      if (each.floor && *each.floor <= depth + tolerance_) continue;
      Position bottom;
      bottom[Axis::x] = each.at.p;
      bottom[Axis::y] = each.at.q;
      bottom[Axis::z] = depth;
      found.add(Rule::not_cut, legs, nullptr, bottom);
    }
  }

 private:
  // A pattern's places are apart from each other; what is nearer than the tolerance is one.
  Column& column(const PlanePoint& at) {
    const auto same = std::ranges::find_if(columns_, [&](const Column& each) {
      return abs(each.at.p - at.p) <= tolerance_ && abs(each.at.q - at.q) <= tolerance_;
    });
    if (same != columns_.end()) return *same;
    return columns_.emplace_back(Column{at, std::nullopt, {}, nullptr});
  }

  // From a hole, after a stop at the level that it is to be left at.
  void leave(std::size_t i, const Leg* leg, const Position& at, Breaches& found) {
    const Column& from = column({at[Axis::x], at[Axis::y]});
    if (from.hole == nullptr || !from.floor) return;
    const Number& level = from.hole->ends_at_r ? from.hole->r : from.hole->level;
    const bool was_there = std::ranges::any_of(
        from.stops, [&](const Number& stop) { return abs(stop - level) <= tolerance_; });
    if (!was_there) found.add(Rule::retract_level, i, leg, at);
  }

  // Below the top only straight down to where a cut was, or straight up.
  void traverse(std::size_t i, const Leg& leg, bool is_vertical, const Column& column,
                Breaches& found) const {
    const Number& low = lower(leg, Axis::z);
    if (low >= -tolerance_) return;
    if (is_vertical && column.floor && low >= *column.floor - tolerance_) return;
    const bool begins_low = leg.from[Axis::z] < leg.to[Axis::z];
    found.add(Rule::traverse_in_stock, i, &leg, begins_low ? leg.from : leg.to);
  }

  void cut(std::size_t i, const Leg& leg, bool is_vertical, Column& column, Breaches& found) const {
    const Number& z = leg.to[Axis::z];
    const Number& bottom = column.hole != nullptr ? column.hole->depth : bottom_;
    if (z < bottom - tolerance_) found.add(Rule::beyond_contour, i, &leg, leg.to);
    if (column.hole != nullptr && column.hole->peck.sign() > 0 && is_vertical) {
      const Number begin = column.floor ? *column.floor : column.hole->r;
      const bool is_deep = begin - z > column.hole->peck + tolerance_;
      if (is_deep) found.add(Rule::peck_too_deep, i, &leg, leg.to);
    }
    if (z < leg.from[Axis::z]) column.stops.clear();
    column.floor = column.floor ? min(*column.floor, z) : z;
  }

  const Number tolerance_;
  Number bottom_;
  std::deque<Column> columns_;  // in which each stays where it is
};

class Lathe {
 public:
  Lathe(const OperationList& list, const Number& tolerance)
      : bar_(list.bar), tolerance_(tolerance) {
    for (const Operation& operation : list.operations) {
      reach(operation.start);
      for (const Cut& each : operation.cuts) reach(each.to);
      if (operation.kind != OperationKind::contour) reach_pass(operation);
    }
  }

  void take(std::size_t i, const Leg& leg, Breaches& found) const {
    if (leg.record.kind == RecordKind::rapid) {
      traverse(i, leg, found);
    } else if (is_motion(leg.record.kind)) {
      const bool is_beyond = leg.to[Axis::x] < x_ - tolerance_ || leg.to[Axis::z] < z_ - tolerance_;
      if (is_beyond) found.add(Rule::beyond_contour, i, &leg, leg.to);
    }
  }

 private:
  void reach(const PlanePoint& at) {
    z_ = min(z_, at.p);
    x_ = has_x_ ? min(x_, at.q) : at.q;
    has_x_ = true;
  }
  void reach_pass(const Operation& operation) {
    reach(operation.end);
    const bool is_face = operation.kind == OperationKind::face;
    reach(is_face ? PlanePoint{operation.end.p + operation.taper, operation.start.q}
                  : PlanePoint{operation.start.p, operation.end.q + operation.taper});
  }

  bool is_inside(const Number& x, const Number& z) const {
    return x < bar_ - tolerance_ && z < -tolerance_;
  }
  void traverse(std::size_t i, const Leg& leg, Breaches& found) const {
    const bool is_straight = same_along(leg, Axis::x) || same_along(leg, Axis::z);
    // The corner that is deepest in it lies on the way of a traverse along one axis.
    const Number& x = lower(leg, Axis::x);
    const Number& z = lower(leg, Axis::z);
    if (is_straight && is_inside(x, z)) {
      Position witness = leg.to;
      witness[Axis::x] = x;
      witness[Axis::z] = z;
      found.add(Rule::traverse_in_stock, i, &leg, witness);
    } else if (is_inside(leg.to[Axis::x], leg.to[Axis::z])) {
      found.add(Rule::traverse_in_stock, i, &leg, leg.to);
    } else if (is_inside(leg.from[Axis::x], leg.from[Axis::z])) {
      found.add(Rule::traverse_in_stock, i, &leg, leg.from);
    }
  }

  const Number bar_;
  const Number tolerance_;
  Number x_;
  Number z_;
  bool has_x_ = false;
};

}  // namespace

std::string_view name(Rule rule) {
  constexpr auto kNames = std::to_array<std::string_view>(
      {"traverse-in-stock", "beyond-contour", "not-cut", "retract-level", "peck-too-deep"});
  return kNames[static_cast<std::size_t>(rule)];
}

std::string_view sentence(Rule rule) {
  constexpr auto kSentences = std::to_array<std::string_view>(
      {"No traverse goes through stock that has not been cut.",
       "No cut goes deeper than the bottom of its hole or beyond the contour.",
       "Every hole is cut down to its bottom.",
       "A hole is left at its R plane or its initial level, as it is asked for.",
       "No cut takes more than one peck."});
  return kSentences[static_cast<std::size_t>(rule)];
}

std::vector<Breach> breaches(const OperationList& list, const std::vector<Leg>& legs,
                             const Number& tolerance) {
  Breaches found;
  try {
    if (list.machine == MachineKind::lathe) {
      const Lathe lathe(list, tolerance);
      for (std::size_t i = 0; i < legs.size(); ++i) lathe.take(i, legs[i], found);
    } else {
      Mill mill(list, tolerance);
      for (std::size_t i = 0; i < legs.size(); ++i) mill.take(i, legs[i], found);
      mill.end(legs.size(), legs.empty() ? Position{} : legs.back().to, found);
    }
  } catch (const exact::Undecided&) {
    // What follows is unknown.
  }
  return found.take();
}

}  // namespace gonogo::relations
