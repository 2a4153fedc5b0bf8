// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traces that follow their program and were once NO-GO, each with the rule that allows them.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

Decision decision_of(std::string_view program, std::string_view trace, const Judging& judging) {
  const Verdict verdict = judge_trace(program, trace, judging);
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
  return decision(verdict.kind);
}

std::string rapid(int block, const char* to) {
  const std::string line = block == 0 ? "" : fmt::format("\"b\":{},", block);
  return fmt::format(R"({{"k":"rapid",{}"to":{{{}}}}})"
                     "\n",
                     line, to);
}

// The last axis of a traverse goes on in the next traverse: each ends where it ends.
TEST(FalseNoGo, ATraverseAxisByAxisMayEndInTheDirectionOfTheNextOne) {
  const Judging no_blocks = {.blocks = false, .dialect = "rs274"};
  const std::string trace = rapid(0, R"("x":"1")") + rapid(0, R"("y":"1")") +
                            rapid(0, R"("y":"2")") + rapid(0, R"("x":"2")");
  decision_of("G0 X1 Y1\nG0 X2 Y2\n", trace, no_blocks);
  // Past the first end, along one axis, and beside it.
  const std::string past = rapid(0, R"("x":"1")") + rapid(0, R"("y":"2")") + rapid(0, R"("x":"2")");
  decision_of("G0 X1 Y1\nG0 X2 Y2\n", past, no_blocks);
  const std::string beside =
      rapid(0, R"("x":"0.5")") + rapid(0, R"("y":"2")") + rapid(0, R"("x":"2")");
  EXPECT_EQ(judge_trace("G0 X1 Y1\nG0 X2 Y2\n", beside, no_blocks).kind,
            VerdictKind::fail_geometry);
}

// HNC-G82-09: the run-out keeps lead and start. R-2 E0 leads on along the thread: to z -42.
TEST(FalseNoGo, ARunOutInLineWithTheThreadMayBeOneWithIt) {
  const std::string before = R"({"k":"rapid","b":1,"to":{"x":"17.5","z":"5"}}
{"k":"rapid","b":2,"to":{"x":"14.5"}}
)";
  const std::string after = R"({"k":"rapid","b":2,"to":{"x":"17.5"}}
{"k":"rapid","b":2,"to":{"z":"5"}}
)";
  const auto thread = [](const char* z, const char* lead) {
    return fmt::format(R"({{"k":"thread","b":2,"to":{{"z":"{}"}},"lead":"{}","start":"0"}})"
                       "\n",
                       z, lead);
  };
  constexpr std::string_view kThreaded = "G00 X35 Z5\nG82 X29 Z-40 R-2 E0 F1.5\n";
  const Judging hnc = {.dialect = "hnc21t"};
  decision_of(kThreaded, before + thread("-40", "1.5") + thread("-42", "1.5") + after, hnc);
  decision_of(kThreaded, before + thread("-42", "1.5") + after, hnc);
  EXPECT_EQ(judge_trace(kThreaded, before + thread("-40", "1.5") + after, hnc).kind,
            VerdictKind::fail_geometry);
  EXPECT_EQ(
      judge_trace(kThreaded, before + thread("-40", "1.5") + thread("-42", "2") + after, hnc).kind,
      VerdictKind::fail_feed);
}

// HNC-G74-02: down by 6 to 4, up by 0.0005, which is within the tolerance, and on to -2.
TEST(FalseNoGo, AWithdrawalTooSmallToSeeMayBeLeftOut) {
  const auto cut = [](const char* z) {
    return fmt::format(R"({{"k":"feed","b":2,"to":{{"z":"{}"}},"f":"50"}})"
                       "\n",
                       z);
  };
  const std::string trace =
      rapid(1, R"("x":"0","z":"10")") + cut("4") + cut("-2") + rapid(2, R"("z":"10")");
  decision_of("G00 X0 Z10\nG74 Z-2 R0.0005 Q6 F50\n", trace,
              {.resolution = "0.001", .dialect = "hnc21t"});
}

