// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traces that depart from their program and were once GO, each with the rule that it breaks.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

const Judging kNgc = {.dialect = "rs274"};

// Radius 100 at the start and 100.002 at the end, linear in the angle: atan(3/4) = 36.87 of the 90
// degrees on, at 0.8 and -0.6 times the radius, it is 100.00082.
constexpr std::string_view kSpiral = "G0 X100 Y0\nG2 X0 Y-100.002 I-100 J0 F100\n";

std::string spiral_with_joint(const char* x, const char* y) {
  return fmt::format(
      R"({{"k":"rapid","b":1,"to":{{"x":"100","y":"0"}}}}
{{"k":"arc","b":2,"plane":"G17","c":{{"x":"0","y":"0"}},"rot":-1,"to":{{"x":"{}","y":"{}"}},"f":"100"}}
{{"k":"arc","b":2,"plane":"G17","c":{{"x":"0","y":"0"}},"rot":-1,"to":{{"x":"0","y":"-100.002"}},"f":"100"}}
)",
      x, y);
}

// J-PATH-09.
TEST(FalseGo, ASpiralInPartsHasItsRadiusAtTheJoint) {
  EXPECT_EQ(decision(judge_trace(kSpiral, spiral_with_joint("80.00066", "-60.00049"), kNgc).kind),
            Decision::go);
  // At the radius of the end already, and still at that of the start.
  EXPECT_EQ(judge_trace(kSpiral, spiral_with_joint("80.0016", "-60.0012"), kNgc).kind,
            VerdictKind::fail_geometry);
  EXPECT_EQ(judge_trace(kSpiral, spiral_with_joint("80", "-60"), kNgc).kind,
            VerdictKind::fail_geometry);
}

std::string traverse_to(double x, double z) {
  return fmt::format(R"({{"k":"rapid","b":1,"to":{{"x":"{:.4f}","z":"{:.4f}"}}}})"
                     "\n",
                     x, z);
}

// GSK: tau 0.001, so that each step back is within it.
// R4.
TEST(FalseGo, ATraverseMayNotCreepBack) {
  std::string creeping = traverse_to(5, 5);
  for (int step = 1; step <= 20; ++step) {
    creeping += traverse_to(5 - step * 0.001, 5 - step * 0.001);
  }
  EXPECT_EQ(judge_trace("G00 X20 Z10\n", creeping + traverse_to(10, 10)).kind,
            VerdictKind::fail_geometry);
  const std::string once = traverse_to(5, 5) + traverse_to(4.9995, 4.9995) + traverse_to(10, 10);
  EXPECT_EQ(decision(judge_trace("G00 X20 Z10\n", once).kind), Decision::go);
}

TEST(FalseGo, AnAxisThatStaysMayNotCreepAway) {
  std::string creeping;
  for (int step = 1; step <= 20; ++step) creeping += traverse_to(step * 0.5, step * 0.001);
  EXPECT_EQ(judge_trace("G00 X20\n", creeping + traverse_to(10, 0)).kind,
            VerdictKind::fail_geometry);
}

constexpr std::string_view kBetween = "M3 S100\nG0 X1\nM8\nG1 X2 F100\nM9\nG1 X3\n";
const std::string kMotions[] = {R"({"k":"rapid","b":2,"to":{"x":"1"}})"
                                "\n",
                                R"({"k":"feed","b":4,"to":{"x":"2"},"f":"100"})"
                                "\n",
                                R"({"k":"feed","b":6,"to":{"x":"3"},"f":"100"})"
                                "\n"};
const std::string kFunctions[] = {"{\"k\":\"m\",\"b\":1,\"m\":3}\n",
                                  "{\"k\":\"m\",\"b\":3,\"m\":8}\n",
                                  "{\"k\":\"m\",\"b\":5,\"m\":9}\n"};

VerdictKind kind_of_functions(const std::string& trace) {
  return judge_trace(kBetween, trace, {.m = true, .dialect = "rs274"}).kind;
}

