// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values and words, and how they stand in the text.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numbers>
#include <string_view>

#include "fuzz/generate/sinumerik_writer.hpp"

namespace gonogo::generate {
namespace {

// Where the value of X10, X=AC(10), CR=5, R5=2 begins.
std::size_t value_at(const std::string& word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos) return 1;
  const std::string_view call = std::string_view(word).substr(equals + 1, 3);
  return equals + (call == "AC(" || call == "IC(" ? 4 : 1);
}

// The bracket of AC( ) and IC( ) stays.
std::string with_text(const std::string& word, const std::string& text) {
  const std::size_t at = value_at(word);
  const bool bracket = at > 1 && word[at - 1] == '(';
  return word.substr(0, at) + text + (bracket ? ")" : "");
}

}  // namespace

std::string SinumerikWriter::code(int number) {
  return choices_.one_in(6) ? fmt::format("G{:02}", number) : fmt::format("G{}", number);
}

std::string SinumerikWriter::constant(std::int64_t counts) {
  std::string text = word('X', counts).substr(1);
  const std::size_t digit = text[0] == '-' ? 1 : 0;
  if (choices_.one_in(30)) {
    if (text.compare(digit, 2, "0.") == 0) {
      text.erase(digit, 1);
    } else if (text.find('.') == std::string::npos) {
      text += '.';
    } else {
      text.insert(digit, "0");
    }
  }
  return text;
}

// Exactly the value, in doubles too.
std::string SinumerikWriter::expression(std::int64_t counts) {
  switch (choices_.below(9)) {
    case 0: {
      const std::int64_t part = length(20);
      return fmt::format("{}+{}", constant(counts - part), constant(part));
    }
    case 1:
      return fmt::format("({})", constant(counts));
    case 2:
      return fmt::format("-({})", constant(-counts));
    case 3:
      return fmt::format("{}-2*3+{}", constant(counts), choices_.pick({"6", "(4+2)", "3*2"}));
    case 4:
      return fmt::format("{}*SQRT({})/2", constant(counts), choices_.pick({"4", "8-4", "ABS(-4)"}));
    case 5:
      return counts < 0 ? fmt::format("-ABS({})", constant(counts))
                        : fmt::format("ABS({})", constant(-counts));
    case 6:
      return fmt::format("{}*{}", constant(counts), choices_.pick({"SIN(90)", "COS(0)"}));
    case 7:
      if (may_assign_) {
        const int number = any_parameter();
        state_.parameters[number] = counts;
        assignments_.push_back(fmt::format("R{}={}", number, constant(counts)));
        return fmt::format("R{}", number);
      }
      [[fallthrough]];
    default:
      if (state_.parameters.empty()) {
        return fmt::format("{}{}", counts < 0 ? '-' : '+', constant(std::abs(counts)));
      }
      auto parameter = state_.parameters.begin();
      std::advance(parameter, choices_.below(static_cast<std::uint32_t>(state_.parameters.size())));
      const std::int64_t rest = counts - parameter->second;
      return fmt::format("R{}{}{}", parameter->first, rest < 0 ? "-" : "+",
                         constant(std::abs(rest)));
  }
}

std::string SinumerikWriter::named(std::string_view name, std::int64_t counts, How how) {
  const bool plain = !choices_.one_in(6);
  const std::string text = plain ? constant(counts) : expression(counts);
  if (how == How::absolute) return fmt::format("{}=AC({})", name, text);
  if (how == How::incremental) return fmt::format("{}=IC({})", name, text);
  const bool bare = plain && name.size() == 1 && !choices_.one_in(8);
  return fmt::format("{}{}{}", name, bare ? "" : "=", text);
}

std::string SinumerikWriter::travel_word(std::string_view name, const Coordinate& from,
                                         std::int64_t travel) {
  const std::int64_t step = state_.steps_of_count();
  const bool has_place = from.steps && *from.steps % step == 0;
  const std::uint32_t style = choices_.below(8);
  const bool plain = style > 1;
  if (has_place && (style == 0 || (plain && !state_.incremental))) {
    return named(name, *from.steps / step + travel, plain ? How::plain : How::absolute);
  }
  return named(name, travel, plain && state_.incremental ? How::plain : How::incremental);
}

std::string SinumerikWriter::axis_word(std::size_t axis, std::int64_t travel) {
  target_[axis] = state_.at[axis].moved(travel * state_.steps_of_count());
  const char name = "XYZ"[axis];
  return travel_word({&name, 1}, state_.at[axis], travel);
}

