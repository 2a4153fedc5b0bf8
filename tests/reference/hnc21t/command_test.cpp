// SPDX-License-Identifier: GPL-3.0-or-later
//
// HNC-MOD-01 to HNC-MOD-05: what holds from block to block.
#include <gtest/gtest.h>

#include "hnc_expanding.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

TEST(Command, AnotherCycleForgetsItsWords) {
  EXPECT_EQ(path("G80 X20 Z-10 I-5 F100\nG81 X20 Z-10\nG80 X20 Z-10").at(8), "rapid x10");
  EXPECT_EQ(path("G74 Z-10 R1 Q5 F50\nG75 X-20").at(4), "feed x-10 f50");
  EXPECT_EQ(path("G74 Z-10 R1 Q5 F50\nG75 X-20").size(), 6U);
}

TEST(Command, AMotionCodeEndsACycleAndForgetsItsWords) {
  for (const char* code : {"G00", "G01", "G02", "G03"}) {
    const Lines got = path("G80 X20 Z-10 I-5 F100\n" + std::string(code) + "\nG80 X20 Z-10 F100");
    EXPECT_EQ(got.at(4), "rapid x10") << code;
  }
  EXPECT_EQ(path("G80 X20 Z-10 F100\nG32 F2\nX40 Z1").at(4), "thread x20 z1 lead2 start0");
  EXPECT_EQ(path("G80 X20 Z-10 F100\nG00 X40 Z1\nX30 Z2").at(5), "rapid x15 z2");
}

// B lies I before C, at a radius of 10.
TEST(Command, WordsLiveOnThroughOtherMotionCodesUnderThatReading) {
  const Profile kept = hnc({{"hnc.modal.words", "kept"}});
  const std::string taper = "G80 X20 Z-10 I-5 F100\n";
  for (const char* code : {"G00", "G01", "G02", "G03", "G32", "G00\nG80 F100\nG01"}) {
    const Lines got = path(taper + code + "\nG80 X20 Z-10 F100", kept);
    EXPECT_EQ(got.at(4), "rapid x5") << code;
  }
  EXPECT_EQ(path(taper + "G00\nG80 X20 Z-10 I-4 F100", kept).at(4), "rapid x6");
  EXPECT_EQ(path("G74 Z-10 R1 Q6 F50\nG00\nG74 Z-8 F50", kept),
            (Lines{"feed z-6 f50", "rapid z-5", "feed z-10 f50", "rapid z0", "feed z-6 f50",
                   "rapid z-5", "feed z-8 f50", "rapid z0"}));
  EXPECT_EQ(path("G75 X-10 Z-2 I1 F30\nG00\nG75 X-10 Z-4 F30", kept).at(8), "rapid z-4");
  EXPECT_EQ(ending_of("G82 X20 Z-10 F3\nG00\nG82 X20 Z-10"), "alarm b3 lead-missing");
  EXPECT_EQ(ending_of("G82 X20 Z-10 F3\nG00\nG82 X20 Z-10", kept), kEndAtOrigin);
}

TEST(Command, AnotherCycleForgetsThemUnderThatReadingToo) {
  const Profile kept = hnc({{"hnc.modal.words", "kept"}});
  const std::string taper = "G80 X20 Z-10 I-5 F100\n";
  EXPECT_EQ(path(taper + "G81 X20 Z-10\nG80 X20 Z-10", kept).at(8), "rapid x10");
  EXPECT_EQ(path(taper + "G00\nG81 X20 Z-10\nG00\nG80 X20 Z-10", kept).at(8), "rapid x10");
  EXPECT_EQ(path("G82 X20 Z-10 I-5 F3\nG00\nG80 X20 Z-10 F100", kept).at(4), "rapid x10");
  // The end point is no such word.
  const Profile both = hnc({{"hnc.modal.words", "kept"}, {"hnc.missing-axis", "keep"}});
  EXPECT_EQ(ending_of(taper + "G00\nG80 X18 F100", both), "alarm b3 missing-word");
}

TEST(Command, AsksForEarlierWordsOnlyWhereTheyAreLacking) {
  const std::string taper = "G80 X20 Z-10 I-5 F100\n";
  EXPECT_EQ(touched(taper + "G00\nG80 X20 Z-10 F100"), Lines{"hnc.modal.words"});
  EXPECT_EQ(touched(taper + "G00\nG80 X20 Z-10 I-5 F100"), Lines{});
  EXPECT_EQ(touched(taper + "G00\nG80 F100"), Lines{});
  EXPECT_EQ(touched(taper + "G00\nG81 X20 Z-10 F100"), Lines{});
  EXPECT_EQ(touched(taper + "X20 Z-10"), Lines{});
  EXPECT_EQ(touched("G80 X20 Z-10 F100\nG00\nG80 X20 Z-10 F100"), Lines{});
}