TEST(FalseGo, MFunctionsStandBetweenTheMotionsOfTheBlocksBesideThem) {
  const std::string all = kMotions[0] + kMotions[1] + kMotions[2];
  const std::string functions = kFunctions[0] + kFunctions[1] + kFunctions[2];
  EXPECT_EQ(kind_of_functions(kFunctions[0] + kMotions[0] + kFunctions[1] + kMotions[1] +
                              kFunctions[2] + kMotions[2]),
            VerdictKind::pass_exact);
  EXPECT_EQ(kind_of_functions(all + functions), VerdictKind::fail_order) << "after all motions";
  EXPECT_EQ(kind_of_functions(functions + all), VerdictKind::fail_order) << "before all motions";
  EXPECT_EQ(kind_of_functions(kFunctions[0] + kMotions[0] + kFunctions[1] + kFunctions[2] +
                              kMotions[1] + kMotions[2]),
            VerdictKind::fail_order)
      << "the last one a motion early";
}

TEST(FalseGo, AnMFunctionStandsBeforeTheDwellOfALaterBlock) {
  const std::string dwell = "{\"k\":\"dwell\",\"b\":2,\"s\":\"1\"}\n";
  const Judging judging = {.m = true, .dialect = "rs274"};
  EXPECT_EQ(judge_trace("M8\nG4 P1\n", kFunctions[0] + dwell, judging).kind,
            VerdictKind::fail_geometry);
  const std::string coolant = "{\"k\":\"m\",\"b\":1,\"m\":8}\n";
  EXPECT_EQ(judge_trace("M8\nG4 P1\n", coolant + dwell, judging).kind, VerdictKind::pass_exact);
  EXPECT_EQ(judge_trace("M8\nG4 P1\n", dwell + coolant, judging).kind, VerdictKind::fail_order);
}

// R2, R3.
TEST(FalseGo, ACoarseResolutionExcusesNoLead) {
  constexpr std::string_view kThread = "G00 X20 Z0\nG92 X18 Z-20 F2\n";
  for (const auto& [lead, due] :
       {std::pair("2", Decision::go), std::pair("2.4", Decision::no_go)}) {
    const std::string trace = fmt::format(
        R"({{"k":"rapid","b":1,"to":{{"x":"10","z":"0"}}}}
{{"k":"rapid","b":2,"to":{{"x":"9"}}}}
{{"k":"thread","b":2,"to":{{"x":"9","z":"-20"}},"lead":"{}","start":"0"}}
{{"k":"rapid","b":2,"to":{{"x":"10"}}}}
{{"k":"rapid","b":2,"to":{{"z":"0"}}}}
)",
        lead);
    EXPECT_EQ(decision(judge_trace(kThread, trace, {.resolution = "1"}).kind), due) << lead;
  }
}

TEST(FalseGo, AnAlarmFollowsNoEnd) {
  const std::string cut = R"({"k":"feed","b":1,"to":{"x":"1"},"f":"100"})"
                          "\n";
  const std::string alarm = R"({"k":"alarm","class":"duplicate-word","b":2})"
                            "\n";
  constexpr std::string_view kTwice = "G1 X1 F100\nG0 X1 X2\n";
  EXPECT_EQ(judge_trace(kTwice, cut + alarm, kNgc).kind, VerdictKind::pass_exact);
  EXPECT_EQ(judge_trace(kTwice,
                        cut +
                            R"({"k":"end","to":{"x":"1"}})"
                            "\n" +
                            alarm,
                        kNgc)
                .kind,
            VerdictKind::fail_overrun);
}

