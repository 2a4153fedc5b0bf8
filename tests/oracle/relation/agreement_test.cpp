// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sentences of docs/relation.md that the judge and the definition once read differently, or both
// wrongly. Each trace is given to both. tau is 0.001 mm.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "deciding.hpp"

namespace gonogo::relation {
namespace {

// What both say, or how they differ.
std::string both(std::string_view program, std::string_view trace, const Declared& declared) {
  const oracle::Verdict verdict = judge(program, trace, declared);
  const Answer answer = decide(program, trace, declared);
  const std::string_view judged = word(verdict.kind);
  const std::string_view defined = word(answer.kind);
  if (judged == defined) return std::string(judged);
  return fmt::format("judge {} ({}), definition {} ({})", judged, verdict.message, defined,
                     answer.message);
}

// A pocket of LCYC75 about X0 Y0, a hole of radius 12 by a tool of radius 5, whose centre reaches
// 7; from Z0, clockwise. One level, 3 deep.
constexpr std::string_view kRoughing = "R104=-3 R121=3 R124=0 R125=0 R127=1";
const Declared kLcyc75{.dialect = "sinumerik802s", .tool = "5"};

std::string program_of(std::string_view words) {
  return fmt::format(
      "G0 X8 Y5 Z14 S400 M3 T1 D1\nR101=10 R102=2 R103=0 R116=0 R117=0 R118=24 R119=24 R120=12\n"
      "R122=100 R123=300 R126=2\n{}\nLCYC75\n",
      words);
}
std::string line(std::string_view kind, std::string_view to, std::string_view feed = "") {
  const std::string word = feed.empty() ? "" : fmt::format(R"(,"f":"{}")", feed);
  return fmt::format(R"({{"k":"{}","b":5,"to":{{{}}}{}}})"
                     "\n",
                     kind, to, word);
}
std::string place(double p, double q) {
  return fmt::format(R"("x":"{:.9f}","y":"{:.9f}")", p, q);
}
std::string rapid(std::string_view to) {
  return line("rapid", to);
}
std::string down_to(std::string_view to) {
  return line("feed", fmt::format(R"("z":"{}")", to), "100");
}
std::string cut(double p, double q) {
  return line("feed", place(p, q), "300");
}
std::string arc(double p, double q, int rot) {
  return fmt::format(
      R"({{"k":"arc","b":5,"plane":"G17","c":{{"x":"0","y":"0"}},"rot":{},"to":{{{}}},"f":"300"}}
)",
      rot, place(p, q));
}
// On the circle of the tool's centre, at an angle.
std::string arc_to(double angle, int rot) {
  return arc(7 * std::cos(angle), 7 * std::sin(angle), rot);
}
const std::string kBorder = cut(7, 0) + arc(7, 0, -1);
const std::string kHome = cut(0, 0);

// The steps begin at R101, and at R103 + R102.
std::string milled_from_r101(std::string_view steps, std::string_view words,
                             const Declared& declared = kLcyc75) {
  const std::string trace = R"({"k":"m","b":1,"m":3}
{"k":"rapid","b":1,"to":{"x":"8","y":"5","z":"14"}}
{"k":"rapid","b":5,"to":{"x":"0","y":"0","z":"10"}}
)" + std::string(steps) + rapid(R"("z":"10")");
  return both(program_of(words), trace, declared);
}
std::string milled(std::string_view steps, std::string_view words = kRoughing,
                   const Declared& declared = kLcyc75) {
  return milled_from_r101(rapid(R"("z":"2")") + std::string(steps), words, declared);
}

// J-PKT-06: a quarter of the tool's radius is 1.25. Back by 0.17 rad is 1.19, by 0.19 rad 1.33.
TEST(Agreement, TheBorderLeadsBackByAQuarterOfTheToolsRadiusAtMost) {
  const std::string begin = down_to("-3") + kBorder;
  EXPECT_EQ(milled(begin + arc_to(0.17, 1) + kHome), "GO");
  EXPECT_EQ(milled(begin + arc_to(0.19, 1) + kHome), "NO-GO");
  // Twice 0.7; with as much forth between them.
  EXPECT_EQ(milled(begin + arc_to(0.1, 1) + arc_to(0.2, 1) + kHome), "NO-GO");
  EXPECT_EQ(milled(begin + arc_to(0.1, 1) + arc_to(0, -1) + arc_to(0.1, 1) + kHome), "GO");
}

// From (7, 0) to (0, 7) is counterclockwise about the middle, and not along the border.
TEST(Agreement, ALineAcrossFromBorderToBorderHasNoSense) {
  EXPECT_EQ(milled(down_to("-3") + kBorder + cut(0, 7) + kHome), "GO");
}