TEST(Command, TheLeadOfG32StaysInForceBehindOtherCodesUnderItsReading) {
  const Profile kept = hnc({{"hnc.g32.lead", "kept"}});
  const std::string first = "G32 Z-10 F2\n";
  for (const char* code : {"G00 Z0", "G01 Z0 F100", "G82 X20 Z-10 F3"}) {
    const std::string program = first + code + "\nG32 Z-20";
    EXPECT_EQ(ending_of(program), "alarm b3 lead-missing") << code;
    EXPECT_EQ(path(program, kept).back(), "thread z-20 lead2 start0") << code;
    EXPECT_EQ(path(program + " F1.5", kept).back(), "thread z-20 lead1.5 start0") << code;
  }
  EXPECT_EQ(ending_of("G01 Z-10 F2\nG32 Z-20", kept), "alarm b2 lead-missing");
  EXPECT_EQ(touched(first + "G00 Z0\nG32 Z-10"), Lines{"hnc.g32.lead"});
  EXPECT_EQ(touched(first + "G00 Z0\nG32 Z-10 F2"), Lines{});
  EXPECT_EQ(touched("G32 Z-10"), Lines{});
}

// HNC-MOD-04: the feed behind a thread is its F, and G32 has the feed for its lead.
TEST(Command, FIsOneWordForFeedsAndLeadsUnderThatReading) {
  const Profile one = hnc({{"hnc.g32.lead", "feed"}});
  for (const char* thread : {"G32 Z-10 F2", "G82 X20 Z-10 F2"}) {
    const std::string program = std::string("F70\n") + thread + "\nG01 X50";
    EXPECT_EQ(path(program).back(), "feed x25 f70") << thread;
    EXPECT_EQ(path(program, one).back(), "feed x25 f2") << thread;
    EXPECT_EQ(path(program + " F80", one).back(), "feed x25 f80") << thread;
  }
  EXPECT_EQ(touched("F70\nG32 Z-10 F2\nG01 X50"), Lines{"hnc.g32.lead"});
  EXPECT_EQ(touched("F70\nG32 Z-10 F2\nG01 X50 F80"), Lines{});
  EXPECT_EQ(touched("F2\nG32 Z-10 F2\nG01 X50"), Lines{});
  EXPECT_EQ(path("G32 Z-10 F2\nG80 X20 Z-10", one).at(2), "feed x10 z-10 f2");
  EXPECT_EQ(path("G01 Z-10 F80\nG32 Z-20\nZ-30", one).back(), "thread z-30 lead80 start0");
  EXPECT_EQ(path("G80 X20 Z-10 F80\nG32 Z-20", one).back(), "thread z-20 lead80 start0");
  EXPECT_EQ(path("G32 Z-10 F2\nG01 Z0 F80\nG32 Z-10", one).back(), "thread z-10 lead80 start0");
  EXPECT_EQ(ending_of("G32 Z-10", one), "alarm b1 lead-missing");
  EXPECT_EQ(ending_of("F0\nG32 Z-10", one), "alarm b2 lead-missing");
  // J is another word, and G82 wants a lead of its own.
  EXPECT_EQ(ending_of("G32 Z-10 J0.1\nG01 X50", one), "alarm b2 feed-missing");
  EXPECT_EQ(ending_of("F80\nG82 X20 Z-10", one), "alarm b2 lead-missing");
}

// HNC-MOD-01: F of a cycle is forgotten with it, that of G32 is none of its group.
TEST(Command, FOfG82IsForgottenWithItThoughFIsOneWord) {
  const Profile both = hnc({{"hnc.g32.lead", "feed"}, {"hnc.modal.f", "forgotten"}});
  EXPECT_EQ(path("F70\nG82 X20 Z-10 F2\nG01 X50", both).back(), "feed x25 f70");
  EXPECT_EQ(path("F70\nG32 Z-10 F2\nG01 X50", both).back(), "feed x25 f2");
  EXPECT_EQ(path("F70\nG80 X20 Z-10 F80\nG32 Z-20", both).back(), "thread z-20 lead70 start0");
  EXPECT_EQ(ending_of("G80 X20 Z-10 F80\nG32 Z-20", both), "alarm b2 lead-missing");
}

// 0.1 inch are 2.54 mm; a lead is the number, or the length.
TEST(Command, TheOneWordFHasItsUnits) {
  const Profile one = hnc({{"hnc.g32.lead", "feed"}});
  const Profile units = hnc({{"hnc.g32.lead", "feed"}, {"hnc.lead.unit", "units"}});
  const Profile number = hnc({{"hnc.g32.lead", "feed"}, {"hnc.feed-units", "number"}});
  EXPECT_EQ(path("G20 G32 Z-1 F0.1\nG01 Z0", one).back(), "feed z0 f2.54");
  EXPECT_EQ(path("G20 F0.1\nG32 Z-1", one).back(), "thread z-25.4 lead0.1 start0");
  EXPECT_EQ(path("G20 F0.1\nG32 Z-1", units).back(), "thread z-25.4 lead2.54 start0");
  EXPECT_EQ(path("G20 G32 Z-1 F0.1\nG21 G01 Z0", one).back(), "feed z0 f2.54");
  EXPECT_EQ(path("G20 G32 Z-1 F0.1\nG21 G01 Z0", number).back(), "feed z0 f0.1");
}

