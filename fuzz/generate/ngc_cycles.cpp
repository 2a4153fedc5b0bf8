// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cycles of holes: their codes, levels and places.
#include <fmt/format.h>

#include "fuzz/generate/ngc_writer.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::generate {

// Modes that count from their own block on. A first block changes them more often.
void NgcWriter::cycle_modes(Words& words, bool first) {
  if (first || choices_.one_in(3)) choose_plane(words);
  if (choices_.one_in(4)) set_incremental(words, choices_.one_in(2));
  if (choices_.one_in(retract_ == 0 ? 2 : 4)) {
    retract_ = choices_.pick({98, 99});
    words.push_back(code(retract_));
  }
}

// How far R lies above the tool.
std::int64_t NgcWriter::above_tool() {
  switch (choices_.below(6)) {
    case 0:
      return 0;
    case 1:
      return choices_.between(-1, 1);
    case 2:
    case 3:
      return length(10);
    default:
      return -length(10);
  }
}

// From R to the bottom: mostly whole pecks, or an increment beside that.
std::int64_t NgcWriter::hole_depth() {
  if (!is_pecking(motion_)) return choices_.one_in(16) ? 0 : length(20);
  std::int64_t depth = *sticky_.q * choices_.between(choices_.one_in(12) ? 0 : 1, settings_.pecks);
  if (choices_.one_in(3)) depth += choices_.between(-1, 1);
  if (choices_.one_in(3)) depth += choices_.between(0, *sticky_.q);
  return depth < 0 ? 0 : depth;
}

// Whether the numbers in force make a hole, and of some pecks at most.
bool NgcWriter::keeps_levels(bool first) const {
  if (first || !sticky_.r || !sticky_.depth) return false;
  const std::int64_t depth = incremental_ ? -*sticky_.depth : *sticky_.r - *sticky_.depth;
  if (depth < 0) return false;
  return !is_pecking(motion_) || depth <= *sticky_.q * 2 * settings_.pecks;
}

// R and the word of the third axis, as the distance mode counts them.
void NgcWriter::level_words(Words& words, bool first) {
  const auto [p, q, third] = plane_axes();
  const bool keeps = keeps_levels(first);
  const bool writes_r = !keeps || choices_.one_in(4);
  const bool writes_depth = !keeps || choices_.one_in(4);
  const std::int64_t depth = hole_depth();
  if (writes_r && (incremental_ || writes_depth)) {
    const std::int64_t base = incremental_ ? 0 : at_[third].value_or(0);
    sticky_.r = base + above_tool();
  } else if (writes_r) {
    sticky_.r = *sticky_.depth + depth;
  }
  if (writes_r) words.push_back(word('R', *sticky_.r));
  if (!writes_depth) return;
  sticky_.depth = incremental_ ? -depth : *sticky_.r - depth;
  words.push_back(word("XYZ"[third], *sticky_.depth));
}

// At least one word of an axis, without which nothing is drilled.
void NgcWriter::place_words(Words& words, std::int64_t holes) {
  if (is_polar_) return polar_words(words);
  const auto [p, q, third] = plane_axes();
  const auto put_place = [&](Axis axis) {
    std::int64_t value = any_sign(length(20));
    if (choices_.one_in(8)) value = incremental_ ? 0 : at_[axis].value_or(0);
    words.push_back(word("XYZ"[axis], value));
    if (!incremental_) {
      target_[axis] = value;
    } else if (target_[axis]) {
      *target_[axis] += holes * value;
    }
  };
  const bool has_depth = !words.empty() && words.back()[0] == "XYZ"[third];
  const bool names_p = choices_.below(4) != 0;
  const bool names_q = choices_.below(3) != 0 || (!names_p && !has_depth);
  if (names_p) put_place(p);
  if (names_q) put_place(q);
}

// Whether the readings leave the tool where the default ones do.
bool NgcWriter::levels_are_told() const {
  const reference::ReadingChoice readings = profile_.readings.shown();
  return readings.is("ngc.cycle.initial=series"_reading) &&
         readings.is("ngc.cycle.initial-kept=place"_reading) &&
         readings.is("ngc.cycle.g91-r=current"_reading) &&
         readings.is("ngc.cycle.sticky=number"_reading) &&
         readings.is("ngc.cycle.retract-start=r-plane"_reading) &&
         readings.is("ngc.g73.end=r-plane"_reading);
}

// Where the tool is behind the block along the third axis, as far as known.
std::optional<std::int64_t> NgcWriter::clear_level() const {
  const std::optional<std::int64_t>& tool = at_[plane_axes()[2]];
  if (!levels_are_told() || (incremental_ && !tool)) return std::nullopt;
  const std::int64_t r = *sticky_.r + (incremental_ ? *tool : 0);
  if (retract_ != 98 || motion_ == 73) return r;
  if (!initial_) return std::nullopt;
  return *initial_ > r ? *initial_ : r;
}

void NgcWriter::count_cycle(bool first) {
  count(fmt::format("cycle in G{}", plane_));
  count(fmt::format("cycle under G{}", incremental_ ? 91 : 90));
  count(retract_ == 0 ? "cycle before G98 and G99" : fmt::format("cycle under G{}", retract_));
  if (!first) count(has_code_ ? "cycle repeated by its code" : "cycle repeated");
  const std::optional<std::int64_t>& tool = at_[plane_axes()[2]];
  if (!tool) return;
  const std::int64_t above = *sticky_.r - (incremental_ ? 0 : *tool);
  count(above > 0 ? "cycle: R above the tool"
                  : (above == 0 ? "cycle: R at the tool" : "cycle: R below the tool"));
}

void NgcWriter::cycle_block() {
  const bool was_cycle = is_hole_cycle(motion_);
  const int drawn = choices_.pick({73, 73, 74, 81, 82, 83, 83, 84, 85, 86, 89});
  const int motion = was_cycle && choices_.below(3) != 0 ? motion_ : drawn;
  const bool first = motion != motion_;
  const bool was_minute = minute_pecks_;
  Words words;
  cycle_modes(words, first);
  const Axis third = plane_axes()[2];
  if (!was_cycle || series_plane_ != plane_) initial_ = at_[third];
  series_plane_ = plane_;
  if (first) sticky_ = {};
  enter(words, motion);
  // The block that set the mode may have been skipped.
  if (profile_.block_skip && !has_code_) words.push_back(code(motion_));
  own_words(words, first);
  level_words(words, first);
  count_cycle(first);
  place_words(words, hole_count(words));
  feed_words(words);
  unused_words(words, letters_unused_by_cycle());
  target_[third] = clear_level();
  arrive();
  cycle_faults(words);
  const bool is_minute = minute_pecks_;
  minute_pecks_ = is_minute || was_minute;
  write(std::move(words), "GML");
  minute_pecks_ = is_minute && is_pecking(motion_);
  dwells_ = false;
}

}  // namespace gonogo::generate
