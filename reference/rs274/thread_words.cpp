// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/thread_words.hpp"

#include <fmt/format.h>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/tool_lengths.hpp"

namespace gonogo::reference::rs274 {
namespace {

// The largest number of a fraction that R may be: (K/J)^u has so many times the digits of K/J.
constexpr std::int64_t kMostOfDegression = 10'000;
// Passes that the gauge follows, spring passes too.
constexpr int kMostPasses = 10'000;

class Reader {
 public:
  explicit Reader(BlockContext& block) : block_(block), words_(block.words) {}
  std::optional<ThreadWords> read();

 private:
  void check_presence();
  void check_axes();
  void read_depths();
  void read_spring_passes();
  void read_taper();
  void read_taper_ends();
  void read_entry();
  void read_degression();
  void limit_passes();
  void read_slide();
  // NGC-G76-03, as far as LinuxCNC looks: an alarm unless ngc.g76.checks = linuxcnc.
  bool forgives() const { return block_.readings.is("ngc.g76.checks=linuxcnc"_reading); }
  // `what` has places for the values.
  void refuse(AlarmClass alarm, char address, std::string_view what,
              std::initializer_list<Number> values) {
    block_.alarm(alarm, "NGC-G76-03"_clause, address, with_values(what, values));
  }
  int decides(std::string_view what, const Number& value) const {
    return decided("NGC-G76-03"_clause, what, value);
  }
  // A length, or a number; 0 where there is none.
  Number length(char address) const { return words_.length(address).value_or(0); }
  // NGC-DIA-01: a length across the thread, which is a diameter under G7.
  Number across(char address) const {
    return block_.machine.modes.diameter ? length(address) / 2 : length(address);
  }
  std::optional<Number> whole(char address);
  Number travel() const { return read_.end[Axis::z] - block_.machine.position[Axis::z]; }

