// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traverses and feeds, and what every motion is written with.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "fuzz/generate/ngc_writer.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::generate {

std::string NgcWriter::code(int number) {
  if (number == kG33Point1) return "G33.1";
  return choices_.one_in(4) ? fmt::format("G{:02}", number) : fmt::format("G{}", number);
}

std::string NgcWriter::axis_word(Axis axis, std::int64_t most_units) {
  const std::int64_t value = any_sign(length(most_units));
  if (!incremental_) {
    target_[axis] = value;
  } else if (target_[axis]) {
    *target_[axis] += value;
  }
  return word("XYZAC"[axis], value);
}

std::string NgcWriter::travel_word(Axis axis, std::int64_t value) {
  if (at_[axis]) target_[axis] = *at_[axis] + value;
  return word("XYZAC"[axis], incremental_ ? value : *at_[axis] + value);
}

void NgcWriter::enter(Words& words, int motion) {
  if (!mode_to_enter_.empty()) words.push_back(std::exchange(mode_to_enter_, {}));
  has_code_ = motion != motion_ || choices_.one_in(3);
  if (has_code_) words.push_back(code(motion));
  count(fmt::format("G{} {}", motion, motion == motion_ ? "repeated" : "entry"));
  motion_ = motion;
}

void NgcWriter::feed_words(Words& words) {
  if (inverse_time_) {
    if (!errs(12)) words.push_back(feed_word());
    return;
  }
  if (choices_.one_in(5)) words.push_back(errs(20) ? "F0" : feed_word());
  if (!choices_.one_in(16)) return;
  const std::string function = choices_.pick({"M3", "M9", "M0", "M60"});
  words.push_back(function != "M3" ? function : spindle_named_ ? "M8" : spindle_word(3));
}

void NgcWriter::line_block() {
  Words words;
  mode_words(words);
  enter(words, choices_.one_in(2) ? 1 : 0);
  const std::uint32_t without = choices_.below(4);
  for (const Axis axis : {x, y, z}) {
    if (axis != without) words.push_back(axis_word(axis, 50));
  }
  // Whose feed holds where the linear axes happen not to move is undecided in inches.
  if (!inch_ && choices_.one_in(6)) words.push_back(axis_word(choices_.one_in(2) ? a : c, 360));
  feed_words(words);
  unused_words(words, "PQLDHEIJKR");
  if (has_code_ && (is_g80_forgotten() ? choices_.one_in(6) : puts_wrong(40))) {
    count("G80 beside a motion");
    words.push_back(code(80));
  }
  arrive();
  write(std::move(words));
}

void NgcWriter::unused_words(Words& words, std::string_view letters) {
  const bool ignored =
      profile_.readings.is("ngc.unused-words=ignored"_reading) && choices_.one_in(4);
  if (!ignored && !puts_wrong(40)) return;
  count("unused word");
  const char letter = letters[choices_.below(static_cast<std::uint32_t>(letters.size()))];
  words.push_back(word(letter, any_sign(length(5))));
}

void NgcWriter::rotary_block() {
  count("rotary alone");
  Words words;
  mode_words(words);
  enter(words, choices_.one_in(2) ? 1 : 0);
  const std::uint32_t without = choices_.below(3);
  if (without != 0) words.push_back(axis_word(a, 360));
  if (without != 1) words.push_back(axis_word(c, 360));
  feed_words(words);
  unused_words(words, "QLDHEJ");
  arrive();
  rotary_ = true;
  write(std::move(words));
  rotary_ = false;
}

void NgcWriter::write(Words words, std::string_view whole) {
  whole_ = whole;
  put(std::move(words));
  target_ = at_;
  spindle_named_ = false;
  // The block that leaves a cycle is still one in which no word may be wrong.
  minute_pecks_ = minute_pecks_ && is_pecking(motion_);
}

