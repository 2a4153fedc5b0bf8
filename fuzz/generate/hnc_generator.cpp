// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "fuzz/generate/hnc_writer.hpp"

namespace gonogo::generate {

using reference::Number;
using reference::Units;

void HncWriter::make_profile() {
  profile_.dialect = "hnc21t";
  if (settings_.machine.state) make_state();
  if (settings_.machine.offsets) make_offsets();
  if (settings_.machine.parameters && choices_.one_in(4)) {
    profile_.parameters["3410"] = Number::millionths(choices_.between(-2, 20) * 1'000);
  }
  if (settings_.machine.readings) choose_readings();
  units_ = profile_.units;
  far_ = units_ == Units::inch;
  diameter_ = profile_.x_diameter;
}

void HncWriter::make_state() {
  if (choices_.one_in(4)) profile_.x_diameter = false;
  if (choices_.one_in(8)) profile_.units = Units::inch;
  if (choices_.one_in(12)) profile_.block_skip = true;
  for (const auto axis : {reference::Axis::x, reference::Axis::z}) {
    if (choices_.one_in(2)) {
      profile_.initial.at[axis] = Number::millionths(choices_.between(-100'000, 100'000) * 1'000);
    }
  }
  if (choices_.one_in(8)) profile_.initial.feed = choices_.between(1, 500);
}

void HncWriter::make_offsets() {
  for (int number = 54; number <= 59; ++number) {
    if (!choices_.one_in(3)) continue;
    reference::Position& offset = profile_.offsets[fmt::format("G{}", number)];
    offset[reference::Axis::x] = Number::millionths(choices_.between(-20'000, 20'000) * 1'000);
    offset[reference::Axis::z] = Number::millionths(choices_.between(-20'000, 20'000) * 1'000);
  }
}

void HncWriter::make_head() {
  if (choices_.one_in(4))
    text_ += choices_.pick({"%1234\n", "O0230\n", "%\nO0230\n", "%7 (part)\n"});
  if (choices_.one_in(3)) text_ += choices_.pick({"T0101\n", "M03 S500\n", "G40 G97 G18 M03\n"});
  Words words;
  if (choices_.one_in(3)) change_offset(words);
  if (choices_.one_in(3)) words.push_back("G90");
  words.push_back("G00");
  for (const Axis axis : {x, z}) {
    target_[axis] = length(100);
    words.push_back(word("XZ"[axis], *target_[axis]));
  }
  if (!errs(10)) words.push_back(feed_word());
  if (choices_.one_in(8)) words.push_back("M03");
  arrive();
  write(std::move(words));
}

void HncWriter::make_block() {
  const std::uint32_t kind = choices_.below(20);
  if (kind < 2) return basic_block();
  if (kind < 3) return arc_block();
  if (kind < 4) return thread_line();
  if (kind < 8) return cut_block(choices_.pick({80, 81}));
  if (kind < 11) return thread_block();
  if (kind < 13) return drill_block();
  if (kind < 16) return groove_block();
  mode_block();
}

void HncWriter::repeat_block() {
  switch (code_) {
    case 32:
      return thread_line();
    case 74:
      return drill_block();
    case 75:
      return groove_block();
    case 82:
      return thread_block();
    default:
      return cut_block(code_);
  }
}

GeneratedProgram HncWriter::run() {
  make_profile();
  make_head();
  const std::int64_t blocks = number_of_blocks(8);
  for (std::int64_t i = 0; i < blocks && !choices_.exhausted(); ++i) {
    // Cycles and thread lines are repeated by blocks without their code.
    if (code_ >= 32 && choices_.one_in(2)) {
      repeat_block();
    } else {
      make_block();
    }
  }
  if (choices_.one_in(2)) text_ += choices_.pick({"M30\n", "M05\nM30\n", "M02\n", "M30\n%\n"});
  return {std::move(profile_), std::move(text_)};
}

GeneratedProgram generate_hnc(Choices& choices, const GeneratorSettings& settings, ProgramKind kind,
                              Distribution* distribution) {
  return HncWriter(choices, settings, kind, distribution).run();
}

}  // namespace gonogo::generate
