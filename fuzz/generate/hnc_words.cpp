// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "fuzz/generate/hnc_writer.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::generate {

std::string HncWriter::axis_word(Axis axis, std::int64_t most_units) {
  const bool increment = choices_.one_in(3);
  const bool absolute = !increment && !incremental_;
  const std::int64_t value = any_sign(length(absolute ? most_units : most_units / 3));
  if (absolute) {
    target_[axis] = value;
  } else if (target_[axis]) {
    *target_[axis] += value;
  }
  return word((increment ? "UW" : "XZ")[axis], value);
}

std::string HncWriter::travel_word(Axis axis, std::int64_t value) {
  const bool known = at_[axis].has_value();
  if (known) target_[axis] = *at_[axis] + value;
  if (choices_.one_in(2)) {
    if (incremental_) return word("XZ"[axis], value);
    if (known) return word("XZ"[axis], *target_[axis]);
  }
  return word("UW"[axis], value);
}

void HncWriter::end_words(Words& words, std::int64_t most_units) {
  const std::uint32_t left_out = lacks_axis(3, 25) ? choices_.below(2) : 2;
  for (const Axis axis : {x, z}) {
    if (axis == left_out) continue;
    words.push_back(choices_.one_in(3) ? travel_word(axis, any_sign(length(most_units / 2)))
                                       : axis_word(axis, most_units));
  }
}

// Whether an axis word is missing, as in one of so many blocks where the machine may do something
// then, or in one of so many of the others.
bool HncWriter::lacks_axis(std::uint32_t one_in, std::uint32_t one_in_refused) {
  if (!settings_.refused && (profile_.readings.is("hnc.missing-axis=reject"_reading) ||
                             profile_.readings.is("hnc.missing-axis=any"_reading)))
    return false;
  return choices_.one_in(profile_.readings.is("hnc.missing-axis=reject"_reading) ? one_in_refused
                                                                                 : one_in);
}

bool HncWriter::enter(Words& words, int code) {
  const bool entry = code != code_;
  if (entry || choices_.one_in(6)) words.push_back(fmt::format("G{:02}", code));
  count(fmt::format("G{:02} {}", code, entry ? "entry" : "repeated"));
  if (entry) {
    peck_ = withdrawal_ = 0;
    counted_ = tiny_ = false;
  }
  code_ = code;
  return entry;
}

void HncWriter::feed_words(Words& words, bool entry, const char* unused) {
  if (entry ? !errs(8) : choices_.one_in(3)) words.push_back(feed_word());
  if (choices_.one_in(20)) words.push_back(fmt::format("{}{}", unused, 1 + choices_.below(9)));
  if (choices_.one_in(20)) words.push_back("M08");
}

void HncWriter::lose_place() {
  at_ = target_ = {};
  far_ = true;
}

void HncWriter::write(Words words) {
  put(std::move(words));
  target_ = at_;
}

std::string HncWriter::stray_word() {
  if (choices_.one_in(20)) return word(choices_.pick({'Y', 'V'}), length(20));
  return axis_word(choices_.one_in(2) ? x : z, 20);
}

bool HncWriter::may_have(Fault fault, const std::string& word) const {
  // Which rules two codes of the motion group leave standing is undecided.
  if (fault == Fault::twice && word[0] == 'G') return word.size() == 3 && word[1] >= '9';
  const char address = word[0];
  const bool pecks = code_ == 74 || code_ == 75;
  // Also undecided: an arc that begins in its centre and ends beside it; e >= dK without a depth.
  const bool arc = code_ == 2 || code_ == 3;
  if (arc && (fault == Fault::missing || fault == Fault::zero)) {
    return address != 'I' && address != 'K';
  }
  // A peck of a few increments from the block before would go all the way.
  if (pecks && fault == Fault::missing) {
    return address == 'F' || (address == 'R' && !keeps_words());
  }
  if (fault == Fault::zero) {
    return !pecks || !counts_from_withdrawn() || address == 'R';
  }
  if (fault != Fault::far) return true;
  // No pecks, plunges and starts without number.
  if (pecks) return address == 'Q' || address == 'F';
  return code_ != 82 || address != 'C';
}

// A blank may stand between a letter and its number.
std::string HncWriter::printed(const std::string& word) {
  if (word.empty() || !choices_.one_in(30)) return word;
  return word.substr(0, 1) + " " + word.substr(1);
}

}  // namespace gonogo::generate
