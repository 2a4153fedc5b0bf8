// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traverses and feeds, thread lines (G32), arcs, and the cycles G80 and G81.
#include <fmt/format.h>

#include "fuzz/generate/hnc_writer.hpp"

namespace gonogo::generate {

void HncWriter::basic_block() {
  Words words;
  mode_words(words);
  if (code_ > 1 || choices_.below(4) != 0) {
    code_ = choices_.one_in(2) ? 1 : 0;
    words.push_back(code_ == 1 ? "G01" : "G00");
  }
  count(code_ == 1 ? "G01" : "G00");
  for (const Axis axis : {x, z}) {
    if (choices_.below(3) != 0) words.push_back(axis_word(axis, 50));
  }
  if (choices_.one_in(5)) words.push_back(choices_.one_in(12) ? "F0" : feed_word());
  if (choices_.one_in(12)) words.push_back("M03");
  arrive();
  write(std::move(words));
}

void HncWriter::thread_line() {
  Words words;
  mode_words(words);
  const bool entry = enter(words, 32);
  const std::uint32_t only = choices_.below(4);
  for (const Axis axis : {x, z}) {
    if (axis != only) words.push_back(axis_word(axis, 50));
  }
  lead_words(words, entry);
  // A run-out or a start angle of G32 is not covered.
  if (choices_.one_in(30)) words.push_back(choices_.pick({"R2", "E1", "P90", "R0"}));
  arrive();
  write(std::move(words));
}

void HncWriter::arc_block() {
  Words words;
  mode_words(words);
  code_ = choices_.pick({2, 3});
  words.push_back(code_ == 2 ? "G02" : "G03");
  const std::int64_t radius = length(20) + length_of(unit());
  if (choices_.one_in(2)) {
    count("arc by R");
    const std::int64_t chord = choices_.between(1, radius);
    words.push_back(travel_word(z, any_sign(chord)));
    if (choices_.one_in(2)) words.push_back(travel_word(x, any_sign(scaled(x, chord / 2))));
    words.push_back(word('R', choices_.one_in(4) ? -radius : radius));
  } else {
    // A quarter, a half or the whole of a circle; now and then the end is a little beside it.
    count("arc by centre");
    const std::int64_t k = choices_.one_in(30) ? 0 : any_sign(radius);
    const std::int64_t i = choices_.one_in(2) ? any_sign(length(20)) : 0;
    if (k != 0 || choices_.one_in(2)) words.push_back(word('K', k));
    if (i != 0 || choices_.one_in(6)) words.push_back(word('I', i));
    const bool nil = k == 0 && i == 0;
    const std::int64_t beside = !nil && choices_.one_in(4) ? choices_.between(-12, 12) : 0;
    const std::int64_t turn = choices_.between(-1, 1);  // 0: half a turn
    if (choices_.below(3) != 0) {
      words.push_back(travel_word(z, (turn == 0 ? 2 * k : k + turn * i) + beside));
      words.push_back(travel_word(x, scaled(x, turn == 0 ? 2 * i : i - turn * k)));
    }
  }
  if (choices_.one_in(6)) words.push_back(feed_word());
  arrive();
  write(std::move(words));
}

void HncWriter::cut_block(int code) {
  Words words;
  mode_words(words);
  const bool entry = enter(words, code);
  end_words(words, 60);
  if (choices_.one_in(2)) words.push_back(word(code == 80 ? 'I' : 'K', any_sign(length(10))));
  feed_words(words, entry, code == 80 ? "K" : "I");
  write(std::move(words));
}

}  // namespace gonogo::generate
