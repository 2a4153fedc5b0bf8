// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks of the thread cycle G82.
#include <fmt/format.h>

#include <cstdlib>

#include "fuzz/generate/hnc_writer.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::generate {

// F or J, seldom both.
void HncWriter::lead_words(Words& words, bool entry) {
  if (entry ? choices_.one_in(20) : choices_.below(4) != 0) return;
  const bool both = choices_.one_in(40);
  const bool inch = choices_.one_in(4);
  if (inch || both) words.push_back(fmt::format("J0.0{}", 1 + choices_.below(9)));
  if (!inch || both) {
    words.push_back(fmt::format("F{}.{}", 1 + choices_.below(5), choices_.below(10)));
  }
}

// C and P.
void HncWriter::start_words(Words& words) {
  const std::uint32_t kind = choices_.below(8);
  if (kind < 2) {
    const auto most = static_cast<std::uint32_t>(settings_.starts) + 1;
    words.push_back(choices_.one_in(20) ? "C1.5" : fmt::format("C{}", choices_.below(most)));
  }
  if (kind > 0 && kind < 4) {
    words.push_back(choices_.one_in(2) ? fmt::format("P{}", choices_.below(25) * 30)
                                       : fmt::format("P{}.{}", choices_.below(800), 5));
  }
}

// The length along X as E counts it.
std::string HncWriter::e_word(std::int64_t length) {
  const bool doubled = diameter_ && profile_.readings.is("hnc.g82.e-scale=diameter"_reading);
  return word('E', doubled ? 2 * length + choices_.between(-1, 1) : length);
}

// R and E, seldom one of them alone or one that is zero.
void HncWriter::run_out_words(Words& words) {
  const std::uint32_t kind = choices_.below(16);
  if (kind == 0) {
    words.push_back("R0");
    words.push_back("E0");
    return;
  }
  if (kind != 1) words.push_back(word('R', any_sign(length(5) + length_of(unit() / 4))));
  if (kind != 2) words.push_back(e_word(any_sign(length(5) + length_of(unit() / 4))));
}

// Z, I, R and E where the run-out along the short axis is 20 times that along the long one, or an
// increment beside that; now and then both travels are alike, too.
void HncWriter::near_ratio_words(Words& words) {
  count("G82 near the ratio");
  const std::int64_t along_z = any_sign(length(20) + 2);
  const std::int64_t along_x =
      choices_.one_in(3) ? std::abs(along_z) + choices_.between(-1, 1) : length(15);
  words.push_back(travel_word(z, along_z));
  words.push_back(word('I', any_sign(along_x)));
  const std::int64_t small = length(2) + 2;
  const std::int64_t large = 20 * small + choices_.between(-1, 1);
  const bool x_is_long = along_x > std::abs(along_z);
  words.push_back(word('R', any_sign(x_is_long ? large : small)));
  words.push_back(e_word(any_sign(x_is_long ? small : large)));
}

void HncWriter::thread_block() {
  Words words;
  mode_words(words);
  const bool entry = enter(words, 82);
  if (choices_.one_in(4)) {
    words.push_back(axis_word(x, 60));
    near_ratio_words(words);
  } else {
    end_words(words, 60);
    if (choices_.one_in(2)) words.push_back(word('I', any_sign(length(10))));
    if (choices_.one_in(3)) run_out_words(words);
  }
  if (choices_.one_in(2)) start_words(words);
  lead_words(words, entry);
  const bool lacks_q = profile_.readings.is("hnc.g82.q=alarm"_reading);
  if (choices_.one_in(8) && (!lacks_q || errs(4))) {
    words.push_back(fmt::format("Q{}", choices_.below(100)));
  }
  if (choices_.one_in(20)) words.push_back("A3");
  write(std::move(words));
}

}  // namespace gonogo::generate
