// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks of turning programs: traverses and feeds, arcs, G90, G92 and G94.
#include <fmt/format.h>

#include "fuzz/generate/gsk_writer.hpp"

namespace gonogo::generate {

void GskWriter::basic_block() {
  Words words;
  const bool cut = choices_.one_in(2);
  if (choices_.below(4) != 0 || mode_ != Mode::basic) words.push_back(cut ? "G01" : "G00");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (choices_.one_in(2)) words.push_back(axis_word(axis, 50));
  }
  if (choices_.one_in(5)) words.push_back(feed_word());
  if (words.empty()) words.push_back("G00");
  count(words.front() == "G01" ? "G01" : "G00 or modal");
  mode_ = Mode::basic;
  put(std::move(words));
}

void GskWriter::arc_block() {
  const auto [p, q, d] = plane_axes();
  Words words = {choices_.pick({"G02", "G03"})};
  const std::int64_t radius = length(20) + length_of(unit());
  const std::int64_t chord = choices_.between(1, radius);
  if (choices_.one_in(2)) {
    count("arc by R");
    words.push_back(word("UVW"[p], scaled(p, choices_.one_in(2) ? chord : -chord)));
    if (choices_.one_in(2)) words.push_back(word("UVW"[q], scaled(q, chord / 2)));
    words.push_back(word('R', choices_.one_in(4) ? -radius : radius));
  } else {
    // A quarter, a half or the whole of a circle about an offset along p.
    count("arc by centre");
    words.push_back(word("IJK"[p], radius));
    const std::uint32_t part = choices_.below(3);
    if (part == 0) words.push_back(word("UVW"[p], scaled(p, 2 * radius)));
    if (part == 1) {
      words.push_back(word("UVW"[p], scaled(p, radius)));
      words.push_back(word("UVW"[q], scaled(q, choices_.one_in(2) ? radius : -radius)));
    }
  }
  if (choices_.one_in(4)) words.push_back(word("UVW"[d], length(10)));
  mode_ = Mode::basic;
  put(std::move(words));
}

void GskWriter::turning_block() {
  const auto [p, q, d] = plane_axes();
  Words words;
  const bool entry = mode_ != Mode::turning;
  const bool coded = entry || choices_.one_in(6);
  if (coded) {
    turning_code_ = choices_.pick({90, 92, 94, 94});
    words.push_back(fmt::format("G{}", turning_code_));
  }
  count(fmt::format("G{} {}", turning_code_, entry ? "entry" : "repeated"));
  if (choices_.below(3) != 0) words.push_back(axis_word(p, 60));
  if (choices_.below(3) != 0) words.push_back(axis_word(q, 60));
  if (choices_.one_in(2)) {
    const std::int64_t taper = length(30);
    words.push_back(word('R', choices_.one_in(2) ? taper : -taper));
  }
  // The F of a thread is its lead.
  if (turning_code_ == 92 && coded) {
    words.push_back(fmt::format("F{}.{}", 1 + choices_.below(4), choices_.below(10)));
  } else if (choices_.one_in(4)) {
    words.push_back(feed_word());
  }
  if (words.empty()) words.push_back(axis_word(q, 60));
  mode_ = Mode::turning;
  put(std::move(words));
}

}  // namespace gonogo::generate
