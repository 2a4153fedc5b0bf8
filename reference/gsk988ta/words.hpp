// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words of one block: by address, exact, in true lengths.
#pragma once

#include <array>
#include <optional>

#include "grammar/ast.hpp"
#include "reference/axis.hpp"
#include "reference/gsk988ta/codes.hpp"
#include "reference/profile.hpp"
#include "reference/words.hpp"

namespace gonogo::reference::gsk988ta {

// X and U, Y and V, Z and W, C and H.
inline constexpr std::array<AxisAddresses, 4> kAxisAddresses = {
    {{Axis::x, 'X', 'U'}, {Axis::y, 'Y', 'V'}, {Axis::z, 'Z', 'W'}, {Axis::c, 'C', 'H'}}};
const AxisAddresses& addresses_of(Axis axis);

// The milling cycles by what their words mean. Each pair is one mode (GSK-MOD-01, GSK-MOD-04).
enum class CycleFamily : std::uint8_t { none, pocket, helix, thread };

class BlockWords : public WordTable {
 public:
  // Takes the words of a block; `units` and `profile` say how lengths are written.
  // `round` is the reading gsk.decimals = nearest.
  BlockWords(const grammar::Block& block, const Profile& profile, Units units, bool round);

  // As a length in mm. X and U are diameters here only through axis_word().
  std::optional<Number> length(char address) const;
  // The axis word, absolute or incremental; X and U halved when they are diameters.
  std::optional<AxisWord> axis_word(Axis axis, bool diameter = true) const;
  bool has_axis_word(Axis axis) const { return has(addresses_of(axis)); }

 private:
  const Profile& profile_;
  Units units_;
  bool round_;
};

// Rules that hold for the words of any block; what they break is appended.
// GSK-COM-01, GSK-COM-07: an address twice (unless the last one wins), X with U.
void check_pairs(const BlockWords& words, bool last_wins, std::string_view may_repeat,
                 std::vector<Alarm>& alarms);
// GSK-COM-03 under gsk.decimals = alarm.
void check_decimals(const BlockWords& words, const Profile& profile, Units units,
                    std::vector<Alarm>& alarms);
// GSK-COM-06: the ranges of the words in blocks of the cycles; P takes no sign in the thread
// cycles. `last_wins`: of an address that stands twice only the last word counts.
void check_ranges(const BlockWords& words, const Code& cycle, CycleFamily family, bool last_wins,
                  const Profile& profile, Units units, std::vector<Alarm>& alarms);
// GSK-G112-01: L of the helical pocket, a whole number from 1 to 99999.
void check_turns(const BlockWords& words, std::vector<Alarm>& alarms);
// GSK-G114-13: K of the thread cycles, 0 to 360 degrees; or as far as the table of lengths says.
void check_run_out_angle(const BlockWords& words, bool full_turn, const Profile& profile,
                         Units units, std::vector<Alarm>& alarms);
// GSK-COM-08: a negative F.
void check_feed_word(const BlockWords& words, std::vector<Alarm>& alarms);
// GSK-MOD-09: codes of group 01 with codes of the milling cycles.
void check_code_groups(const BlockWords& words, const BlockCodes& codes,
                       std::vector<Alarm>& alarms);

// Whether the reading of fine decimals matters for the block.
bool has_fine_words(const grammar::Block& block, const Profile& profile, Units units);

// Decimals that a length may have: 3 or 4 in mm, 4 or 5 in inch (ISB, ISC).
std::uint32_t decimals_of(const Profile& profile, Units units);

}  // namespace gonogo::reference::gsk988ta
