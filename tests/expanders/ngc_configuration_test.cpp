// SPDX-License-Identifier: GPL-3.0-or-later
// Profiles of the expander of rs274.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

int create_ngc(const char* profile) {
  return Session(profile, {}, "ngc").outcome().create;
}

TEST(NgcConfiguration, ThePowerOnState) {
  EXPECT_EQ(run_ngc("X1\n", R"({"initial":{"motion":"G00"}})").motions(), "rapid x=1\n");
  EXPECT_EQ(run_ngc("X1\n", R"({"initial":{"motion":"G01","f":"50"}})").motions(),
            "feed x=1 f=50\n");
  EXPECT_EQ(run_ngc("G91 G0 Y1 A1\n", R"({"initial":{"x":"7","y":"2.5","a":"-3"}})").all(),
            "answer 0\n1 rapid y=3.5 a=-2\n1 end x=7 y=3.5 z=0 a=-2 c=0\n");
  EXPECT_EQ(run_ngc("G2 Y2 J1 F1\n", R"({"initial":{"plane":"G19"}})").motions(),
            "arc19 c=1,0 rot=-1 y=2 z=0 f=1\n");
  EXPECT_EQ(run_ngc("G0 X1\n", R"({"units":"inch"})").motions(), "rapid x=25.4\n");
}

TEST(NgcConfiguration, DefaultsWrittenOutAreAccepted) {
  EXPECT_EQ(create_ngc(R"({"dialect":"rs274","units":"mm","increment":"ISB","resolution":"0.0001",
      "x_diameter":false,"initial":{"x":"0","y":"0","z":"0","a":"0","c":"0","f":"0","plane":"G17",
      "motion":"none","spindle":"0"},"offsets":{},"tools":{},"parameters":{},"readings":
      {"ngc.arc-tolerance":"any","ngc.full-circle-words":"free",
      "ngc.whole":"exact"},"alarm_timing":"block",
      "block_skip":false})"),
            GONOGO_OK);
}

TEST(NgcConfiguration, WhatIsNotImplementedIsRefused) {
  for (const char* profile :
       {R"({"x_diameter":true})", R"({"offsets":{"G54":{"x":"1"}}})",
        R"({"initial":{"motion":"G02"}})", R"({"readings":{"ngc.arc-tolerance":"other"}})",
        R"({"readings":{"ngc.whole":"other"}})", R"({"readings":{"hnc.g75.i":"I"}})",
        R"({"alarm_timing":"program"})", R"({"unknown":1})", R"({"initial":{"f":"-1"}})"}) {
    EXPECT_EQ(create_ngc(profile), GONOGO_UNSUPPORTED) << profile;
  }
}

}  // namespace
}  // namespace gonogo::expanders::testing
