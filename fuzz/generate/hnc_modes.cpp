// SPDX-License-Identifier: GPL-3.0-or-later
//
// What changes modes, or has nothing to do with them.
#include <fmt/format.h>

#include "fuzz/generate/hnc_writer.hpp"

namespace gonogo::generate {

using reference::Units;

void HncWriter::change_offset(Words& words) {
  count("work offset");
  words.push_back(fmt::format("G{}", 54 + choices_.below(6)));
  at_ = target_ = {};
}

// Modes that stand in a block that moves.
void HncWriter::mode_words(Words& words) {
  if (!choices_.one_in(8)) return;
  switch (choices_.below(3)) {
    case 0:
      incremental_ = choices_.one_in(2);
      words.push_back(incremental_ ? "G91" : "G90");
      break;
    case 1:
      diameter_ = choices_.one_in(2);
      words.push_back(diameter_ ? "G36" : "G37");
      at_ = target_ = {};
      break;
    default:
      change_offset(words);
      break;
  }
}

// The words of G92 are absolute under G91 too; U and W change the present coordinates.
void HncWriter::set_position() {
  count("G92");
  Words words = {"G92"};
  const std::uint32_t only = choices_.below(3);
  for (const Axis axis : {x, z}) {
    if (axis == only) continue;
    const bool increment = choices_.one_in(4);
    const std::int64_t value = any_sign(length(30));
    words.push_back(word((increment ? "UW" : "XZ")[axis], value));
    target_[axis] = increment && at_[axis] ? *at_[axis] + value : value;
    if (increment && !at_[axis]) target_[axis].reset();
  }
  arrive();
  write(std::move(words));
}

void HncWriter::setting_block() {
  Words words;
  switch (choices_.below(4)) {
    case 0:
      count("absolute or incremental");
      incremental_ = choices_.one_in(2);
      words.push_back(incremental_ ? "G91" : "G90");
      break;
    case 1:
      count("diameter or radius");
      diameter_ = choices_.one_in(2);
      words.push_back(diameter_ ? "G36" : "G37");
      at_ = target_ = {};
      break;
    case 2:
      count("units change");
      units_ = choices_.one_in(3) ? Units::inch : Units::mm;
      words.push_back(units_ == Units::inch ? "G20" : "G21");
      peck_ = 0;
      lose_place();
      break;
    default:
      change_offset(words);
      break;
  }
  write(std::move(words));
}

// Where a program ends.
void HncWriter::outside_block() {
  count("undefined or outside");
  Words words = {choices_.one_in(2) ? code_that_is(Treatment::outside)
                                    : choices_.pick({"G05", "G83", "G33", "G81.1", "G17", "G19"})};
  if (choices_.one_in(2)) words.push_back(axis_word(z, 20));
  if (choices_.one_in(8)) words.push_back("X#1");
  write(std::move(words));
}

void HncWriter::mode_block() {
  switch (choices_.below(10)) {
    case 0:
    case 1:
    case 2:
    case 3:
      return setting_block();
    case 4:
    case 5:
      return set_position();
    case 6:
      count("feed mode");
      return write({choices_.pick({"G94", "G95"}), fmt::format("F{}", 1 + choices_.below(99))});
    case 7:
      count("dwell");
      return write({"G04", fmt::format("P{}", choices_.below(5000))});
    case 8:
      if (puts_wrong(4)) return outside_block();
      if (choices_.one_in(2)) return write({code_that_is(Treatment::without_effect)});
      return write({choices_.pick({"M03", "M08", "S800", "T0101", "F120"})});
    default:
      count("no motion");
      text_ += choices_.pick({"\n", "(only a comment)\n", ";\n", "N77\n", "O55\n"});
  }
}

}  // namespace gonogo::generate
