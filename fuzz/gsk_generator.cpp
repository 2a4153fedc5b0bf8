// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/gsk_generator.hpp"

#include <fmt/format.h>

#include <array>
#include <vector>

namespace gonogo::fuzz {
namespace {

using reference::Increment;
using reference::Plane;
using reference::Profile;
using reference::ReadingKey;
using reference::Units;

// A length in least increments, written with its decimals: 12500 -> "12.5".
std::string decimal(std::int64_t increments, int decimals) {
  const bool negative = increments < 0;
  std::string digits = std::to_string(negative ? -increments : increments);
  while (static_cast<int>(digits.size()) <= decimals) digits.insert(0, "0");
  digits.insert(digits.size() - static_cast<std::size_t>(decimals), ".");
  while (digits.back() == '0') digits.pop_back();
  if (digits.back() == '.') digits.pop_back();
  return (negative ? "-" : "") + digits;
}

class Generator {
 public:
  Generator(Choices& choices, const GskSettings& settings, Distribution* distribution)
      : choices_(choices), settings_(settings), distribution_(distribution) {}

  GeneratedProgram run();

 private:
  enum class Mode { basic, g94, pocket };

  void count(const std::string& name) {
    if (distribution_ != nullptr) ++(*distribution_)[name];
  }
  void make_profile();
  void make_head();
  void make_block();
  void basic_block();
  void arc_block();
  void g94_block();
  void pocket_block();
  void mode_block();
  void spoil(std::vector<std::string>& words);
  void put(std::vector<std::string> words);

  // Words.
  std::int64_t length(std::int64_t most_mm);
  std::string word(char address, std::int64_t increments) const {
    return address + decimal(increments, decimals());
  }
  int decimals() const {
    return (units_ == Units::inch ? 4 : 3) + (profile_.increment == Increment::isc ? 1 : 0);
  }
  std::int64_t unit() const {  // increments of one mm or inch
    std::int64_t value = 1;
    for (int i = 0; i < decimals(); ++i) value *= 10;
    return value;
  }
  std::string axis_word(std::size_t axis, std::int64_t most_mm);
  std::array<std::size_t, 3> plane_axes() const {
    switch (plane_) {
      case Plane::g17:
        return {0, 1, 2};
      case Plane::g18:
        return {2, 0, 1};
      case Plane::g19:
        return {1, 2, 0};
    }
    return {0, 1, 2};
  }