// SIE-LC75-04: the approach of roughing is of the pocket's own block. The traces end there; what is
// asked is whether the judge gets so far.
TEST(FalseGo, TheApproachOfAPocketBelongsToItsBlock) {
  constexpr std::string_view kPocket =
      "G0 X0 Y0 Z5 S400 M3 T1 D1\n"
      "R101=5 R102=2 R103=0 R104=-2 R116=0 R117=0 R118=60 R119=50 R120=6\n"
      "R121=2 R122=100 R123=300 R124=9.5 R125=0 R126=2 R127=1\nLCYC75\n";
  const auto message_of = [&](int block) {
    const std::string trace = fmt::format(
        R"({{"k":"rapid","b":1,"to":{{"x":"0","y":"0","z":"5"}}}}
{{"k":"rapid","b":{},"to":{{"z":"2"}}}}
)",
        block);
    return judge_trace(kPocket, trace, {.dialect = "sinumerik802s", .tool = "5"}).message;
  };
  for (const int block : {1, 2, 3}) {
    EXPECT_EQ(message_of(block), "The motion belongs to another block.") << block;
  }
  EXPECT_EQ(message_of(4),
            "The pocket is not milled to its floor. No level is milled between 0 and -2.");
}

// Six hundred chords of 0.262 mm and a sagitta of 0.0001. The last four as one: 1.05 mm and 0.0014,
// so that the middle lies between the two radii, but 0.0014 from the spiral's, which is 100.002
// there.
std::string spiral_in_chords(int last) {
  TraceText text(1);
  text.rapid({{'x', 100}, {'y', 0}}).block(2, 100);
  constexpr int kChords = 600;
  for (int i = 1; i <= kChords; ++i) {
    if (i > kChords - last && i < kChords) continue;
    const double part = static_cast<double>(i) / kChords;
    const double angle = std::numbers::pi / 2 * part;
    const double radius = 100 + 0.002 * part;
    text.feed({{'x', radius * std::cos(angle)}, {'y', -radius * std::sin(angle)}});
  }
  return text.text();
}

TEST(FalseGo, AChordOfASpiralStaysAtItsRadius) {
  const auto kind = [](int last, const char* chord) {
    return judge_trace(kSpiral, spiral_in_chords(last), {.chord = chord, .dialect = "rs274"}).kind;
  };
  EXPECT_EQ(decision(kind(1, "0.0003")), Decision::go);
  EXPECT_EQ(kind(4, "0.0003"), VerdictKind::fail_geometry);
  EXPECT_EQ(decision(kind(4, "0.002")), Decision::go);
}

// Only what the block that alarms says itself may have come of it.
TEST(FalseGo, NoMFunctionComesBesideAnAlarmThatItsBlockDoesNotName) {
  const auto kind = [](std::string_view second, const char* functions) {
    const std::string program = "G0 X1\n" + std::string(second) + "\n";
    return judge_trace(program,
                       std::string(R"({"k":"rapid","b":1,"to":{"x":"1"}})"
                                   "\n") +
                           functions + R"({"k":"alarm","class":"feed-missing","b":2})" + "\n",
                       {.m = true, .dialect = "rs274"})
        .kind;
  };
  constexpr const char* kM8 = "{\"k\":\"m\",\"b\":2,\"m\":8}\n";
  EXPECT_EQ(kind("G1 X2", kM8), VerdictKind::fail_geometry);
  EXPECT_EQ(kind("G1 X2 M80", kM8), VerdictKind::fail_geometry);
  EXPECT_EQ(decision(kind("G1 X2 M8", kM8)), Decision::go);
  EXPECT_EQ(decision(kind("G1 X2 m 08", kM8)), Decision::go);
  // Near enough to 8 where ngc.whole says so; found by fuzz_differential_ngc.
  EXPECT_EQ(decision(kind("G1 X2 m 7.999991", kM8)), Decision::go);
  EXPECT_EQ(kind("G1 X2 M6.999991", kM8), VerdictKind::fail_geometry);
  EXPECT_EQ(decision(kind("G1 X2 M8", "")), Decision::go);
}

