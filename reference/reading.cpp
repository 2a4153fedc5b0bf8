// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/reading.hpp"

#include <algorithm>

namespace gonogo::reference {
namespace {

const std::vector<Reading>& table() {
  static const std::vector<Reading> kTable = {
      {ReadingKey::g94_rewrite,
       "gsk.g94.rewrite",
       "gsk988ta",
       {"keep", "clear"},
       "keep",
       false,
       false,
       "GSK-G94-06"_clause,
       "R when G94 is written again without it: kept, or cleared"},
      {ReadingKey::g94_after_00,
       "gsk.g94.after-00",
       "gsk988ta",
       {"stays", "cancelled"},
       "stays",
       false,
       false,
       "GSK-G94-07"_clause,
       "G94 itself after a code of group 00 that clears its words: it stays, or is cancelled"},
      {ReadingKey::g94_empty_block,
       "gsk.g94.empty-block",
       "gsk988ta",
       {"none", "repeat"},
       "none",
       false,
       false,
       "GSK-G94-12"_clause,
       "a block of words without axis and R while G94 is in force: no cycle, or the cycle again"},
      {ReadingKey::g94_in_mode,
       "gsk.g94.in-mode",
       "gsk988ta",
       {"keep", "clear"},
       "keep",
       false,
       false,
       "GSK-G94-07"_clause,
       "what a cutting cycle retains when a milling cycle is entered without a code of group 01: "
       "kept, or cleared"},
      {ReadingKey::g92_lead,
       "gsk.g92.lead",
       "gsk988ta",
       {"own", "feed"},
       "own",
       false,
       false,
       "GSK-G92-06"_clause,
       "F of G92: a lead apart from the feed, or the one feed word in force"},
      {ReadingKey::pocket_path,
       "gsk.pocket.path",
       "gsk988ta",
       {"semicircles", "concentric"},
       "any",
       true,
       false,
       "GSK-G110-09"_clause,
       "the path that clears a layer: judged by what it clears, or one of two given paths"},
      {ReadingKey::pocket_end,
       "gsk.pocket.end",
       "gsk988ta",
       {"initial", "r-plane"},
       "initial",
       false,
       false,
       "GSK-G110-13"_clause,
       "where the tool ends: at the initial or at the R plane"},
      {ReadingKey::pocket_p_omitted,
       "gsk.pocket.p-omitted",
       "gsk988ta",
       {"0"},
       "0",
       false,
       true,
       "GSK-G110-11"_clause,
       "the clearance where P is omitted, mm"},
      {ReadingKey::pocket_pair,
       "gsk.pocket.pair",
       "gsk988ta",
       {"shared", "each"},
       "shared",
       false,
       false,
       "GSK-MOD-01"_clause,
       "I L Q D between G110 and G111: shared, or to be given again on each change"},
      {ReadingKey::pocket_r,
       "gsk.pocket.R",
       "gsk988ta",
       {"per-block", "modal"},
       "per-block",
       false,
       false,
       "GSK-MOD-03"_clause,
       "R and P: for their block, or retained in the mode"},
      {ReadingKey::missing_axis,
       "gsk.missing-axis",
       "gsk988ta",
       {"skip", "position"},
       "skip",
       false,
       false,
       "GSK-G110-14"_clause,
       "a block that lacks one of the three axes: nothing moves, or its plane axes are positioned"},
      {ReadingKey::zero_depth,
       "gsk.zero-depth",
       "gsk988ta",
       {"no-cut", "alarm"},
       "no-cut",
       false,
       false,
       "GSK-G110-17"_clause,
       "a pocket without depth: positioned over, or an alarm"},
      {ReadingKey::zero_depth_end,
       "gsk.zero-depth-end",
       "gsk988ta",
       {"initial", "r-plane"},
       "initial",
       false,
       false,
       "GSK-G110-17"_clause,
       "where a pocket without depth ends under gsk.pocket.end = r-plane"},
      {ReadingKey::x_depth,
       "gsk.x-depth",
       "gsk988ta",
       {"diameter", "radius"},
       "diameter",
       false,
       false,
       "GSK-G110-18"_clause,
       "X and U as depth words of G19: diameters, or true lengths"},
      {ReadingKey::helix_entry_side,
       "gsk.helix.entry-side",
       "gsk988ta",
       {"+p"},
       "any",
       true,
       false,
       "GSK-G112-04"_clause,
       "the side of the helical pocket on which the semicircles lie: any, or +p"},
      {ReadingKey::helix_flat,
       "gsk.helix.flat",
       "gsk988ta",
       {"off", "on"},
       "off",
       false,
       false,
       "GSK-G112-05"_clause,
       "a full circle at the bottom of the helical pocket: none, or one"},
      {ReadingKey::helix_turns,
       "gsk.helix.L",
       "gsk988ta",
       {"per-block", "modal"},
       "per-block",
       false,
       false,
       "GSK-G112-01"_clause,
       "L of the helical pocket: for its block, or retained in the mode"},
      {ReadingKey::thread_path,
       "gsk.thread.path",
       "gsk988ta",
       {"arc"},
       "any",
       true,
       false,
       "GSK-G114-06"_clause,
       "entry, infeed and the way between the passes: judged by what the text fixes, or one given "
       "path"},
      {ReadingKey::thread_runout,
       "gsk.thread.runout",
       "gsk988ta",
       {"polar", "radial", "tangent"},
       "any",
       true,
       false,
       "GSK-G114-11"_clause,
       "the run-out of a thread: judged by its clearance, or one of three given shapes"},
      {ReadingKey::thread_v_from,
       "gsk.thread.v-from",
       "gsk988ta",
       {"r-plane", "initial"},
       "r-plane",
       false,
       false,
       "GSK-G114-01"_clause,
       "what an increment of the depth word counts from in the thread cycles"},
      {ReadingKey::thread_modal,
       "gsk.thread.modal",
       "gsk988ta",
       {"code", "none"},
       "code",
       false,
       false,
       "GSK-MOD-04"_clause,
       "G114 to G117: the code stays in force, or holds for its block"},
      {ReadingKey::thread_mode,
       "gsk.thread.mode",
       "gsk988ta",
       {"pairs", "one"},
       "pairs",
       false,
       false,
       "GSK-MOD-04"_clause,
       "G114 with G115 and G116 with G117 are a mode each, as of the pockets, or all four are one"},
      {ReadingKey::thread_direction,
       "gsk.thread.direction",
       "gsk988ta",
       {"alarm", "free"},
       "alarm",
       false,
       false,
       "GSK-G114-12"_clause,
       "R of a thread cycle that leads away from the bottom: an alarm, or allowed"},
      {ReadingKey::thread_r,
       "gsk.thread.r",
       "gsk988ta",
       {"optional", "required"},
       "optional",
       false,
       false,
       "GSK-G114-12"_clause,
       "R of G116 and G117: optional, or required"},
      {ReadingKey::thread_k_range,
       "gsk.thread.k-range",
       "gsk988ta",
       {"360", "table"},
       "360",
       false,
       false,
       "GSK-G114-13"_clause,
       "the upper end of K of the thread cycles: 360 degrees, or that of the table of lengths"},
      {ReadingKey::decimals,
       "gsk.decimals",
       "gsk988ta",
       {"keep", "nearest", "alarm"},
       "keep",
       false,
       false,
       "GSK-COM-03"_clause,
       "more decimals than the least increment: kept, rounded to nearest, or an alarm"},
      {ReadingKey::duplicate,
       "gsk.duplicate",
       "gsk988ta",
       {"alarm", "last"},
       "alarm",
       false,
       false,
       "GSK-COM-07"_clause,
       "an address or group of codes twice: an alarm, or the last one wins"},
      {ReadingKey::dwell_without_word,
       "gsk.dwell-without-word",
       "gsk988ta",
       {"alarm", "none"},
       "alarm",
       false,
       false,
       "GSK-COM-05"_clause,
       "G04 without a time: an alarm, or no dwell"},
      {ReadingKey::arc_zero_radius,
       "gsk.arc.zero-radius",
       "gsk988ta",
       {"alarm", "none"},
       "alarm",
       false,
       false,
       "GSK-COM-05"_clause,
       "an arc whose start, end and centre are one point: an alarm, or no motion in the plane"},
      {ReadingKey::arc_tolerance_zero,
       "gsk.arc.tolerance-zero",
       "gsk988ta",
       {"off", "exact"},
       "off",
       false,
       false,
       "GSK-COM-05"_clause,
       "parameter 3410 = 0: the radii of an arc are not compared, or must be equal"},
      {ReadingKey::g50_initial_plane,
       "gsk.g50.initial-plane",
       "gsk988ta",
       {"shifted", "kept"},
       "shifted",
       false,
       false,
       "GSK-MOD-05"_clause,
       "the initial plane of a milling cycle under G50: renamed with the position, or its "
       "coordinate kept"},
      {ReadingKey::rotary_feed_inch,
       "gsk.rotary-feed-inch",
       "gsk988ta",
       {"scaled", "degrees"},
       "scaled",
       false,
       false,
       "GSK-COM-05"_clause,
       "F under G20 of a rotary axis that moves alone: scaled as a length, or degrees"},
  };
  return kTable;
}

}  // namespace

std::span<const Reading> readings() {
  return table();
}

const Reading& reading(ReadingKey key) {
  return table()[index(key)];
}

const Reading* find_reading(std::string_view name) {
  auto found = std::ranges::find(table(), name, &Reading::name);
  return found == table().end() ? nullptr : &*found;
}

bool admits(const Reading& reading, std::string_view value) {
  if (reading.is_length) {
    auto number = exact::Number::parse(value);
    return number && number->is_rational() && number->sign() >= 0;
  }
  return value == "any" ||
         std::ranges::find(reading.alternatives, value) != reading.alternatives.end();
}

ReadingChoice::ReadingChoice() {
  for (const Reading& reading : table()) set(reading.key, reading.fallback);
}

ReadingsInUse::ReadingsInUse(const ReadingChoice& choice) : choice_(choice) {
  for (const Reading& reading : table()) {
    std::string_view value = choice.get(reading.key);
    bool shown = value == "any" && !reading.by_properties;
    effective_[index(reading.key)] = shown ? reading.alternatives.front() : value;
  }
}

bool ReadingsInUse::is(ReadingKey key, std::string_view alternative) const {
  touched_[index(key)] = true;
  return effective_[index(key)] == alternative;
}

exact::Number ReadingsInUse::length(ReadingKey key) const {
  touched_[index(key)] = true;
  return exact::Number::parse(choice_.get(key)).value();
}

std::vector<ReadingKey> ReadingsInUse::touched() const {
  std::vector<ReadingKey> keys;
  for (const Reading& reading : table()) {
    if (touched_[index(reading.key)]) keys.push_back(reading.key);
  }
  return keys;
}

}  // namespace gonogo::reference