// The tolerance is 0.001. A piece comes within it of the end, and the next one ends beyond the end
// by no more: together they are a motion that ends there.
TEST(FalseNoGo, ThePiecesOfAMotionMayEndBeyondWhereItIsDue) {
  const auto cut = [](int block, const char* to) {
    return fmt::format(R"({{"k":"feed","b":{},"to":{{{}}},"f":"50"}})"
                       "\n",
                       block, to);
  };
  // HNC-G74-02: down by 6 to 4, up to 4.0015, and on to -2.
  const auto withdrawn = [&](const std::string& up) {
    return rapid(1, R"("x":"0","z":"10")") + cut(2, R"("z":"4")") + up + cut(2, R"("z":"-2")") +
           rapid(2, R"("z":"10")");
  };
  constexpr std::string_view kPecks = "G00 X0 Z10\nG74 Z-2 R0.0015 Q6 F50\n";
  const Judging hnc = {.resolution = "0.001", .dialect = "hnc21t"};
  const std::string near = rapid(2, R"("z":"4.00075")");
  decision_of(kPecks, withdrawn(near + rapid(2, R"("z":"4.002")")), hnc);
  EXPECT_NE(decision(judge_trace(kPecks, withdrawn(near + rapid(2, R"("z":"4.003")")), hnc).kind),
            Decision::go);
  constexpr std::string_view kCorner = "G00 X0 Z10\nG01 X0 Z5 F50\nX10\n";
  const std::string to_corner = rapid(1, R"("x":"0","z":"10")") + cut(2, R"("z":"5.0005")");
  decision_of(kCorner, to_corner + cut(2, R"("z":"4.9992")") + cut(3, R"("x":"5")"), hnc);
}

// The infeed to Z4 of a level in pieces, and a circle at each of these X, up to the tool's reach
// (GSK-G110-08, -09).
std::string level_by_circles(const std::vector<std::string>& infeed,
                             const std::vector<std::string>& circles) {
  std::string trace = rapid(1, R"("x":"15","y":"14","z":"9")") + rapid(2, R"("x":"10","y":"10")") +
                      rapid(2, R"("z":"6")");
  for (const std::string& z : infeed) {
    trace += fmt::format(R"({{"k":"feed","b":2,"to":{{"z":{}}},"f":"200"}})"
                         "\n",
                         z);
  }
  for (const std::string& x : circles) {
    trace += fmt::format(
        R"({{"k":"feed","b":2,"to":{{"x":{0}}},"f":"200"}})"
        "\n"
        R"({{"k":"arc","b":2,"plane":"G17","c":{{"x":"10","y":"10"}},"rot":-1,"to":{{"x":{0},"y":"10"}},"f":"200"}})"
        "\n",
        x);
  }
  return trace + rapid(2, R"("z":"6")") + rapid(2, R"("x":"10","y":"10")") + rapid(2, R"("z":"9")");
}
constexpr std::string_view kOneLevel =
    "G17 G00 X30 Y14 Z9\nG110 X20 Y10 W-2 R-3 I10 L4 Q2 P0.5 D3 F200\n";

// In steps of 4.
TEST(FalseNoGo, ThePiecesOfAnInfeedMayEndBeyondTheLevel) {
  decision_of(kOneLevel,
              level_by_circles({R"("4.0005")", R"("3.9992")"},
                               {R"("12")", R"("14")", R"("16")", R"("17")"}),
              {.resolution = "0.001"});
}

// R9: what an enclosure leaves open of a level is less than the gauge's own rounding of it.
TEST(FalseNoGo, CirclesOfALevelMayEndInEnclosures) {
  const std::string near_12 = R"({"enclosure":["11.99999999999999999","12.00000000000000001"]})";
  const auto level = [&](const std::string& last) {
    return level_by_circles({R"("4")"}, {near_12, R"("14")", R"("16")", last});
  };
  decision_of(kOneLevel, level(R"("17")"), {});
  // Into the wall, and a ring that is left out.
  EXPECT_EQ(judge_trace(kOneLevel, level(R"("17.01")")).kind, VerdictKind::fail_region);
  EXPECT_EQ(judge_trace(kOneLevel, level_by_circles({R"("4")"}, {near_12, R"("17")"})).kind,
            VerdictKind::fail_region);
}

// The sagitta of a chord of 0.1 of a circle of 1.3 is 1.3 - sqrt(1.69 - 0.0025) = 0.00096, within
// the tolerance of 0.001.
TEST(FalseNoGo, AnArcThatAgreesWithItsChordMayBePartOfALongerLine) {
  const Judging sinumerik = {.blocks = false, .dialect = "sinumerik840d", .tolerance = "0.001"};
  const auto feed = [](const char* to) {
    return fmt::format(R"({{"k":"feed","to":{{{}}},"f":"100"}})"
                       "\n",
                       to);
  };
  const std::string before = rapid(0, R"("x":"0","y":"0","z":"0")");
  constexpr std::string_view kArcInLine =
      "G0 X0 Y0 Z0\nG1 X10 F100\nG2 X10.1 Y0 CR=1.3\nG1 X20\nX20 Y5\n";
  const std::string after = feed(R"("y":"5")");
  decision_of(kArcInLine, before + feed(R"("x":"20")") + after, sinumerik);
  decision_of(kArcInLine, before + feed(R"("x":"9")") + feed(R"("x":"20")") + after, sinumerik);
  const std::string over = before + feed(R"("x":"10.05")") + feed(R"("x":"9")");
  EXPECT_EQ(judge_trace(kArcInLine, over + feed(R"("x":"20")") + after, sinumerik).kind,
            VerdictKind::fail_geometry);
  // Beside it.
  EXPECT_EQ(
      judge_trace(kArcInLine, before + feed(R"("x":"20","y":"0.002")") + after, sinumerik).kind,
      VerdictKind::fail_geometry);
  // As much of an arc as is a line, across the end of one.
  const std::string across =
      feed(R"("x":"9.95")") +
      R"({"k":"arc","plane":"G17","c":{"x":"10","y":"-1.3"},"rot":-1,"to":{"x":"10.05","y":"0"},"f":"100"})"
      "\n" +
      feed(R"("x":"20")");
  decision_of("G0 X0 Y0 Z0\nG1 X10 F100\nX10.1\nX20\n", before + across, sinumerik);
}

