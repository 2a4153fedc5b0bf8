// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "expanders/common/axes.hpp"
#include "expanders/common/profile_reader.hpp"

namespace gonogo::expanders::ngc {

/// One of the outcomes of a reading, in the order of its names in configuration.cpp.
using Option = std::uint8_t;

enum : Option { kByNist, kByLinuxcnc, kByPage, kByGrbl };          // ngc.arc-tolerance
enum : Option { kExact, kNist, kLinuxcnc, kGrbl };                 // ngc.whole
enum : Option { kFromTool, kFromInitial, kAbsolute };              // ngc.cycle.g91-r
enum : Option { kTenThou, kOneMillimetre, kTenth, kTwentieth };    // ngc.peck.clearance
enum : Option { kEndOnR, kEndOnClear, kEndOnBoth };                // ngc.g73.end
enum : Option { kTapOptional, kTapLast, kTapNeeded, kTapBarred };  // ngc.tap.p
enum : Option { kEnterByThread, kEnterByFeed, kEnterByRapid };     // ngc.g76.entry

/// The machine: what its parameters and options fix. Lengths are millimetres.
struct Configuration {
  bool block_delete = false;

  // State at power-on.
  bool inch = false;
  Point position{};
  Fixed feed = 0;
  int plane = 17;
  int motion = -1;  ///< number of the G code; below 0: none
  int spindle = 5;  ///< M3, M4 or M5

  // Readings; 0 is the standard machine.
  Option whole = kExact;
  Option arc_tolerance = kByNist;  ///< ngc.arc-tolerance
  Option circle_needs_word = 0;    ///< ngc.full-circle-words
  Option forgets_g80 = 0;          ///< ngc.g80-beside
  Option ignores_words = 0;        ///< ngc.unused-words
  Option whole_line_numbers = 0;   ///< ngc.line-number
  Option refuses_names = 0;        ///< ngc.o-name
  Option needs_no_end = 0;         ///< ngc.program-end
  Option motion_needs_axis = 0;    ///< ngc.bare-motion
  Option arc_needs_axis = 0;       ///< ngc.arc-words-alone
  Option looks_for_tools = 0;      ///< ngc.missing-tool
  Option g94_ends_feed = 0;        ///< ngc.g94-feed
  Option feed_in_new_units = 0;    ///< ngc.feed-units
  Option reads_skipped = 0;        ///< ngc.block-delete
  Option cr_is_blank = 0;          ///< ngc.lone-cr
  Option refuses_long_lines = 0;   ///< ngc.long-line
  Option dwells_first = 0;         ///< ngc.alarm-dwell
  // of the hole cycles
  Option initial_of_block = 0;      ///< ngc.cycle.initial
  Option r_base = kFromTool;        ///< ngc.cycle.g91-r
  Option keeps_levels = 0;          ///< ngc.cycle.sticky
  Option crosses_at_clear = 0;      ///< ngc.cycle.approach
  Option initial_is_number = 0;     ///< ngc.cycle.initial-kept
  Option starts_with_g98 = 0;       ///< ngc.cycle.retract-start
  Option needs_no_feed = 0;         ///< ngc.cycle.feed
  Option alarms_late = 0;           ///< ngc.cycle.alarm-at
  Option q_at_once = 0;             ///< ngc.cycle.alarm-at-q
  Option pecks_to_clear = 0;        ///< ngc.g83.retract
  Option returns_by_feed = 0;       ///< ngc.g83.return
  Option clearance = kTenThou;      ///< ngc.peck.clearance
  Option clearance_word = 0;        ///< ngc.peck.d
  Option pecks_dwell = 0;           ///< ngc.peck.dwell
  Option g73_end = kEndOnR;         ///< ngc.g73.end
  Option g85_to_clear = 0;          ///< ngc.g85.out
  Option tap_dwell = kTapOptional;  ///< ngc.tap.p
  Option g74_without_l = 0;         ///< ngc.g74.l
  // of the threads
  Option any_lead = 0;                ///< ngc.g33.k
  Option lenient_g76 = 0;             ///< ngc.g76.checks
  Option slide_at_start = 0;          ///< ngc.g76.slide
  Option g76_entry = kEnterByThread;  ///< ngc.g76.entry
};

/// Reads {"dialect", "profile"}. When it cannot, `message` says what is not implemented or wrong.
ConfigurationResult read_configuration(std::string_view json, Configuration& configuration,
                                       std::string& message);

}  // namespace gonogo::expanders::ngc
