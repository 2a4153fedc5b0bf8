// SPDX-License-Identifier: GPL-3.0-or-later
//
// The modal state of an HNC-21T lathe, and what a block sees of it.
#pragma once

#include <array>
#include <optional>

#include "reference/block_base.hpp"
#include "reference/hnc21t/codes.hpp"
#include "reference/hnc21t/words.hpp"

namespace gonogo::reference::hnc21t {

constexpr bool is_cycle(int motion) {
  return motion == 74 || motion == 75 || (motion >= 80 && motion <= 82);
}
// Whether F is a lead.
constexpr bool cuts_thread(int motion) {
  return motion == 32 || motion == 82;
}

// A length along X that a reading may call a diameter: mm, and whether G36 was in force.
struct ScaledLength {
  Number value;
  bool diameter = false;
};

// F or J of G32 and G82 as written; what it means is a reading.
struct Lead {
  // F written under G21 is in mm under each reading.
  enum class Kind : std::uint8_t { millimetres, f_under_g20, j };
  Number value;
  Kind kind = Kind::millimetres;
};

// HNC-MOD-01: what the command in force retains, forgotten when the command changes.
struct CommandWords {
  std::optional<Number> i;  // a length, but the count as written in G75
  std::optional<Number> k;
  std::optional<Number> c;
  std::optional<Number> p;
  std::optional<ScaledLength> r;
  std::optional<ScaledLength> e;
  std::optional<ScaledLength> q;
  std::optional<Lead> lead;
  std::optional<Number> feed;  // F of G74, G75, G80, G81
  // C of the last block that ran, in the base frame.
  std::optional<Number> end_x;
  std::optional<Number> end_z;

  std::optional<Number>& end(Axis axis) { return axis == Axis::x ? end_x : end_z; }
  bool empty() const {
    return !i && !k && !c && !p && !r && !e && !q && !lead && !feed && !end_x && !end_z;
  }
  // Takes what it lacks of the words of an earlier command, but no feed and no end point. Whether
  // it lacks any.
  bool complete_from(const CommandWords& earlier);
  // The words that are lengths. `counts`: I is a count.
  bool has_lengths(bool counts) const { return (i && !counts) || k || r || e || q; }
  void scale_lengths(const Number& factor, bool counts);
};

// HNC-MOD-04: F in force as a feed: the last one, and the last of those outside the cycles.
struct FeedWords {
  std::optional<Number> latest;
  std::optional<Number> plain;
  bool is_written = false;  // by the program, not of power-on

  void give(const Number& feed, bool in_cycle) {
    latest = feed;
    if (!in_cycle) plain = feed;
    is_written = true;
  }
};

// Positions are in the base frame: the work offset in force is added to absolute words.
struct Machine : MotionState {
  WordModes modes;
  std::array<Position, 6> offsets;  // G54 to G59
  int offset = -1;                  // its place; -1: none commanded yet
  int motion = 0;                   // 0, 1, 2, 3, 32, 74, 75, 80, 81, 82
  CommandWords command;
  // HNC-MOD-05: the cycle that a code outside the group has ended, until its words are taken up
  // again or another cycle comes (0: none), and what it retained.
  int ended = 0;
  CommandWords ended_words;
  std::optional<Lead> line_lead;  // HNC-MOD-04: the last of G32
  FeedWords feeds;                // each F that is no lead
  FeedWords any_f;                // each F, which hnc.g32.lead = feed has for one word
};

// One block in the hands of the file that carries its code.
struct BlockContext : BlockBase {
  Machine& machine;
  const BlockWords& words;
  const BlockCodes& codes;

  // HNC-COM-01, HNC-COM-04, HNC-MOD-04: the feed in force; an alarm when there is none. Motions
  // take it from here.
  void need_feed();
  // The work offset in force along an axis.
  Number offset(Axis axis) const;
  // The commanded coordinate; nothing without a word of the axis.
  std::optional<Number> commanded(const AxisAddresses& axis) const;
  // HNC-MOD-04: the lead in force, mm. REQUIRES: there is one.
  Number lead() const;
};

// HNC-COM-07, HNC-COM-04: says of the block that it runs on although it has words without effect.
void note_unused_words(const BlockContext& block);

// HNC-COM-01, in basic_motion.cpp and arc.cpp.
void run_dwell(BlockContext& block);
void run_rename_position(BlockContext& block);
void run_positioning(BlockContext& block);
void run_straight_feed(BlockContext& block);
void run_thread(BlockContext& block);
void run_arc(BlockContext& block, int sense);
// The axis words of the block as an end point; the axes that it names.
AxisSet commanded_end_point(const BlockContext& block, Position& to);

// The cycles, one file each.
void run_g74(BlockContext& block);
void run_g75(BlockContext& block);
void run_g80(BlockContext& block);
void run_g81(BlockContext& block);
void run_g82(BlockContext& block);

}  // namespace gonogo::reference::hnc21t