std::string SinumerikWriter::random_word(std::size_t axis, std::int64_t most_units) {
  if (kind_ == Kind::line && choices_.one_in(30)) return irrational_word(axis);
  const std::int64_t value = any_sign(length(most_units));
  if (choices_.one_in(2) && state_.known) return axis_word(axis, value);
  target_[axis] = Coordinate::exactly(value * state_.steps_of_count());
  const char name = "XYZ"[axis];
  const bool plain = !state_.incremental && choices_.below(8) != 0;
  return named({&name, 1}, value, plain ? How::plain : How::absolute);
}

// A place that no decimal says.
std::string SinumerikWriter::irrational_word(std::size_t axis) {
  count("value: no decimal");
  const auto whole = static_cast<double>(1 + choices_.below(40));
  const auto angle = static_cast<double>(1 + choices_.below(60));
  const double radians = angle * std::numbers::pi / 180;
  std::string text;
  double value = 0;
  switch (choices_.below(5)) {
    case 0:
      text = fmt::format("{}*SIN({})", whole, angle);
      value = whole * std::sin(radians);
      break;
    case 1:
      text = fmt::format("-{}*COS({})", whole, angle);
      value = -whole * std::cos(radians);
      break;
    case 2:
      text = fmt::format("{}*TAN({})", whole, angle);
      value = whole * std::tan(radians);
      break;
    case 3:
      text = fmt::format("SQRT({})", whole);
      value = std::sqrt(whole);
      break;
    default:
      text = fmt::format("{}/7", whole);
      value = whole / 7;
  }
  const bool travels = choices_.one_in(2) && state_.known;
  const double from = travels ? state_.at[axis].mm : 0;
  target_[axis] = Coordinate::about(from + value * state_.mm_of_count() * 1'000);
  const bool plain = travels == state_.incremental;
  return fmt::format("{}={}{}{}", "XYZ"[axis],
                     plain     ? ""
                     : travels ? "IC("
                               : "AC(",
                     text, plain ? "" : ")");
}

std::string SinumerikWriter::rotary_word() {
  const How how = choices_.one_in(4)   ? How::incremental
                  : choices_.one_in(4) ? How::absolute
                                       : How::plain;
  return named(choices_.one_in(3) ? "C" : "A", any_sign(length(360)), how);
}

void SinumerikWriter::enter(Words& words, Motion motion) {
  has_code_ = motion != state_.motion || choices_.one_in(3);
  static constexpr const char* kNames[] = {"G0", "G1", "G2", "G3", "CIP", "CT"};
  if (has_code_) words.push_back(motion < kCip ? code(motion) : kNames[motion]);
  count(fmt::format("{} {}", kNames[motion], motion == state_.motion ? "repeated" : "entry"));
  ends_ct_ = state_.motion == kCt && motion != kCt;
  state_.motion = motion;
}

std::string SinumerikWriter::new_feed() {
  if (errs(40)) return "F0";
  return choices_.one_in(6) ? named("F", 50'000 + length(500)) : feed_word();
}

void SinumerikWriter::feed_words(Words& words) {
  if (choices_.one_in(5) && !new_feed_mode_) words.push_back(new_feed());
  if (choices_.one_in(16)) {
    words.push_back(choices_.pick({"M3", "M4", "M8", "M0", "M1", "M41", "H5", "H5=12", "D1"}));
  }
  if (choices_.one_in(30) && !new_feed_mode_) {
    state_.speed = choices_.pick({300, 600, 1200, 1500});
    words.push_back(fmt::format("S{}", state_.speed));
  }
}

std::string SinumerikWriter::stray_word() {
  if (choices_.one_in(20)) return word(choices_.pick({'B', 'U', 'V', 'W'}), length(20));
  if (kind_ == Kind::line && !inch_feed_ && choices_.one_in(4)) return rotary_word();
  const std::size_t axis = choices_.below(3);
  if (kind_ != Kind::line && kind_ != Kind::arc) return word("XYZ"[axis], length(20));
  return random_word(axis, 20);
}

bool SinumerikWriter::may_have(Fault fault, const std::string& word) const {
  if (faulted_) return false;  // one is enough: all that are broken would have to be named
  const char address = word[0];
  const bool is_value = word.find_first_of("0123456789") != std::string::npos && address != 'G' &&
                        address != 'M' && address != 'T' && address != 'D' && address != 'H';
  const bool is_feed = address == 'F';
  // A CT goes where it was chosen to go: nearly straight on, or nearly back, its radius would be
  // one that no controller's numbers hold.
  if (kind_ == Kind::arc && state_.motion == kCt && fault != Fault::twice &&
      !(fault == Fault::missing && (is_feed || word == "CT"))) {
    return false;
  }
  if (word.starts_with("RPL") && word[3] != '=' && fault != Fault::missing) return false;
  switch (fault) {
    case Fault::missing:
      // A deeper pocket would have levels by the hundreds.
      if (address == 'R' && kind_ == Kind::other && is_802s()) return false;
      // Undecided: a pole with one coordinate, a dwell without a time, an old F in a new mode, AR=
      // alone, a CT that goes on from a helix in another plane.
      return kind_ != Kind::pole && kind_ != Kind::dwell && !(new_feed_mode_ && is_feed) &&
             address != 'S' && !(kind_ == Kind::arc && word.starts_with("AP=")) && !by_angle_ &&
             !(ends_ct_ && (address == 'G' || address == 'C'));
    case Fault::twice:
      return address != 'M' && address != 'T' && (kind_ != Kind::other || address == 'G') &&
             kind_ != Kind::cycle;
    case Fault::sign:
      return is_value && kind_ != Kind::dwell && kind_ != Kind::other && kind_ != Kind::cycle;
    case Fault::zero:
      // Whether the tool stands at a pole is not for rounding to decide.
      return is_value && address != 'S' && !word.starts_with("RP=") && kind_ != Kind::other &&
             kind_ != Kind::cycle;
    case Fault::stray:
      return kind_ != Kind::other;
    case Fault::far:
      // An arc that is nearly straight has a centre too far for some numbers.
      return is_value && (kind_ == Kind::line || kind_ == Kind::arc) && address != 'S' &&
             (kind_ != Kind::arc || (address >= 'I' && address <= 'K') || word.starts_with("CR="));
  }
  return false;
}

std::string SinumerikWriter::negated(const std::string& word) const {
  const std::size_t at = value_at(word);
  if (at == 1) return ProgramWriter::negated(word);
  std::string text = word.substr(at);
  if (word[at - 1] == '(') text.pop_back();
  if (text.find_first_of("123456789") == std::string::npos) return word;
  return with_text(word, fmt::format("-({})", text));
}

std::string SinumerikWriter::with_value(const std::string& word, const char* value) const {
  // Far out is not so far that an angle of 0.001 degrees has its centre beyond all numbers.
  return with_text(word, std::string_view(value) == "0" ? "0" : "9000");
}

// Letters in either case; blanks between an address and its value, round '=' and in brackets.
std::string SinumerikWriter::printed(const std::string& word) {
  if (word.empty() || word.find('"') != std::string::npos) return word;
  std::string text = word;
  if (choices_.one_in(20)) {
    for (char& letter : text) {
      if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    }
  }
  const std::size_t equals = text.find('=');
  if (choices_.one_in(30)) {
    if (equals != std::string::npos) {
      text.replace(equals, 1, choices_.pick({" = ", "= ", " =", "=\t"}));
    } else if (text.size() > 1 && text[1] < 'A') {
      text.insert(1, " ");
    }
  }
  const std::size_t bracket = text.find('(');
  if (bracket != std::string::npos && choices_.one_in(10)) text.insert(bracket + 1, " ");
  // A name goes on with letters and digits: LCYC82, CFIN.
  const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
  const bool is_name = equals == std::string::npos &&
                       std::ranges::all_of(std::string_view(text).substr(0, 2), is_letter);
  return is_name ? text + ' ' : text;
}

std::string SinumerikWriter::head() {
  std::string text;
  slashed_ = choices_.one_in(40);
  if (slashed_) text += choices_.pick({"/", "/0", "/7 ", "/ "});
  if (choices_.one_in(10)) {
    text += fmt::format("{}{} ", choices_.one_in(8) ? ":" : "N", choices_.below(9999));
  } else if (choices_.one_in(60)) {
    text += "TEIL_2: ";
  }
  return text;
}

std::string SinumerikWriter::tail() {
  return choices_.one_in(12) ? choices_.pick({";", " ;cut (X5", " ; \xE5\x88\x80", "\t;G1 X999"})
                             : "";
}

}  // namespace gonogo::generate
