// SPDX-License-Identifier: GPL-3.0-or-later
//
// The right places with other words: kinds, feeds, blocks, leads, planes.
#include "operator.hpp"

namespace gonogo::mutations {
namespace {

std::optional<std::size_t> any_cut(Edit& edit) {
  return edit.any([&](std::size_t i) {
    const RecordKind kind = edit.right(i).kind;
    return kind == RecordKind::feed || kind == RecordKind::arc || kind == RecordKind::arc3;
  });
}

void traverse_as_cut(Edit& edit, std::size_t number) {
  const auto words = edit.cutting_words(number);
  Record& record = edit.trace.records[number];
  record.kind = RecordKind::feed;
  record.feed = words ? words->feed : Number(100);
  if (words) record.feed_mode = words->feed_mode;
}

bool cut_as_traverse(Edit& edit) {
  const auto number = any_cut(edit);
  if (!number) return false;
  Record& record = edit.trace.records[*number];
  record.kind = RecordKind::rapid;
  record.axes = reference::kEveryAxis;
  record.to = edit.specimen.after[*number];
  return true;
}

bool change_feed(Edit& edit, const Number& factor, const Number& more) {
  const auto number = any_cut(edit);
  if (!number) return false;
  Number& feed = edit.trace.records[*number].feed;
  feed = feed * factor + more;
  return true;
}

bool other_feed_mode(Edit& edit) {
  const auto number = any_cut(edit);
  if (!number) return false;
  reference::FeedMode& mode = edit.trace.records[*number].feed_mode;
  mode = mode == reference::FeedMode::per_minute ? reference::FeedMode::per_revolution
                                                 : reference::FeedMode::per_minute;
  return true;
}

void other_lead(Edit& edit, std::size_t number) {
  edit.trace.records[number].lead += Number::millionths(100'000);
}

void other_start_angle(Edit& edit, std::size_t number) {
  edit.trace.records[number].start += edit.chance.once_in(2) ? Number(90) : Number(1);
}

// In two pieces, the second of which engages at another angle.
bool second_piece_elsewhere(Edit& edit) {
  const auto number = edit.any_of_kind(RecordKind::thread);
  if (!number || edit.size_of(*number) < 0.1) return false;
  Record first = edit.right(*number);
  for (const reference::Axis axis : reference::kAllAxes) {
    first.to[axis] = (edit.specimen.before[*number][axis] + edit.specimen.after[*number][axis]) / 2;
  }
  first.axes = reference::kEveryAxis;
  edit.trace.records[*number].start += edit.chance.once_in(2) ? Number(77) : Number(1);
  edit.insert(*number, first);
  return true;
}

void thread_as_cut(Edit& edit, std::size_t number) {
  Record& record = edit.trace.records[number];
  record.kind = RecordKind::feed;
  record.feed = record.lead;
  record.feed_mode = reference::FeedMode::per_revolution;
}

bool other_block(Edit& edit) {
  const auto number = edit.any(
      [&](std::size_t i) { return is_motion(edit.right(i).kind) && edit.right(i).block != 0; });
  if (!number) return false;
  Record& record = edit.trace.records[*number];
  record.block = edit.chance.once_in(2) && record.block > 1 ? record.block - 1 : record.block + 1;
  return true;
}

bool all_blocks_later(Edit& edit) {
  if (!edit.any_motion()) return false;
  for (Record& record : edit.trace.records) {
    if (record.block != 0) ++record.block;
  }
  if (edit.trace.end.kind == oracle::RunEnd::Kind::alarm) ++edit.trace.end.alarm.block;
  return true;
}

// The same numbers in another plane: the pair and the sense mean something else.
void other_plane(Edit& edit, std::size_t number) {
  Record& record = edit.trace.records[number];
  const std::size_t next = (static_cast<std::size_t>(record.plane) + 1 + edit.chance.below(2)) % 3;
  record.plane = static_cast<reference::Plane>(next);
  record.axes = reference::kEveryAxis;
  record.to = edit.specimen.after[number];
}

void swap_centre(Edit& edit, std::size_t number) {
  Record& record = edit.trace.records[number];
  std::swap(record.centre[0], record.centre[1]);
}

}  // namespace

std::vector<Operator> word_operators() {
  return {
      {"traverse-as-cut", "a traverse cuts", to_any(RecordKind::rapid, traverse_as_cut)},
      {"cut-as-traverse", "a cut is a traverse", cut_as_traverse},
      {"arc-as-line", "an arc is its chord",
       to_any(RecordKind::arc,
              [](Edit& edit, std::size_t i) { edit.trace.records[i].kind = RecordKind::feed; })},
      {"double-feed", "a feed is twice as fast",
       [](Edit& edit) { return change_feed(edit, 2, 0); }},
      {"faster-by-one", "a feed is faster by 1",
       [](Edit& edit) { return change_feed(edit, 1, 1); }},
      {"slightly-faster", "a feed is faster by 0.00001",
       [](Edit& edit) { return change_feed(edit, 1, Number::millionths(10)); }},
      {"other-feed-mode", "a feed a minute is one a revolution", other_feed_mode},
      {"other-lead", "a thread has another lead", to_any(RecordKind::thread, other_lead)},
      {"other-start-angle", "a thread begins at another spindle angle",
       to_any(RecordKind::thread, other_start_angle)},
      {"second-piece-elsewhere", "a thread goes on at another spindle angle",
       second_piece_elsewhere},
      {"thread-as-cut", "a thread is cut without the spindle",
       to_any(RecordKind::thread, thread_as_cut)},
      {"other-block", "a motion claims another block", other_block},
      {"all-blocks-later", "all claim the next block", all_blocks_later},
      {"other-plane", "an arc turns in another plane", to_any(RecordKind::arc, other_plane)},
      {"swap-centre", "the coordinates of a centre change places",
       to_any(RecordKind::arc, swap_centre)},
  };
}

}  // namespace gonogo::mutations