// A helix of hardly a turn, whose end is rounded to where it starts: its record cannot say less
// than a full turn.
// J-PATH-06.
TEST(FalseNoGo, AHelixThatClosesOnlyBecauseItIsRoundedIsTriedAsNoTurn) {
  const auto trace = [](const char* x) {
    return fmt::format(
        R"({{"k":"arc","b":2,"plane":"G17","c":{{"x":"{}","y":"0"}},"rot":1,"to":{{"x":"0","y":"0","z":"5"}},"f":"100"}})"
        "\n",
        x);
  };
  const Judging rounded = {.resolution = "0.0001", .dialect = "rs274"};
  decision_of("G0 X0 Y0\nG3 X0 Y0.00004 I-10 J0 Z5 F100\n", trace("-10"), rounded);
  // One that does go round is not taken for none.
  EXPECT_EQ(judge_trace("G0 X0 Y0\nG1 X0 Y0 Z5 F100\n", trace("-10"), rounded).kind,
            VerdictKind::fail_geometry);
}

TEST(FalseNoGo, TheLineOfAnAlarmAsksForNoneOfRecords) {
  const std::string trace = rapid(0, R"("x":"1")") + R"({"k":"alarm","class":"feed-missing","b":2})"
                                                     "\n";
  decision_of("G0 X1\nG1 X2\n", trace, {.blocks = false, .dialect = "rs274"});
}

// GSK-G112-01: M35 before the first cut. A feed that stays where it is cuts nothing.
constexpr std::string_view kClamped = "G17 G00 X40 Y30 Z10\nG112 X20 Y10 W-4 I6 D4 F200 M35\n";

// By hand: the centre (10, 10), from the start's height 10 the entry by a half circle of radius
// (6 - 4) / 2 = 1 about (11, 10), a turn of radius 2 down by 4, a half circle back to the centre.
std::string clamped_pocket(std::string_view entry, std::string_view before_m = "") {
  return fmt::format(R"({{"k":"rapid","b":1,"to":{{"x":"20","y":"30","z":"10"}}}}
{{"k":"rapid","b":2,"to":{{"x":"10","y":"10"}}}}
{}{{"k":"m","b":2,"m":35}}
{}{{"k":"arc","b":2,"plane":"G17","c":{{"x":"10","y":"10"}},"rot":-1,"to":{{"x":"12","y":"10","z":"6"}},"f":"200"}}
{{"k":"arc","b":2,"plane":"G17","c":{{"x":"11","y":"10"}},"rot":-1,"to":{{"x":"10","y":"10"}},"f":"200"}}
{{"k":"rapid","b":2,"to":{{"z":"10"}}}}
)",
                     before_m, entry);
}
constexpr std::string_view kEntryCircle =
    R"({"k":"arc","b":2,"plane":"G17","c":{"x":"11","y":"10"},"rot":-1,"to":{"x":"12","y":"10"},"f":"200"})"
    "\n";

TEST(FalseNoGo, AFeedThatStaysComesNotBeforeM35) {
  const auto feed_to = [](const char* z) {
    return fmt::format(R"({{"k":"feed","b":2,"to":{{"z":"{}"}},"f":"200"}})"
                       "\n",
                       z);
  };
  const Judging with_m = {.m = true};
  decision_of(kClamped, clamped_pocket(kEntryCircle), with_m);
  decision_of(kClamped, clamped_pocket(kEntryCircle, feed_to("10")), with_m);
  const std::string late = clamped_pocket("", kEntryCircle);
  EXPECT_EQ(judge_trace(kClamped, late, with_m).kind, VerdictKind::fail_order);
}

