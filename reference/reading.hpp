// SPDX-License-Identifier: GPL-3.0-or-later
//
// Readings: named choices where a manual is open or contradicts itself.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/clause.hpp"
#include "reference/exact/number.hpp"

namespace gonogo::reference {

// Every reading, in the order of the table in reading.cpp.
enum class ReadingKey : std::uint8_t {
  g94_rewrite,
  g94_after_00,
  g94_empty_block,
  g94_in_mode,
  g92_lead,
  pocket_path,
  pocket_end,
  pocket_p_omitted,
  pocket_pair,
  pocket_r,
  missing_axis,
  zero_depth,
  zero_depth_end,
  x_depth,
  helix_entry_side,
  helix_flat,
  helix_turns,
  thread_path,
  thread_runout,
  thread_v_from,
  thread_modal,
  thread_mode,
  thread_direction,
  thread_r,
  thread_k_range,
  decimals,
  duplicate,
  dwell_without_word,
  arc_zero_radius,
  arc_tolerance_zero,
  g50_initial_plane,
  rotary_feed_inch,
  hnc_missing_axis,
  hnc_peck_from,
  hnc_peck_withdraw,
  hnc_peck_clamp,
  hnc_g75_i,
  hnc_g75_steps,
  hnc_g75_end,
  hnc_g75_mode3,
  hnc_g75_depth_scale,
  hnc_g82_exit,
  hnc_g82_e_scale,
  hnc_g82_starts,
  hnc_modal_f,
  hnc_offset_initial,
  hnc_lead_unit,
  hnc_arc_zero_radius,
  ngc_arc_tolerance,
  ngc_full_circle_words,
  ngc_whole,
  ngc_g80_beside,
  ngc_unused_words,
  ngc_line_number,
  ngc_o_name,
  ngc_program_end,
  ngc_bare_motion,
  ngc_arc_words_alone,
  ngc_g92_other_axes,
  ngc_equal,
  ngc_sign_of_value,
  ngc_call_parameters,
  ngc_missing_tool,
  ngc_g94_feed,
  ngc_feed_units,
  ngc_block_delete,
  ngc_lone_cr,
  ngc_alarm_dwell,
  ngc_cycle_initial,
  ngc_cycle_g91_r,
  ngc_cycle_sticky,
  ngc_cycle_approach,
  ngc_cycle_initial_kept,
  ngc_cycle_retract_start,
  ngc_cycle_feed,
  ngc_cycle_alarm_at,
  ngc_g83_retract,
  ngc_g83_return,
  ngc_peck_clearance,
  ngc_peck_d,
  ngc_peck_dwell,
  ngc_g73_end,
  ngc_g85_out,
  ngc_tap_p,
  ngc_g74_l,
  ngc_g33_k,
  ngc_g76_checks,
  ngc_g76_slide,
  ngc_g76_entry,
  sie_arc_correct,
  sie_cr_tolerance,
  sie_spindle,
  sie_initial_motion,
  sie_g70_f,
  sie_g158,
  sie_rpl_equals,
  sie_g258,
  sie_infeed,
  sie_infeed_from,
  sie_finish_levels,
  sie_corner,
  sie_pocket_path,
  sie_lcyc_unit,
  sie_lc75_r125_limit,
};
inline constexpr std::size_t kReadings = 104;
constexpr std::size_t index(ReadingKey key) {
  return static_cast<std::size_t>(key);
}

struct Reading {
  ReadingKey key;
  std::string_view name;                       // "gsk.pocket.end"
  std::string_view dialect;                    // "gsk988ta"
  std::vector<std::string_view> alternatives;  // without "any"; the default or the one shown first
  std::string_view fallback;                   // the default: an alternative or "any"
  bool by_properties = false;  // "any" is judged by what the path does, not by paths
  bool is_length = false;      // any decimal (mm) is an alternative
  ClauseId clause = kNoClause;
  std::string_view text;       // what the choice is about
  std::string_view also = {};  // a second dialect that has the reading

  bool belongs_to(std::string_view name_of_dialect) const;
};

std::span<const Reading> readings();
const Reading& reading(ReadingKey key);
const Reading* find_reading(std::string_view name);
// Whether `value` is one of the reading's alternatives or "any".
bool admits(const Reading& reading, std::string_view value);

// The value of each reading, "any" among them; what a profile says. Small: a campaign copies one
// with every case.
class ReadingChoice {
 public:
  ReadingChoice();  // the defaults
  std::string_view get(ReadingKey key) const;
  void set(ReadingKey key, std::string_view value);
  bool is(ReadingKey key, std::string_view value) const { return get(key) == value; }
  // The same choice, but for each open "any" that is not judged by properties the alternative that
  // `expand` shows.
  ReadingChoice shown() const;
  friend bool operator==(const ReadingChoice&, const ReadingChoice&) = default;

 private:
  // A place in the reading's list of values: "any", the alternatives, the default where it is
  // neither; or kOwnText.
  using Place = std::uint8_t;
  static constexpr Place kAny = 0;
  static constexpr Place kFirst = 1;
  static constexpr Place kFallback = 254;
  static constexpr Place kOwnText = 255;
  using OwnText = std::pair<ReadingKey, std::string>;
  static Place place_of(const Reading& reading, std::string_view value);

  std::array<Place, kReadings> places_;
  std::vector<OwnText> texts_;  // lengths, by key
};

// The readings as one run of the reference sees them; remembers which of them mattered.
class ReadingsInUse {
 public:
  explicit ReadingsInUse(const ReadingChoice& choice) : shown_(choice.shown()) {}
  // Whether the alternative holds. An open "any" that is not judged by properties counts as the
  // alternative that `expand` shows.
  bool is(ReadingKey key, std::string_view alternative) const;
  exact::Number length(ReadingKey key) const;
  // The reading mattered, whatever it says.
  void touch(ReadingKey key) const {
    if (!std::exchange(touched_[index(key)], true)) ++count_;
  }
  bool touched(ReadingKey key) const { return touched_[index(key)]; }
  std::vector<ReadingKey> touched() const;
  std::size_t touched_count() const { return count_; }
  void forget_touched() {
    touched_.fill(false);
    count_ = 0;
  }

 private:
  ReadingChoice shown_;
  mutable std::array<bool, kReadings> touched_{};
  mutable std::size_t count_ = 0;
};

}  // namespace gonogo::reference