TEST(Agreement, ARingOfAPocketIsMilledTenTimesAtMost) {
  const auto turns = [](int count) {
    return milled(down_to("-3") + cut(7, 0) + arc(7, 0, -count) + kHome);
  };
  EXPECT_EQ(turns(10), "GO");
  EXPECT_EQ(turns(11), "NO-GO");
  EXPECT_EQ(turns(50), "NO-GO");
  std::string again;
  for (int i = 0; i < 11; ++i) again += arc(-7, 0, -1) + arc(7, 0, -1);
  EXPECT_EQ(milled(down_to("-3") + cut(7, 0) + again + kHome), "NO-GO");
}

// Ninety chords of the border, each off its arc by 7 (1 - cos 2 degrees) = 0.0043.
TEST(Agreement, ChordsThatAreGrantedClearALevel) {
  std::string chords = down_to("-3") + cut(7, 0);
  for (int i = 1; i <= 90; ++i) {
    const double angle = -i * std::numbers::pi / 45;
    chords += cut(7 * std::cos(angle), 7 * std::sin(angle));
  }
  Declared granted = kLcyc75;
  granted.chord = "0.01";
  EXPECT_EQ(milled(chords + kHome, kRoughing, granted), "GO");
  EXPECT_EQ(milled(chords + kHome), "NO-GO");
}

// SIE-LC75-04: R103 + R102 is Z2, from where the tool feeds. Z0.1 lies in the air.
TEST(Agreement, NoTraverseLeadsOnBeforeTheFirstInfeed) {
  const std::string rest = down_to("-3") + kBorder + kHome;
  EXPECT_EQ(milled(rapid(R"("z":"0.1")") + rest), "NO-GO");
  EXPECT_EQ(milled(down_to("0.1") + rest), "GO");
}

// SIE-LC75-11: in finishing there is air where roughing was, and above R103 also where the tool did
// not fit to rough: 24 less twice 8 is narrower than it.
TEST(Agreement, AFinishingComesDownFastInTheAir) {
  constexpr std::string_view kWide = "R104=-3 R121=3 R124=8 R125=0 R127=2";
  const std::string rest = down_to("-3") + kBorder + kHome;
  EXPECT_EQ(milled(rapid(R"("z":"0.1")") + rest, kWide), "GO");
  EXPECT_EQ(milled(rapid(R"("z":"-0.1")") + rest, kWide), "NO-GO");
}

// Roughing left 1 along the wall, and its floor at -8: the tool is free within 6, and the ring of 7
// clears what lies beyond. Neither alone clears the way from 7 to the middle.
TEST(Agreement, ALevelAndRoughingClearAWayTogether) {
  constexpr std::string_view kTwoLevels = "R104=-8 R121=4 R124=1 R125=0 R127=2";
  EXPECT_EQ(milled(rapid(R"("z":"-4")") + rapid(R"("x":"5.9")") + kBorder +
                       rapid(R"("x":"0","y":"0")") + down_to("-8") + kBorder + kHome,
                   kTwoLevels),
            "GO");
}

// SIE-LC75-13, SIE-LC75-04: the way from R101 down to R103 + R102 is printed of roughing alone.
TEST(Agreement, OfFinishingTheWayDownFromR101IsFree) {
  constexpr std::string_view kTwoLevels = "R104=-8 R121=4 R124=1 R125=0 R127=2";
  const std::string rest = kBorder + rapid(R"("x":"0","y":"0")") + down_to("-8") + kBorder + kHome;
  const std::string beside = rapid(R"("x":"5.9")");
  EXPECT_EQ(milled_from_r101(beside + rapid(R"("z":"-4")") + rest, kTwoLevels), "GO");
  EXPECT_EQ(milled_from_r101(line("feed", R"("z":"-4")", "500") + rest, kTwoLevels), "GO");
  // Through the wall, and above R101.
  EXPECT_EQ(
      milled_from_r101(rapid(R"("x":"7.9")") + beside + rapid(R"("z":"-4")") + rest, kTwoLevels),
      "NO-GO");
  EXPECT_EQ(milled_from_r101(rapid(R"("z":"11")") + rapid(R"("z":"-4")") + rest, kTwoLevels),
            "NO-GO");
  const std::string roughed = down_to("-3") + kBorder + kHome;
  EXPECT_EQ(
      milled_from_r101(beside + rapid(R"("x":"0")") + rapid(R"("z":"2")") + roughed, kRoughing),
      "NO-GO");
}

// SIE-LC75-13: it ends above the centre at R101.
TEST(Agreement, NothingOfAPocketFollowsItsEnd) {
  const std::string whole = down_to("-3") + kBorder + kHome;
  EXPECT_EQ(milled(whole), "GO");
  EXPECT_EQ(milled(whole + rapid(R"("z":"10")") + rapid(R"("z":"-2")")), "NO-GO");
}

