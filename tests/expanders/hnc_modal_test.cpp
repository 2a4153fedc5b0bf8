// SPDX-License-Identifier: GPL-3.0-or-later
// What one block hands to the next: modal words, cancelling, frames, units, feeds.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

constexpr const char* kOffsets =
    R"({"offsets":{"G54":{"x":"10","z":"100"},"G55":{"x":"1","z":"-5"}}})";

TEST(HncModal, WordsAreForgottenWhenTheCommandChanges) {
  // Without I: B and C have the same X.
  EXPECT_EQ(run_hnc("G80 X-4 Z-5 I-1 F9\nG81 X-4 Z-5\nG80 X-4 Z-5\n").records[8], "rapid x=-2");
  EXPECT_EQ(run_hnc("G80 X-4 Z-5 I-1 F9\nG00 X0\nG80 X-4 Z-5\n").records[4], "rapid x=-2");
  EXPECT_EQ(run_hnc("G74 Z-5 R1 Q2 F9\nG75 X-8\n").records[6], "feed x=-4 f=9");
  EXPECT_EQ(run_hnc("G82 X-4 Z-5 F2\nG80 X-4 Z-5 F9\nG82 X-4 Z-5\n").alarm, "lead-missing");
}

TEST(HncModal, TheSameCodeAgainKeepsThem) {
  EXPECT_EQ(run_hnc("G80 X-4 Z-5 I-1 F9\nG80 X-4 Z-5\n").records[4], "rapid x=-3");
  EXPECT_EQ(run_hnc("G82 X-4 Z-5 R-1 E1 F2\nG82 X-4 Z-6\n").records[7],
            "thread x=-1 z=-7 lead=2 start=0");
}

TEST(HncModal, OrdersWithoutMotionKeepThem) {
  const std::string first = "G80 X-4 Z-5 I-1 F9\n";
  for (const char* between : {"M8", "G04 P10", "G92 X0 Z0", "G55", "S9 T0101", "G40"}) {
    EXPECT_EQ(run_hnc(first + between + "\nM9\nU-4 W-5\n").alarm, "") << between;
    const Outcome outcome = run_hnc(first + between + "\nU-4 W-5\n");
    // I-1 is still there: the last cut comes from B at -3 to C at -2.
    EXPECT_EQ(outcome.records[outcome.records.size() - 5], "rapid x=-3") << between;
  }
}

TEST(HncModal, MotionCodesCancelTheCycle) {
  for (const char* code : {"G00", "G01", "G32 F1"}) {
    const Outcome outcome = run_hnc(std::string("G80 X-4 Z-5 F9\n") + code + " X2\n");
    EXPECT_EQ(outcome.records.size(), 6u) << code;
  }
}

TEST(HncModal, ACodeWithoutAxisTakesItsWordsIn) {
  EXPECT_EQ(run_hnc("G80 I-1 F9\nX-4 Z-5\n").motions(),
            "rapid x=-3\nfeed x=-2 z=-5 f=9\nfeed x=0 f=9\nrapid z=0\n");
}

TEST(HncModal, WordsOfDwellAreNotTheCycles) {
  // P of G04 is no start angle.
  EXPECT_EQ(run_hnc("G82 F2\nG04 P500\nX-2 Z-4\n").motions(),
            "dwell 0.5\nrapid x=-1\nthread x=-1 z=-4 lead=2 start=0\nrapid x=0\nrapid z=0\n");
}

TEST(HncModal, MissingAxis) {
  EXPECT_EQ(run_hnc("G80 X-4 Z-5 F9\nX-6\n").alarm, "missing-word");
  EXPECT_EQ(run_hnc("G80 X-4 F9\n").alarm_word, 'Z');
  const char* keep = R"({"readings":{"hnc.missing-axis":"keep"}})";
  EXPECT_EQ(run_hnc("G80 X-4 Z-5 F9\nX-6\nW-7\n", keep).motions(),
            "rapid x=-2\nfeed x=-2 z=-5 f=9\nfeed x=0 f=9\nrapid z=0\n"
            "rapid x=-3\nfeed x=-3 z=-5 f=9\nfeed x=0 f=9\nrapid z=0\n"
            "rapid x=-3\nfeed x=-3 z=-7 f=9\nfeed x=0 f=9\nrapid z=0\n");
  EXPECT_EQ(run_hnc("G80 X-4 F9\n", keep).alarm, "missing-word");
  EXPECT_EQ(run_hnc("G80 X-4 Z-5 F9\nG81 X-4\n", keep).alarm, "missing-word");
  const char* none = R"({"readings":{"hnc.missing-axis":"none"}})";
  EXPECT_EQ(run_hnc("G00 X2 Z3\nG80 X-4 F9\n", none).motions(),
            "rapid x=1 z=3\nrapid x=-2\nfeed x=1 f=9\n");
}

