// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions about as large as the tolerance (0.001 mm), which one side may drop and the other keep;
// and motions that go on past what is covered. X is a diameter in the programs, a radius in traces.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

constexpr double kHair = 1e-10;
constexpr double kTau = 0.001;

VerdictKind kind_of(std::string_view program, const TraceText& trace, bool blocks = true) {
  Judging judging;
  judging.blocks = blocks;
  judging.binary64 = true;
  return judge_trace(program, trace.text(), judging).kind;
}
Decision decided_as_binary64(std::string_view program, const TraceText& trace, bool blocks = true) {
  return decision(kind_of(program, trace, blocks));
}

// The traverse of block 1, short of its end by `hair`.
TraceText at_ten(double hair = 0) {
  TraceText trace(1);
  trace.decimals(15).rapid({{'z', 10 - hair}}).block(2, 100);
  return trace;
}

// Exactly the tolerance: the reference drops it.
constexpr std::string_view kStep = "G00 Z10\nG01 Z10.001 F100\n";
constexpr std::string_view kStepAndOn = "G00 Z10\nG01 Z10.001 F100\nG00 X20\n";

TEST(SmallMotions, OneThatOnlyTheSubjectKeepsIsNoOverrun) {
  for (double hair : {-kHair, 0.0, kHair}) {
    TraceText trace = at_ten(hair);
    trace.feed({{'z', 10 + kTau + hair}});
    EXPECT_EQ(decided_as_binary64(kStep, trace), Decision::go) << hair;
  }
}

TEST(SmallMotions, OneThatOnlyTheSubjectKeepsMayStandBeforeAnother) {
  for (double hair : {-kHair, 0.0, kHair}) {
    TraceText trace = at_ten(hair);
    trace.feed({{'z', 10 + kTau + hair}}).block(3, 0).rapid({{'x', 10}});
    EXPECT_EQ(decided_as_binary64(kStepAndOn, trace), Decision::go) << hair;
  }
}

// Two motions of exactly the tolerance, along Z and X, both dropped by the reference. As doubles
// the first is 0.00100000000000033 long, and the second ends as much off: the subject's numbers
// here are those doubles.
TEST(SmallMotions, OneOfExactlyTheToleranceMayBeLongerAsADouble) {
  static_assert(7.001 - 7.0 > 0.001 && 5.3 < 5.301);
  const std::string_view program = "G00 X10.6 Z7\nG01 Z7.001 F100\nX10.602\n";
  TraceText trace(1);
  trace.line(R"({"k":"rapid","b":1,"to":{"x":"0x1.5333333333333p+2","z":"7"}})")
      .line(R"({"k":"feed","b":2,"to":{"z":"0x1.c010624dd2f1bp+2"},"f":"100"})")
      .line(R"({"k":"feed","b":3,"to":{"x":"0x1.534395810624ep+2"},"f":"100"})");
  EXPECT_EQ(decided_as_binary64(program, trace), Decision::go);
}

// Half a circle of the size of the tolerance about (0.0005, 0), which the reference drops. The
// subject's centre, off by half a nanometre, makes it a little more than half a turn.
TEST(SmallMotions, AnArcThatOnlyTheSubjectKeepsMayBeOfMoreThanHalfATurn) {
  const std::string before = R"({"k":"feed","b":1,"to":{"y":"-5"},"f":"100"}
{"k":"feed","b":2,"to":{"y":"0"},"f":"100"}
)";
  const auto arc = [](std::string_view centre_y) {
    return fmt::format(R"({{"k":"arc","b":3,"plane":"G17","c":{{"x":"0.0005","y":"{}"}},"rot":1,)"
                       R"("to":{{"x":"0.001","y":"0"}},"f":"100"}})"
                       "\n",
                       centre_y);
  };
  const std::string half = "G17 G1 F100 Y-5\nY0\nG3 X0.001 I0.0005\n";
  Judging judging;
  judging.dialect = "sinumerik802s";
  for (const char* centre_y : {"-0.0000000005", "0", "0.0000000005"}) {
    const std::string small = before + arc(centre_y);
    EXPECT_EQ(decision(judge_trace(half, small, judging).kind), Decision::go) << centre_y;
    const std::string on = R"({"k":"feed","b":4,"to":{"x":"3"},"f":"100"})";
    EXPECT_EQ(decision(judge_trace(half + "G1 X3\n", small + on, judging).kind), Decision::go)
        << centre_y;
  }
  // A whole circle of 20 mm from there closes within the tolerance, too: the arc of that block with
  // another centre.
  const std::string big = R"({"k":"arc","b":3,"plane":"G17","c":{"x":"10","y":"0"},"rot":1,)"
                          R"("to":{"x":"0.001","y":"0"},"f":"100"})";
  EXPECT_EQ(judge_trace(half, before + big, judging).kind, VerdictKind::fail_geometry);
  // Where the reference has no arc, it is one too many.
  EXPECT_EQ(judge_trace("G17 G1 F100 Y-5\nY0\n", before + arc("-0.0000000005"), judging).kind,
            VerdictKind::fail_overrun);
}

