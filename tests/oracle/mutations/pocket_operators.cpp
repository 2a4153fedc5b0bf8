// SPDX-License-Identifier: GPL-3.0-or-later
//
// What goes wrong in pockets: the way round in pieces, turns over and over, excursions, a traverse
// onto the floor.
#include <cmath>
#include <numbers>

#include "alternative.hpp"
#include "operator.hpp"

namespace gonogo::mutations {
namespace {

using reference::Axis;
using reference::PlaneAxes;
using reference::Position;
using std::numbers::pi;

bool is_in_pocket(const Edit& edit, std::size_t i) {
  const PartKind part = edit.specimen.part[i];
  return part == PartKind::level || part == PartKind::pocket_milling;
}

// An arc of a pocket, of a radius that is seen.
std::optional<std::size_t> any_pocket_arc(Edit& edit) {
  return edit.any([&](std::size_t i) {
    return is_in_pocket(edit, i) && edit.right(i).kind == RecordKind::arc && edit.size_of(i) > 0.5;
  });
}

bool turns_in_one_record(Edit& edit) {
  const auto number = any_pocket_arc(edit);
  if (!number) return false;
  static const std::array<std::int32_t, 3> kTurns = {20, 5'000, 1'000'000'000};
  std::int32_t& rot = edit.trace.records[*number].rot;
  rot = (rot < 0 ? -1 : 1) * edit.chance.one_of(kTurns);
  return true;
}

bool rings_over_and_over(Edit& edit) {
  const auto number = any_pocket_arc(edit);
  if (!number) return false;
  Record full = edit.right(*number);
  full.axes = reference::kEveryAxis;
  full.to = edit.specimen.after[*number];
  full.rot = full.rot < 0 ? -1 : 1;
  const std::size_t times = 15 + edit.chance.below(50);
  for (std::size_t k = 0; k < times; ++k) edit.insert(*number + 1, full);
  return true;
}

// The ring about the middle that a level ends with, in arcs that each turn as they should and lead
// the other way round: their centres lie outside.
bool ring_back_in_pieces(Edit& edit) {
  const auto number = edit.any([&](std::size_t i) {
    const bool closes = edit.specimen.before[i] == edit.specimen.after[i];
    return edit.specimen.part[i] == PartKind::level && edit.right(i).kind == RecordKind::arc &&
           closes && edit.size_of(i) > 0.5;
  });
  if (!number) return false;
  static const std::array<int, 4> kPieces = {5, 40, 130, 260};
  static const std::array<double, 3> kFarther = {1.5, 8, 70};
  const Record ring = edit.right(*number);
  const PlaneAxes axes = axes_of(ring.plane);
  const Position& start = edit.specimen.before[*number];
  const double p = value_of(start[axes.p] - ring.centre[0]);
  const double q = value_of(start[axes.q] - ring.centre[1]);
  const int pieces = edit.chance.one_of(kPieces);
  const double angle = (ring.rot < 0 ? 1 : -1) * 2 * pi / pieces;
  const double farther = edit.chance.one_of(kFarther);
  const auto turned = [&](double by, double scale) {
    return std::array<Number, 2>{
        ring.centre[0] + number_near(scale * (p * std::cos(by) - q * std::sin(by))),
        ring.centre[1] + number_near(scale * (p * std::sin(by) + q * std::cos(by)))};
  };
  edit.erase(*number);
  for (int k = pieces; k >= 1; --k) {
    Record arc = ring;
    arc.axes = reference::kEveryAxis;
    arc.to = start;
    if (k < pieces) {
      const auto to = turned(angle * k, 1);
      arc.to[axes.p] = to[0];
      arc.to[axes.q] = to[1];
    }
    arc.centre = turned(angle * (k - 0.5), farther);
    edit.insert(*number, arc);
  }
  return true;
}

const reference::PocketMilling* pocket_of(const Edit& edit, std::size_t number) {
  if (edit.specimen.part[number] != PartKind::pocket_milling) return nullptr;
  return &std::get<reference::PocketMilling>(
      edit.specimen.items[edit.specimen.part_number[number]]);
}

// There and back before a motion along the depth axis: before the first infeed, between levels, on
// the way out.
bool there_and_back(Edit& edit, std::size_t number, const Position& there) {
  Record out = edit.motion_to(RecordKind::rapid, edit.right(number).block, there);
  edit.insert(number, edit.motion_to(RecordKind::rapid, out.block, edit.specimen.before[number]));
  edit.insert(number, out);
  return true;
}

bool is_along_depth(const Edit& edit, std::size_t i) {
  const reference::PocketMilling* pocket = pocket_of(edit, i);
  if (pocket == nullptr) return false;
  const Axis d = axes_of(pocket->plane).d;
  return edit.specimen.before[i][d] != edit.specimen.after[i][d];
}

bool pocket_excursion(Edit& edit) {
  const auto number = edit.any([&](std::size_t i) { return is_along_depth(edit, i); });
  if (!number) return false;
  Position there = edit.specimen.before[*number];
  there[axes_of(pocket_of(edit, *number)->plane).p] +=
      Number(edit.chance.once_in(2) ? 5'000 : -300);
  return there_and_back(edit, *number, there);
}

bool traverse_onto_the_floor(Edit& edit) {
  const auto number = edit.any([&](std::size_t i) {
    const reference::PocketMilling* pocket = pocket_of(edit, i);
    return is_along_depth(edit, i) && pocket->finishing &&
           pocket->reference_plane - pocket->rough_floor > edit.times_tolerance(20);
  });
  if (!number) return false;
  const reference::PocketMilling& pocket = *pocket_of(edit, *number);
  const Axis d = axes_of(pocket.plane).d;
  Position there = edit.specimen.before[*number];
  if (there[d] <= pocket.rough_floor) return false;
  there[d] = pocket.rough_floor;
  return there_and_back(edit, *number, there);
}

}  // namespace

std::vector<Operator> pocket_operators() {
  return {
      {"turns-in-one-record", "an arc of a pocket turns over and over", turns_in_one_record},
      {"rings-over-and-over", "a ring of a pocket is milled over and over", rings_over_and_over},
      {"ring-back-in-pieces", "a ring the other way round in arcs that turn as they should",
       ring_back_in_pieces},
      {"pocket-excursion", "metres away beside a pocket of LCYC75", pocket_excursion},
      {"traverse-onto-the-floor", "of finishing, a traverse to the floor that roughing left",
       traverse_onto_the_floor},
  };
}

}  // namespace gonogo::mutations