// Its F of 200 lies in the enclosure; one about 250 is another feed.
TEST(FalseNoGo, AFeedOfAHelicalPocketMayComeAsAnEnclosure) {
  const auto enclosed = [](std::string_view low, std::string_view high) {
    std::string trace = clamped_pocket(kEntryCircle);
    const std::string feed = R"("z":"6"},"f":"200")";
    return trace.replace(trace.find(feed), feed.size(),
                         fmt::format(R"("z":"6"}},"f":{{"enclosure":["{}","{}"]}})", low, high));
  };
  decision_of(kClamped, enclosed("199.9999999999999999", "200.0000000000000001"), {.m = true});
  EXPECT_EQ(judge_trace(kClamped, enclosed("249.9999999999999999", "250"), {.m = true}).kind,
            VerdictKind::fail_feed);
}

// An arc3 is one kind with arc: by way of (11, 11), clockwise from (10, 10) to (12, 10); and the
// other way round, by (11, 9).
TEST(FalseNoGo, AnArcThroughAPointMayBePartOfAHelicalPocket) {
  const auto through = [](const char* y) {
    return fmt::format(
        R"({{"k":"arc3","b":2,"via":{{"x":"11","y":"{}","z":"10"}},"to":{{"x":"12","y":"10","z":"10","a":"0","c":"0"}},"f":"200"}})"
        "\n",
        y);
  };
  decision_of(kClamped, clamped_pocket(through("11")), {});
  EXPECT_EQ(judge_trace(kClamped, clamped_pocket(through("9"))).kind, VerdictKind::fail_geometry);
}

// "%a" of 359.999, the way that a double is written exactly.
// R3.
TEST(FalseNoGo, ASpindleAngleMayBeTheNearestDouble) {
  const auto trace = [](const char* start) {
    return fmt::format(R"({{"k":"rapid","b":1,"to":{{"x":"17.5","z":"5"}}}}
{{"k":"rapid","b":2,"to":{{"x":"14.5"}}}}
{{"k":"thread","b":2,"to":{{"z":"-40"}},"lead":"3","start":"{}"}}
{{"k":"rapid","b":2,"to":{{"x":"17.5"}}}}
{{"k":"rapid","b":2,"to":{{"z":"5"}}}}
)",
                       start);
  };
  constexpr std::string_view kThreaded = "G00 X35 Z5\nG82 X29 Z-40 P359.999 F3\n";
  const Judging doubles = {.binary64 = true, .dialect = "hnc21t"};
  decision_of(kThreaded, trace("0x1.67ffbe76c8b44p+8"), doubles);
  EXPECT_EQ(judge_trace(kThreaded, trace("359.9991"), doubles).kind, VerdictKind::fail_geometry);
}

// I 4.001 and D 4: a circle of radius 0.001, and semicircles whose centre, 0.0005 off, is rounded
// onto their end.
std::string cut_arc(const char* x, int rot, const char* to) {
  return fmt::format(
      R"({{"k":"arc","b":2,"plane":"G17","c":{{"x":"{}","y":"10"}},"rot":{},"to":{{{}}},"f":"200"}})"
      "\n",
      x, rot, to);
}

// J-PATH-06.
TEST(FalseNoGo, ASemicircleAsSmallAsTheResolutionMayEndOnItsOwnCentre) {
  const Judging rounded = {.resolution = "0.001"};
  const std::string before =
      rapid(1, R"("x":"20","y":"30","z":"10")") + rapid(2, R"("x":"10","y":"10")");
  const std::string entry = cut_arc("10.001", -1, R"("x":"10.001","y":"10")");
  const std::string helix = cut_arc("10", -2, R"("x":"10.001","y":"10","z":"5")");
  const std::string after = rapid(2, R"("z":"10")");
  constexpr std::string_view kHelix =
      "G17 G00 X40 Y30 Z10\nG112 X20 Y10 W-4 R-1 I4.001 D4 L2 F200\n";
  const std::string down = before + rapid(2, R"("z":"9")");
  const std::string back = cut_arc("10.001", -1, R"("x":"10","y":"10")");
  decision_of(kHelix, down + entry + helix + back + after, rounded);
  decision_of(kHelix, down + entry + helix + after, rounded);
  EXPECT_EQ(judge_trace(kHelix, down + entry + back + after, rounded).kind,
            VerdictKind::fail_geometry);
  const std::string wide = cut_arc("10.5", -1, R"("x":"10","y":"10")");
  EXPECT_EQ(judge_trace(kHelix, down + wide + entry + helix + back + after, rounded).kind,
            VerdictKind::fail_geometry);
  // The same of a level of G110.
  const std::string cleared = before + R"({"k":"feed","b":2,"to":{"z":"8"},"f":"200"})" + "\n" +
                              entry + cut_arc("10", -1, R"("x":"10.001","y":"10")") + after +
                              rapid(2, R"("x":"10","y":"10")");
  decision_of("G17 G00 X40 Y30 Z10\nG110 X20 Y10 W-2 I4.001 L4 Q2 D4 F200\n", cleared, rounded);
}

}  // namespace
}  // namespace gonogo::oracle