// G112 with a radius of the tolerance: the reference drops the half circles before and behind the
// helix. The subject's first may be a piece of the helix or nothing; it goes on from it as nothing.
TEST(SmallMotions, AnArcBeforeAHelixAsSmallIsNoPartOfItsTurns) {
  const auto judged = [](std::string_view helix, int times = 1,
                         std::string_view entry_feed = "495") {
    std::string trace = R"({"k":"rapid","b":1,"to":{"x":"20","y":"-16","z":"5"}}
{"k":"rapid","b":2,"to":{"x":"42.25","z":"-13.421"}}
{"k":"rapid","b":2,"to":{"y":"-17"}}
{"k":"arc","b":2,"plane":"G18","c":{"x":"42.25","z":"-13.4205"},"rot":-1,"to":{"x":"42.25","z":"-13.42"},"f":")";
    trace += std::string(entry_feed) + "\"}\n";
    for (; times > 0; --times) {
      trace += fmt::format(R"({{"k":"arc","b":2,"plane":"G18","c":{{"x":"42.25","z":"-13.421"}},)"
                           R"({},"to":{{"x":"42.25","y":"-17.001","z":"-13.42"}},"f":"495"}})"
                           "\n",
                           helix);
    }
    trace +=
        R"({"k":"arc","b":2,"plane":"G18","c":{"x":"42.25","z":"-13.4205"},"rot":-1,"to":{"x":"42.25","z":"-13.421"},"f":"495"}
{"k":"rapid","b":2,"to":{"y":"-16"}}
)";
    Judging judging;
    judging.reading = "gsk.helix.entry-side=+p";
    return decision(
        judge_trace("G00 G18 X40 Y-16 Z5 F495\nG112 Z-13.421 U44.5 V-0.001 R-1 I1.001 D1 L6\n",
                    trace, judging)
            .kind);
  };
  EXPECT_EQ(judged(R"("rot":-6)"), Decision::go);
  EXPECT_EQ(judged(R"("rot":-3)", 2), Decision::go);
  // What is too small to see has no feed to see either.
  EXPECT_EQ(judged(R"("rot":-6)", 1, "400"), Decision::go);
  // Five turns and the two halves are six to within the tolerance.
  EXPECT_EQ(judged(R"("rot":-4)"), Decision::no_go);
  EXPECT_EQ(judged(R"("rot":-7)"), Decision::no_go);
  EXPECT_EQ(judged(R"("rot":6)"), Decision::no_go);
}

// The answer to an arc with so many turns, after a traverse; `%` stands for them in the trace.
Decision decided_with_turns(std::string_view program, std::string trace, std::string_view rot) {
  Judging judging;
  judging.dialect = "rs274";
  return decision(judge_trace(program, trace.replace(trace.find('%'), 1, rot), judging).kind);
}

// The radius grows by 0.0019 over two turns of 6.6 mm, and ends on the ray where it starts: the nil
// and the full turn lie side by side there, but after others only one is meant.
// J-PATH-06.
TEST(SmallMotions, OneTurnTooManyToAnEndOnTheSameRayIsNoGo) {
  const auto judged = [](std::string_view rot) {
    return decided_with_turns("G0 X0 Y0.0002\nG17 G2 X0.0019 Y0.0002 I-6.6 J0 P2 F236\n",
                              R"({"k":"rapid","b":1,"to":{"x":"0","y":"0.0002"}}
{"k":"arc","b":2,"plane":"G17","c":{"x":"-6.6","y":"0.0002"},"rot":%,"to":{"x":"0.0019","y":"0.0002"},"f":"236"}
)",
                              rot);
  };
  EXPECT_EQ(judged("-2"), Decision::go);
  EXPECT_EQ(judged("-3"), Decision::no_go);
  EXPECT_EQ(judged("-1"), Decision::no_go);
}

