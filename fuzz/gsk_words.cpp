// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "fuzz/gsk_writer.hpp"

namespace gonogo::fuzz {
namespace {

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

}  // namespace

using reference::Increment;
using reference::Plane;
using reference::Units;

int GskWriter::decimals() const {
  return (units_ == Units::inch ? 4 : 3) + (profile_.increment == Increment::isc ? 1 : 0);
}

std::int64_t GskWriter::unit() const {
  std::int64_t value = 1;
  for (int i = 0; i < decimals(); ++i) value *= 10;
  return value;
}

std::array<std::size_t, 3> GskWriter::plane_axes() const {
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

std::string GskWriter::word(char address, std::int64_t increments) const {
  return address + decimal(increments, decimals());
}

std::string GskWriter::feed_word() {
  return fmt::format("F{}", 50 + choices_.below(500));
}

// Small whole numbers, tenths, single increments: where boundaries lie close together.
std::int64_t GskWriter::length(std::int64_t most_mm) {
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

std::string GskWriter::axis_word(std::size_t axis, std::int64_t most_mm) {
  const bool increment = choices_.one_in(3);
  std::int64_t value = length(most_mm);
  if (choices_.one_in(2)) value = -value;
  return word((increment ? "UVW" : "XYZ")[axis], value);
}

void GskWriter::put(Words words) {
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
void GskWriter::spoil(Words& words) {
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
      // Whether -0 has a sign is undecided.
      if (victim[0] != 'G' && victim[0] != 'M' &&
          victim.find_first_of("123456789") != std::string::npos) {
        victim = victim[1] == '-' ? victim.substr(0, 1) + victim.substr(2)
                                  : fmt::format("{}-{}", victim[0], victim.substr(1));
      }
      break;
    case 3:
      count("fault: zero");
      // A straight run-out along the tangent meets the thread itself.
      if (victim[0] == 'K' && profile_.readings.is(reference::ReadingKey::thread_runout, "tangent"))
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

}  // namespace gonogo::fuzz
