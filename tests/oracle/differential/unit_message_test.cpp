// SPDX-License-Identifier: GPL-3.0-or-later
//
// Planted faults of units are told as such; each program is short enough to say by hand by how much
// the fault is off.
#include <gtest/gtest.h>

#include "expanders/registry.hpp"
#include "oracle/differential/differential.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::oracle {
namespace {

Verdict verdict_of(std::string_view expander, std::string_view fault, std::string_view dialect,
                   std::string_view program) {
  const auto subject = make_interface_subject(*expanders::find(expander, fault));
  const auto profile = std::get<reference::Profile>(reference::default_profile(dialect));
  subject->configure(profile);
  return run_and_judge(*subject, profile, program, 1'000).value();
}

// F10 under G20 is 254 mm/min; not converted it is 10, 5/127 of that.
TEST(UnitMessage, OfAFeedInInches) {
  for (const auto& [expander, fault, dialect] :
       {std::array{"gsk", "inch-feed", "gsk988ta"}, std::array{"hnc", "inch-feed", "hnc21t"},
        std::array{"ngc", "inch-feed-unscaled", "rs274"}}) {
    const Verdict verdict = verdict_of(expander, fault, dialect, "G20\nG01 X1 F10\nM30\n");
    EXPECT_EQ(verdict.kind, VerdictKind::fail_feed) << expander;
    EXPECT_EQ(
        verdict.message,
        "The feed differs. It is 10 mm/min in place of 254 mm/min. It is 5/127 of what is due: "
        "inches not converted to mm?");
    EXPECT_EQ(decision(verdict_of(expander, "", dialect, "G20\nG01 X1 F10\nM30\n").kind),
              Decision::go);
  }
}

// G20 scales lengths (NGC-UNI-01), and F360 of A alone is 360 degrees a minute; scaled it is 360 *
// 25.4 = 9144.
TEST(UnitMessage, OfAFeedOfARotaryAxis) {
  EXPECT_EQ(verdict_of("ngc", "rotary-feed-scaled", "rs274", "G20\nG1 A90 F360\nM2\n").message,
            "The feed differs. It is 9144 degrees/min in place of 360 degrees/min. It is 127/5 "
            "times what is due: degrees taken for inches?");
}

// G4 P300 of rs274 is 300 s; in ms it is 0.3 s.
TEST(UnitMessage, OfADwell) {
  EXPECT_EQ(verdict_of("ngc", "dwell-in-milliseconds", "rs274", "G4 P300\nM2\n").message,
            "The dwell differs. It is 0.3 s in place of 300. It is a 1000th of what is due: s "
            "taken for ms?");
  EXPECT_EQ(verdict_of("gsk", "dwell-halved", "gsk988ta", "G04 X3\nM30\n").message,
            "The dwell differs. It is 1.5 s in place of 3. It is half what is due: halved as a "
            "diameter is?");
}

}  // namespace
}  // namespace gonogo::oracle
