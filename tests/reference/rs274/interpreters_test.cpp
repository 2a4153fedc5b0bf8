// SPDX-License-Identifier: GPL-3.0-or-later
//
// What no text decides and interpreters do differently. The alternatives of LinuxCNC are as its
// stand-alone interpreter, 2.9, was seen to run these programs.
#include <gtest/gtest.h>

#include <algorithm>

#include "ngc_expanding.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

TEST(NgcTool, OneThatTheTableHasNotIsTakenOrAlarms) {
  const Profile looks = ngc({{"ngc.missing-tool", "alarm"}});
  EXPECT_EQ(path("G0 X1\nT5 X2\nM2"), (Lines{"rapid x1", "rapid x2"}));
  EXPECT_EQ(path("G0 X1\nT5 X2\nM2", looks), (Lines{"rapid x1", "alarm b2 no-tool"}));
  EXPECT_EQ(clauses("T5\nM2", looks), Lines{"NGC-COM-11"});
  EXPECT_EQ(touched("T5\nM2"), Lines{"ngc.missing-tool"});
}

TEST(NgcTool, OneOfTheTableAndNoneAreTaken) {
  Profile looks = ngc({{"ngc.missing-tool", "alarm"}});
  looks.tools["5"] = {};
  EXPECT_EQ(path("T5 M6 G0 X1\nT0 M6\nM2", looks), Lines{"rapid x1"});
  EXPECT_EQ(ending_of("T5.0\nT6\nM2", looks), "alarm b2 no-tool");
  EXPECT_EQ(touched("T0\nM2"), Lines{});
  // A number that is none of a tool is wrong by another rule.
  EXPECT_EQ(ending_of("T-1\nM2", looks), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("T1.5\nM2", looks), "alarm b1 not-an-integer");
}

TEST(NgcFeed, IsKeptByG94OrLost) {
  const Profile none = ngc({{"ngc.g94-feed", "none"}});
  EXPECT_EQ(path("F100\nG94\nG1 X1\nM2"), Lines{"feed x1 f100"});
  EXPECT_EQ(ending_of("F100\nG94\nG1 X1\nM2", none), "alarm b3 feed-missing");
  EXPECT_EQ(touched("F100\nG94\nM2"), Lines{"ngc.g94-feed"});
  // The F of the block comes behind the mode; a feed that there is not cannot be lost.
  EXPECT_EQ(path("F100\nG94 F80\nG1 X1\nM2", none), Lines{"feed x1 f80"});
  EXPECT_EQ(path("G94\nF100 G1 X1\nM2", none), Lines{"feed x1 f100"});
  EXPECT_EQ(touched("G94\nG94 F100\nM2"), Lines{});
}

// 10 inches are 254 mm: F10 is 10 mm/min before G20 and 254 mm/min behind it.
TEST(NgcFeed, BesideNewUnitsCountsInThoseBeforeOrBehind) {
  const Profile after = ngc({{"ngc.feed-units", "after"}});
  EXPECT_EQ(path("G20 G1 X1 F10\nM2"), Lines{"feed x25.4 f10"});
  EXPECT_EQ(path("G20 G1 X1 F10\nM2", after), Lines{"feed x25.4 f254"});
  EXPECT_EQ(path("G20\nG21 G1 X1 F10\nM2"), Lines{"feed x1 f254"});
  EXPECT_EQ(path("G20\nG21 G1 X1 F10\nM2", after), Lines{"feed x1 f10"});
  EXPECT_EQ(touched("G20 F10\nM2"), Lines{"ngc.feed-units"});
  EXPECT_EQ(touched("G21 F10\nG20\nG20 F1\nM2"), Lines{});
}

