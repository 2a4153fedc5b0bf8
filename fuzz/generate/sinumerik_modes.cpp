// SPDX-License-Identifier: GPL-3.0-or-later
//
// What changes modes, or has nothing to do with them, and where programs end.
#include <fmt/format.h>

#include "fuzz/generate/sinumerik_writer.hpp"

namespace gonogo::generate {

void SinumerikWriter::forget_pole() {
  state_.angle.reset();
  state_.radius.reset();
  state_.at_polar = false;
}

// A code of a plane puts the pole at the zero, that of the plane in force under one reading only.
void SinumerikWriter::set_plane(Words& words, int asked) {
  const int plane = plane_in_frame(asked);
  if (plane == state_.plane && keeps_pole_) return words.push_back(code(plane));
  state_.plane = plane;
  state_.pole = {};
  state_.spoke.reset();
  forget_pole();
  words.push_back(code(plane));
}

void SinumerikWriter::units_words(Words& words) {
  count("units change");
  state_.inch = choices_.one_in(3);
  // In which units a radius from before it holds is undecided.
  state_.radius.reset();
  words.push_back(state_.inch ? "G70" : "G71");
}

// SIE-MOD-07: a new mode with a feed of its own, that of a cutting speed with the speed.
void SinumerikWriter::feed_mode_words(Words& words) {
  new_feed_mode_ = true;
  const std::uint32_t mode = choices_.below(16);
  const bool per_minute = mode < 8;
  const bool is_plain = per_minute && is_802s();  // which has G94 alone
  if (!is_plain && (mode == 0 || mode == 15)) {
    words.push_back(per_minute ? "G961" : "G96");
    words.push_back("S120");
  } else if (!is_plain && (mode == 1 || mode == 14)) {
    words.push_back(per_minute ? "G971" : "G97");
  } else {
    words.push_back(per_minute ? "G94" : "G95");
  }
  words.push_back(per_minute ? feed_word() : "F.2");
}

// Modes that stand in a block that moves.
void SinumerikWriter::mode_words(Words& words) {
  if (!choices_.one_in(5)) return;
  switch (choices_.below(7)) {
    case 0:
    case 1:
    case 2:
      state_.incremental = choices_.one_in(2);
      words.push_back(state_.incremental ? "G91" : "G90");
      break;
    case 3:
      if (choices_.one_in(3)) units_words(words);
      break;
    case 4:
      feed_mode_words(words);
      break;
    default:
      words.push_back(choices_.one_in(4) ? choices_.pick({"T2", "D1"})
                                         : code_that_is(Treatment::without_effect));
      // Under a frame no text says what it leaves out of a motion.
      if (is_802s() && words.back() == "G53") words.back() = "G500";
  }
}

void SinumerikWriter::setting_block() {
  Words words;
  switch (choices_.below(4)) {
    case 0:
      count("absolute or incremental");
      state_.incremental = choices_.one_in(2);
      words.push_back(code(state_.incremental ? 91 : 90));
      break;
    case 1:
      count("plane alone");
      set_plane(words, choices_.pick({17, 18, 19}));
      break;
    case 2:
      units_words(words);
      break;
    default:
      state_.speed = choices_.pick({300, 600, 1200, 1500});
      words = {fmt::format("S{}", state_.speed), choices_.pick({"M3", "M3", "M4", "M5"})};
  }
  write(std::move(words), Kind::other);
}

int SinumerikWriter::any_parameter() {
  return choices_.pick({0, 1, 2, 7, 99, 100, 249, is_802s() ? 299 : 999});
}

// R parameters alone: each acts at once.
void SinumerikWriter::assignment_block() {
  count("R parameters");
  Words words;
  for (std::uint32_t i = 1 + choices_.below(3); i > 0; --i) {
    const int number = any_parameter();
    const std::int64_t value = any_sign(length(40));
    may_assign_ = false;
    const std::string text = expression(value);
    may_assign_ = true;
    words.push_back(fmt::format("R{}={}", number, text));
    state_.parameters[number] = value;
  }
  write(std::move(words), Kind::other);
}

void SinumerikWriter::dwell_block() {
  count("dwell");
  Words words = {code(4)};
  if (state_.speed != 0 && choices_.one_in(2)) {
    words.push_back(fmt::format("S{}", choices_.below(50)));
  } else {
    words.push_back(fmt::format("F{}.{}", choices_.below(9), choices_.below(10)));
  }
  kind_ = Kind::dwell;
  write(std::move(words), Kind::dwell);
}

// Where a program ends: outside, undefined, or out of its range.
void SinumerikWriter::outside_block() {
  static constexpr const char* kOutside[] = {"RPL=45",
                                             "CYCLE800(1,2)",
                                             "CYCLE81(5,0,2,-3)",
                                             "POCKET3(5)",
                                             "HOLES1(1)",
                                             "X1=5",
                                             "B20",
                                             "S2=500",
                                             "L10",
                                             "TURN=R[1]",
                                             "T=\"MILL\"",
                                             "GOTOB ANFANG",
                                             "X=R[1]",
                                             "X=$AA_IM[X]",
                                             "Z=ROUND(5)",
                                             "ANG=30",
                                             "DEF REAL A1",
                                             "CHF=2",
                                             "IF R1>5 GOTOF ENDE"};
  static constexpr const char* kAlarm[] = {
      "G6",         "G21",       "G28",         "G43",     "G81",
      "G158",       "G259",      "G999",        "G1.5",    "LCYC75",
      "LCYC82",     "LCYC99",    "FRAESEN",     "TIEFE=5", "E5",
      "Q3",         "M100",      "S-5",         "X=5/0",   "R1=2/(3-3)",
      "Y=SQRT(-1)", "Z=TAN(90)", "X=TAN(-270)", "R1000=5", "X5 X=AC(6)",
      "G90 G91",    "G2 CIP",    "G17 G18",     "I5",      "TURN=2",
      "K1=3",       "CR=5",      "AR=90",       "F-20",    "G110 X5 Y5 F10"};
  const bool outside = choices_.one_in(3);
  count(outside ? "outside" : "alarm of its own");
  Words words = {!outside             ? kAlarm[choices_.below(std::size(kAlarm))]
                 : choices_.one_in(2) ? code_that_is(Treatment::outside)
                                      : kOutside[choices_.below(std::size(kOutside))]};
  // Where no frame code is, what it means is undecided.
  if (is_802s() && words[0] == "RPL=45") words[0] = "ROT";
  // The words of lines: an arc would ask for its own.
  const bool is_line = state_.motion == kTraverse || state_.motion == kLine;
  if (!is_line && words[0][0] != 'G') words.insert(words.begin(), "G1");
  faulted_ = true;
  write(std::move(words), Kind::other);
}

void SinumerikWriter::syntax_line() {
  count("syntax");
  text_ += choices_.pick({"CR5\n", "X\n", "G=1\n", "X=\n", "R5\n", "X=(5\n", "X=5+\n", "X5)\n",
                          "X=AC(5\n", "CR=AC(5)\n", "RP=IC(3)\n", "X--5\n", "X1.2.3\n", "I1=\n",
                          ("X\xE2\x88\x92"
                           "5\n"),
                          "X=SIN 30\n", "X5 ! Y3\n", "X=5*/2\n"});
}

// What the machine does beside its axes.
void SinumerikWriter::machine_block() {
  const std::string words =
      choices_.pick({"M8", "M9", "M0", "M1", "M6", "M41", "T4", "D2", "H5=3", "T1 D1 M6"});
  state_.has_m6 = state_.has_m6 || words.ends_with("M6");
  write({words}, Kind::other);
}

void SinumerikWriter::ignored_block() {
  count("ignored");
  if (choices_.one_in(2)) return write({code_that_is(Treatment::without_effect)}, Kind::other);
  write({choices_.pick(
            {"MSG(\"CUT (1; \xE5\x88\x80\")", "MSG()", "msg(\"\")", "LIMS=2000", "SPOS=90"})},
        Kind::other);
}

void SinumerikWriter::mode_block() {
  kind_ = Kind::other;
  switch (choices_.below(12)) {
    case 0:
    case 1:
    case 2:
      return setting_block();
    case 3:
    case 4:
      return assignment_block();
    case 5:
    case 6:
      return dwell_block();
    case 7:
      if (!puts_wrong(4)) return ignored_block();
      return choices_.one_in(3) ? syntax_line() : outside_block();
    case 8:
      return write({new_feed()}, Kind::other);
    case 9:
      return ignored_block();
    case 10:
      if (choices_.one_in(3)) return ignored_block();
      return machine_block();
    default:
      count("no motion");
      text_ += choices_.pick({"\n", ";only a comment\n", "N77\n", "/\n", " \t\n", ":5\n",
                              "ANFANG:\n", "; ( \" G1 X5\n"});
  }
}

}  // namespace gonogo::generate
