// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/features.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "oracle/records/features.hpp"

namespace gonogo::program {
namespace {

using Features = std::set<std::string>;

Features features_of(const char* dialect, const char* program) {
  return features_needed(
      {std::get<reference::Profile>(reference::default_profile(dialect)), program});
}

TEST(ProgramFeatures, ACycleNeedsItsFeature) {
  EXPECT_EQ(features_of("gsk988ta", "G0 X1\nG111 X2\n"), (Features{"g110"}));
  EXPECT_EQ(features_of("sinumerik802s", "LCYC75\n"), (Features{"lcyc75"}));
}

// As in the corpus, where a case of g94 is asked of whoever declares g94.
TEST(ProgramFeatures, WhatStandsAroundEveryCycleNeedsNoFeatureOfItsOwn) {
  EXPECT_EQ(features_of("gsk988ta", "G18 G21 M3\nG00 X1\nG94 X1 Z1 F1\nG01 X2\nM30\n"),
            Features{"g94"});
  EXPECT_EQ(features_of("gsk988ta", "G00 X1\nG01 X2 F1\nM30\n"), Features{"basic"});
  EXPECT_EQ(features_of("gsk988ta", "G94 X1 Z1 F1\nG04 P1\n"), (Features{"basic", "g94"}));
  EXPECT_TRUE(
      features_of_part(
          {std::get<reference::Profile>(reference::default_profile("gsk988ta")), "G00 X1\n"})
          .empty());
}

TEST(ProgramFeatures, AWordMayNeedAFeature) {
  EXPECT_EQ(features_of("sinumerik840d", "G2 X1 CR=5\n"), (Features{"arc", "cr"}));
}

// They stand for no code. A lone O is a program's name (NGC-COM-06).
TEST(ProgramFeatures, ParametersAndOWordsAreNeededWhereverTheyStand) {
  EXPECT_EQ(features_of("rs274", "G6 X#1\n"), (Features{"parameters"}));
  EXPECT_EQ(features_of("rs274", "#1=2 (#)\n"), (Features{"parameters"}));
  EXPECT_EQ(features_of("rs274", "G0 X[1+2]\n"), (Features{"parameters"}));
  EXPECT_EQ(features_of("rs274", "N1 O100 sub\nO100 endsub\n"), (Features{"o-words"}));
  EXPECT_EQ(features_of("rs274", "o<part> call\n"), (Features{"o-words"}));
  EXPECT_EQ(features_of("rs274", "N1 O0007 (part #1)\nG0 X1 (; [)\n"), (Features{"basic"}));
}

// NGC-COM-04: what looks like G3 is G33.1.
TEST(ProgramFeatures, BlanksInACodeChangeNothing) {
  EXPECT_EQ(features_of("rs274", "G3  3.1 Z-5 K1\n"), (Features{"g33.1"}));
  EXPECT_EQ(features_of("rs274", "G 8 1 X 1 0 Z - 1 R2\n"), (Features{"g81"}));
}

TEST(ProgramFeatures, ARotaryAxisIsOne) {
  EXPECT_EQ(features_of("rs274", "G0 A5\n"), (Features{"rotary"}));
  EXPECT_EQ(features_of("rs274", "G92 C5\n"), (Features{"offsets", "rotary"}));
  EXPECT_TRUE(features_of("rs274", "G81 X1 Z-1 R1 A5\n").contains("rotary"));
}

TEST(ProgramFeatures, WhatOnlyLinuxcncHasIsOne) {
  const Features own = {"linuxcnc"};
  for (const char* program : {"G97\n", "G61.1\n", "G8\n", "G64 P0.1\n", "G64 Q0.1 P0.1 G0 X1\n",
                              "M50 P1\n", "M66 P0 L0\n", "M67 E0 Q1\n", "M61 Q1\n", "M70\n",
                              "G0 X1 ; here\n", "(a) (Abort, stop)\n"}) {
    EXPECT_EQ(features_of("rs274", program), own) << program;
  }
  for (const char* program : {"G61\n", "G64\n", "M60\n", "M48\n", "(abort)\n", "(print, x)\n"}) {
    EXPECT_EQ(features_of("rs274", program), Features{"basic"}) << program;
  }
  EXPECT_EQ(features_of("gsk988ta", "G0 X1 ; here\n"), Features{"basic"});
}

std::vector<std::string> of_case(const char* dialect, const char* program,
                                 const std::vector<std::string>& stated) {
  return features_of_case(
      {std::get<reference::Profile>(reference::default_profile(dialect)), program}, stated);
}

// A group states what most of its cases need.
TEST(ProgramFeatures, ACaseHasThoseOfItsGroupThatItNeeds) {
  using List = std::vector<std::string>;
  EXPECT_EQ(of_case("gsk988ta", "G00 X10\nG04 P1\n", {"basic", "g94"}), List{"basic"});
  EXPECT_EQ(of_case("gsk988ta", "G00 C90\n", {"g94"}), List{"basic"});
  EXPECT_EQ(of_case("gsk988ta", "G94 X1 Z1 F1\n", {"g94", "g90", "arc"}), List{"g94"});
  // What no code shows stays, and what any program may have is added.
  EXPECT_EQ(of_case("rs274", "G0 A1\n", {"basic", "arc", "lines", "m"}),
            (List{"basic", "lines", "m", "rotary"}));
  EXPECT_EQ(of_case("rs274", "G90.1 G97\n", {"basic"}),
            (List{"basic", "arc-distance", "linuxcnc"}));
  // The words of an arc that nothing in force takes ask for none.
  EXPECT_EQ(of_case("rs274", "G0 X1 R5\n", {"basic"}), List{"basic"});
}

TEST(ProgramFeatures, PIsTurnsInArcsOnly) {
  EXPECT_EQ(features_of("rs274", "G4 P1\n"), (Features{"basic"}));
  EXPECT_EQ(features_of("rs274", "G2 I1 P2\n"), (Features{"arc", "turns"}));
}

// R101 belongs to the cycle, R1 to the calculations.
TEST(ProgramFeatures, AParameterOfACycleNeedsNoExpressions) {
  EXPECT_EQ(features_of("sinumerik802s", "R101=5\nLCYC82\n"), (Features{"lcyc82"}));
  EXPECT_EQ(features_of("sinumerik802s", "R1=5\n"), (Features{"expressions"}));
}

TEST(ProgramFeatures, ThreeAxesOfAnArcAreAHelix) {
  EXPECT_EQ(features_of("rs274", "G2 X1 Y2 Z3 I1\n"), (Features{"arc", "helix"}));
  EXPECT_EQ(features_of("rs274", "G1 X1 Y2 Z3\n"), (Features{"basic"}));
}

TEST(ProgramFeatures, AUseOfACodeMayNeedAFeature) {
  EXPECT_EQ(features_of("rs274", "G81 X1 Z-1 R2\n"), (Features{"g81"}));
  EXPECT_EQ(features_of("rs274", "G81 X1 Z-1 R2\nX2\n"), (Features{"cycle-modal", "g81"}));
  EXPECT_EQ(features_of("rs274", "G81 X1 Z-1 R2\nF100\nG80\nG0 X2\n"), (Features{"g81"}));
  EXPECT_EQ(features_of("rs274", "G91 G81 X1 Z-1 R2\n"), (Features{"cycle-steps", "g81"}));
  EXPECT_EQ(features_of("rs274", "G81 X1 Z-1 R2 L2\n"), (Features{"cycle-steps", "g81"}));
  EXPECT_EQ(features_of("rs274", "G18 G81 Z1 Y-1 R2\n"), (Features{"cycle-planes", "g81"}));
  EXPECT_EQ(features_of("rs274", "G18 G2 X1 I1\n"), (Features{"arc", "planes"}));
  EXPECT_EQ(features_of("rs274", "G18 G76 P1 Z-5 I-1 J1 K2\n"), (Features{"g76"}));
}

TEST(ProgramFeatures, OnlyFeaturesOfTheVocabularyAreNeeded) {
  constexpr const char* kAll =
      "G2 G3 G18 G32 G33 G33.1 G73 G74 G75 G76 G83 G84 G85 G86 G80 G81 G82 G90 G90.1 G92 G94 G110 "
      "G112 G114 G116 G158\nG2 X1 Y1 Z1 "
      "R1 "
      "P1 CR=1 AR=1 AP=1 TURN=1 A1 RPL=1\nCIP CT LCYC82\nLCYC75\n";
  for (const char* dialect : {"gsk988ta", "hnc21t", "rs274", "sinumerik802s"}) {
    for (const std::string& feature : features_of(dialect, kAll)) {
      const auto known = oracle::feature_vocabulary();
      EXPECT_TRUE(std::ranges::any_of(known,
                                      [&](const oracle::Feature& entry) {
                                        return entry.dialect == dialect && entry.name == feature;
                                      }))
          << dialect << " " << feature;
    }
  }
}

}  // namespace
}  // namespace gonogo::program
