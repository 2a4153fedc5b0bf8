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

TEST(RunOutReadings, AloneAndAmongOthersARunOutIntoTheMaterialIsUndecided) {
  for (const char* k : {"30", "5"}) {
    EXPECT_EQ(judged_under(bore(k), "tangent", "tangent"), Decision::undecided) << k;
    EXPECT_EQ(judged_under(bore(k), "tangent", "any"), Decision::undecided) << k;
    EXPECT_EQ(judged_under(bore(k), "polar", "any"), Decision::go) << k;
    // None of the readings that are left leads there.
    EXPECT_EQ(judged_under(bore(k), "tangent", "polar"), Decision::no_go) << k;
    EXPECT_EQ(judged_under(bore(k), "polar", "tangent"), Decision::no_go) << k;
  }
}

}  // namespace
}  // namespace gonogo::oracle
