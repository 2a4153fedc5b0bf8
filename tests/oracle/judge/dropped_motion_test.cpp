// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions that are too small to see on one side and not on the other, since the two have not
// dropped the same ones before. Found by generated programs with lengths of a few increments.
#include <gtest/gtest.h>

#include "judging.hpp"
#include "own_outcome.hpp"

namespace gonogo::oracle {
namespace {

// Each ends within the tolerance of where the reference stands, or stood before what it dropped.
TEST(DroppedMotions, OfTheReferenceAreExactWhereTheSubjectKeepsThem) {
  struct Program {
    std::string_view dialect;
    std::string_view text;
  };
  for (const Program& program : {
           // A thread, whose last traverse is 0.001, and a taper of 0.002 from there.
           Program{"gsk988ta",
                   "G17\nG117 X0 Y0 W1.08 I0.27 E2 P0.001 D0.5 J0 F1\nG94 U-0.003\nG02 U1 R1\n"},
           Program{"gsk988ta", "F1\nG18 G116 Z0 X0 V1 I1 E1 P0.001 D0.002 J0\nG94 W0.002 R-0.001\n"},
           Program{"gsk988ta", "F1\nG18 G117 W0 U0 V3.808 I1.904 E1 P0.001 D0.003 J0\nG94 R-0.002\n"},
           // An arc before a thread, a traverse to the first level of a pocket or to a helix.
           Program{"gsk988ta", "G17 Y0.002 F1\nG02 U0.002 R1\nG116 U0 Y0.002 W1 I1 E5 P1 D1 J0\n"},
           Program{"gsk988ta",
                   "F1\nG18 G116 Z0.002 X0 V1 I1 E0.016 P0.001 D0.003 J0.001 K0\n"
                   "G110 Z-0.001 U0 V0.001 I2 L1 Q1 D1\n"},
           Program{"gsk988ta",
                   "F1\nG18 G116 Z0.001 X33.5 V-1.974 I0.718 E0.009 P0.001 D0.002 J0.002 K0\n"
                   "G113 Z0 U0 V-0.001 I4.703 D0.003\n"},
           // The second arc is too small to see and ends beside the end of the third.
           Program{"rs274",
                   "G0 X-19.9998 Y20.0004\nG17 G3 X-19.9997 R0.0003 F111\nG3 X-19.9999 R5.4002\n"
                   "G2 X-19.9996 Y20.0004 R19.0002\nG0 Y-48.9999\n"},
           // A full circle of twice the tolerance, and a quarter of the tolerance.
           Program{"rs274",
                   "G0 X1 Y1\nG17 G91 G2 Y0 J-0.0002 F141\nX0.0001 Y-0.0001 I0 J-0.0001\nM30\n"},
           Program{"sinumerik802s",
                   "F131\nG0 X0 Y=IC(-0.001)\nG259 RPL=-135\nG17 G3 X=IC(0) Y=IC(0) I-0.004 J0 "
                   "F50\nM17\n"},
       }) {
    const reference::Profile profile = profile_of(program.dialect);
    // A thread may begin anywhere, and the subject's may be off by what the judge allows it.
    EXPECT_EQ(decision(judge_own(program.text, profile).kind), Decision::go) << program.text;
    EXPECT_EQ(decision(judge_own(program.text, profile, "0.001").kind), Decision::go)
        << program.text;
  }
}

// Two arcs of exactly the tolerance on each axis, of which the reference keeps none: the subject's
// ends are off by half a nanometre, so that its first is longer than that.
TEST(DroppedMotions, LeadToPlacesWhereTheSubjectMayStand) {
  const auto judged = [](std::string_view first_end) {
    const std::string trace =
        R"({"k":"feed","b":1,"to":{"y":"-5"},"f":"100"}
{"k":"feed","b":2,"to":{"y":"0"},"f":"100"}
{"k":"arc","b":3,"plane":"G17","c":{"x":"0.001","y":"0"},"rot":1,"to":{"x":")" +
        std::string(first_end) +
        R"(","y":"-0.001"},"f":"100"}
{"k":"arc","b":4,"plane":"G17","c":{"x":"0","y":"-0.002"},"rot":1,"to":{"x":"-0.001","y":"-0.001"},"f":"100"}
{"k":"feed","b":5,"to":{"x":"3"},"f":"100"}
)";
    Judging judging;
    judging.dialect = "sinumerik840d";
    return decision(judge_trace("G17 G1 F100 Y-5\nY0\nG3 X0.001 Y-0.001 I0.001\n"
                                "X-0.001 I-0.001 J-0.001\nG1 X3\n",
                                trace, judging)
                        .kind);
  };
  EXPECT_EQ(judged("0.001"), Decision::go);
  EXPECT_EQ(judged("0.0010000005"), Decision::go);
  EXPECT_EQ(judged("0.0021"), Decision::no_go);
}

// A taper of the tolerance, of which nothing is seen. With the taper's sign turned the traverse
// leads to within the tolerance of where the cut ends, but two of it from where it should.
TEST(DroppedMotions, LeadNoOtherMotionAnywhere) {
  constexpr std::string_view kTaper = "G00 X200 Z50 F200\nG94 Z50.001 X200 R-0.001\n";
  const auto judged = [&](double along) {
    TraceText trace(1);
    trace.rapid({{'x', 100}, {'z', 50}}).block(2, 200).rapid({{'z', along}});
    trace.feed({{'x', 100}, {'z', 50.001}}).feed({{'z', 50}}).rapid({{'x', 100}});
    return decision(judge_trace(kTaper, trace.text()).kind);
  };
  EXPECT_EQ(judged(50), Decision::go);
  EXPECT_EQ(judged(50.002), Decision::no_go);
}

// The subject's traverse comes in two pieces, of which the second is too small to see: what follows
// is within the tolerance of the first's end, but not of where the reference stands.
TEST(DroppedMotions, OfTheSubjectMayBeWhatTheReferenceMakesNext) {
  constexpr std::string_view kThereAndBack = "G00 X130 Z10\nG01 Z9.9985 F100\nZ10\n";
  const auto arrives = [] {
    TraceText trace(1);
    return trace.rapid({{'x', 65}, {'z', 9.9992}}).rapid({{'z', 10}});
  };
  TraceText there_and_back = arrives();
  there_and_back.block(2, 100).feed({{'z', 9.9985}}).block(3, 100).feed({{'z', 10}});
  EXPECT_EQ(decision(judge_trace(kThereAndBack, there_and_back.text()).kind), Decision::go);
  EXPECT_EQ(decision(judge_trace(kThereAndBack, arrives().text()).kind), Decision::no_go);
  TraceText other_feed = arrives();
  other_feed.block(2, 90).feed({{'z', 9.9985}}).block(3, 90).feed({{'z', 10}});
  EXPECT_EQ(decision(judge_trace(kThereAndBack, other_feed.text()).kind), Decision::no_go);
}

// The subject leaves out the half micrometre that the reference drops: its cut is as far off.
TEST(DroppedMotions, OfTheReferenceCountWhereTheSubjectLeavesThemOut) {
  const std::string program = "G00 X0 Z10\nG01 X0.001 F100\nZ0\nX5\n";
  TraceText trace(1);
  trace.rapid({{'x', 0}, {'z', 10}}).block(3, 100).feed({{'z', 0}}).block(4, 100);
  trace.feed({{'x', 2.5}});
  Judging judging;
  judging.resolution = "0.001";
  EXPECT_EQ(judge_trace(program, trace.text(), judging).kind, VerdictKind::pass_rounded);
}

// Pecks of the tolerance with withdrawals as long: each is too small to see, but they lead on. A
// trace that ends behind the first has not done them.
TEST(DroppedMotions, OfACycleThatLeadsOnAreMissedWhereTheTraceEnds) {
  const std::string trace = R"({"k":"rapid","b":1,"to":{"x":"5"}})"
                            "\n"
                            R"({"k":"feed","b":2,"to":{"x":"5.001"},"f":"60"})"
                            "\n";
  const Verdict verdict =
      judge_trace("G00 X10\nG75 X9999 R0.001 Q0.001 F60\n", trace, {.dialect = "hnc21t"});
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_EQ(verdict.record, 2U);
}

}  // namespace
}  // namespace gonogo::oracle