  BlockContext& block_;
  const BlockWords& words_;
  ThreadWords read_;
};

// NGC-G76-01
void Reader::check_presence() {
  const ClauseId clause = "NGC-G76-01"_clause;
  if (!words_.has('P')) {
    block_.alarm(AlarmClass::lead_missing, clause, 'P', "P, the lead, is needed in every block.");
  }
  for (const char address : {'I', 'J', 'K'}) {
    if (!words_.has(address)) block_.missing(clause, address);
  }
  if (words_.has('Z') || (words_.has_linear_axis_word() && forgives())) return;
  block_.missing(clause, 'Z');
}

// NGC-G76-02
void Reader::check_axes() {
  const ClauseId clause = "NGC-G76-02"_clause;
  const bool wrong_plane = block_.machine.plane != Plane::g18;
  if (wrong_plane && !forgives()) {
    block_.alarm(AlarmClass::plane_not_allowed, clause, 'G', "G76 runs in G18 alone.");
  }
  for (const char address : {'X', 'Y', 'A', 'C'}) {
    if (!words_.has(address)) continue;
    const bool is_linear = address == 'X' || address == 'Y';
    if (is_linear && forgives()) continue;
    block_.alarm(AlarmClass::axis_not_in_plane, clause, address,
                 fmt::format("G76 has no word {}.", address));
  }
}

void Reader::read_depths() {
  read_.lead = length('P');
  read_.peak = across('I');
  read_.first_depth = across('J');
  read_.full_depth = across('K');
  if (words_.has('P') && decides("P", read_.lead) <= 0 && !forgives()) {
    refuse(AlarmClass::value_sign, 'P', "The lead, {} mm, is not above zero.", {read_.lead});
  }
  if (words_.has('I') && decides("I", read_.peak) == 0) {
    refuse(AlarmClass::value_out_of_range, 'I', "I is {}, and says outside or inside by its sign.",
           {read_.peak});
  }
  if (words_.has('J') && decides("J", read_.first_depth) <= 0) {
    refuse(AlarmClass::value_sign, 'J', "The depth of the first pass, {} mm, is not above zero.",
           {read_.first_depth});
  }
  if (!words_.has('K')) return;
  if (decides("K", read_.full_depth) < 0 && !forgives()) {
    refuse(AlarmClass::value_sign, 'K', "The depth of the thread, {} mm, is below zero.",
           {read_.full_depth});
  }
  if (words_.has('J') && decides("K - J", read_.full_depth - read_.first_depth) <= 0) {
    refuse(AlarmClass::value_out_of_range, 'K',
           "The thread is {} mm deep, not deeper than its first pass of {} mm.",
           {read_.full_depth, read_.first_depth});
  }
}

// A word that is whole, or near enough to it; 0 where it does not stand, nothing where it is not
// whole.
std::optional<Number> Reader::whole(char address) {
  if (!words_.has(address)) return 0;
  return whole_word(block_, "NGC-G76-03"_clause, address);
}

void Reader::read_spring_passes() {
  const std::optional<Number> count = whole('H');
  if (!count) return;
  read_.spring_passes = *count;
  if (decides("H", *count) >= 0) return;
  if (*count == -1 && forgives()) return;
  refuse(AlarmClass::value_sign, 'H', "The number of spring passes, {}, is below zero.", {*count});
}

void Reader::read_taper() {
  read_.taper = length('E');
  if (decides("E", read_.taper) < 0) {
    if (!forgives())
      refuse(AlarmClass::value_sign, 'E', "The length of the taper, {} mm, is below zero.",
             {read_.taper});
    read_.taper = 0;
  }
  read_taper_ends();
  if (read_.enters_by_taper()) read_entry();
  const bool tapers = read_.taper_at_start || read_.taper_at_end;
  if (tapers && decides("2 E - abs(travel)", read_.taper * 2 - abs(travel())) > 0 && !forgives()) {
    refuse(AlarmClass::value_out_of_range, 'E',
           "The taper of {} mm is longer than half of the thread of {} mm.",
           {read_.taper, abs(travel())});
  }
}

// NGC-G76-09, NGC-G76-10: L.
void Reader::read_taper_ends() {
  std::optional<Number> ends = whole('L');
  if (!ends) return;
  const bool is_above = decides("L - 3", *ends - 3) > 0;
  const bool is_below = decides("L", *ends) < 0;
  if (is_below || (is_above && !forgives())) {
    refuse(AlarmClass::value_out_of_range, 'L', "L is {}, and not 0, 1, 2 or 3.", {*ends});
    if (is_below)
      refuse(AlarmClass::value_sign, 'L', "L, {}, is below zero.", {*ends});  // either is true
    return;
  }
  if (is_above) *ends -= (*ends / 4).floor() * 4;
  read_.taper_at_start = *ends == 1 || *ends == 3;
  read_.taper_at_end = *ends >= 2;
}

// NGC-G76-09
void Reader::read_entry() {
  if (block_.readings.is("ngc.g76.entry=rapid"_reading)) read_.entry = TaperEntry::rapid;
  if (!block_.readings.is("ngc.g76.entry=feed"_reading)) return;
  read_.entry = TaperEntry::feed;
  block_.need_feed("NGC-G76-09"_clause);
}

// NGC-G76-05
void Reader::read_degression() {
  if (!words_.has('R')) return;
  Number degression = words_.written('R');
  if (decides("R - 1", degression - 1) < 0) {
    if (!forgives())
      refuse(AlarmClass::value_out_of_range, 'R', "The degression, {}, is below 1.", {degression});
    degression = 1;
  }
  // In lowest terms: a decimal has few of them.
  std::int64_t divisor = 1;
  while (divisor <= kMostOfDegression && !(degression * Number(divisor)).to_int64()) ++divisor;
  const Number numerator = degression * Number(divisor);
  if (divisor > kMostOfDegression || numerator > Number(kMostOfDegression)) {
    block_.not_covered(76, 'R',
                       "The gauge reads a degression that is a fraction of whole numbers up to "
                       "10000.");
    return;
  }
  read_.degression = static_cast<unsigned long>(*numerator.to_int64());
  read_.degression_divisor = static_cast<unsigned long>(divisor);
}

// NGC-G76-05: the number of passes, (K/J)^R, grows fast.
void Reader::limit_passes() {
  if (read_.spring_passes >= kMostPasses) {
    block_.not_covered(76, 'H', "The gauge follows up to 10000 passes: the word H asks for more.");
  } else if (read_.is_part_of_depth(kMostPasses)) {
    block_.not_covered(
        76, 'R',
        "The gauge follows up to 10000 passes: the word K is too deep for the word J "
        "and the word R.");
  }
}

// NGC-G76-08: Q.
void Reader::read_slide() {
  if (!words_.has('Q')) return;
  Number degrees = words_.written('Q');
  if (degrees == -1 && forgives()) degrees = 0;
  const auto [cosine, sine] = exact::cos_sin_degrees(degrees);
  if (cosine.sign() == 0) {
    block_.not_covered(76, 'Q', "No text says how a tool slides along a right angle.");
    return;
  }
  read_.tangent = sine / cosine;
}

std::optional<ThreadWords> Reader::read() {
  commanded_end_point(block_, read_.end);
  check_presence();
  check_axes();
  read_depths();
  read_spring_passes();
  read_taper();
  read_degression();
  read_slide();
  // NGC-G76-04
  if (!block_.machine.spindle_turns()) {
    block_.alarm(AlarmClass::spindle_stopped, "NGC-G76-04"_clause, 'M',
                 "G76 needs a spindle that turns.");
  }
  if (!block_.out.alarms.empty() || block_.out.not_covered) return std::nullopt;
  limit_passes();
  if (block_.out.not_covered) return std::nullopt;
  return std::move(read_);
}

}  // namespace

// d_n < K without rounding: n^v < (K/J)^u.
bool ThreadWords::is_part_of_depth(const Number& n) const {
  return exact::power(n, degression_divisor) < exact::power(full_depth / first_depth, degression);
}

std::optional<ThreadWords> read_thread_words(BlockContext& block) {
  return Reader(block).read();
}

}  // namespace gonogo::reference::rs274
