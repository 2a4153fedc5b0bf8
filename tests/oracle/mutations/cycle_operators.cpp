// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps of pockets left out, done otherwise, or too many.
#include <algorithm>
#include <cmath>

#include "operator.hpp"
#include "reference/sinumerik/lcyc75.hpp"

namespace gonogo::mutations {
namespace {

using reference::Axis;
using reference::PlaneAxes;
using reference::Position;

double way(const Edit& edit, std::size_t number, Axis axis) {
  return std::abs(value_of(edit.specimen.after[number][axis] - edit.specimen.before[number][axis]));
}

bool is_level_cut(const Edit& edit, std::size_t i) {
  return reference::clause_name(edit.right(i).clause) == "GSK-G110-09";
}

// The first and the one behind the last record of any level of G110.
std::optional<std::pair<std::size_t, std::size_t>> any_level(Edit& edit) {
  const auto first = edit.any([&](std::size_t i) {
    return is_level_cut(edit, i) && (i == 0 || !is_level_cut(edit, i - 1));
  });
  if (!first) return std::nullopt;
  std::size_t end = *first;
  while (end < edit.specimen.right.records.size() && is_level_cut(edit, end)) ++end;
  return std::pair{*first, end};
}

bool no_level(Edit& edit) {
  const auto level = any_level(edit);
  if (!level) return false;
  edit.replace(level->first, level->second);
  return true;
}

// The same circles about the same centres, from the wall to the middle.
bool clear_inwards(Edit& edit) {
  const auto level = any_level(edit);
  if (!level || level->second - level->first < 3) return false;
  const auto [begin, end] = *level;
  const Record& last = edit.right(end - 1);
  std::vector<Record> inwards;
  inwards.push_back(edit.cut_to(last, last.block, edit.specimen.before[end - 1]));
  for (std::size_t i = end; i-- > begin;) {
    Record record = edit.right(i);
    record.axes = reference::kEveryAxis;
    record.to = edit.specimen.before[i];
    inwards.push_back(record);
  }
  edit.replace(begin, end, inwards);
  return true;
}

// A cut from the centre to the wall and back before the level is cleared.
bool through_solid(Edit& edit) {
  const auto level = any_level(edit);
  if (!level || level->second - level->first < 4) return false;
  const auto [begin, end] = *level;
  const Record& last = edit.right(end - 1);
  const Record out = edit.cut_to(last, last.block, edit.specimen.before[end - 1]);
  Record back = out;
  back.to = edit.specimen.before[begin];
  edit.insert(begin, back);
  edit.insert(begin, out);
  return true;
}

// An inner arc of a level left out: what follows begins where it began.
bool island(Edit& edit) {
  const auto level = any_level(edit);
  if (!level || level->second - level->first < 4) return false;
  const std::size_t at = level->first + edit.chance.below(level->second - level->first - 2);
  edit.erase(at);
  return true;
}

bool no_finishing_circle(Edit& edit) {
  const auto level = any_level(edit);
  if (!level) return false;
  edit.erase(level->second - 1);
  return true;
}

// The traverses with which a cycle begins.
bool no_approach(Edit& edit) {
  const auto number = edit.any([&](std::size_t i) {
    const bool begins = i > 0 && edit.right(i - 1).block != edit.right(i).block;
    const bool goes_on = i + 1 < edit.specimen.right.records.size() &&
                         edit.right(i + 1).block == edit.right(i).block;
    return edit.right(i).kind == RecordKind::rapid && begins && goes_on;
  });
  if (!number) return false;
  const std::uint64_t block = edit.right(*number).block;
  while (*number < edit.trace.records.size() && edit.trace.records[*number].block == block &&
         edit.trace.records[*number].kind == RecordKind::rapid) {
    edit.erase(*number);
  }
  return true;
}

const reference::PocketMilling* any_pocket(Edit& edit, std::size_t& begin, std::size_t& end) {
  const auto number =
      edit.any([&](std::size_t i) { return edit.specimen.part[i] == PartKind::pocket_milling; });
  if (!number) return nullptr;
  const std::size_t part = edit.specimen.part_number[*number];
  begin = end = *number;
  const auto belongs = [&](std::size_t i) {
    return edit.specimen.part[i] == PartKind::pocket_milling &&
           edit.specimen.part_number[i] == part;
  };
  while (begin > 0 && belongs(begin - 1)) --begin;
  while (end < edit.specimen.right.records.size() && belongs(end)) ++end;
  return &std::get<reference::PocketMilling>(edit.specimen.items[part]);
}

// Up above R101 and back as a cut, before the tool plunges.
bool cut_above_retract(Edit& edit) {
  std::size_t begin = 0;
  std::size_t end = 0;
  const reference::PocketMilling* pocket = any_pocket(edit, begin, end);
  if (pocket == nullptr) return false;
  const Axis depth = axes_of(pocket->plane).d;
  Record up = edit.motion_to(RecordKind::feed, pocket->block, edit.specimen.before[begin]);
  up.feed = edit.chance.once_in(2) ? pocket->depth_feed : pocket->plane_feed;
  up.feed_mode = pocket->feed_mode;
  Record back = up;
  up.to[depth] = pocket->retract + Number(20);
  edit.insert(begin, back);
  edit.insert(begin, up);
  return true;
}

// A level that is not cleared: two infeeds at once, or a floor that is left.
bool no_pocket_level(Edit& edit) {
  std::size_t begin = 0;
  std::size_t end = 0;
  const reference::PocketMilling* pocket = any_pocket(edit, begin, end);
  if (pocket == nullptr) return false;
  const Axis depth = axes_of(pocket->plane).d;
  std::vector<std::size_t> plunges;
  for (std::size_t i = begin; i < end; ++i) {
    if (way(edit, i, depth) > 0) plunges.push_back(i);
  }
  if (plunges.size() < 2) return false;
  const std::size_t which = edit.chance.below(plunges.size() - 1);
  edit.replace(plunges[which], plunges[which + 1]);
  return true;
}

// The floor milled where only the contour is to be finished.
bool floor_with_the_contour(Edit& edit) {
  std::size_t begin = 0;
  std::size_t end = 0;
  const reference::PocketMilling* found = any_pocket(edit, begin, end);
  if (found == nullptr || !found->contour_only) return false;
  reference::PocketMilling pocket = *found;
  pocket.contour_only = false;
  std::vector<Record> records;
  auto path = reference::sinumerik::contour_parallel(pocket);
  while (const reference::Item* item = path.next()) records.push_back(std::get<Record>(*item));
  edit.replace(begin, end, records);
  return true;
}

// The plunge of a level beside the centre.
bool plunge_aside(Edit& edit) {
  std::size_t begin = 0;
  std::size_t end = 0;
  const reference::PocketMilling* pocket = any_pocket(edit, begin, end);
  if (pocket == nullptr || begin == 0) return false;
  const PlaneAxes axes = axes_of(pocket->plane);
  Record aside = edit.motion_to(RecordKind::rapid, pocket->block, edit.specimen.before[begin]);
  aside.to[axes.p] += Number::millionths(100'000);
  Record& plunge = edit.trace.records[begin];
  plunge.axes = reference::kEveryAxis;
  plunge.to = edit.specimen.after[begin];
  plunge.to[axes.p] = aside.to[axes.p];
  edit.lead_next_to_its_end(begin);
  edit.insert(begin, aside);
  return true;
}

}  // namespace

std::vector<Operator> cycle_operators() {
  return {
      {"no-approach", "a cycle begins without its traverses", no_approach},
      {"no-level", "a level is not cleared", no_level},
      {"clear-inwards", "a level is cleared from the wall to the middle", clear_inwards},
      {"through-solid", "a cut to the wall before the level is cleared", through_solid},
      {"island", "an inner arc of a level is missing", island},
      {"no-finishing-circle", "the circle along the wall is missing", no_finishing_circle},
      {"cut-above-retract", "a cut above R101 before the plunge", cut_above_retract},
      {"no-pocket-level", "a level of LCYC75 is missing", no_pocket_level},
      {"floor-with-the-contour", "the floor is milled with the contour alone due",
       floor_with_the_contour},
      {"plunge-aside", "a plunge beside the centre", plunge_aside},
  };
}

}  // namespace gonogo::mutations
