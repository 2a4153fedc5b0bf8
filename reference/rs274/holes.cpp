// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/holes.hpp"

#include "reference/clause_literal.hpp"
#include "reference/rs274/idle.hpp"
#include "reference/rs274/m_functions.hpp"

namespace gonogo::reference::rs274 {

std::array<Number, 2> Holes::place(const Number& k) const {
  if (polar) return polar->after(k).in_xy();
  return {first[0] + (k - 1) * step[0], first[1] + (k - 1) * step[1]};
}

Record Holes::along(RecordKind kind, ClauseId clause, const Number& level) const {
  Record record = record_of(kind, line, clause);
  record.axes.add(axes.d);
  record.to[axes.d] = level;
  return record;
}

Record Holes::rapid(ClauseId clause, const Number& level) const {
  return along(RecordKind::rapid, clause, level);
}

Record Holes::feed(ClauseId clause, const Number& level) const {
  Record record = along(RecordKind::feed, clause, level);
  record.feed = feed_in_force;
  record.feed_mode = feed_mode;
  return record;
}

Record Holes::dwell(ClauseId clause) const {
  Record record = record_of(RecordKind::dwell, line, clause);
  record.seconds = dwell_time;
  return record;
}

Record Holes::spindle_function(ClauseId clause, int m) const {
  return function_record(line, clause, m);
}

namespace {

// NGC-CYC-13, NGC-CYC-14: from one hole to the next, at the level on which the tool is.
Record across(const Holes& holes, const Number& k) {
  Record record = record_of(RecordKind::rapid, holes.line, "NGC-CYC-13"_clause);
  const std::array<Number, 2> place = holes.place(k);
  record.axes = {holes.axes.p, holes.axes.q};
  record.to[holes.axes.p] = place[0];
  record.to[holes.axes.q] = place[1];
  return record;
}

Generator<Item> all_holes(Holes holes, Hole hole) {
  for (const Record& traverse : holes.approach) co_yield traverse;
  for (Number k = 1; k <= holes.count; k += 1) {
    if (k > 1) {
      co_yield across(holes, k);
      co_yield holes.rapid("NGC-CYC-14"_clause, holes.r_plane);
    }
    Generator<Item> records = hole(holes);
    while (const Item* item = records.next()) co_yield *item;
  }
}

}  // namespace

Generator<Item> run_holes(Holes holes, Hole hole) {
  const Position start = holes.start;
  return without_idle(all_holes(std::move(holes), std::move(hole)), start);
}

}  // namespace gonogo::reference::rs274