// Three turns and a half about a radius of twice the tolerance, down by 0.3: the ends lie opposite
// each other, however each is moved.
TEST(SmallMotions, OneTurnTooManyOfATinyHelixIsNoGo) {
  const auto judged = [](std::string_view rot) {
    return decided_with_turns("G0 X45.4 Y8\nG17 G2 X45.4004 Y8 I0.0002 Z-0.3 P4 F541\n",
                              R"({"k":"rapid","b":1,"to":{"x":"45.4","y":"8"}}
{"k":"arc","b":2,"plane":"G17","c":{"x":"45.4002","y":"8"},"rot":%,"to":{"x":"45.4004","y":"8","z":"-0.3"},"f":"541"}
)",
                              rot);
  };
  EXPECT_EQ(judged("-4"), Decision::go);
  EXPECT_EQ(judged("-5"), Decision::no_go);
  EXPECT_EQ(judged("-3"), Decision::no_go);
}

TEST(SmallMotions, TwiceTheToleranceIsADeparture) {
  TraceText trace = at_ten();
  trace.feed({{'z', 10 + 2 * kTau + kHair}});
  EXPECT_EQ(kind_of("G00 Z10\n", trace), VerdictKind::fail_overrun);
  trace.block(3, 0).rapid({{'x', 10}});
  EXPECT_EQ(decided_as_binary64(kStepAndOn, trace), Decision::no_go);
}

// R3.
TEST(SmallMotions, ManyOfThemCannotAddUp) {
  // To and fro in X, and on in Z by 0.6 of the tolerance.
  TraceText trace = at_ten();
  for (int i = 1; i <= 20; ++i) {
    trace.rapid({{'x', i % 2 == 0 ? 0 : 0.6 * kTau}, {'z', 10 + 0.6 * kTau * i}});
  }
  EXPECT_EQ(decided_as_binary64("G00 Z10\n", trace), Decision::no_go);
  EXPECT_EQ(decided_as_binary64("G00 Z10\nM30\n", trace), Decision::no_go);
  EXPECT_EQ(decided_as_binary64("G00 Z10\nG00 X100\n", trace), Decision::no_go);
}

TEST(SmallMotions, ManyOfThemOnTheSpotAreNone) {
  TraceText trace = at_ten();
  for (int i = 1; i <= 20; ++i) {
    trace.rapid({{'x', i % 2 == 0 ? -0.9 * kTau : 0.9 * kTau}});
  }
  EXPECT_EQ(decided_as_binary64("G00 Z10\n", trace), Decision::go);
}

TEST(SmallMotions, ManyDroppedOnesOfTheReferenceCannotAddUp) {
  // 0.6 of the tolerance ten times, in X and Z by turns so that they are not joined: 0.003 each.
  std::string program = "G00 Z10\n";
  for (int i = 1; i <= 5; ++i) {
    program += "G01 Z" + std::to_string(10 + 0.0006 * i) + " F100\n";
    program += "X" + std::to_string(0.0012 * i) + "\n";
  }
  EXPECT_EQ(decided_as_binary64(program, at_ten()), Decision::no_go);
}

// The reference keeps a motion of 0.0011; of the subject's, 0.001 long, nothing is left.
constexpr std::string_view kKept = "G00 Z10\nG01 Z10.0011 F100\n";

TEST(SmallMotions, OneThatOnlyTheReferenceKeepsIsDoneWhereTheSubjectStands) {
  TraceText trace = at_ten();
  trace.feed({{'z', 10 + kTau}});
  EXPECT_EQ(decided_as_binary64(kKept, trace), Decision::go);
  EXPECT_EQ(decided_as_binary64(kKept, at_ten()), Decision::no_go);
}