TEST(Command, TheSameCodeAgainIsNoChange) {
  EXPECT_EQ(path("G80 X20 Z-10 I-5 F100\nG80 X20 Z-10").at(4), "rapid x5");
}

TEST(Command, BlocksWithoutAxisWordsDoNotRepeatACycle) {
  EXPECT_EQ(path("G80 X20 Z-10 F100\nM08\nS300\nT0101\nF50\nI5").size(), 4U);
  EXPECT_EQ(path("G80 X20 Z-10 F100\nF50\nX18 Z-10").at(5), "feed x9 z-10 f50");
}

TEST(Command, ADwellLeavesTheCycle) {
  EXPECT_EQ(path("G80 X20 Z-10 I-5 F100\nG04 P1000\nX20 Z-10").at(4), "dwell 1");
  EXPECT_EQ(path("G80 X20 Z-10 I-5 F100\nG04 P1000\nX20 Z-10").at(5), "rapid x5");
}

TEST(Command, FOfACycleIsTheFeed) {
  EXPECT_EQ(path("F70\nG80 X20 Z-10").at(1), "feed x10 z-10 f70");
  EXPECT_EQ(path("G80 X20 Z-10 F80\nG81 X20 Z-10").at(5), "feed x10 z-10 f80");
  EXPECT_EQ(path("G80 X20 Z-10 F80\nG01 X50").back(), "feed x25 f80");
}

TEST(Command, FOfACycleIsForgottenUnderItsReading) {
  const Profile forgotten = hnc({{"hnc.modal.f", "forgotten"}});
  EXPECT_EQ(ending_of("F70\nG80 X20 Z-10", forgotten), "alarm b2 feed-missing");
  EXPECT_EQ(ending_of("G80 X20 Z-10 F80\nG81 X20 Z-10", forgotten), "alarm b2 feed-missing");
  EXPECT_EQ(path("G80 X20 Z-10 F80\nX18 Z-10", forgotten).at(5), "feed x9 z-10 f80");
  EXPECT_EQ(ending_of("G80 X20 Z-10 F80\nG01 X50", forgotten), "alarm b2 feed-missing");
  EXPECT_EQ(path("F70\nG80 X20 Z-10 F80\nG01 X50", forgotten).back(), "feed x25 f70");
}

TEST(Command, AsksForTheFeedOnlyWhereItMatters) {
  EXPECT_EQ(touched("F70\nG80 X20 Z-10 F80"), Lines{});
  EXPECT_EQ(touched("F70\nG80 X20 Z-10"), Lines{"hnc.modal.f"});
  EXPECT_EQ(touched("F70\nG80 X20 Z-10 F80\nG01 X5"), Lines{"hnc.modal.f"});
  EXPECT_EQ(touched("F70\nG80 X20 Z-10 F70\nG01 X5"), Lines{});
  EXPECT_EQ(touched("G01 X1 F70\nG80 X20 Z-10 F80\nG01 X5 F60"), Lines{});
}

TEST(Command, ALeadIsNoFeedAndAFeedNoLead) {
  EXPECT_EQ(ending_of("G82 X20 Z-10 F3\nG01 X5"), "alarm b2 feed-missing");
  EXPECT_EQ(ending_of("G32 Z-10 F3\nG01 X5"), "alarm b2 feed-missing");
  EXPECT_EQ(ending_of("G01 X5 F100\nG32 Z-5"), "alarm b2 lead-missing");
  EXPECT_EQ(ending_of("G80 X20 Z-10 F80\nG82 X20 Z-10"), "alarm b2 lead-missing");
  EXPECT_EQ(path("F70\nG82 X20 Z-10 F3\nG01 X5").back(), "feed x2.5 f70");
}

TEST(Command, YAndVAreNoWordsOfACycle) {
  EXPECT_EQ(ending_of("G80 X20 Z-10 Y5 F100"), "alarm b1 undefined-code");
  EXPECT_EQ(ending_of("G74 Z-10 V5 F100"), "alarm b1 undefined-code");
  EXPECT_EQ(ending_of("G82 F2\nY5"), "alarm b2 undefined-code");
  EXPECT_EQ(ending_of("G80 X20 Y5 F-1"),
            "alarm b1 undefined-code value-sign feed-missing missing-word");
}

TEST(Command, OutsideACycleTheyBelongToAMill) {
  EXPECT_EQ(ending_of("G00 X20 Y5"), "not-covered b1 Y");
  EXPECT_EQ(ending_of("G80 X20 Z-1 F100\nG01 V5 X1 U1"), "not-covered b2 V");
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