std::string NgcWriter::stray_word() {
  if (choices_.one_in(20)) return word(choices_.pick({'B', 'U', 'V', 'W'}), length(20));
  if (rotary_ && inch_) return axis_word(choices_.one_in(2) ? a : c, 90);
  return axis_word(
      inch_ || choices_.below(4) != 0 ? choices_.pick({x, y, z}) : choices_.pick({a, c}), 20);
}

bool NgcWriter::may_have(Fault fault, const std::string& word) const {
  const char address = word[0];
  const bool is_code = address == 'G' || address == 'M';
  if (minute_pecks_) return false;
  // Undecided: two M functions of one kind.
  // Also whose P it is where a dwell meets an arc.
  if (fault == Fault::stray && dwells_) return motion_ < 2 && !profile_.block_skip;
  if (fault == Fault::twice) return address != 'M';
  if (fault == Fault::far) return is_code || may_be_far(address);
  // Also undecided: an R of nil for an arc that ends where it starts.
  if (fault == Fault::zero) return address != 'R' || is_hole_cycle(motion_);
  return address != 'S' && address != 'T';
}

// No fault makes pecks without number.
bool NgcWriter::may_be_far(char address) const {
  if (address == 'R') return is_hole_cycle(motion_) && !is_pecking(motion_);
  if (address != 'X' && address != 'Y' && address != 'Z') return false;
  return !is_pecking(motion_) || address != "XYZ"[plane_axes()[2]];
}

// A number that must be whole, near one of the limits within which interpreters take it as that:
// 0.0001 and 0.001, of a G code a tenth of them. A seventh decimal may follow.
std::string NgcWriter::beside_whole(const std::string& word) {
  if (whole_.find(word[0]) == std::string_view::npos || word[1] == '-') return word;
  // Where they need not be whole exactly, more of them: the program may go on.
  const bool often = !profile_.readings.shown().is("ngc.whole=exact"_reading);
  if (!meets_limit(12) && !(often && puts_wrong(12))) return word;
  count("beside a whole number");
  const std::size_t point = std::min(word.find('.'), word.size());
  const std::int64_t tenths = std::stoll(word.substr(1, point - 1)) * 10 +
                              (point < word.size() ? word[point + 1] - '0' : 0);
  const std::int64_t off = choices_.pick({10, 100, 1000}) + choices_.between(-1, 1);
  const std::int64_t millionths = tenths * 100'000 + any_sign(off);
  const std::int64_t size = std::abs(millionths);
  return fmt::format("{}{}{}.{:06}{}", word[0], millionths < 0 ? "-" : "", size / 1'000'000,
                     size % 1'000'000, choices_.pick({"", "", "1", "9"}));
}

// Now and then a number with decimals, one that is too large for some, or one that is none
// (NGC-COM-05).
std::string NgcWriter::head() {
  if (puts_wrong(120)) {
    count("fault: line number");
    return choices_.pick({"N10. ", "N10.5.5 ", "N10.5. "});
  }
  if (!errs(60)) return ProgramWriter::head();
  count("line number of one reading");
  return choices_.pick({"N10.5 ", "N 7 . 0", "N99999 ", "N100000 ", "N123456789 "});
}

// Letters in either case; blanks may stand between all of it.
std::string NgcWriter::printed(const std::string& planned) {
  if (planned.empty()) return planned;
  const std::string word = beside_whole(planned);
  const bool small = choices_.one_in(20) && word[0] >= 'A' && word[0] <= 'Z';
  std::string text(1, small ? static_cast<char>(word[0] - 'A' + 'a') : word[0]);
  if (choices_.one_in(30)) text += ' ';
  text += word.substr(1);
  if (choices_.one_in(30)) {
    const std::uint32_t place = choices_.below(static_cast<std::uint32_t>(text.size()));
    text.insert(place + 1, choices_.pick({" ", "\t", "  "}));
  }
  return text;
}

}  // namespace gonogo::generate
