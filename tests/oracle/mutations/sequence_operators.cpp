// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions dropped, repeated, in another order, the other way round, or too many.
#include <algorithm>

#include "operator.hpp"

namespace gonogo::mutations {
namespace {

using reference::Axis;
using reference::kLinearAxes;
using reference::Position;

// All that follows lies where it lay: the next motion takes the short cut.
bool drop_and_cut_short(Edit& edit) {
  const auto number = edit.any_motion();
  if (!number || !edit.lead_next_to_its_end(*number)) return false;
  edit.erase(*number);
  return true;
}

void drop_several(Edit& edit, std::size_t number) {
  const std::size_t count = 2 + edit.chance.below(4);
  for (std::size_t i = 0; i < count; ++i) {
    if (number < edit.trace.records.size() && is_motion(edit.trace.records[number].kind)) {
      edit.erase(number);
    }
  }
}

void drop_block(Edit& edit, std::size_t number) {
  const std::uint64_t block = edit.right(number).block;
  std::erase_if(edit.trace.records, [&](const Record& record) {
    return is_motion(record.kind) && record.block == block;
  });
}

// A motion back to its start before it is made again.
Record way_back(Edit& edit, std::size_t number) {
  Record back = edit.right(number);
  back.axes = reference::kEveryAxis;
  back.to = edit.specimen.before[number];
  if (back.kind == RecordKind::arc) back.rot = -back.rot;
  return back;
}

void repeat_there_and_back(Edit& edit, std::size_t number) {
  Record again = edit.right(number);
  again.axes = reference::kEveryAxis;
  again.to = edit.specimen.after[number];
  edit.insert(number + 1, again);
  edit.insert(number + 1, way_back(edit, number));
}

bool swap_two(Edit& edit) {
  const auto number = edit.any([&](std::size_t i) {
    return i + 1 < edit.specimen.right.records.size() && is_motion(edit.right(i).kind) &&
           is_motion(edit.right(i + 1).kind);
  });
  if (!number) return false;
  std::swap(edit.trace.records[*number], edit.trace.records[*number + 1]);
  return true;
}

// To the end of a motion first, then back along it, then on.
bool reverse(Edit& edit) {
  const auto number = edit.any_motion();
  if (!number || !edit.lead_next_to_its_end(*number)) return false;
  Record& record = edit.trace.records[*number];
  record.axes = reference::kEveryAxis;
  record.to = edit.specimen.before[*number];
  if (record.kind == RecordKind::arc) record.rot = -record.rot;
  Record there = edit.motion_to(RecordKind::rapid, record.block, edit.specimen.after[*number]);
  edit.insert(*number, there);
  return true;
}

// Several motions of one block, from the last to the first.
bool reverse_run(Edit& edit) {
  const auto number = edit.any_motion();
  if (!number) return false;
  std::size_t end = *number;
  const std::uint64_t block = edit.right(*number).block;
  while (end < edit.specimen.right.records.size() && is_motion(edit.right(end).kind) &&
         edit.right(end).block == block) {
    ++end;
  }
  if (end - *number < 2) return false;
  const auto first = edit.trace.records.begin() + static_cast<std::ptrdiff_t>(*number);
  std::reverse(first, edit.trace.records.begin() + static_cast<std::ptrdiff_t>(end));
  return true;
}

// Away and back before a motion.
bool excursion(Edit& edit, RecordKind kind) {
  const auto number = edit.any_motion();
  if (!number) return false;
  const std::uint64_t block = edit.right(*number).block;
  Position aside = edit.specimen.before[*number];
  Position here = aside;
  aside[edit.chance.one_of(kLinearAxes)] += edit.off();
  Record there = edit.motion_to(kind, block, aside);
  Record back = edit.motion_to(kind, block, here);
  if (kind != RecordKind::rapid) {
    const auto words = edit.cutting_words(*number);
    if (!words) return false;
    there.feed = back.feed = words->feed;
    there.feed_mode = back.feed_mode = words->feed_mode;
  }
  edit.insert(*number, back);
  edit.insert(*number, there);
  return true;
}

// Back along the depth axis, as a cut where something cuts.
bool extra_plunge(Edit& edit) {
  const auto number = edit.any_motion();
  if (!number) return false;
  const auto words = edit.cutting_words(*number);
  if (!words) return false;
  const Axis depth = words->kind == RecordKind::arc ? axes_of(words->plane).d : Axis::z;
  Record down = edit.cut_to(*words, edit.right(*number).block, edit.specimen.before[*number]);
  Record up = down;
  down.to[depth] -= Number(1);
  edit.insert(*number, up);
  edit.insert(*number, down);
  return true;
}

void motion_at_the_end(Edit& edit, std::size_t /*number*/) {
  std::size_t last = edit.specimen.right.records.size();
  while (!is_motion(edit.right(last - 1).kind)) --last;
  Position to = edit.specimen.after[last - 1];
  to[edit.chance.one_of(kLinearAxes)] += edit.off();
  edit.insert(last, edit.motion_to(RecordKind::rapid, edit.right(last - 1).block, to));
}

void motion_behind_the_end(Edit& edit, std::size_t number) {
  Position to = edit.specimen.after[number];
  to[edit.chance.one_of(kLinearAxes)] += edit.off();
  edit.insert(number + 1, edit.motion_to(RecordKind::rapid, edit.right(number).block, to));
}

}  // namespace

std::vector<Operator> sequence_operators() {
  return {
      {"drop", "a motion is missing", to_any_motion(&Edit::erase)},
      {"drop-and-cut-short", "a motion is left out", drop_and_cut_short},
      {"drop-several", "several motions are missing", to_any_motion(drop_several)},
      {"drop-block", "the motions of a block are missing", to_any_motion(drop_block)},
      {"cut-off", "the trace stops",
       to_any_motion([](Edit& edit, std::size_t i) { edit.trace.records.resize(i); })},
      {"repeat", "a motion comes twice",
       to_any_motion([](Edit& edit, std::size_t i) { edit.insert(i + 1, edit.right(i)); })},
      {"repeat-there-and-back", "a motion is made, taken back and made again",
       to_any_motion(repeat_there_and_back)},
      {"swap-two", "two motions change places", swap_two},
      {"reverse", "a motion is made from its end to its start", reverse},
      {"reverse-run", "motions come from the last to the first", reverse_run},
      {"excursion-as-traverse", "away and back",
       [](Edit& edit) { return excursion(edit, RecordKind::rapid); }},
      {"excursion-as-cut", "away and back, cutting",
       [](Edit& edit) { return excursion(edit, RecordKind::feed); }},
      {"extra-plunge", "down and up again", extra_plunge},
      {"motion-at-the-end", "a motion more", to_any_motion(motion_at_the_end)},
      {"motion-behind-the-end", "a motion behind the end",
       to_any(RecordKind::end, motion_behind_the_end)},
  };
}

}  // namespace gonogo::mutations
