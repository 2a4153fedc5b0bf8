// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/program_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "fuzz/program/text.hpp"
#include "reference/dialect.hpp"

namespace gonogo::generate {
namespace {

// What a word of a letter and a plain decimal says, in least increments; nothing of other words,
// and of more decimals than these.
std::optional<std::int64_t> increments_of(const std::string& word, int decimals) {
  constexpr std::size_t kMostDigits = 12;
  if (word.size() < 2) return std::nullopt;
  std::int64_t value = 0;
  int behind = -1;  // digits behind the point; -1: before it
  for (const char c : std::string_view(word).substr(word[1] == '-' ? 2 : 1)) {
    if (c == '.' && behind < 0) {
      behind = 0;
    } else if (c >= '0' && c <= '9' && word.size() <= kMostDigits) {
      value = value * 10 + (c - '0');
      if (behind >= 0) ++behind;
    } else {
      return std::nullopt;
    }
  }
  if (behind > decimals) return std::nullopt;
  for (int i = std::max(behind, 0); i < decimals; ++i) value *= 10;
  return value;
}

bool is_code(const std::string& word) {
  return word[0] == 'G' || word[0] == 'M';
}

}  // namespace

std::int64_t ProgramWriter::unit() const {
  std::int64_t value = 1;
  for (int i = 0; i < decimals(); ++i) value *= 10;
  return value;
}

std::string ProgramWriter::word(char address, std::int64_t increments) const {
  return address + program::SmallDecimal{increments, decimals()}.text();
}

std::string ProgramWriter::feed_word() {
  return fmt::format("F{}", 50 + choices_.below(500));
}

// Small whole numbers, tenths, single increments: where boundaries lie close together.
std::int64_t ProgramWriter::length(std::int64_t most_units) {
  if (program_kind_ == ProgramKind::tiny && choices_.one_in(2)) return choices_.between(0, 3);
  switch (choices_.below(4)) {
    case 0:
      return choices_.between(0, most_units) * unit();
    case 1:
      return choices_.between(0, most_units * 10) * (unit() / 10);
    case 2:
      return choices_.between(0, most_units) * unit() + choices_.between(-1, 1);
    default:
      return choices_.between(0, most_units * unit());
  }
}

std::int64_t ProgramWriter::length_of(std::int64_t increments) {
  if (program_kind_ == ProgramKind::tiny && choices_.one_in(2)) return choices_.between(1, 3);
  return increments;
}

std::string ProgramWriter::head() {
  std::string text;
  if (choices_.one_in(40)) text += '/';
  if (choices_.one_in(10)) text += fmt::format("N{} ", choices_.below(9999));
  return text;
}

std::string ProgramWriter::tail() {
  std::string text;
  if (choices_.one_in(12)) text += "(comment \xE5\x88\x80)";
  if (choices_.one_in(10)) text += ";";
  return text;
}

std::string ProgramWriter::negated(const std::string& word) const {
  return word[1] == '-' ? word.substr(0, 1) + word.substr(2)
                        : fmt::format("{}-{}", word[0], word.substr(1));
}

std::string ProgramWriter::with_value(const std::string& word, const char* value) const {
  return word.substr(0, 1) + value;
}

void ProgramWriter::put(Words words) {
  if (puts_wrong(settings_.fault_one_in)) {
    spoil(words);
    on_fault();
  }
  if (program_kind_ == ProgramKind::boundary && choices_.one_in(2)) move_to_boundary(words);
  std::string line = head();
  const bool together = choices_.one_in(6);
  for (const std::string& item : words) {
    line += printed(item);
    if (!together) line += ' ';
  }
  line += tail();
  text_ += line + (choices_.one_in(30) ? "\r\n" : "\n");
  if (choices_.one_in(30)) text_ += "\n";
}

std::string ProgramWriter::code_that_is(reference::Treatment treatment) {
  const auto codes = reference::find_dialect(profile_.dialect)->descriptor->codes;
  const auto is_it = [&](const reference::Code& code) {
    // Addresses need a value, and patterns stand for what the table does not list.
    const bool stands_alone = code.name.size() > 1 && code.name.find('<') == std::string_view::npos;
    return code.treatment == treatment && stands_alone;
  };
  const auto count = std::ranges::count_if(codes, is_it);
  auto left = choices_.below(static_cast<std::uint32_t>(count));
  const auto found = std::ranges::find_if(
      codes, [&](const reference::Code& code) { return is_it(code) && left-- == 0; });
  return std::string(found->name);
}

void ProgramWriter::choose_readings() {
  while (choices_.one_in(2) && !choices_.exhausted()) {
    count("reading " + choose_reading(choices_, profile_));
  }
}

void ProgramWriter::choose_initial_modes() {
  if (choices_.one_in(8)) profile_.initial.feed = choices_.between(1, 500);
  if (choices_.one_in(8)) profile_.initial.motion = choices_.one_in(2) ? 1 : 0;
  if (choices_.one_in(8)) {
    profile_.initial.plane = choices_.one_in(2) ? reference::Plane::g18 : reference::Plane::g19;
  }
}

// One value to another of the block, its double or its half, or the least increment beside; the
// sign stays. For words that may have any value.
void ProgramWriter::move_to_boundary(Words& words) {
  std::vector<std::size_t> values;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (letters_of_codes().find(words[i][0]) != std::string_view::npos) continue;
    if (increments_of(words[i], decimals())) values.push_back(i);
  }
  if (values.size() < 2) return;
  const auto one_of_them = [&] {
    return values[choices_.below(static_cast<std::uint32_t>(values.size()))];
  };
  std::string& victim = words[one_of_them()];
  const std::int64_t other = std::abs(*increments_of(words[one_of_them()], decimals()));
  const std::int64_t value = choices_.pick({other, 2 * other, other / 2}) + choices_.between(-1, 1);
  if (value < 0 || !may_have(Fault::far, victim) || !may_have(Fault::zero, victim)) return;
  count("boundary");
  victim = word(victim[0], victim[1] == '-' ? -value : value);
  on_fault();
}

// What is left may alarm, or may not.
void ProgramWriter::spoil(Words& words) {
  static constexpr Fault kFaults[] = {Fault::missing, Fault::twice, Fault::sign,
                                      Fault::zero,    Fault::stray, Fault::far};
  if (words.empty()) return;
  std::string& victim = words[choices_.below(static_cast<std::uint32_t>(words.size()))];
  const Fault fault = kFaults[choices_.below(6)];
  if (!may_have(fault, victim)) return;
  switch (fault) {
    case Fault::missing:
      count("fault: word missing");
      victim.clear();
      break;
    case Fault::twice:
      count("fault: word twice");
      words.push_back(std::string(victim));
      break;
    case Fault::sign:
      count("fault: sign");
      // Whether -0 has a sign is undecided.
      if (!is_code(victim) && victim.find_first_of("123456789") != std::string::npos) {
        victim = negated(victim);
      }
      break;
    case Fault::zero:
      count("fault: zero");
      if (!is_code(victim) && victim[0] != 'F') victim = with_value(victim, "0");
      break;
    case Fault::stray:
      count("fault: another axis");
      words.push_back(stray_word());
      break;
    case Fault::far:
      count("fault: far out");
      if (!is_code(victim) && victim[0] != 'F') victim = with_value(victim, far_out());
      break;
  }
}

}  // namespace gonogo::generate