  Choices& choices_;
  const GskSettings& settings_;
  Distribution* distribution_;
  Profile profile_;
  Units units_ = Units::mm;
  Plane plane_ = Plane::g18;
  Mode mode_ = Mode::basic;
  std::string text_;
};

void Generator::make_profile() {
  if (choices_.one_in(4)) profile_.increment = Increment::isc;
  if (choices_.one_in(4)) profile_.x_diameter = false;
  if (choices_.one_in(8)) profile_.units = Units::inch;
  if (choices_.one_in(8)) profile_.initial.plane = choices_.pick({Plane::g17, Plane::g19});
  if (choices_.one_in(12)) profile_.block_skip = true;
  if (choices_.one_in(3)) {
    const auto [key, value] = choices_.pick<std::pair<ReadingKey, const char*>>({
        {ReadingKey::g94_rewrite, "clear"},
        {ReadingKey::g94_after_00, "cancelled"},
        {ReadingKey::pocket_end, "r-plane"},
        {ReadingKey::pocket_pair, "each"},
        {ReadingKey::pocket_r, "modal"},
        {ReadingKey::missing_axis, "position"},
        {ReadingKey::x_depth, "radius"},
        {ReadingKey::duplicate, "last"},
    });
    profile_.readings.set(key, value);
    count(fmt::format("reading {}={}", reference::reading(key).name, value));
  }
  units_ = profile_.units;
  plane_ = profile_.initial.plane;
}

// Small whole numbers, tenths, single increments: where boundaries lie close together.
std::int64_t Generator::length(std::int64_t most_mm) {
  switch (choices_.below(4)) {
    case 0:
      return choices_.between(0, most_mm) * unit();
    case 1:
      return choices_.between(0, most_mm * 10) * (unit() / 10);
    case 2:
      return choices_.between(0, most_mm) * unit() + choices_.between(-1, 1);
    default:
      return choices_.between(0, most_mm * unit());
  }
}

std::string Generator::axis_word(std::size_t axis, std::int64_t most_mm) {
  const bool increment = choices_.one_in(3);
  std::int64_t value = length(most_mm);
  if (choices_.one_in(2)) value = -value;
  return word((increment ? "UVW" : "XYZ")[axis], value);
}

void Generator::put(std::vector<std::string> words) {
  if (settings_.fault_one_in != 0 && choices_.one_in(settings_.fault_one_in)) spoil(words);
  std::string line;
  if (choices_.one_in(40)) line += '/';
  if (choices_.one_in(10)) line += fmt::format("N{} ", choices_.below(9999));
  const bool together = choices_.one_in(6);
  for (const std::string& item : words) {
    line += item;
    if (!together) line += ' ';
  }
  if (choices_.one_in(12)) line += "(comment \xE5\x88\x80)";
  if (choices_.one_in(10)) line += ";";
  text_ += line + (choices_.one_in(30) ? "\r\n" : "\n");
  if (choices_.one_in(30)) text_ += "\n";
}

// One thing put wrong: what is left may alarm, or may not.
void Generator::spoil(std::vector<std::string>& words) {
  if (words.empty()) return;
  std::string& victim = words[choices_.below(static_cast<std::uint32_t>(words.size()))];
  switch (choices_.below(6)) {
    case 0:
      count("fault: word missing");
      victim.clear();
      break;
    case 1:
      count("fault: word twice");
      words.push_back(victim);
      break;
    case 2:
      count("fault: sign");
      if (victim[0] != 'G' && victim[0] != 'M' && victim.size() > 1) {
        victim = victim[1] == '-' ? victim.substr(0, 1) + victim.substr(2)
                                  : fmt::format("{}-{}", victim[0], victim.substr(1));
      }
      break;
    case 3:
      count("fault: zero");
      // An arc of no radius is undecided, and so is a pocket without depth that ends at the R
      // plane.
      if (victim.find_first_of("UVWXYZ") == 0 &&
          !profile_.readings.is(ReadingKey::pocket_end, "initial")) {
        break;
      }
      if ((words.front() == "G02" || words.front() == "G03") && victim.find_first_of("IJK") == 0)
        break;
      if (victim[0] != 'G' && victim[0] != 'M' && victim[0] != 'F')
        victim = victim.substr(0, 1) + "0";
      break;
    case 4:
      count("fault: another axis");
      words.push_back(axis_word(choices_.below(3), 20));
      break;
    default:
      count("fault: far out");
      if (victim[0] != 'G' && victim[0] != 'M' && victim[0] != 'F') {
        victim = victim.substr(0, 1) + "1000000";
      }
      break;
  }
}

void Generator::make_head() {
  std::vector<std::string> words = {"G00"};
  if (choices_.one_in(2)) {
    plane_ = choices_.pick({Plane::g17, Plane::g18, Plane::g19});
    words.push_back(fmt::format("G{}", reference::plane_code(plane_)));
  }
  count(fmt::format("plane G{}", reference::plane_code(plane_)));
  for (std::size_t axis = 0; axis < 3; ++axis) words.push_back(word("XYZ"[axis], length(100)));
  if (choices_.below(10) != 0) words.push_back(fmt::format("F{}", 50 + choices_.below(500)));
  put(std::move(words));
}

void Generator::basic_block() {
  std::vector<std::string> words;
  const bool cut = choices_.one_in(2);
  if (choices_.below(4) != 0 || mode_ != Mode::basic) words.push_back(cut ? "G01" : "G00");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (choices_.one_in(2)) words.push_back(axis_word(axis, 50));
  }
  if (choices_.one_in(5)) words.push_back(fmt::format("F{}", 50 + choices_.below(500)));
  if (words.empty()) words.push_back("G00");
  count(words.front() == "G01" ? "G01" : "G00 or modal");
  mode_ = Mode::basic;
  put(std::move(words));
}

void Generator::arc_block() {
  const auto [p, q, d] = plane_axes();
  std::vector<std::string> words = {choices_.pick({"G02", "G03"})};
  const std::int64_t radius = length(20) + unit();
  const std::int64_t chord = choices_.between(1, radius);
  // A diameter word is twice the length.
  auto scaled = [&](std::size_t axis, std::int64_t value) {
    return axis == 0 && profile_.x_diameter ? value * 2 : value;
  };
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

void Generator::g94_block() {
  const auto [p, q, d] = plane_axes();
  // Whether the words of G94 outlive a pocket mode is undecided: it is left by a code of its own.
  if (mode_ == Mode::pocket) text_ += choices_.pick({"G80\n", "G00\n"});
  std::vector<std::string> words;
  if (mode_ != Mode::g94 || choices_.one_in(6)) words.push_back("G94");
  count(mode_ == Mode::g94 ? "G94 repeated" : "G94 entry");
  if (choices_.below(3) != 0) words.push_back(axis_word(p, 60));
  if (choices_.below(3) != 0) words.push_back(axis_word(q, 60));
  if (choices_.one_in(2)) {
    std::int64_t taper = length(30);
    words.push_back(word('R', choices_.one_in(2) ? taper : -taper));
  }
  if (choices_.one_in(4)) words.push_back(fmt::format("F{}", 50 + choices_.below(500)));
  if (words.empty()) words.push_back(axis_word(q, 60));
  mode_ = Mode::g94;
  put(std::move(words));
}

void Generator::pocket_block() {
  const auto [p, q, d] = plane_axes();
  std::vector<std::string> words;
  const bool entry = mode_ != Mode::pocket;
  if (entry || choices_.one_in(4)) words.push_back(choices_.pick({"G110", "G111"}));
  count(entry ? "pocket entry" : "pocket repeated");
  words.push_back(axis_word(p, 60));
  words.push_back(axis_word(q, 60));
  // Depth as an increment from the R plane, so that its direction is known.
  const bool down = choices_.below(6) != 0;
  const std::int64_t infeed = length(4) + 1;
  std::int64_t depth = infeed * choices_.between(1, settings_.layers) - choices_.below(3);
  // Where a pocket without depth ends under gsk.pocket.end = r-plane is undecided.
  const bool ends_above = profile_.readings.is(ReadingKey::pocket_end, "initial");
  if (choices_.one_in(20) && ends_above) depth = 0;
  if (depth == 0 && !ends_above) depth = 1;
  const std::int64_t scale = d == 0 && profile_.x_diameter ? 2 : 1;
  words.push_back(word("UVW"[d], (down ? -depth : depth) * scale));
  if (choices_.below(3) != 0) {
    const std::int64_t above = length(5);
    words.push_back(word('R', down != choices_.one_in(25) ? -above : above));
  }
  if (entry || choices_.one_in(3)) {
    const std::int64_t tool = length(5) + choices_.below(3) + 1;
    const std::int64_t step = choices_.between(1, 2 * tool) - (choices_.one_in(2) ? 1 : 0);
    const std::int64_t rings = choices_.between(0, settings_.rings * 4);
    const std::int64_t reach = (step > 0 ? step : 1) * rings / 4 + choices_.below(2);
    words.push_back(word('I', tool + reach));
    words.push_back(word('L', step));
    words.push_back(word('Q', infeed));
    words.push_back(word('D', tool));
  }
  if (choices_.one_in(2)) words.push_back(word('P', choices_.one_in(5) ? -length(2) : length(2)));
  if (choices_.one_in(4)) words.push_back(fmt::format("F{}", 50 + choices_.below(500)));
  mode_ = Mode::pocket;
  put(std::move(words));
}

// What changes modes, or has nothing to do with them.
void Generator::mode_block() {
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
      // Not through put(): what a dwell without a time means is undecided.
      text_ += fmt::format("G04 P{}\n", choices_.below(5000));
      return;
    case 4:
      count("G28");
      return put({"G28", axis_word(choices_.below(3), 20)});
    case 5:
      if (mode_ == Mode::pocket) return put({"M8"});  // the initial plane is undecided there
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

void Generator::make_block() {
  const std::uint32_t kind = choices_.below(12);
  if (kind < 2) return basic_block();
  if (kind < 3) return settings_.arcs ? arc_block() : basic_block();
  if (kind < 7) return g94_block();
  if (kind < 10) return settings_.pockets ? pocket_block() : g94_block();
  mode_block();
}

GeneratedProgram Generator::run() {
  make_profile();
  make_head();
  const std::int64_t blocks = choices_.between(1, settings_.blocks);
  for (std::int64_t i = 0; i < blocks && !choices_.exhausted(); ++i) make_block();
  if (choices_.one_in(2)) text_ += "M30\n";
  return {std::move(profile_), std::move(text_)};
}

}  // namespace

GeneratedProgram generate_gsk(Choices& choices, const GskSettings& settings,
                              Distribution* distribution) {
  return Generator(choices, settings, distribution).run();
}

}  // namespace gonogo::fuzz