// SIE-LC75-13: no speed is printed for the way back to R101. There the cycle is over.
TEST(Agreement, APocketIsLeftByATraverseOrAFeed) {
  const std::string level = down_to("-3") + kBorder + kHome;
  for (const std::string_view feed : {"100", "300", "500"}) {
    const std::string up = line("feed", R"("z":"10")", feed);
    EXPECT_EQ(milled(level + up), "GO") << feed;
    EXPECT_EQ(milled(level + up + line("feed", R"("x":"1")", feed)), "NO-GO") << feed;
  }
  EXPECT_EQ(milled(level + line("feed", R"("z":"10.01")", "300")), "NO-GO");
}

// R2 ------------------------------------------------------------------------------------------

constexpr std::string_view kMoved = R"({"k":"rapid","b":1,"to":{"x":"10","y":"0"}})"
                                    "\n";
std::string turn_about_zero(std::string_view y) {
  return std::string(kMoved) +
         fmt::format(
             R"({{"k":"arc","b":2,"plane":"G17","c":{{"x":"0","y":"0"}},"rot":1,"to":{{"x":"10","y":"{}"}},"f":"100"}}
)",
             y);
}

// J-PATH-06, J-PROP-01: 10 * pi / 180000 = 0.00017 due, which are rounded to none.
TEST(Agreement, AnArcThatRoundingClosesIsThatArcAndNoWholeTurn) {
  constexpr std::string_view kProgram = "G0 X10 Y0\nG3 I-10 AR=0.001 F100\n";
  const auto says = [&](std::string_view resolution, bool exact) {
    return both(
        kProgram, turn_about_zero("0"),
        {.dialect = "sinumerik840d", .exact = exact, .resolution = std::string(resolution)});
  };
  EXPECT_EQ(says("0.001", false), "GO");
  EXPECT_EQ(says("", false), "undecided");
  // What it says, and what is rounded more finely, is a turn of 62 mm.
  EXPECT_EQ(says("", true), "NO-GO");
  EXPECT_EQ(says("0.0001", false), "NO-GO");
}

// A turn and 0.00002 more, which are rounded to none: the record has two turns, as that of the
// program has.
TEST(Agreement, AnArcOfSeveralTurnsThatRoundingClosesMakesNoneMore) {
  const auto says = [](int rot, std::string_view resolution) {
    return both("G21 G90 G17\nG0 X10 Y0\nG3 X10 Y0.00002 I-10 P2 F100\nM2\n",
                fmt::format(R"({{"k":"rapid","b":2,"to":{{"x":"10","y":"0"}}}}
{{"k":"arc","b":3,"plane":"G17","c":{{"x":"0","y":"0"}},"rot":{},"to":{{"x":"10","y":"0"}},"f":"100"}}
)",
                            rot),
                {.m = false, .resolution = std::string(resolution)});
  };
  EXPECT_EQ(says(2, "0.0001"), "GO");
  EXPECT_EQ(says(2, ""), "undecided");
  EXPECT_EQ(says(1, "0.0001"), "GO");
  EXPECT_EQ(says(3, "0.0001"), "NO-GO");
}

TEST(Agreement, AWholeTurnWhereNoArcIsDueIsOneWhateverIsDeclared) {
  for (const std::string_view resolution : {"", "0.001"}) {
    EXPECT_EQ(both("G0 X10 Y0\nG4 F1\n", turn_about_zero("0") + R"({"k":"dwell","b":2,"s":"1"})",
                   {.dialect = "sinumerik840d", .resolution = std::string(resolution)}),
              "NO-GO");
  }
}

// R3 ------------------------------------------------------------------------------------------

TEST(Agreement, ADwellThatRoundsToNoneNeedNotCome) {
  const auto dwells = [](std::string_view time, std::string_view came,
                         std::string_view resolution) {
    return both(fmt::format("G0 X10\nG4 F{}\nG0 X5\n", time),
                fmt::format(R"({{"k":"rapid","b":1,"to":{{"x":"10"}}}}
{}{{"k":"rapid","b":3,"to":{{"x":"5"}}}}
)",
                            came),
                {.dialect = "sinumerik840d", .resolution = std::string(resolution)});
  };
  constexpr std::string_view kNone = "{\"k\":\"dwell\",\"b\":2,\"s\":\"0\"}\n";
  for (const std::string_view resolution : {"0.001", ""}) {
    EXPECT_EQ(dwells("0.0004", kNone, resolution), "GO");
    EXPECT_EQ(dwells("0.0004", "", resolution), "GO");
    EXPECT_EQ(dwells("0.0004", "{\"k\":\"dwell\",\"b\":2,\"s\":\"0.0004\"}\n", resolution), "GO");
    EXPECT_EQ(dwells("0.0006", kNone, resolution), "NO-GO");
    EXPECT_EQ(dwells("0.0006", "", resolution), "NO-GO");
  }
}