TEST(SmallMotions, OneThatOnlyTheReferenceKeepsMayStandBeforeADwell) {
  const std::string program = std::string(kKept) + "G04 X1\n";
  const char* dwell = R"({"k":"dwell","b":3,"s":"1"})";
  TraceText trace = at_ten();
  trace.feed({{'z', 10 + kTau}}).line(dwell);
  EXPECT_EQ(decided_as_binary64(program, trace), Decision::go);
  EXPECT_EQ(decided_as_binary64(program, at_ten().line(dwell)), Decision::no_go);
}

// Without line numbers the subject's 0.001 is one with the cut before it, or after it.
TEST(SmallMotions, OneThatIsJoinedOnOneSideOnlyBelongsToTheCut) {
  TraceText before = at_ten();
  before.feed({{'z', 20}}).feed({{'z', 20 + kTau + kHair}});
  EXPECT_EQ(decided_as_binary64("G00 Z10\nG01 Z20 F100\nZ20.001\n", before, false), Decision::go);
  TraceText after(1, 100);
  after.decimals(15).rapid({{'z', 10 - kHair}}).feed({{'z', 10 + kTau}}).feed({{'z', 20}});
  EXPECT_EQ(decided_as_binary64("G00 Z10\nG01 Z10.001 F100\nZ20\n", after, false), Decision::go);
}

// A cut from (10, 10) to (15, 20), and on in the same direction after a code that is not covered.
constexpr std::string_view kCutOn = "G00 X20 Z10\nG01 X30 Z20 F100\nG55\nX60 Z50\n";

TEST(NotCovered, WithoutLineNumbersACutMayGoOnPastIt) {
  const auto to = [](double x, double z, double feed = 100) {
    TraceText trace(1, feed);
    trace.decimals(15).rapid({{'x', 10 + kHair}, {'z', 10}}).feed({{'x', x}, {'z', z}});
    return kind_of(kCutOn, trace, false);
  };
  EXPECT_EQ(to(30, 50), VerdictKind::oracle_gap);
  EXPECT_EQ(to(15, 20), VerdictKind::oracle_gap);
  EXPECT_EQ(to(30 + kHair, 50), VerdictKind::oracle_gap);
  EXPECT_EQ(decision(to(30, 49)), Decision::no_go);
  EXPECT_EQ(decision(to(5, 0)), Decision::no_go);
  EXPECT_EQ(decision(to(30, 50, 90)), Decision::no_go);
}

TEST(NotCovered, WithoutLineNumbersThePiecesOfACutMayGoOnPastIt) {
  TraceText trace(1, 100);
  trace.rapid({{'x', 10}, {'z', 10}})
      .feed({{'x', 12.0005}, {'z', 14}})
      .feed({{'x', 30}, {'z', 50}});
  EXPECT_EQ(kind_of(kCutOn, trace, false), VerdictKind::oracle_gap);
}

// A quarter from (10, 0) to (0, 10) about the origin, and on to (-10, 0).
TEST(NotCovered, WithoutLineNumbersAnArcMayGoOnPastIt) {
  constexpr std::string_view kArcOn =
      "G17 G00 X20 Y0 Z0\nG03 X0 Y10 I-10 J0 F100\nG55\nG03 X-20 Y0 I0 J-10\n";
  const auto arc = [&](double centre, int rot, double x) {
    TraceText trace(1, 100);
    trace.rapid({{'x', 10}}).arc("G17", {{'x', centre}, {'y', 0}}, rot, {{'x', x}, {'y', 0}});
    return kind_of(kArcOn, trace, false);
  };
  EXPECT_EQ(arc(0, 1, -10), VerdictKind::oracle_gap);
  EXPECT_EQ(decision(arc(0, -1, -10)), Decision::no_go);
  EXPECT_EQ(decision(arc(0.0011, 1, -10)), Decision::no_go);
  EXPECT_EQ(decision(arc(0, 1, -10.0021)), Decision::no_go);
}

// With line numbers the cut is told from what follows.
TEST(NotCovered, WithLineNumbersACutEndsWhereItsBlockDoes) {
  TraceText trace(1, 100);
  trace.rapid({{'x', 10}, {'z', 10}}).block(2, 100).feed({{'x', 30}, {'z', 50}});
  EXPECT_EQ(decided_as_binary64(kCutOn, trace), Decision::no_go);
}

}  // namespace
}  // namespace gonogo::oracle
