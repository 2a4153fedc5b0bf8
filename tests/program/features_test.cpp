// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/features.hpp"

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
  EXPECT_EQ(features_of("gsk988ta", "G0 X1\nG111 X2\n"), (Features{"basic", "g110"}));
  EXPECT_EQ(features_of("sinumerik802s", "LCYC75\n"), (Features{"basic", "lcyc75"}));
}

TEST(ProgramFeatures, AWordMayNeedAFeature) {
  EXPECT_EQ(features_of("sinumerik840d", "G2 X1 CR=5\n"), (Features{"arc", "basic", "cr"}));
}

// They stand for no code. A lone O is a program's name (NGC-COM-06).
TEST(ProgramFeatures, ParametersAndOWordsAreNeededWhereverTheyStand) {
  EXPECT_EQ(features_of("rs274", "G6 X#1\n"), (Features{"basic", "parameters"}));
  EXPECT_EQ(features_of("rs274", "#1=2 (#)\n"), (Features{"basic", "parameters"}));
  EXPECT_EQ(features_of("rs274", "G0 X[1+2]\n"), (Features{"basic", "parameters"}));
  EXPECT_EQ(features_of("rs274", "N1 O100 sub\nO100 endsub\n"), (Features{"basic", "o-words"}));
  EXPECT_EQ(features_of("rs274", "o<part> call\n"), (Features{"basic", "o-words"}));
  EXPECT_EQ(features_of("rs274", "N1 O0007 (part #1)\nG0 X1 ; [\n"), (Features{"basic"}));
}

// NGC-COM-04: what looks like G3 is G33.1.
TEST(ProgramFeatures, BlanksInACodeChangeNothing) {
  EXPECT_EQ(features_of("rs274", "G3  3.1 Z-5 K1\n"), (Features{"basic", "g33.1"}));
  EXPECT_EQ(features_of("rs274", "G 8 1 X 1 0 Z - 1 R2\n"), (Features{"basic", "g81"}));
}

TEST(ProgramFeatures, PIsTurnsInArcsOnly) {
  EXPECT_EQ(features_of("rs274", "G4 P1\n"), (Features{"basic"}));
  EXPECT_EQ(features_of("rs274", "G2 I1 P2\n"), (Features{"arc", "basic", "turns"}));
}

// R101 belongs to the cycle, R1 to the calculations.
TEST(ProgramFeatures, AParameterOfACycleNeedsNoExpressions) {
  EXPECT_EQ(features_of("sinumerik802s", "R101=5\nLCYC82\n"), (Features{"basic", "lcyc82"}));
  EXPECT_EQ(features_of("sinumerik802s", "R1=5\n"), (Features{"basic", "expressions"}));
}

TEST(ProgramFeatures, ThreeAxesOfAnArcAreAHelix) {
  EXPECT_EQ(features_of("rs274", "G2 X1 Y2 Z3 I1\n"), (Features{"arc", "basic", "helix"}));
  EXPECT_EQ(features_of("rs274", "G1 X1 Y2 Z3\n"), (Features{"basic"}));
}

TEST(ProgramFeatures, AUseOfACodeMayNeedAFeature) {
  EXPECT_EQ(features_of("rs274", "G81 X1 Z-1 R2\n"), (Features{"basic", "g81"}));
  EXPECT_EQ(features_of("rs274", "G81 X1 Z-1 R2\nX2\n"), (Features{"basic", "cycle-modal", "g81"}));
  EXPECT_EQ(features_of("rs274", "G81 X1 Z-1 R2\nF100\nG80\nG0 X2\n"), (Features{"basic", "g81"}));
  EXPECT_EQ(features_of("rs274", "G91 G81 X1 Z-1 R2\n"), (Features{"basic", "cycle-steps", "g81"}));
  EXPECT_EQ(features_of("rs274", "G81 X1 Z-1 R2 L2\n"), (Features{"basic", "cycle-steps", "g81"}));
  EXPECT_EQ(features_of("rs274", "G18 G81 Z1 Y-1 R2\n"),
            (Features{"basic", "cycle-planes", "g81"}));
  EXPECT_EQ(features_of("rs274", "G18 G2 X1 I1\n"), (Features{"arc", "basic", "planes"}));
  EXPECT_EQ(features_of("rs274", "G18 G76 P1 Z-5 I-1 J1 K2\n"), (Features{"basic", "g76"}));
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
