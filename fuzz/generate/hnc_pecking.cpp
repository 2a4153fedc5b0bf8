// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks of the pecking cycles G74 and G75.
#include <fmt/format.h>

#include "fuzz/generate/hnc_writer.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::generate {

bool HncWriter::counts_from_withdrawn() const {
  return profile_.readings.is("hnc.peck.from=withdrawn"_reading);
}

bool HncWriter::keeps_words() const {
  return profile_.readings.is("hnc.modal.words=kept"_reading);
}

// Q and R. The depth of a peck is a quarter of a unit at least, so that no fault makes pecks
// without number.
void HncWriter::peck_words(Words& words, bool entry) {
  const bool fresh = peck_ == 0 || choices_.one_in(3);
  // Words of before another motion code may be in force: both are written.
  const bool anew = entry && keeps_words();
  if (fresh) {
    peck_ = unit() / 4 + length(4);
    if (anew || choices_.below(20) != 0 || tiny_) words.push_back(word('Q', peck_));
    tiny_ = false;
  }
  // Where pecks count from the withdrawn point, what they gain must not be tiny.
  const bool gains = counts_from_withdrawn() && fresh;
  if (!entry && !gains && !choices_.one_in(3)) return;
  switch (choices_.below(8)) {
    case 0:
      if (!gains && !anew) return;
      [[fallthrough]];
    case 1:
      withdrawal_ = 0;
      break;
    case 2:
      count("e not below dK");
      withdrawal_ = peck_ + (choices_.one_in(2) ? 0 : length(1));
      break;
    default:
      withdrawal_ = peck_ / choices_.pick({2, 3, 4, 10});
      break;
  }
  words.push_back(word('R', withdrawal_));
}

// A few pecks of a few increments; Q is given anew after that.
void HncWriter::tiny_pecks(Words& words, Axis axis) {
  count("tiny pecks");
  const std::int64_t peck = choices_.between(1, 20);
  words.push_back(word('Q', peck));
  words.push_back(word('R', peck / 2));
  const std::int64_t depth = peck * choices_.between(1, settings_.pecks);
  words.push_back(word("UW"[axis], any_sign(scaled(axis, depth))));
  peck_ = withdrawal_ = 0;
  tiny_ = true;
}

// Mostly a whole number of pecks deep, or an increment beside that, counted from the tool.
void HncWriter::bottom_word(Words& words, Axis axis, bool entry) {
  if (!far_ && !entry && choices_.one_in(5)) {
    peck_ = (5 + choices_.below(20)) * unit();
    withdrawal_ = 0;
    tiny_ = false;
    words.push_back(word('Q', peck_));
    words.push_back("R0.1");
    words.push_back(axis_word(axis, 60));
    return;
  }
  if (choices_.one_in(15)) return tiny_pecks(words, axis);
  peck_words(words, entry);
  const bool doubled =
      axis == x && diameter_ && !profile_.readings.is("hnc.g75.depth-scale=diameter"_reading);
  const std::int64_t peck = doubled ? 2 * peck_ : peck_;
  std::int64_t least = choices_.one_in(12) ? 0 : 1;
  // Whether e >= dK counts where the first peck arrives is undecided.
  if (counts_from_withdrawn() && withdrawal_ >= peck_) least = 3;
  std::int64_t depth = peck * choices_.between(least, settings_.pecks);
  if (choices_.one_in(2)) depth += choices_.between(-1, 1);
  if (choices_.one_in(3)) depth += choices_.between(0, peck);
  words.push_back(travel_word(axis, choices_.below(4) != 0 ? -depth : depth));
}

void HncWriter::drill_block() {
  Words words;
  mode_words(words);
  const bool entry = enter(words, 74);
  if (!lacks_axis(6, 40)) bottom_word(words, z, entry);
  // X has no effect, or is where it drills.
  if (choices_.one_in(10)) {
    words.push_back(axis_word(x, 30));
    if (profile_.readings.is("hnc.g74.x=first"_reading)) at_[x].reset();
  }
  feed_words(words, entry, "I");
  write(std::move(words));
}

// Z or W, and the number of axial steps: W / I need not terminate.
void HncWriter::width_words(Words& words) {
  const bool by_p = profile_.readings.is("hnc.g75.i=P"_reading);
  const bool wide = choices_.one_in(2);
  if (wide) words.push_back(travel_word(z, any_sign(length(20))));
  const bool needed = wide && (!counted_ || choices_.one_in(3));
  if (needed != errs(20)) {
    std::string number = fmt::format("{}", choices_.between(1, settings_.steps));
    if (errs(20)) number = choices_.pick({"0", "2.5", "-3", "3.0"});
    words.push_back((by_p ? 'P' : 'I') + number);
    counted_ = true;
  }
  // The other address has no effect.
  if (choices_.one_in(20)) words.push_back(by_p ? "I4" : "P4");
}

void HncWriter::groove_block() {
  Words words;
  mode_words(words);
  const bool entry = enter(words, 75);
  if (!lacks_axis(6, 40)) bottom_word(words, x, entry);
  width_words(words);
  feed_words(words, entry, "A");
  // A groove may end elsewhere than it began.
  if (profile_.readings.is("hnc.g75.end=last"_reading)) at_[z].reset();
  write(std::move(words));
}

}  // namespace gonogo::generate