TEST(HncModal, FeedOfACycleIsTheOrdinaryOne) {
  EXPECT_EQ(run_hnc("G01 X2 F9\nG80 X-4 Z-5\n").records[2], "feed x=-2 z=-5 f=9");
  EXPECT_EQ(run_hnc("G80 X-4 Z-5 F9\nG01 X2\n").records[4], "feed x=1 f=9");
  EXPECT_EQ(run_hnc("G80 X-4 Z-5 F0\n").alarm, "feed-missing");
}

TEST(HncModal, ForgottenFeed) {
  const char* forgotten = R"({"readings":{"hnc.modal.f":"forgotten"}})";
  EXPECT_EQ(run_hnc("G01 X2 F9\nG80 X-4 Z-5\n", forgotten).alarm, "feed-missing");
  EXPECT_EQ(run_hnc("G80 X-4 Z-5 F9\nG81 X-4 Z-5\n", forgotten).alarm, "feed-missing");
  EXPECT_EQ(run_hnc("G80 X-4 Z-5 F9\nG01 X2\n", forgotten).alarm, "feed-missing");
  EXPECT_EQ(run_hnc("G01 X0 F7\nG80 F9\nX-4 Z-5\nG01 X2\n", forgotten).motions(),
            "rapid x=-2\nfeed x=-2 z=-5 f=9\nfeed x=0 f=9\nrapid z=0\nfeed x=1 f=7\n");
}

TEST(HncModal, FeedPerRevolution) {
  EXPECT_EQ(run_hnc("G95 G80 X-4 Z-5 F0.2\nG94 G01 X2 F50\n").motions(),
            "rapid x=-2\nfeed x=-2 z=-5 f=0.2/rev\nfeed x=0 f=0.2/rev\nrapid z=0\nfeed x=1 f=50\n");
}

TEST(HncFrames, OffsetsAddToAbsoluteWords) {
  EXPECT_EQ(run_hnc("G00 X2 Z3\nG55 X2 Z3\nG91 X2 Z3\nG56 G90 X2\n", kOffsets).motions(),
            "rapid x=11 z=103\nrapid x=2 z=-2\nrapid x=3 z=1\nrapid x=1\n");
  EXPECT_EQ(run_hnc("G00 X22 Z105\nG80 X2 Z3 I-1 F9\n", kOffsets).motions(),
            "rapid x=21 z=205\nrapid x=10\nfeed x=11 z=103 f=9\nfeed x=21 f=9\nrapid z=205\n");
}

TEST(HncFrames, OffsetAtPowerOn) {
  const char* none = R"({"offsets":{"G54":{"x":"10"}},"readings":{"hnc.offset.initial":"none"}})";
  EXPECT_EQ(run_hnc("G00 X2\nG54 X2\n", none).motions(), "rapid x=1\nrapid x=11\n");
}

TEST(HncFrames, SetPosition) {
  EXPECT_EQ(run_hnc("G92 X10 Z7\nG91 G00 X2 Z1\n").motions(), "rapid x=6 z=8\n");
  // The word is in the work frame: X2 is 1 + 10 in the base frame.
  EXPECT_EQ(run_hnc("G92 X2\nG91 G00 U2\n", kOffsets).motions(), "rapid x=12\n");
  EXPECT_EQ(run_hnc("G00 X8 Z9\nG91 G92 X2 W3\nG00 U2 W1\n").motions(),
            "rapid x=4 z=9\nrapid x=2 z=13\n");
  EXPECT_EQ(run_hnc("G37 G92 X2\nG00 U2\n").motions(), "rapid x=4\n");
}

TEST(HncUnits, DiametersAndRadii) {
  EXPECT_EQ(run_hnc("G00 X20\nU30\nG37 X10\nU15\nG36 X8\n").motions(),
            "rapid x=10\nrapid x=25\nrapid x=10\nrapid x=25\nrapid x=4\n");
  EXPECT_EQ(run_hnc("G00 X20\nG36 U2\n", R"({"x_diameter":false})").motions(),
            "rapid x=20\nrapid x=21\n");
  // I is a radius under both.
  EXPECT_EQ(run_hnc("G37 G80 X-2 Z-5 I-1 F9\n").records[0], "rapid x=-3");
}