// A tolerance is one of axes: a dwell of 1.4 s is none of 1 s, however coarsely lengths come.
TEST(FalseGo, AGrantedToleranceExcusesNoDwell) {
  const auto kind = [](const char* seconds) {
    return judge_trace("G4 P1\n",
                       fmt::format(R"({{"k":"dwell","b":1,"s":"{}"}})"
                                   "\n",
                                   seconds),
                       {.resolution = "1", .dialect = "rs274", .tolerance = "1"})
        .kind;
  };
  EXPECT_EQ(decision(kind("1")), Decision::go);
  EXPECT_EQ(decision(kind("1.4")), Decision::no_go);
}

std::string lathe_motion(const char* kind, const char* axis, const char* to) {
  const std::string feed = std::string(kind) == "feed" ? R"(,"f":"50")" : "";
  return fmt::format(R"({{"k":"{}","b":2,"to":{{"{}":"{}"}}{}}})"
                     "\n",
                     kind, axis, to, feed);
}

// HNC-G75-03: X30 is the radius 15. To traverse there and cut 3 further is a way of a groove with a
// width.
TEST(FalseGo, AGrooveWithoutAWidthIsNotTraversedToItsBottom) {
  const std::string start = R"({"k":"rapid","b":1,"to":{"x":"25","z":"5"}})"
                            "\n";
  const std::string plunge = lathe_motion("rapid", "x", "15") + lathe_motion("feed", "x", "12") +
                             lathe_motion("rapid", "x", "25");
  const Judging hnc = {.reading = "hnc.g75.mode3=any", .dialect = "hnc21t"};
  EXPECT_EQ(decision(judge_trace("G00 X50 Z5\nG75 X30 Q3 F50\n", start + plunge, hnc).kind),
            Decision::no_go);
  const std::string wide =
      start + plunge + lathe_motion("rapid", "z", "4") + plunge + lathe_motion("rapid", "z", "5");
  EXPECT_EQ(decision(judge_trace("G00 X50 Z5\nG75 X30 Z4 Q3 I1 F50\n", wide, hnc).kind),
            Decision::go);
}

// A G50 moves nothing: between its block and the one before, no motion is due. It was a gap.
TEST(FalseGo, AMotionTooManyBeforeARenamingIsNoGap) {
  constexpr std::string_view kRenamed = "G00 X50 Z20\nG50 Z0\nG01 Z-5 F100\n";
  const std::string there = R"({"k":"rapid","b":1,"to":{"x":"25","z":"20"}})"
                            "\n";
  const std::string back = R"({"k":"rapid","b":1,"to":{"x":"0","z":"0"}})"
                           "\n";
  const std::string cut = R"({"k":"feed","b":3,"to":{"x":"25","z":"-5"},"f":"100"})"
                          "\n";
  EXPECT_EQ(decision(judge_trace(kRenamed, there + cut).kind), Decision::go);
  EXPECT_EQ(judge_trace(kRenamed, there + back + cut).kind, VerdictKind::fail_geometry);
}

// The centre is (40.000..., 32.999...), both about the middle of 30 and 43: with the coordinates
// swapped it is off by 7 on either axis, and which of them is more no precision shows. It was a
// gap.
TEST(FalseGo, ACentreOffByTheSameOnBothAxesIsNoGap) {
  const std::string trace =
      R"({"k":"rapid","b":1,"to":{"x":"30","y":"40"}}
{"k":"arc","b":3,"plane":"G17","rot":-1,"f":"100","c":{)"
      R"("x":{"enclosure":["32.99996935274966657332","32.99996935274966657333"]},)"
      R"("y":{"enclosure":["40.00024976559255608353","40.00024976559255608354"]}},"to":{)"
      R"("x":{"enclosure":["51.39621626625134174992","51.39621626625134174993"]},)"
      R"("y":{"enclosure":["37.37459756009948043842","37.37459756009948043843"]}}})"
      "\n";
  EXPECT_EQ(judge_trace("G0 X30 Y40\nG111 X40 Y33\nG2 RP=12.207 AP=21 F100\n", trace,
                        {.reading = "sie.arc.correct=project", .dialect = "sinumerik840d"})
                .kind,
            VerdictKind::fail_geometry);
}

}  // namespace
}  // namespace gonogo::oracle
