// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps of thread milling left out, done otherwise, too many, or with an excursion.
#include <array>
#include <cmath>

#include "operator.hpp"

namespace gonogo::mutations {
namespace {

using reference::Axis;
using reference::PlaneAxes;
using reference::Position;

// What a record of a thread is, by its clause and where it leads.
enum class Step : std::uint8_t { other, entry, infeed, helix, run_out, back, away };

Step step_of(const Edit& edit, std::size_t number) {
  const Record& record = edit.right(number);
  const std::string_view clause = reference::clause_name(record.clause);
  if (clause == "GSK-G114-11") return Step::run_out;
  if (clause != "GSK-G114-06") return Step::other;
  if (record.kind == RecordKind::feed) return Step::infeed;
  const auto words = edit.cutting_words(number);
  const PlaneAxes axes = axes_of(words ? words->plane : record.plane);
  if (record.kind == RecordKind::arc) {
    return record.axes.has(axes_of(record.plane).d) ? Step::helix : Step::entry;
  }
  return record.axes.has(axes.d) ? Step::back : Step::away;
}

std::optional<std::size_t> any_step(Edit& edit, Step step) {
  return edit.any([&](std::size_t i) {
    return step_of(edit, i) == step && edit.size_of(i) > 8 * edit.specimen.tolerance();
  });
}

bool leave_out(Edit& edit, Step step) {
  const auto number = any_step(edit, step);
  if (!number || !edit.lead_next_to_its_end(*number)) return false;
  edit.erase(*number);
  return true;
}

// A traverse from the centre to the pass radius, without arc or infeed.
bool straight_in(Edit& edit) {
  const auto number = edit.any([&](std::size_t i) {
    return step_of(edit, i) == Step::entry && i + 1 < edit.specimen.right.records.size() &&
           step_of(edit, i + 1) == Step::infeed;
  });
  if (!number) return false;
  Record& record = edit.trace.records[*number];
  record.kind = RecordKind::rapid;
  record.axes = reference::kEveryAxis;
  record.to = edit.specimen.after[*number + 1];
  edit.erase(*number + 1);
  return true;
}

// The run-out straight on to a place that is so many times as far.
bool run_out_by(Edit& edit, const Number& factor) {
  const auto number = any_step(edit, Step::run_out);
  if (!number) return false;
  Record& record = edit.trace.records[*number];
  Position to = edit.specimen.after[*number];
  for (const Axis axis : reference::kLinearAxes) {
    const Number& from = edit.specimen.before[*number][axis];
    to[axis] = from + (to[axis] - from) * factor;
  }
  record.kind = RecordKind::feed;
  record.axes = reference::kEveryAxis;
  record.to = to;
  return true;
}

// Away from the thread at its bottom, where J is 0 or has been used up.
bool run_out_too_many(Edit& edit) {
  const auto number = edit.any([&](std::size_t i) { return step_of(edit, i) == Step::back; });
  if (!number) return false;
  const auto words = edit.cutting_words(*number);
  if (!words || words->kind != RecordKind::arc) return false;
  const PlaneAxes axes = axes_of(words->plane);
  Position aside = edit.specimen.before[*number];
  for (const bool second : {false, true}) {
    const Axis axis = second ? axes.q : axes.p;
    aside[axis] += (aside[axis] - words->centre[second ? 1 : 0]) / 4;
  }
  const Record out = edit.cut_to(*words, edit.right(*number).block, aside);
  Record& up = edit.trace.records[*number];
  up.axes = reference::kEveryAxis;
  up.to = aside;
  up.to[axes.d] = edit.specimen.after[*number][axes.d];
  edit.lead_next_to_its_end(*number);
  edit.insert(*number, out);
  return true;
}

// A second thread on the way back, with the hand of the first or the other.
bool helix_on_the_way_back(Edit& edit) {
  const auto number = any_step(edit, Step::back);
  if (!number) return false;
  std::size_t helix = *number;
  while (helix > 0 && step_of(edit, helix) != Step::helix) --helix;
  if (step_of(edit, helix) != Step::helix) return false;
  Record up = edit.right(helix);
  up.axes = reference::kEveryAxis;
  up.to = edit.specimen.after[*number];
  if (edit.chance.once_in(2)) up.rot = -up.rot;
  const PlaneAxes axes = axes_of(up.plane);
  const double radius =
      plane_radius(axes, place_of(up.to), {value_of(up.centre[0]), value_of(up.centre[1])});
  if (radius < 0.1) return false;
  edit.trace.records[*number] = up;
  return true;
}

// All of one pass but its helix's neighbours: a pass less than P and Q order.
bool no_pass(Edit& edit) {
  const auto number = any_step(edit, Step::helix);
  if (!number) return false;
  std::size_t begin = *number;
  while (begin > 0 &&
         (step_of(edit, begin - 1) == Step::infeed || step_of(edit, begin - 1) == Step::entry)) {
    --begin;
  }
  std::size_t end = *number + 1;
  while (end < edit.specimen.right.records.size() && step_of(edit, end) != Step::other &&
         step_of(edit, end) != Step::infeed && step_of(edit, end) != Step::entry) {
    ++end;
  }
  edit.replace(begin, end);
  return true;
}

// The entry by a far place, and a straight infeed from there.
bool entry_from_afar(Edit& edit) {
  const auto number = any_step(edit, Step::entry);
  if (!number || *number + 1 >= edit.trace.records.size()) return false;
  static const std::array<std::int64_t, 3> kFar = {100, 300, 5'000};
  Record& arc = edit.trace.records[*number];
  const PlaneAxes axes = axes_of(arc.plane);
  const Position& from = edit.specimen.before[*number];
  arc.axes = reference::kEveryAxis;
  arc.to = edit.specimen.after[*number];
  arc.to[axes.p] += Number(edit.chance.one_of(kFar));
  arc.centre = {(from[axes.p] + arc.to[axes.p]) / 2, (from[axes.q] + arc.to[axes.q]) / 2};
  return edit.lead_next_to_its_end(*number);
}

// The entry between its ends by most of a large circle, through the wall of a bore and far round a
// bolt.
bool entry_far_round(Edit& edit) {
  const auto number = any_step(edit, Step::entry);
  if (!number) return false;
  static const std::array<std::int64_t, 3> kTimes = {2, 5, 100};
  const Number times = edit.chance.one_of(kTimes);
  Record& arc = edit.trace.records[*number];
  const PlaneAxes axes = axes_of(arc.plane);
  const Position& from = edit.specimen.before[*number];
  const Position& to = edit.specimen.after[*number];
  // The centre is left of the chord as one goes clockwise the long way, else right.
  const Number side = arc.rot < 0 ? times : -times;
  arc.rot = arc.rot < 0 ? -1 : 1;
  arc.centre = {(from[axes.p] + to[axes.p]) / 2 - (to[axes.q] - from[axes.q]) * side,
                (from[axes.q] + to[axes.q]) / 2 + (to[axes.p] - from[axes.p]) * side};
  return true;
}

bool away_to(Edit& edit, const std::function<Number(const Number& from, const Number& to)>& place) {
  const auto number = any_step(edit, Step::away);
  const auto words = number ? edit.cutting_words(*number) : std::nullopt;
  if (!words || words->kind != RecordKind::arc) return false;
  const PlaneAxes axes = axes_of(words->plane);
  Record& away = edit.trace.records[*number];
  const Number& centre = words->centre[0];
  away.axes = reference::kEveryAxis;
  away.to = edit.specimen.after[*number];
  away.to[axes.p] = centre + place(edit.specimen.before[*number][axes.p] - centre,
                                   edit.specimen.after[*number][axes.p] - centre);
  return edit.lead_next_to_its_end(*number);
}

bool away_too_far(Edit& edit) {
  static const std::array<std::int64_t, 3> kFar = {50, 300, 5'000};
  const Number far = edit.chance.one_of(kFar);
  return away_to(
      edit, [&](const Number&, const Number& to) { return to.sign() < 0 ? to - far : to + far; });
}

bool away_across(Edit& edit) {
  return away_to(edit, [](const Number& from, const Number& to) {
    return from.sign() < 0 ? abs(to) : -abs(to);
  });
}

// The run-out leads up to the R plane while it leads out.
bool run_out_rises(Edit& edit) {
  const auto number = any_step(edit, Step::run_out);
  if (!number || *number + 1 >= edit.trace.records.size()) return false;
  if (step_of(edit, *number + 1) != Step::back) return false;
  Record& record = edit.trace.records[*number];
  const auto words = edit.cutting_words(*number);
  const Axis depth = axes_of(words ? words->plane : record.plane).d;
  record.axes = reference::kEveryAxis;
  record.to = edit.specimen.after[*number];
  const Number& low = edit.specimen.before[*number][depth];
  const Number& high = edit.specimen.after[*number + 1][depth];
  record.to[depth] = edit.chance.once_in(2) ? high : (low + high) / 2;
  return true;
}

// Half the way up the tool swings out and in again.
bool way_back_swings(Edit& edit) {
  const auto number = any_step(edit, Step::back);
  const auto words = number ? edit.cutting_words(*number) : std::nullopt;
  if (!words || words->kind != RecordKind::arc) return false;
  const PlaneAxes axes = axes_of(words->plane);
  Position aside = edit.specimen.before[*number];
  aside[axes.d] = (aside[axes.d] + edit.specimen.after[*number][axes.d]) / 2;
  aside[axes.q] += Number(edit.chance.once_in(2) ? 1 : 1'000);
  Record out = edit.motion_to(RecordKind::rapid, edit.right(*number).block, aside);
  Record& back = edit.trace.records[*number];
  back.axes = reference::kEveryAxis;
  back.to = edit.specimen.after[*number];
  edit.insert(*number, out);
  return true;
}

}  // namespace

std::vector<Operator> thread_operators() {
  return {
      {"no-entry", "a thread is entered without its arc",
       [](Edit& edit) { return leave_out(edit, Step::entry); }},
      {"no-infeed", "a pass lacks its infeed",
       [](Edit& edit) { return leave_out(edit, Step::infeed); }},
      {"straight-in", "a traverse from the centre to the pass radius", straight_in},
      {"no-helix", "a pass lacks its helix",
       [](Edit& edit) { return leave_out(edit, Step::helix); }},
      {"no-pass", "a pass is missing", no_pass},
      {"no-run-out", "the run-out is missing",
       [](Edit& edit) { return leave_out(edit, Step::run_out); }},
      {"long-run-out", "the run-out is three times as long",
       [](Edit& edit) { return run_out_by(edit, 3); }},
      {"run-out-to-the-other-side", "the run-out leads into the thread",
       [](Edit& edit) { return run_out_by(edit, -1); }},
      {"run-out-too-many", "a run-out more", run_out_too_many},
      {"helix-on-the-way-back", "a second thread on the way back", helix_on_the_way_back},
      {"no-way-back", "the tool leaves the thread across it",
       [](Edit& edit) { return leave_out(edit, Step::back); }},
      {"no-way-to-safety", "the safe position is left out",
       [](Edit& edit) { return leave_out(edit, Step::away); }},
      {"entry-from-afar", "the entry ends far out, the infeed begins there", entry_from_afar},
      {"entry-far-round", "the entry goes round most of a large circle", entry_far_round},
      {"away-too-far", "the safe position is far out", away_too_far},
      {"away-across", "the way to the safe position crosses the part", away_across},
      {"run-out-rises", "the run-out rises at full depth", run_out_rises},
      {"way-back-swings", "the way back leads aside and in again", way_back_swings},
  };
}

}  // namespace gonogo::mutations
