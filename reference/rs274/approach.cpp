// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/approach.hpp"

#include "reference/clause_literal.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"

#include <algorithm>

namespace gonogo::reference::rs274 {
namespace {

// Puts traverses one behind the other.
class Way {
 public:
  explicit Way(const BlockContext& block)
      : line_(block.line), axes_(axes_of(block.machine.plane)), at_(block.machine.position) {}

  const Number& level() const { return at_[axes_.d]; }
  void to_level(const Number& level, ClauseId clause) {
    Position to = at_;
    to[axes_.d] = level;
    traverse(to, {axes_.d}, clause);
  }
  // At the level where the tool is.
  void across(const Position& hole, ClauseId clause) {
    Position to = hole;
    to[axes_.d] = at_[axes_.d];
    traverse(to, {axes_.p, axes_.q}, clause);
  }
  // All axes together.
  void slanting(const Position& hole, const Number& level, ClauseId clause) {
    Position to = hole;
    to[axes_.d] = level;
    traverse(to, {axes_.p, axes_.q, axes_.d}, clause);
  }
  void end_lift() { approach_.lifts = approach_.traverses.size(); }
  Approach take() { return std::move(approach_); }

 private:
  void traverse(const Position& to, AxisSet named, ClauseId clause) {
    if (to == at_) return;
    Record record = record_of(RecordKind::rapid, line_, clause);
    record.axes = named;
    record.to = at_ = to;
    approach_.traverses.push_back(std::move(record));
  }

  std::uint64_t line_;
  PlaneAxes axes_;
  Position at_;
  Approach approach_;
};

// NGC-CYC-11: up to R where the tool is below it. NGC-CYC-12: across at that level, and down to R.
Approach at_current_level(const HoleAhead& ahead) {
  const Number& r = ahead.r_plane();
  Way way(ahead.block);
  if (decided("NGC-CYC-11"_clause, "tool - R", way.level(), r) < 0)
    way.to_level(r, "NGC-CYC-11"_clause);
  way.end_lift();
  way.across(ahead.hole, "NGC-CYC-12"_clause);
  way.to_level(r, "NGC-CYC-12"_clause);
  return way.take();
}

// ngc.cycle.approach = initial-level: the initial level decides, not where the tool is. `initial`
// is I0, `clear` C.
Approach at_initial_level(const HoleAhead& ahead, const Number& initial, const Number& clear) {
  const Number& r = ahead.r_plane();
  Way way(ahead.block);
  if (decided("NGC-CYC-11"_clause, "initial - R", initial, r) < 0)
    way.to_level(r, "NGC-CYC-11"_clause);
  way.end_lift();
  if (decided("NGC-CYC-12"_clause, "tool - R", way.level(), r) > 0) {
    way.across(ahead.hole, "NGC-CYC-12"_clause);
  } else {
    way.slanting(ahead.hole, clear, "NGC-CYC-12"_clause);
  }
  way.to_level(r, "NGC-CYC-12"_clause);
  return way.take();
}

// NGC-CYC-10: whether the clear level is I0 where that is above R, and may be.
bool returns_above_r(const HoleAhead& ahead) {
  const BlockContext& block = ahead.block;
  const bool is_never_above =
      ahead.initial.always([&](const Number& initial) { return initial <= ahead.r_plane(); });
  if (is_never_above) return false;
  const Retract said = block.machine.retract;
  if (said != Retract::unsaid) return said == Retract::initial_level;
  return block.readings.is("ngc.cycle.retract-start=initial"_reading);
}

// The way of ngc.cycle.approach = initial-level as a function of I0.
auto by_initial_level(const HoleAhead& ahead) {
  return [&ahead, rises = returns_above_r(ahead)](const Number& initial) {
    const Number& r = ahead.r_plane();
    return at_initial_level(ahead, initial, rises ? max(initial, r) : r);
  };
}

}  // namespace

bool operator==(const Approach& a, const Approach& b) {
  return a.lifts == b.lifts &&
         std::ranges::equal(a.traverses, b.traverses, {}, &Record::to, &Record::to);
}

// NGC-CYC-10
Number clear_level(const HoleAhead& ahead) {
  const Number& r = ahead.r_plane();
  if (!returns_above_r(ahead)) return r;
  return ahead.initial.of([&](const Number& initial) { return max(initial, r); });
}

Approach approach(const HoleAhead& ahead) {
  Approach usual = at_current_level(ahead);
  const auto other = by_initial_level(ahead);
  const bool alike =
      ahead.initial.always([&](const Number& initial) { return other(initial) == usual; });
  if (alike || !ahead.block.readings.is("ngc.cycle.approach=initial-level"_reading)) {
    return usual;
  }
  return ahead.initial.of(other);
}

bool always_approached(const HoleAhead& ahead, bool (*holds)(const Approach&)) {
  if (!holds(at_current_level(ahead))) return false;
  const auto other = by_initial_level(ahead);
  return ahead.initial.always([&](const Number& initial) { return holds(other(initial)); });
}

}  // namespace gonogo::reference::rs274
