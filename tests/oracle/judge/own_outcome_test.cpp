// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reference's own outcome, judged as a subject's, is a pass-exact (of an open path,
// pass-properties): from a micrometre to a kilometre, for any form of arc.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <rapidcheck.h>

#include "own_outcome.hpp"
#include "tests/fixed_seed.hpp"

namespace gonogo::oracle {
namespace {

const bool kSeeded = fix_seed("100");

// u = (0, 0.001, -0.001) and v = (0, 0.002, 0): half a circle of radius 0.001, which nothing tells
// from its chord.
TEST(OwnOutcome, ACircleInSpaceAsSmallAsTheToleranceIsExact) {
  const Verdict verdict = judge_own("F100\nG1 X-50 Z5.288\nCIP Y0.002 J1=0.001 K1=5.287\n",
                                    profile_of("sinumerik840d"));
  EXPECT_EQ(verdict.kind, VerdictKind::pass_exact) << verdict.message;
}

TEST(OwnOutcome, ASmallCircleInSpaceOutOfThePlanesIsExact) {
  const Verdict verdict =
      judge_own("F100\nCIP X0.002 Y0.002 I1=0 J1=0.002 K1=0.001\n", profile_of("sinumerik840d"));
  EXPECT_EQ(verdict.kind, VerdictKind::pass_exact) << verdict.message;
}

// Start, end and pole on one ray: the radius grows over a full turn.
TEST(OwnOutcome, ATurnFromRadiusToRadiusOnOneRayIsExact) {
  const Verdict verdict =
      judge_own("G110 X20 Y20\nG1 AP=-359 RP=1 F100\nG3 AP=-359 RP=1.005\n",
                profile_of("sinumerik840d", {{"sie.arc.correct", "programmed"}}));
  EXPECT_EQ(verdict.kind, VerdictKind::pass_exact) << verdict.message;
}

// The ways from poles beside places that are only enclosed are exact: found by generated programs.
TEST(OwnOutcome, FromAPoleBesideAnEnclosedPlaceIsExact) {
  for (const char* program :
       {"F267\nG19 G3 J-12.001 AR=57.599\nG110 Y-11 Z11\nG1 AP=315 RP=15.001\n"
        "G2 Y=IC(0) Z=IC(-11.589) CR=-15.037\n",
        "F200\nG111\nG1 AP=342.167 RP=14.301\nG110 X-4 Y6\nG1 AP=0 RP=4.001\nG3 Y69 Z108\n"}) {
    const Verdict verdict = judge_own(program, profile_of("sinumerik840d"));
    EXPECT_EQ(verdict.kind, VerdictKind::pass_exact) << program << verdict.message;
  }
}

// Lengths of a program, all of one size. In micrometres: 1 to 1e9.
class Lengths {
 public:
  Lengths() : size_(*rc::gen::element<std::int64_t>(2, 10, 1000, 100'000, 1'000'000'000)) {}
  std::string next() const { return text(*rc::gen::inRange<std::int64_t>(-size_, size_ + 1)); }
  std::string above_zero() const { return text(*rc::gen::inRange<std::int64_t>(1, 2 * size_)); }

 private:
  static std::string text(std::int64_t micrometres) {
    return fmt::format("{}{}.{:03}", micrometres < 0 ? "-" : "", std::abs(micrometres) / 1000,
                       std::abs(micrometres) % 1000);
  }
  std::int64_t size_;
};

std::string degrees(int most) {
  const int thousandths = *rc::gen::inRange(1, most * 1000);
  return *rc::gen::arbitrary<bool>()
             ? fmt::format("{}", 1 + thousandths / 1000)
             : fmt::format("{}.{:03}", thousandths / 1000, thousandths % 1000);
}

std::string any_motion_block(const Lengths& at) {
  const std::string sense = *rc::gen::element<std::string>("G2", "G3");
  const std::string end = fmt::format("X{} Y{}", at.next(), at.next());
  switch (*rc::gen::inRange(0, 8)) {
    case 0:
      return fmt::format("G1 {} Z{}", end, at.next());
    case 1:
      return fmt::format("CIP {} Z{} I1={} J1={} K1={}", end, at.next(), at.next(), at.next(),
                         at.next());
    case 2:
      return "CT " + end;
    case 3:
      return fmt::format("{} {} AR={}", sense, end, degrees(359));
    case 4:
      return fmt::format("{} I{} J{} AR={} Z{}", sense, at.next(), at.next(), degrees(359),
                         at.next());
    case 5:
      return fmt::format("{} {} CR={}{}", sense, end, *rc::gen::element<std::string>("", "-"),
                         at.above_zero());
    case 6:
      return fmt::format("G{} {}\nG1 AP={} RP={}", *rc::gen::inRange(110, 113), end, degrees(360),
                         at.above_zero());
    default:
      return fmt::format("G1 AP={} RP={}\n{} AP={} Z{} TURN={}", degrees(360), at.above_zero(),
                         sense, degrees(360), at.next(), *rc::gen::inRange(0, 4));
  }
}

// A pocket as deep as the tolerance: the way out of it is no motion, and the next one comes behind
// G50. Found by generated program 30,192,820.
TEST(OwnOutcome, APocketAsDeepAsTheToleranceIsLeftBeforeTheNextBlock) {
  EXPECT_EQ(
      judge_own("G00 X29.308 Y66 Z9 F416\nG110 Z58.999 X60 V-0.001 I3.003 L2.654 Q0.001 D3.002\n"
                "G50 X18\nG00 X20 Z10\n",
                profile_of("gsk988ta"))
          .kind,
      VerdictKind::pass_properties);
}

// A slot that the tool fills except for a micrometre: at each level four quarters of a circle of
// that radius, each too small to see, between infeeds along one line. Found by generated programs.
// R1.
TEST(OwnOutcome, CirclesAsSmallAsTheToleranceMayStandBetweenInfeeds) {
  reference::Profile profile =
      profile_of("sinumerik802s", {{"sie.pocket.path", "contour-parallel"}});
  profile.tools["1"].radius = 3;
  const Verdict verdict = judge_own(
      "F254 S600 M3 G0 X0 Y0 Z23\nT1 D1\nR101=10 R102=2.5 R103=7.5 R104=1.6 R116=19 R117=10\n"
      "R118=6.002 R119=6.002 R120=3.001 R121=3.475 R122=105 R123=214 R124=0 R125=0.1 R126=2 "
      "R127=1\n"
      "LCYC75\n",
      profile);
  EXPECT_EQ(verdict.kind, VerdictKind::pass_exact) << verdict.message << verdict.got;
}

TEST(OwnOutcome, OfRandomProgramsIsExact) {
  const reference::Profile profile = profile_of("sinumerik840d");
  EXPECT_TRUE(rc::check([&] {
    const Lengths lengths;
    std::string program = "G17 G90 F100\nG1 AP=20 RP=" + lengths.above_zero() + "\n";
    const int motions = *rc::gen::inRange(1, 6);
    for (int i = 0; i < motions; ++i) program += any_motion_block(lengths) + "\n";
    for (const char* resolution : {"0.001", "0.000001"}) {
      Verdict verdict;
      try {
        verdict = judge_own(program, profile, resolution);
      } catch (const exact::Undecided&) {
        RC_DISCARD("the reference itself cannot tell");
      }
      if (verdict.kind == VerdictKind::pass_exact) continue;
      RC_FAIL(fmt::format("{} {}: {}\n{}want {}\ngot {}", resolution, name(verdict.kind),
                          verdict.message, program, verdict.want, verdict.got));
    }
  }));
}

}  // namespace
}  // namespace gonogo::oracle