TEST(NgcSkipped, ALineThatCannotBeReadIsNothingOrAlarms) {
  Profile unread = ngc();
  unread.block_skip = true;
  Profile read = ngc({{"ngc.block-delete", "read"}});
  read.block_skip = true;
  for (const char* line : {"/G0 X1.2.3", " / X", "/@"}) {
    const std::string text = "G0 X1\n" + std::string(line) + "\nX2\nM2";
    EXPECT_EQ(path(text, unread), (Lines{"rapid x1", "rapid x2"})) << line;
    EXPECT_EQ(path(text, read), (Lines{"rapid x1", "alarm b2 syntax"})) << line;
    EXPECT_EQ(touched(text, unread), Lines{"ngc.block-delete"}) << line;
  }
  EXPECT_EQ(path("/G0 G1 X1\n/M2\nG0 X2\nM2", read), Lines{"rapid x2"});
  EXPECT_EQ(touched("/G0 G1 X1\nM2", read), Lines{});
}

TEST(NgcLines, ACarriageReturnAloneEndsOneOrIsABlank) {
  const Profile blank = ngc({{"ngc.lone-cr", "blank"}});
  const std::string text = "G0 X1\rY5\nX2\nM2\n";
  EXPECT_EQ(path(text), (Lines{"rapid x1", "rapid y5", "rapid x2"}));
  EXPECT_EQ(path(text, blank), (Lines{"rapid x1 y5", "rapid x2"}));
  EXPECT_EQ(touched(text), Lines{"ngc.lone-cr"});
  EXPECT_EQ(touched(text, blank), Lines{"ngc.lone-cr"});
  EXPECT_EQ(path("G0 X1\r0\r\nM2", blank), Lines{"rapid x10"});
  EXPECT_EQ(path("G0 X1 ;note\rX2\nM2", blank), Lines{"rapid x1"});
  EXPECT_EQ(ending_of("G0 X1\rY5\nX2 X3\nM2", blank), "alarm b2 duplicate-word");
  EXPECT_EQ(touched("G0 X1\r\nM2\r"), Lines{});
}

TEST(NgcDwell, ABlockWhoseMotionAlarmsMayHaveDwelt) {
  const Profile dwells = ngc({{"ngc.alarm-dwell", "dwells"}});
  EXPECT_EQ(path("G4 P1 G1 Y5\nM2"), Lines{"alarm b1 feed-missing"});
  EXPECT_EQ(path("G4 P1 G1 Y5\nM2", dwells), (Lines{"dwell 1", "alarm b1 feed-missing"}));
  EXPECT_EQ(path("G4 P1 G1\nM2", dwells), (Lines{"dwell 1", "alarm b1 feed-missing"}));
  EXPECT_EQ(path("F9\nG4 P1 G81 X1 Z-1\nM2", dwells), (Lines{"dwell 1", "alarm b2 missing-word"}));
  EXPECT_EQ(touched("G4 P1 G1 Y5\nM2"), Lines{"ngc.alarm-dwell"});
  // What is found when the line is read comes before.
  for (const char* block : {"G4 P1 I2", "G4 P1 G81", "G4 P1 G80 X1", "G4 P1 X1", "G4 G1 Y5"}) {
    EXPECT_EQ(path(block, dwells).size(), 1U) << block;
    EXPECT_EQ(std::ranges::count(touched(block), "ngc.alarm-dwell"), 0) << block;
  }
}

// The documents: 256 characters.
TEST(NgcInterpreters, ALineOfMoreThan256CharactersIsReadOrNot) {
  const auto line = [](std::size_t size) {
    const std::string words = "G0 X1 (";
    return words + std::string(size - words.size() - 1, 'a') + ")";
  };
  const Profile reads = ngc({{"ngc.long-line", "read"}});
  const Profile refuses = ngc({{"ngc.long-line", "syntax"}});
  EXPECT_EQ(path(line(256), reads), Lines{"rapid x1"});
  EXPECT_EQ(path(line(256), refuses), Lines{"rapid x1"});
  EXPECT_EQ(path(line(257), reads), Lines{"rapid x1"});
  EXPECT_EQ(ending_of("G0 X5\n" + line(257), refuses), "alarm b2 syntax");
  EXPECT_EQ(touched(line(256) + "\nM2"), Lines{});
  EXPECT_EQ(touched(line(257) + "\nM2"), Lines{"ngc.long-line"});
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
