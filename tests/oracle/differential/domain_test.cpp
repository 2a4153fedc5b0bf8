// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/differential/domain.hpp"

#include <gtest/gtest.h>

#include "fuzz/generate/generator.hpp"

namespace gonogo::oracle {
namespace {

std::string outside(std::string_view dialect, std::string_view program) {
  const auto profile = std::get<reference::Profile>(reference::default_profile(dialect));
  return std::string(outside_domain(profile, program));
}

std::string outside_840d(std::string_view program) {
  return outside("sinumerik840d", program);
}

// D-DOM-01
TEST(Domain, NineDigitsBeforeThePointAndSevenBehindAreShort) {
  EXPECT_TRUE(has_short_numbers(""));
  EXPECT_TRUE(has_short_numbers("G1 X-123456789.1234567 Y.5 Z5."));
  EXPECT_TRUE(has_short_numbers("N0000000000000000000010 X1.00000000000000000000\n"));
  EXPECT_FALSE(has_short_numbers("X1234567890"));
  EXPECT_FALSE(has_short_numbers("X1 Y=AC(20.00000000000000000001)"));
  EXPECT_FALSE(has_short_numbers("X.00000001"));
  EXPECT_FALSE(has_short_numbers("X1..00000001"));
  EXPECT_EQ(outside_840d("G0 X0.00000001"), "D-DOM-01");
}

// D-DOM-02: also of an inch, of a rotary axis, and in a block before an alarm.
TEST(Domain, ReachesTenMetres) {
  EXPECT_EQ(outside_840d("G0 X-10000 A10000"), "");
  EXPECT_EQ(outside_840d("G0 X-10000.001"), "D-DOM-02");
  EXPECT_EQ(outside_840d("G70 G0 Y393.701"), "D-DOM-02");
  EXPECT_EQ(outside_840d("G0 A10000.001"), "D-DOM-02");
  EXPECT_EQ(outside_840d("G0 X10001\nG2 X3"), "D-DOM-02");
  EXPECT_EQ(outside_840d("G2 X10001"), "");  // an alarm, and nothing moves
}

// D-DOM-02: an external thread begins at E/2 + D, 9,985 + 15 mm from its centre, and ends on its
// bottom.
TEST(Domain, ReachesTenMetresWithCirclesToo) {
  EXPECT_EQ(outside("gsk988ta", "G17 G114 X0 Y0 Z-9 I3 E19970 P2 D15 F100 J1 K90"), "");
  EXPECT_EQ(outside("gsk988ta", "G17 G114 X0 Y0 Z-9 I3 E19970 P2 D15.001 F100 J1 K90"), "D-DOM-02");
  EXPECT_EQ(outside("gsk988ta", "G17 G114 X0 Y0 Z-10000 I3 E30 P2 D3 F100 J1 K90"), "");
  EXPECT_EQ(outside("gsk988ta", "G17 G114 X0 Y0 Z-10000.001 I3 E30 P2 D3 F100 J1 K90"), "D-DOM-02");
  EXPECT_EQ(outside("gsk988ta", "G17 G110 X0 Y9900 Z-9 R0 I105 D5 L4 Q9 F100"), "");
  EXPECT_EQ(outside("gsk988ta", "G17 G110 X0 Y9900 Z-9 R0 I105.001 D5 L4 Q9 F100"), "D-DOM-02");
}

// D-DOM-03: 400 mm are 0.00229 degrees of a circle of 10 km.
TEST(Domain, HasCirclesOfTenKilometres) {
  EXPECT_EQ(outside_840d("G3 X400 AR=0.0023 F100"), "");
  EXPECT_EQ(outside_840d("G3 X400 AR=0.0022 F100"), "D-DOM-03");
  // A rise of 1 over 400 mm has a radius of 20 m, one of 0.001 mm one of 20 km.
  EXPECT_EQ(outside_840d("CIP X400 I1=200 J1=1 F100"), "");
  EXPECT_EQ(outside_840d("CIP X400 I1=200 J1=0.001 F100"), "D-DOM-03");
  EXPECT_EQ(outside_840d("CIP X400 I1=200 F100"), "");  // a line
}

// D-DOM-04: 0.001 mm times the sine of 0.01 and of 0.1 degrees is 1.7e-7 and 1.7e-6 mm.
TEST(Domain, HasNoWaysThatAreAllButNone) {
  EXPECT_EQ(outside_840d("G0 AP=359.99 RP=0.001"), "D-DOM-04");
  EXPECT_EQ(outside_840d("G0 AP=359.9 RP=0.001"), "");
  EXPECT_EQ(outside_840d("G0 X1\nX=IC(0)\nX=1"), "");
  // Reckoned twice, and the same: no bits tell the two apart.
  EXPECT_EQ(outside("sinumerik802s", "G0 X1 Y2\nG259 RPL=20\nG259 RPL=-20\nG0 X1 Y2"), "");
  EXPECT_EQ(outside_840d("CIP X4 I1=2 J1=1 K1=0.0000009 F100"), "D-DOM-04");
}

// D-DOM-05
TEST(Domain, HasNoFlatterArcsThanAThousandthOfADegree) {
  EXPECT_EQ(outside_840d("G3 X10 AR=0.001 F100"), "");
  EXPECT_EQ(outside_840d("G3 I10 F100"), "");  // a full circle
  EXPECT_EQ(outside("rs274", "F100\nG2 X0.001 R100\nM2"), "D-DOM-05");
}

// D-DOM-06
TEST(Domain, HasHelicesOfAHundredThousandTurns) {
  EXPECT_EQ(outside("gsk988ta", "G17 G112 X0 Y0 Z-5 I5 D2 L99999 F100"), "");
  EXPECT_EQ(outside("gsk988ta", "G17 G114 X0 Y0 Z-101 I0.001 E30 P2 D3 F100 J1 K90"), "D-DOM-06");
  EXPECT_EQ(outside("gsk988ta", "G17 G114 X0 Y0 Z-99 I0.001 E30 P2 D3 F100 J1 K90"), "");
}

std::string outside_with_pocket(const std::string& sides) {
  auto profile = std::get<reference::Profile>(reference::default_profile("sinumerik802s"));
  profile.tools["1"].radius = 3;
  return std::string(
      outside_domain(profile,
                     "T1 S300 M3\nR101=5 R102=1 R103=0 R104=-5 R116=0 R117=0 R120=3 R121=5\n"
                     "R122=50 R123=100 R124=0 R125=0 R126=2 R127=1\n" +
                         sides + "\nLCYC75\n"));
}

// D-DOM-07: the tool is 6 mm wide.
TEST(Domain, HasNoPocketsHardlyWiderThanTheTool) {
  EXPECT_EQ(outside_with_pocket("R118=6 R119=6"), "");
  EXPECT_EQ(outside_with_pocket("R118=6.003 R119=9"), "");
  EXPECT_EQ(outside_with_pocket("R118=6.004 R119=9"), "D-DOM-07");
  EXPECT_EQ(outside_with_pocket("R118=9 R119=6.019"), "D-DOM-07");
  EXPECT_EQ(outside_with_pocket("R118=6.02 R119=6.02"), "");
}

// D-DOM-08: four increments of 0.001 and of 0.0001 mm.
TEST(Domain, HasCirclesOfFourIncrementsToGoRound) {
  EXPECT_EQ(outside_840d("G2 I0.004 F100"), "");
  EXPECT_EQ(outside_840d("G2 I0.003 F100"), "D-DOM-08");
  EXPECT_EQ(outside_840d("G2 X0.004 I0.002 TURN=1 F100"), "D-DOM-08");
  EXPECT_EQ(outside_840d("G2 X0.004 I0.002 F100"), "");  // half a turn
  EXPECT_EQ(outside("rs274", "F100\nG2 I0.0004\nM2"), "");
  EXPECT_EQ(outside("rs274", "F100\nG2 I0.0003\nM2"), "D-DOM-08");
}

// D-DOM-10: the tool stands 1.7e-8 mm below the X axis, so that the chord to X20 is longer than 10 by 1.5e-17.
TEST(Domain, LeavesOutWhatMissesALimitByATrace) {
  const std::string beside = "G0 X133 Y44.48\nG0 AP=359.999 RP=0.001\nG0 X10\n";
  EXPECT_EQ(outside_840d(beside + "G2 X20 Y0 CR=5 F100"), "D-DOM-10");
  EXPECT_EQ(outside_840d(beside + "G2 X20 Y3 CR=5 F100"), "");  // too long by 0.44
  EXPECT_EQ(outside_840d("G0 X10\nG2 X20 Y0 CR=5 F100"), "");  // on the limit
  EXPECT_EQ(outside_840d("G0 X10\nG2 X20 Y0 CR=4.9995 F100"), "");
  EXPECT_EQ(outside_840d("G0 X10\nG2 X20 Y0 CR=4.9996 F100"), "D-DOM-10");
  // The chord of (3, 4) is 5; that of (3, 4.0005) is longer by 0.0004.
  EXPECT_EQ(outside("rs274", "F100\nG2 X3 Y4 R2.5\nM2"), "");
  EXPECT_EQ(outside("rs274", "F100\nG2 X3 Y4.0001 R2.5\nM2"), "D-DOM-10");
  EXPECT_EQ(outside("rs274", "F100\nG2 X3 Y4.0005 R2.5\nM2"), "");
}

// D-DOM-10: radii of 5 and 5.01 differ by the tolerance of the 840D, by CIRCLE_ERROR_CONST = 0.01; a taper of
// the GSK is as steep as its travel; L of G110 is twice D.
TEST(Domain, HoldsEveryLimitInOneWay) {
  EXPECT_EQ(outside_840d("G2 X10.01 I5 F100"), "");
  EXPECT_EQ(outside_840d("G2 X10.0101 I5 F100"), "D-DOM-10");
  EXPECT_EQ(outside_840d("G2 X10.0095 I5 F100"), "D-DOM-10");
  const auto taper = [](const std::string& r) {
    return outside("gsk988ta", "G00 X50 Z5 M3\nG94 X30 Z-5 R" + r + " F100");
  };
  EXPECT_EQ(taper("10"), "");
  EXPECT_EQ(taper("10.0005"), "D-DOM-10");
  EXPECT_EQ(taper("10.001"), "");
  // An angle is above 0 and below 360.
  EXPECT_EQ(outside_840d("G3 X10 AR=0.0009 F100"), "D-DOM-10");
  EXPECT_EQ(outside_840d("G3 X10 AR=359.9991 F100"), "D-DOM-10");
  EXPECT_EQ(outside("gsk988ta", "G17 G110 X0 Y0 Z-9 R0 I10 D2 L3.9995 Q9 F100"), "D-DOM-10");
}

// D-DOM-09
TEST(Domain, LeavesOutWhatCannotBeDecided) {
  const auto profile = std::get<reference::Profile>(reference::default_profile("rs274"));
  oracle::Verdict verdict = oracle::gap_verdict(oracle::GapReason::comparison, "It is too close.");
  EXPECT_EQ(outside_domain(profile, "M2", verdict), "D-DOM-09");
  verdict = oracle::gap_verdict(oracle::GapReason::not_covered, "The gauge does not read G55.");
  EXPECT_EQ(outside_domain(profile, "M2", verdict), "");
  verdict = {};
  verdict.kind = oracle::VerdictKind::fail_geometry;
  EXPECT_EQ(outside_domain(profile, "M2", verdict), "");
  EXPECT_EQ(outside_domain(profile, "F1 G1 X10001\nM2", verdict), "D-DOM-02");
}

// Generators draw lengths at limits on purpose: those within an increment are more.
TEST(Domain, HoldsAllButOneInAHundredOfTheProgramsThatAreGenerated) {
  constexpr std::uint64_t kPrograms = 1'000;
  for (const generate::Generator& generator : generate::generators()) {
    std::size_t outside = 0;
    std::size_t near_limit = 0;
    for (std::uint64_t seed = 1; seed <= kPrograms; ++seed) {
      generate::Choices choices(seed);
      const generate::GeneratedProgram program = generator.generate(choices, nullptr);
      const std::string_view rule = outside_domain(program.profile, program.text);
      if (rule == "D-DOM-10") ++near_limit;
      if (!rule.empty() && rule != "D-DOM-10") ++outside;
    }
    EXPECT_LT(outside, kPrograms / 100) << generator.dialect;
    EXPECT_LT(near_limit, kPrograms * 6 / 100) << generator.dialect;
  }
}

}  // namespace
}  // namespace gonogo::oracle
