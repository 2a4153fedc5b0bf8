// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readings of RS274/NGC: where its interpreters differ. In the order of ReadingKey.
#pragma once

#include <vector>

#include "reference/reading.hpp"

namespace gonogo::reference::catalog {

// NOLINTNEXTLINE(readability-function-size): a table.
inline std::vector<Reading> rs274_readings() {
  return {
      {ReadingKey::ngc_arc_tolerance,
       "ngc.arc-tolerance",
       "rs274",
       {"nist", "linuxcnc"},
       "any",
       false,
       false,
       "NGC-ARC-03"_clause,
       "how far an arc's end may miss its circle: as NIST's interpreter has it, or as LinuxCNC's"},
      {ReadingKey::ngc_full_circle_words,
       "ngc.full-circle-words",
       "rs274",
       {"free", "needed"},
       "any",
       false,
       false,
       "NGC-ARC-04"_clause,
       "an arc by its centre without an axis word of the plane: a full circle, or an alarm"},
      {ReadingKey::ngc_whole,
       "ngc.whole",
       "rs274",
       {"exact", "nist", "linuxcnc"},
       "any",
       false,
       false,
       "NGC-COM-01"_clause,
       "how far an M function, ten times a G code, or P of an arc may be from a whole number and "
       "count as it: not at all; by 0.0001, as NIST's report says; or, as LinuxCNC has it, by "
       "0.0001 for M and 0.001 for the others"},
      {ReadingKey::ngc_g80_beside,
       "ngc.g80-beside",
       "rs274",
       {"alarm", "ignored"},
       "any",
       false,
       false,
       "NGC-COM-03"_clause,
       "G80 in a block with another code of the motion group: an alarm, as the documents and "
       "NIST's "
       "interpreter have it; or forgotten, as LinuxCNC has it. Open, for the usual first line of a "
       "program, G00 G17 G21 G40 G49 G80 G90, hangs on it. Asked for only where the group has one "
       "other code or G80 again"},
      {ReadingKey::ngc_unused_words,
       "ngc.unused-words",
       "rs274",
       {"alarm", "ignored"},
       "alarm",
       false,
       false,
       "NGC-COM-02"_clause,
       "a word that no code of its block uses: an alarm, on which the documents and all "
       "interpreters of controls agree; or passed over, as viewers of programs have it. Asked for "
       "only where such a word stands"},
      {ReadingKey::ngc_line_number,
       "ngc.line-number",
       "rs274",
       {"decimal", "whole"},
       "any",
       false,
       false,
       "NGC-COM-05"_clause,
       "a line number with decimals or above 99999: without meaning as any other, as the documents "
       "and LinuxCNC have it; or an alarm, as NIST's interpreter has it. Open, and asked for only "
       "where there is one"},
      {ReadingKey::ngc_o_name,
       "ngc.o-name",
       "rs274",
       {"passed-over", "syntax"},
       "any",
       false,
       false,
       "NGC-COM-06"_clause,
       "a line of O and a number alone: passed over, as LinuxCNC has it; or an alarm, as NIST's "
       "interpreter has it. No text says which: open, and asked for only where there is one"},
      {ReadingKey::ngc_program_end,
       "ngc.program-end",
       "rs274",
       {"needed", "free"},
       "needed",
       false,
       false,
       "NGC-COM-08"_clause,
       "a text that ends before the program does: an alarm, on which the documents, LinuxCNC and "
       "NIST's interpreter agree; or the end, as controls have it that are sent blocks one by one. "
       "Asked for only at such an end"},
      {ReadingKey::ngc_bare_motion,
       "ngc.bare-motion",
       "rs274",
       {"nothing", "missing-word"},
       "any",
       false,
       false,
       "NGC-MOD-02"_clause,
       "G0 or G1 without an axis word: no motion, as LinuxCNC has it; or an alarm, as NIST's "
       "interpreter has it. Open, and asked for only where there is one"},
      {ReadingKey::ngc_arc_words_alone,
       "ngc.arc-words-alone",
       "rs274",
       {"arc", "alarm"},
       "any",
       false,
       false,
       "NGC-ARC-06"_clause,
       "I J K in a block without a code of motion and axis words, while G2 or G3 is in force: an "
       "arc, as LinuxCNC has it; or words that nothing uses, as NIST's interpreter has it. Open, "
       "and asked for only in such a block"},
      {ReadingKey::ngc_g92_other_axes,
       "ngc.g92-other-axes",
       "rs274",
       {"zero", "kept"},
       "any",
       false,
       false,
       "NGC-OFS-07"_clause,
       "the offset of an axis that G92 does not name: zero, as the page of G92 says; or as it was, "
       "as NIST's report and LinuxCNC have it. Open, and asked for only where it is not zero"},
      {ReadingKey::ngc_equal,
       "ngc.equal",
       "rs274",
       {"millionth", "ten-thousandth"},
       "any",
       false,
       false,
       "NGC-EXP-02"_clause,
       "by how much less values differ that EQ and NE take for equal: a millionth, as the "
       "documents "
       "say; or a ten-thousandth, as LinuxCNC 2.9 has it. Open, and asked for only in between"},
      {ReadingKey::ngc_sign_of_value,
       "ngc.sign-of-value",
       "rs274",
       {"taken", "syntax"},
       "any",
       false,
       false,
       "NGC-EXP-05"_clause,
       "a sign before a parameter, brackets or a function: taken, as LinuxCNC has it; or an alarm, "
       "as the grammar of NIST's report has it. Open, and asked for only where there is one"},
      {ReadingKey::ngc_call_parameters,
       "ngc.call-parameters",
       "rs274",
       {"kept", "zero"},
       "any",
       false,
       false,
       "NGC-OWD-02"_clause,
       "a parameter up to #30 that a call gives no value: as in the calling lines, as the "
       "documents "
       "say; or zero, as LinuxCNC 2.9 has it. Open, and asked for only where one is read that was "
       "not zero"},
      {ReadingKey::ngc_missing_tool,
       "ngc.missing-tool",
       "rs274",
       {"taken", "alarm"},
       "any",
       false,
       false,
       "NGC-COM-11"_clause,
       "T of a tool that the table, `tools` of the profile, has not: taken, as NIST's interpreter "
       "has it; or an alarm, as LinuxCNC has it. Open, and asked for only where there is one; T0 "
       "is no tool"},
      {ReadingKey::ngc_g94_feed,
       "ngc.g94-feed",
       "rs274",
       {"kept", "none"},
       "any",
       false,
       false,
       "NGC-MOD-03"_clause,
       "the feed behind G94: the one that was in force, as NIST's interpreter has it; or none "
       "until "
       "F is given, as LinuxCNC has it. Open, and asked for only where one was in force and the "
       "block has no F"},
      {ReadingKey::ngc_feed_units,
       "ngc.feed-units",
       "rs274",
       {"before", "after"},
       "before",
       false,
       false,
       "NGC-MOD-01"_clause,
       "F in the block of a G20 or G21 that changes the units: in the units before it, as the "
       "order "
       "of execution says in which F comes first; or in the units behind it, as grblHAL and bCNC "
       "have it"},
      {ReadingKey::ngc_block_delete,
       "ngc.block-delete",
       "rs274",
       {"unread", "read"},
       "any",
       false,
       false,
       "NGC-COM-12"_clause,
       "a line behind a slash, where such lines are left out, that cannot be read: nothing in it "
       "is "
       "wrong; or an alarm, as on a control that reads a line before it leaves it out. Open, and "
       "asked for only where there is one"},
      {ReadingKey::ngc_lone_cr,
       "ngc.lone-cr",
       "rs274",
       {"line-end", "blank"},
       "any",
       false,
       false,
       "NGC-COM-13"_clause,
       "a carriage return without a line feed: ends a line; or is a blank, as NIST's interpreter, "
       "LinuxCNC, grblHAL and uCNC have it. Open, and asked for only where there is one before "
       "other text"},
      {ReadingKey::ngc_alarm_dwell,
       "ngc.alarm-dwell",
       "rs274",
       {"none", "dwells"},
       "any",
       false,
       false,
       "NGC-G4-02"_clause,
       "the dwell of a G4 beside a motion that alarms: none; or the control dwells before it finds "
       "what is wrong, as LinuxCNC has it. Open, and asked for only where nothing else alarms"},
  };
}

}  // namespace gonogo::reference::catalog