TEST(HncUnits, Inches) {
  EXPECT_EQ(run_hnc("G20 G80 X-2 Z-1 I-0.1 F10\n").motions(),
            "rapid x=-27.94\nfeed x=-25.4 z=-25.4 f=254\nfeed x=0 f=254\nrapid z=0\n");
  EXPECT_EQ(run_hnc("G20 G74 Z-0.1 R0.01 Q0.06 F1\n").motions(),
            "feed z=-1.524 f=25.4\nrapid z=-1.27\nfeed z=-2.54 f=25.4\nrapid z=0\n");
  EXPECT_EQ(run_hnc("G21 G00 Z1\n", R"({"units":"inch"})").motions(), "rapid z=1\n");
  EXPECT_EQ(run_hnc("G00 Z1\n", R"({"units":"inch"})").motions(), "rapid z=25.4\n");
}

TEST(HncArcs, MakersExample) {
  EXPECT_EQ(run_hnc("G00 X0 Z0\nG03 U24 W-24 R15 F60\nG02 X26 Z-31 R5\n").motions(),
            "arc18 c=-15,0 rot=1 x=12 z=-24 f=60\narc18 c=-27,16 rot=-1 x=13 z=-31 f=60\n");
}

TEST(HncArcs, CentreWordsAreTrueLengths) {
  // From (Z0, X0) about (Z-15, X0) to (Z-24, X12): 9-12-15.
  EXPECT_EQ(run_hnc("G03 X24 Z-24 K-15 F60\n").motions(), "arc18 c=-15,0 rot=1 x=12 z=-24 f=60\n");
  EXPECT_EQ(run_hnc("G02 X10 Z5 I5 F60\n").motions(), "arc18 c=0,5 rot=-1 x=5 z=5 f=60\n");
  EXPECT_EQ(run_hnc("G02 I5 F60\n").motions(), "arc18 c=0,5 rot=-1 x=0 z=0 f=60\n");
}

TEST(HncArcs, RadiiMayDifferByTheParameter) {
  const std::string arc = "G02 X10.02 Z5 I5 F60\n";  // 5 and sqrt(25.0001) = 5.00001
  EXPECT_EQ(run_hnc(arc).alarm, "");
  EXPECT_EQ(run_hnc(arc, R"({"parameters":{"3410":"0"}})").alarm, "arc-end-point");
  EXPECT_EQ(run_hnc("G02 X10 Z5.02 I5 F60\n").alarm, "arc-end-point");
  EXPECT_EQ(run_hnc("G02 X10 Z9 I5 F60\n", R"({"parameters":{"3410":"-1"}})").alarm, "");
}

TEST(HncArcs, BrokenRules) {
  EXPECT_EQ(run_hnc("G02 X2 Z2 F9\n").alarm, "missing-word");
  EXPECT_EQ(run_hnc("G02 X0 Z0 R5 F9\n").alarm, "arc-end-point");
  EXPECT_EQ(run_hnc("G02 Z10.002 R5 F9\n").alarm, "arc-radius");
  EXPECT_EQ(run_hnc("G02 X2 Z2 I0 K0 F9\n").answer, GONOGO_ALARM);
  EXPECT_EQ(run_hnc("G02 I0 F9\n").alarm, "arc-radius");
  EXPECT_EQ(run_hnc("G02 I0 F9\n", R"({"readings":{"hnc.arc.zero-radius":"none"}})").motions(), "");
  EXPECT_EQ(run_hnc("G02 X2 Z2 R5\n").alarm, "feed-missing");
}

// Half the chord is 5.01 and R 5.
TEST(HncArcs, BrokenRulesOfROnOtherMachines) {
  const char* closed = R"({"readings":{"hnc.arc.closed":"none"}})";
  EXPECT_EQ(run_hnc("G02 X0 Z0 R5 F9\nG00 X2\n", closed).motions(), "rapid x=1\n");
  const char* half = R"({"readings":{"hnc.arc.small-radius":"semicircle"}})";
  EXPECT_EQ(run_hnc("G02 Z10.02 R5 F9\n", half).motions(),
            "arc18 c=5.01,0 rot=-1 x=0 z=10.02 f=9\n");
  EXPECT_EQ(run_hnc("G02 Z10.022 R5 F9\n", half).alarm, "arc-radius");
}

}  // namespace
}  // namespace gonogo::expanders::testing
