// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/label.hpp"

namespace gonogo::relation {

using reference::Record;
using reference::RecordKind;

Label label_of(const Record& motion, bool is_flat, const Tolerances& tolerances) {
  Label label;
  label.kind = motion.kind == RecordKind::arc3 ? RecordKind::arc : motion.kind;
  label.is_flat = is_flat;
  if (tolerances.compare_blocks) label.block = motion.block;
  if (motion.kind == RecordKind::thread) {
    label.lead = motion.lead;
    label.start = motion.start;
  } else if (motion.kind != RecordKind::rapid) {
    label.feed = motion.feed;
    label.feed_mode = motion.feed_mode;
  }
  label.finds_centre = motion.centre_clause != reference::kNoClause;
  return label;
}

namespace {

constexpr int kBitsOfLabel = 64;

// Whether two numbers are surely farther apart than that.
bool are_apart(const Number& a, const Number& b, const Number& most) {
  const auto [low_a, high_a] = a.bounds(kBitsOfLabel);
  const auto [low_b, high_b] = b.bounds(kBitsOfLabel);
  return low_a - high_b > most || low_b - high_a > most;
}

bool is_same(const Number& a, const Number& b) {
  return !are_apart(a, b, 0);
}

// Half of the last place that a decimal is written to, or of the least increment where that is
// finer; 0 where it is no decimal.
Number half_of_last_place(const Number& written, const Number& increment) {
  constexpr int kMostPlaces = 40;
  Number step = 1;
  for (int place = 0; place < kMostPlaces && written.is_rational(); ++place) {
    const Number steps = written / step;
    if (steps == steps.floor()) return min(step, increment) / 2;
    step = step / 10;
  }
  return 0;
}

}  // namespace

bool is_same(const Label& a, const Label& b) {
  return a.kind == b.kind && a.block == b.block && a.feed_mode == b.feed_mode &&
         is_same(a.feed, b.feed) && is_same(a.lead, b.lead) && is_same(a.start, b.start);
}

bool agree(const Number& want, const Number& got, const std::optional<Number>& resolution,
           const Tolerances& tolerances) {
  // Two units in the last place of a double lie below 2^-51 of its value. A subject that declares
  // nothing of its numbers may have doubles.
  const bool may_be_double = tolerances.binary64 || (!tolerances.exact && !resolution);
  const Number last_places =
      may_be_double ? abs(want.bounds(kBitsOfLabel)[0]) * Number::binary(1, -51) : Number(0);
  const Number half = resolution ? *resolution / 2 : half_of_last_place(got, tolerances.increment);
  return !are_apart(want, got, max(half, last_places));
}

bool is_granted_chord(const Label& want, const Label& got, const Tolerances& tolerances) {
  return tolerances.chord.sign() > 0 && want.kind == RecordKind::arc &&
         got.kind == RecordKind::feed;
}

namespace {

bool is_same_kind(const Label& want, const Label& got, const Tolerances& tolerances) {
  if (want.kind == got.kind) return true;
  const bool line_for_arc = want.kind == RecordKind::arc && got.kind == RecordKind::feed;
  const bool arc_for_line = want.kind == RecordKind::feed && got.kind == RecordKind::arc;
  return (line_for_arc && want.is_flat) || (arc_for_line && got.is_flat) ||
         is_granted_chord(want, got, tolerances);
}

// A lead is a length and agrees as lengths do; so does the angle of a start, within a turn.
bool is_same_thread(const Label& want, const Label& got, const Tolerances& tolerances) {
  // Turns of it that the subject adds; where rounding tells, one more or less.
  const Number turns =
      ((got.start.bounds(kBitsOfLabel)[0] - want.start.bounds(kBitsOfLabel)[0]) / 360).floor();
  for (const int turn : {0, 1}) {
    const Number start = want.start + (turns + turn) * 360;
    if (!agree(start, got.start, tolerances.resolution, tolerances)) continue;
    return agree(want.lead, got.lead, tolerances.resolution, tolerances);
  }
  return false;
}

}  // namespace

Likeness compare(const Label& want, const Label& got, const Tolerances& tolerances) {
  if (!is_same_kind(want, got, tolerances) || want.block != got.block) return Likeness::other;
  const bool is_same_feed = want.feed_mode == got.feed_mode &&
                            agree(want.feed, got.feed, tolerances.feed_resolution, tolerances);
  return is_same_feed && is_same_thread(want, got, tolerances) ? Likeness::same : Likeness::number;
}

}  // namespace gonogo::relation
