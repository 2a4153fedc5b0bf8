// SPDX-License-Identifier: GPL-3.0-or-later
//
// Modes of feed and of diameters, modes that are saved, and polar words: some blocks under one of
// them, and the way back to the modes that the other blocks are written for.
#include "fuzz/generate/ngc_writer.hpp"

namespace gonogo::generate {

// G93 asks for F in each block that cuts, and no F outlives a change of the mode.
void NgcWriter::feed_mode_blocks() {
  inverse_time_ = choices_.below(3) != 0;
  count(inverse_time_ ? "inverse time" : "feed per revolution");
  mode_to_enter_ = inverse_time_ ? "G93" : "G95";
  if (choices_.one_in(2)) write({std::exchange(mode_to_enter_, {})});
  for (std::int64_t blocks = choices_.between(1, 3); blocks > 0; --blocks) {
    const std::uint32_t kind = choices_.below(8);
    if (kind < 3) {
      line_block();
    } else if (kind < 5) {
      rotary_block();
    } else if (kind < 7 || !errs(3)) {
      arc_block();
    } else {
      cycle_block();
    }
  }
  inverse_time_ = false;
  Words words = {"G94"};
  if (!errs(4)) words.push_back(feed_word());
  write(std::move(words));
}

// Half of what X says is a place for which the other blocks have no number.
void NgcWriter::diameter_blocks() {
  count("diameters");
  at_[x].reset();
  write({"G7"});
  for (std::int64_t blocks = choices_.between(1, 2); blocks > 0; --blocks) line_block();
  write({"G8"});
  lose_place();
}

// Without the motion, what M72 puts back is as it was.
void NgcWriter::saved_modes_blocks() {
  count("saved modes");
  write({"M70"});
  const auto [inch, incremental, absolute_centre, plane, retract] =
      std::tuple(inch_, incremental_, absolute_centre_, plane_, retract_);
  for (std::int64_t blocks = choices_.between(1, 2); blocks > 0; --blocks) {
    if (choices_.one_in(2)) {
      setting_block();
    } else {
      line_block();
    }
  }
  if (inch_ != inch) lose_place();
  std::tie(inch_, incremental_, absolute_centre_, plane_, retract_) =
      std::tuple(inch, incremental, absolute_centre, plane, retract);
  series_plane_ = 0;
  write({errs(12) ? "M71" : "M72"});
  line_block();
}

// Under G90 the distance, the angle or both; under G91 what is added to them.
void NgcWriter::polar_words(Words& words) {
  count("polar words");
  const std::uint32_t without = choices_.below(4);
  if (without != 0) words.push_back(word('@', choices_.one_in(16) ? 0 : length(20)));
  if (without != 1) words.push_back(word('^', any_sign(unit() * 15 * choices_.between(0, 14))));
  if (puts_wrong(16)) words.push_back(word(choices_.pick({'X', 'Y'}), length(20)));
  target_[x].reset();
  target_[y].reset();
}

void NgcWriter::polar_blocks() {
  if (plane_ != 17) {
    plane_ = 17;
    write({code(17)});
  }
  for (std::int64_t blocks = choices_.between(1, 3); blocks > 0; --blocks) {
    if (choices_.one_in(3)) {
      is_polar_ = true;
      cycle_block();
      is_polar_ = false;
      continue;
    }
    Words words;
    mode_words(words);
    enter(words, choices_.one_in(2) ? 1 : 0);
    polar_words(words);
    if (choices_.one_in(4)) words.push_back(axis_word(z, 20));
    feed_words(words);
    arrive();
    write(std::move(words));
  }
}

void NgcWriter::further_modes() {
  switch (choices_.below(4)) {
    case 0:
      return feed_mode_blocks();
    case 1:
      return diameter_blocks();
    case 2:
      return saved_modes_blocks();
    default:
      return polar_blocks();
  }
}

}  // namespace gonogo::generate
