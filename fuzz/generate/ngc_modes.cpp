// SPDX-License-Identifier: GPL-3.0-or-later
//
// What changes modes, or has nothing to do with them.
#include <fmt/format.h>

#include "fuzz/generate/ngc_writer.hpp"

namespace gonogo::generate {

void NgcWriter::set_incremental(Words& words, bool incremental) {
  incremental_ = incremental;
  words.push_back(code(incremental ? 91 : 90));
}

// Modes that stand in a block that moves.
void NgcWriter::mode_words(Words& words) {
  if (!choices_.one_in(6)) return;
  if (choices_.one_in(2)) {
    set_incremental(words, choices_.one_in(2));
  } else {
    words.push_back(choices_.one_in(4) ? choices_.pick({"S300", "T2"})
                                       : code_that_is(Treatment::without_effect));
  }
}

// The tool stands where words of the new units cannot say it exactly.
void NgcWriter::units_block() {
  count("units change");
  inch_ = choices_.one_in(3);
  Words words = {code(inch_ ? 20 : 21)};
  // F acts before the units of its block.
  if (choices_.one_in(3)) words.push_back(feed_word());
  lose_place();
  if (choices_.one_in(2)) {
    enter(words, 0);
    for (const Axis axis : {x, y, z}) words.push_back(axis_word(axis, 50));
    arrive();
  }
  write(std::move(words));
}

void NgcWriter::setting_block() {
  Words words;
  switch (choices_.below(7)) {
    case 6:
      count("G98 or G99 alone");
      retract_ = choices_.pick({98, 99});
      words.push_back(code(retract_));
      break;
    case 5:
      count("motion code alone");
      motion_ = choices_.one_in(2) ? 1 : 0;
      words.push_back(code(motion_));
      if (choices_.one_in(4)) words.push_back(feed_word());
      break;
    case 0:
      count("absolute or incremental");
      set_incremental(words, choices_.one_in(2));
      break;
    case 1:
      count("centres absolute or incremental");
      absolute_centre_ = choices_.one_in(2);
      words.push_back(absolute_centre_ ? "G90.1" : "G91.1");
      break;
    case 2:
      count("plane alone");
      set_plane(words);
      break;
    case 3:
      count("G80");
      motion_ = -1;
      words.push_back(code(80));
      // An axis word has no motion then.
      if (errs(20)) words.push_back(axis_word(x, 20));
      break;
    default:
      return units_block();
  }
  write(std::move(words));
}

// Before the motion of its block. An arc has a use of its own for P.
void NgcWriter::dwell_block() {
  count("dwell");
  const auto seconds = choices_.below(9);
  const auto tenths = choices_.below(10);
  Words words = {code(4), fmt::format("P{}.{}", seconds, tenths)};
  if (choices_.one_in(3)) {
    enter(words, choices_.one_in(2) ? 1 : 0);
    // The block that set the mode may have been skipped.
    if (profile_.block_skip && !has_code_) words.push_back(code(motion_));
    words.push_back(axis_word(choices_.pick({x, y, z}), 30));
    arrive();
  }
  if (choices_.one_in(8)) words.push_back(spindle_word(3));
  dwells_ = true;
  write(std::move(words), "GM");
  dwells_ = false;
}

// Where a program ends.
void NgcWriter::outside_block() {
  count("undefined or outside");
  Words words = {choices_.one_in(3) ? choices_.pick({"G6", "G999", "G21.1", "M150", "M10"})
                                    : code_that_is(Treatment::outside)};
  if (choices_.one_in(2)) words.push_back(axis_word(z, 20));
  if (choices_.one_in(8)) words.push_back(choices_.pick({"X#1", "Y[1+2]", "B20"}));
  write(std::move(words));
}

void NgcWriter::mode_block() {
  switch (choices_.below(10)) {
    case 0:
    case 1:
    case 2:
    case 3:
    case 4:
      return setting_block();
    case 5:
    case 6:
      return dwell_block();
    case 7:
      if (puts_wrong(4)) return outside_block();
      return write({errs(4) ? "F0" : feed_word()});
    case 8:
      if (choices_.one_in(3)) return write({code_that_is(Treatment::without_effect)});
      if (choices_.one_in(3)) return write({spindle_word(choices_.pick({3, 4, 5}))});
      return write({choices_.pick({"M8", "M9", "M0", "M1", "M60", "M48", "S800", "T4", "M66 P0 L0",
                                   "M67 E1 Q2", "M62 P1", "M61 Q3", "M50 P0", "G64 P0.1 Q0.1"})});
    default:
      count("no motion");
      text_ += choices_.pick(
          {"\n", "(only a comment)\n", "; text\n", "N77\n", "/\n", ";\n", "O12 (name)\n"});
  }
}

}  // namespace gonogo::generate
