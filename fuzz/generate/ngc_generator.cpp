// SPDX-License-Identifier: GPL-3.0-or-later
#include <variant>

#include "fuzz/generate/ngc_writer.hpp"

namespace gonogo::generate {

using reference::Number;
using reference::Units;

void NgcWriter::make_profile() {
  profile_ = std::get<reference::Profile>(reference::default_profile("rs274"));
  if (settings_.machine.state) make_state();
  if (settings_.machine.readings) choose_readings();
  inch_ = profile_.units == Units::inch;
  motion_ = profile_.initial.motion;
  plane_ = plane_code(profile_.initial.plane);
  spindle_ = profile_.initial.spindle;
}

void NgcWriter::make_state() {
  if (choices_.one_in(8)) profile_.units = Units::inch;
  if (choices_.one_in(12)) profile_.block_skip = true;
  for (const auto axis : reference::kAllAxes) {
    if (choices_.one_in(3)) {
      profile_.initial.at[axis] = Number::millionths(choices_.between(-500'000, 500'000) * 100);
    }
  }
  choose_initial_modes();
  if (choices_.one_in(4)) profile_.initial.spindle = choices_.one_in(2) ? 3 : 4;
}

void NgcWriter::make_head() {
  if (choices_.one_in(4)) {
    opened_ = true;
    text_ += choices_.pick({"%\n", "\n  %\n", "%\n(part 7)\n", "%\nO0007 (part)\n"});
  } else if (puts_wrong(40)) {
    text_ += choices_.pick({"(part 7)\n\n%\n", ";\n%\n", "%part 7\n", "/\n%\n"});
  } else if (errs(16)) {
    count("name of a program");
    text_ += choices_.pick({"O7\n", "o 0 0 7 (part) ;\n", "O0007 (part)\n", "N1 O7\n"});
  }
  if (choices_.one_in(3)) {
    text_ += choices_.pick(
        {"G17 G21 G40 G49 G80 G90 G94\n", "T1 M3 S500\n", "G54 G64 M3\n", "g40 g49 g90\n"});
    if (text_.find("G17") != std::string::npos) start_modes(-1);
    if (text_.find("M3") != std::string::npos) spindle_ = 3;
  } else if (is_g80_forgotten() ? choices_.one_in(2) : errs(40)) {
    count("G80 beside G0");
    text_ += "G00 G17 G21 G40 G49 G80 G90\n";
    start_modes(0);
  }
  Words words;
  enter(words, 0);
  for (const Axis axis : {x, y, z}) words.push_back(axis_word(axis, 50));
  if (!errs(20)) words.push_back(feed_word());
  arrive();
  write(std::move(words));
}

// After a first line that says all of them.
void NgcWriter::start_modes(int motion) {
  plane_ = 17;
  motion_ = motion;
  inch_ = false;
}

// A text without an end alarms, or does not, by a reading.
void NgcWriter::make_end() {
  if (errs(12)) return count("no end");
  if (opened_ && choices_.one_in(2)) {
    text_ += choices_.pick({"%\n", "%\nG0 X99\n", " % \ngarbage (\n"});
  } else if (puts_wrong(20)) {
    text_ += choices_.pick({"%\n", "% end\n", "%%\n"});
  } else {
    text_ += choices_.pick({"M30\n", "M5\nM2\n", "m2\n", "M2\n%\n", "M 0 2\n", "M30\nX99\n"});
  }
}

void NgcWriter::make_block() {
  const std::uint32_t kind = choices_.below(20);
  if (kind < 3) return line_block();
  if (kind < 4) return rotary_block();
  if (kind < 10) return arc_block();
  if (kind < 15) return cycle_block();
  if (kind < 16) return synchronous_block();
  if (kind < 17) return threading_block();
  if (kind == 19 && choices_.one_in(3)) return further_modes();
  mode_block();
}

GeneratedProgram NgcWriter::run() {
  make_profile();
  make_head();
  const std::int64_t blocks = number_of_blocks(10);
  for (std::int64_t i = 0; i < blocks && !choices_.exhausted(); ++i) {
    // Cycles come one behind the other.
    if (is_hole_cycle(motion_) && choices_.one_in(2)) {
      cycle_block();
    } else {
      make_block();
    }
  }
  make_end();
  return {std::move(profile_), std::move(text_)};
}

GeneratedProgram generate_ngc(Choices& choices, const GeneratorSettings& settings, ProgramKind kind,
                              Distribution* distribution) {
  return NgcWriter(choices, settings, kind, distribution).run();
}

}  // namespace gonogo::generate
