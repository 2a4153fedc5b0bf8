// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "fuzz/generate/gsk_writer.hpp"

namespace gonogo::generate {

using reference::Increment;
using reference::Plane;
using reference::Units;

namespace {

// GSK-MOD-08: milliseconds of P, seconds of X and U; the address follows from the time.
std::string dwell_word(std::uint32_t milliseconds) {
  constexpr std::uint32_t kAddresses = 4;
  const std::uint32_t address = milliseconds % kAddresses;
  if (address > 1) return fmt::format("P{}", milliseconds);
  return fmt::format("{}{}.{:03}", address == 0 ? 'X' : 'U', milliseconds / 1000,
                     milliseconds % 1000);
}

}  // namespace

void GskWriter::make_state() {
  if (choices_.one_in(4)) profile_.increment = Increment::isc;
  if (choices_.one_in(4)) profile_.x_diameter = false;
  if (choices_.one_in(8)) profile_.units = Units::inch;
  if (choices_.one_in(8)) profile_.initial.plane = choices_.pick({Plane::g17, Plane::g19});
  if (choices_.one_in(12)) profile_.block_skip = true;
}

void GskWriter::make_profile() {
  if (settings_.machine.state) make_state();
  // Any other choice than the default.
  if (settings_.machine.readings && choices_.one_in(3)) {
    count("reading " + choose_reading(choices_, profile_));
  }
  if (settings_.machine.parameters && choices_.one_in(4)) {
    profile_.parameters["5920"] = reference::Number(choices_.between(0, 360));
    profile_.parameters["5921"] = reference::Number::millionths(choices_.between(0, 9'999) * 1'000);
  }
  units_ = profile_.units;
  plane_ = profile_.initial.plane;
}

void GskWriter::make_head() {
  Words words = {"G00"};
  if (choices_.one_in(2)) {
    plane_ = choices_.pick({Plane::g17, Plane::g18, Plane::g19});
    words.push_back(fmt::format("G{}", reference::plane_code(plane_)));
  }
  count(fmt::format("plane G{}", reference::plane_code(plane_)));
  for (std::size_t axis = 0; axis < 3; ++axis) words.push_back(word("XYZ"[axis], length(100)));
  if (!errs(10)) words.push_back(fmt::format("F{}", 50 + choices_.below(500)));
  put(std::move(words));
}

// What changes modes, or has nothing to do with them.
void GskWriter::mode_block() {
  switch (choices_.below(9)) {
    case 0:
      count("plane change");
      plane_ = choices_.pick({Plane::g17, Plane::g18, Plane::g19});
      return put({fmt::format("G{}", reference::plane_code(plane_))});
    case 1:
      count("units change");
      units_ = choices_.one_in(3) ? Units::inch : Units::mm;
      return put({units_ == Units::inch ? "G20" : "G21"});
    case 2:
      count("feed mode");
      return put({choices_.pick({"G98", "G99"}), fmt::format("F{}", 1 + choices_.below(99))});
    case 3:
      count("dwell");
      return put({"G04", dwell_word(choices_.below(5000))});
    case 4:
      count("G28");
      return put({"G28", axis_word(choices_.below(3), 20)});
    case 5:
      count("G50");
      return put({"G50", word("XYZ"[choices_.below(3)], length(30))});
    case 6:
      count("G80");
      mode_ = Mode::basic;
      return put({"G80"});
    case 7:
      return put({choices_.pick({"M3", "M8", "M35", "G40", "G97", "S800", "T0101"})});
    default:
      count("no motion");
      text_ += choices_.pick({"\n", "(only a comment)\n", ";\n", "N77\n"});
  }
}

void GskWriter::make_block() {
  const std::uint32_t kind = choices_.below(16);
  if (kind < 2) return basic_block();
  if (kind < 3) return arc_block();
  if (kind < 7) return turning_block();
  if (kind < 9) return settings_.pockets ? pocket_block() : turning_block();
  if (kind < 11) return helix_block();
  if (kind < 14) return thread_block();
  mode_block();
}

GeneratedProgram GskWriter::run() {
  make_profile();
  make_head();
  const std::int64_t blocks = number_of_blocks(8);
  for (std::int64_t i = 0; i < blocks && !choices_.exhausted(); ++i) make_block();
  if (choices_.one_in(2)) text_ += "M30\n";
  return {std::move(profile_), std::move(text_)};
}

GeneratedProgram generate_gsk(Choices& choices, const GeneratorSettings& settings, ProgramKind kind,
                              Distribution* distribution) {
  return GskWriter(choices, settings, kind, distribution).run();
}

}  // namespace gonogo::generate
