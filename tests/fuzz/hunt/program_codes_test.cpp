// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/program_codes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "oracle/features.hpp"

namespace gonogo::fuzz {
namespace {

using Codes = std::vector<std::string>;
using Features = std::set<std::string>;

TEST(ProgramCodes, ACodeStaysInForceUntilTheNextOfItsKind) {
  const auto lines = lines_of("G00 X1\nG94 X2 Z3\nX4\nG99 F1\nG01 Z5\n");
  EXPECT_EQ(codes_in_force("gsk988ta", lines), (Codes{"G0", "G94", "G94", "G94", "G1"}));
}

TEST(ProgramCodes, TheSameCodeIsAnotherThingInAnotherDialect) {
  const auto lines = lines_of("G90 X1\n");
  EXPECT_EQ(codes_in_force("gsk988ta", lines), (Codes{"G90"}));
  EXPECT_EQ(codes_in_force("hnc21t", lines), (Codes{""}));
}

TEST(ProgramCodes, ACycleNeedsItsFeature) {
  EXPECT_EQ(features_needed("gsk988ta", lines_of("G0 X1\nG111 X2\n")), (Features{"basic", "g110"}));
  EXPECT_EQ(features_needed("sinumerik802s", lines_of("LCYC75\n")), (Features{"basic", "lcyc75"}));
}

TEST(ProgramCodes, AWordMayNeedAFeature) {
  EXPECT_EQ(features_needed("sinumerik840d", lines_of("G2 X1 CR=5\n")),
            (Features{"arc", "basic", "cr"}));
}

TEST(ProgramCodes, PIsTurnsInArcsOnly) {
  EXPECT_EQ(features_needed("rs274", lines_of("G4 P1\n")), (Features{"basic"}));
  EXPECT_EQ(features_needed("rs274", lines_of("G2 I1 P2\n")), (Features{"arc", "basic", "turns"}));
}

TEST(ProgramCodes, OnlyFeaturesOfTheVocabularyAreNeeded) {
  constexpr const char* kAll =
      "G2 G3 G18 G32 G74 G75 G80 G81 G82 G90 G90.1 G92 G94 G110 G112 G114 G116 G158\nG2 X1 Y1 Z1 "
      "R1 "
      "P1 CR=1 AR=1 AP=1 TURN=1 A1 RPL=1\nCIP CT LCYC82\nLCYC75\n";
  for (const char* dialect : {"gsk988ta", "hnc21t", "rs274", "sinumerik802s"}) {
    for (const std::string& feature : features_needed(dialect, lines_of(kAll))) {
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
}  // namespace gonogo::fuzz
