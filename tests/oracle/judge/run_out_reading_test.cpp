// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-THR-05: a run-out that leads into the material by itself, named alone or among others.
#include <gtest/gtest.h>

#include "tests/oracle/judge/own_outcome.hpp"

namespace gonogo::oracle {
namespace {

// The verdict on what is shown of a program under one value of the reading, judged under another.
Decision judged_under(const std::string& program, std::string_view shown, std::string_view read) {
  const auto profile = [](std::string_view value) {
    return profile_of("gsk988ta", {{"gsk.thread.runout", value}});
  };
  const OwnOutcome own = own_outcome(program, profile(shown));
  const reference::Profile judging = profile(read);
  return decision(
      judge_outcome(judging, program, exact_terms(judging), own.records, own.end).verdict.kind);
}

// Passes at 5 and 5.5 in a bore, J 2 along the tangent: K 30 leads inward by 2 sin 30 = 1 only,
// outside of rho_0 = 4.5; K 5 through the wall, where a chord of 2 needs 2 / (2 * 5) = sin 11.5.
std::string bore(const char* k) {
  return std::string("G0 X70 Z70 Y30\nG18\nG116 X70 Z70 V-20 R-5 I5 J2 K") + k +
         " E15 P1 Q0.5 D3 F900\nG0 X80\n";
}

TEST(RunOutReadings, ARunOutIntoTheMaterialIsUndecidedWhereItsReadingIsStated) {
  for (const char* k : {"30", "5"}) {
    EXPECT_EQ(judged_under(bore(k), "tangent", "tangent"), Decision::undecided) << k;
    // The polar one keeps off (GSK-G114-10).
    EXPECT_EQ(judged_under(bore(k), "tangent", "any"), Decision::no_go) << k;
    EXPECT_EQ(judged_under(bore(k), "polar", "any"), Decision::go) << k;
    // None of the readings that are left leads there.
    EXPECT_EQ(judged_under(bore(k), "tangent", "polar"), Decision::no_go) << k;
    EXPECT_EQ(judged_under(bore(k), "polar", "tangent"), Decision::no_go) << k;
  }
}

// Straight along the normal with K 180: 6 mm into the wall of a bore, 3 mm into a bolt. The polar
// run-outs end at 8.5 - 6 and 11.5 + 3 from the axis.
TEST(RunOutReadings, ARunOutIntoTheMaterialIsNoGoWhereAnotherKeepsOff) {
  for (const char* words : {"G116 X0 Y0 W-1 R-1 I1 E20 J6 K180 P0.5 D2 F100\n",
                            "G114 X0 Y0 W-1 R-1 I1 E20 J3 K180 P0.5 D2 F100\n"}) {
    const std::string program = std::string("G17 G00 X0 Y0 Z3\n") + words;
    EXPECT_EQ(judged_under(program, "radial", "radial"), Decision::undecided) << words;
    EXPECT_EQ(judged_under(program, "radial", "any"), Decision::no_go) << words;
    EXPECT_EQ(judged_under(program, "polar", "any"), Decision::go) << words;
  }
}

// With J 60 in a bore of rho_0 = 27 and a pass at 28 every run-out is in the far wall.
TEST(RunOutReadings, WhereNoneKeepsOffTheMaterialItIsUndecided) {
  const std::string program = "G17 G00 X0 Y0 Z3\nG116 X0 Y0 W-1 R-1 I1 E60 J60 K0 P1 D3 F100\n";
  for (const char* shown : {"polar", "radial"}) {
    EXPECT_EQ(judged_under(program, shown, "any"), Decision::undecided) << shown;
  }
}

// The reading that leads into the wall leads 6 mm along p, not 4.
TEST(RunOutReadings, ARunOutThatStopsShortOfItsReadingIsNoGo) {
  const std::string program = "G17 G00 X0 Y0 Z3\nG116 X0 Y0 W-1 R-1 I1 E20 J6 K180 P0.5 D2 F100\n";
  const reference::Profile profile = profile_of("gsk988ta", {{"gsk.thread.runout", "radial"}});
  OwnOutcome own = own_outcome(program, profile);
  int changed = 0;
  for (Record& record : own.records) {
    if (record.kind != RecordKind::feed || record.to[Axis::x] != Number(29) / 2) continue;
    record.to[Axis::x] = Number(25) / 2;
    ++changed;
  }
  EXPECT_EQ(changed, 1);
  const Verdict verdict =
      judge_outcome(profile, program, exact_terms(profile), own.records, own.end).verdict;
  EXPECT_EQ(decision(verdict.kind), Decision::no_go) << verdict.message;
}

}  // namespace
}  // namespace gonogo::oracle