TEST(Agreement, ADwellThatRoundsToNoneNeedNotComeBeforeTheEnd) {
  EXPECT_EQ(both("G0 X10\nG4 F0.0004\n", R"({"k":"rapid","b":1,"to":{"x":"10"}})",
                 {.dialect = "sinumerik840d", .resolution = "0.001"}),
            "GO");
}

// A circle of radius 0.0003 lies within 0.0006 of each of its points, one of 0.0006 does not lie
// within tau.
TEST(Agreement, AHelixNoWiderThanTauMayComeAsALineAndTheReverse) {
  const auto down = [](std::string_view radius) {
    return both(fmt::format("G0 X{0} Y0 Z0\nG2 I-{0} Z-5 F100\n", radius),
                fmt::format(R"({{"k":"rapid","b":1,"to":{{"x":"{}","y":"0","z":"0"}}}}
{{"k":"feed","b":2,"to":{{"z":"-5"}},"f":"100"}}
)",
                            radius),
                {.dialect = "sinumerik840d"});
  };
  EXPECT_EQ(down("0.0003"), "GO");
  EXPECT_EQ(down("0.0006"), "NO-GO");
  const auto winds = [](std::string_view radius) {
    return both(fmt::format("G0 X{} Y0 Z0\nG1 Z-5 F100\n", radius),
                fmt::format(
                    R"({{"k":"rapid","b":1,"to":{{"x":"{0}","y":"0","z":"0"}}}}
{{"k":"arc","b":2,"plane":"G17","c":{{"x":"0","y":"0"}},"rot":-2,"to":{{"x":"{0}","y":"0","z":"-5"}},"f":"100"}}
)",
                    radius),
                {.dialect = "sinumerik840d"});
  };
  EXPECT_EQ(winds("0.0003"), "GO");
  EXPECT_EQ(winds("0.0006"), "NO-GO");
}

// R6 ------------------------------------------------------------------------------------------

// A negative feed is an alarm (NGC), and line 3 moves on through it.
TEST(Agreement, WhoRunsThroughAnAlarmMissesIt) {
  constexpr std::string_view kProgram = "G21 G90 F100\nG1 X10\nG1 Y10 F-1\nM2\n";
  const std::string through = R"({"k":"feed","b":2,"to":{"x":"10"},"f":"100"}
{"k":"feed","b":3,"to":{"y":"10"},"f":"100"}
)";
  EXPECT_EQ(judge(kProgram, through, {.m = false}).kind, oracle::VerdictKind::fail_alarm_missing);
  EXPECT_EQ(decide(kProgram, through, {.m = false}).kind, oracle::VerdictKind::fail_alarm_missing);
  const std::string late = through + R"({"k":"alarm","b":3,"class":"value-sign"})";
  EXPECT_EQ(judge(kProgram, late, {.m = false}).kind, oracle::VerdictKind::fail_alarm_late);
  EXPECT_EQ(decide(kProgram, late, {.m = false}).kind, oracle::VerdictKind::fail_alarm_late);
}

// The alarm map has no class for it, so that nothing says that it is of another one.
TEST(Agreement, AnAlarmWithoutAClassIsUnmapped) {
  constexpr std::string_view kProgram = "G21 G90 F100\nG1 X10\nG1 Y10 F-1\nM2\n";
  const std::string trace = R"({"k":"feed","b":2,"to":{"x":"10"},"f":"100"}
{"k":"alarm","b":3,"native":"E7"}
)";
  EXPECT_EQ(judge(kProgram, trace, {.m = false}).kind, oracle::VerdictKind::unmapped_alarm);
  EXPECT_EQ(decide(kProgram, trace, {.m = false}).kind, oracle::VerdictKind::unmapped_alarm);
}

// F0 leaves no feed, which is an alarm; whether the value is one, no text says (SIE-COM-06, R7).
TEST(Agreement, AnAlarmOfABlockThatAlarmsMayAnswerAnUnstatedRuleOfIt) {
  constexpr std::string_view kProgram = "G0 X10 M3 S100\nG1 X20 F0\nM30\n";
  const auto said = [&](std::string_view alarm) {
    return both(kProgram,
                fmt::format(R"({{"k":"rapid","b":1,"to":{{"x":"10"}}}}
{{"k":"alarm","b":2,"class":"{}"}}
)",
                            alarm),
                {.dialect = "sinumerik840d", .m = false});
  };
  EXPECT_EQ(said("feed-missing"), "GO");
  EXPECT_EQ(said("value-out-of-range"), "advice");
  EXPECT_EQ(said("syntax"), "NO-GO");
}

}  // namespace
}  // namespace gonogo::relation
