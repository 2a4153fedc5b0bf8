// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

int create_gsk(const std::string& profile) {
  return Session(profile).outcome().create;
}

TEST(GskConfiguration, DefaultsMayBeWrittenOut) {
  EXPECT_EQ(create_gsk(R"({"dialect":"gsk988ta","units":"mm","increment":"ISB","resolution":"0.001",
    "x_diameter":true,"initial":{"x":"0","y":"0","z":"0","a":"0","c":"0","f":"0","plane":"G18",
    "motion":"G00","spindle":"M5"},"offsets":{},"tools":{},"parameters":{"3410":"0.01",
    "3403.6":"1"},"reference_point":{"x":"0","z":"0"},"alarm_timing":"block","block_skip":false,
    "readings":{"gsk.pocket.path":"any","gsk.pocket.end":"initial","gsk.pocket.p-omitted":"0",
    "gsk.missing-axis":"skip","gsk.zero-depth":"no-cut","gsk.g94.rewrite":"keep",
    "gsk.g94.after-00":"stays","gsk.g94.empty-block":"none","gsk.helix.entry-side":"any",
    "gsk.helix.flat":"off","gsk.helix.L":"per-block","gsk.thread.path":"any",
    "gsk.thread.runout":"any","gsk.thread.v-from":"r-plane","gsk.thread.direction":"alarm",
    "gsk.thread.r":"optional","gsk.thread.k-range":"360","gsk.thread.modal":"code",
    "gsk.pocket.pair":"shared","gsk.pocket.R":"per-block","gsk.x-depth":"diameter",
    "gsk.decimals":"keep","gsk.duplicate":"alarm","gsk.g94.in-mode":"keep",
    "gsk.zero-depth-end":"initial","gsk.dwell-without-word":"alarm","gsk.arc.zero-radius":"alarm",
    "gsk.arc.tolerance-zero":"off","gsk.g50.initial-plane":"shifted",
    "gsk.rotary-feed-inch":"scaled","gsk.retained":"keep","gsk.feed-units":"length",
    "gsk.feed-change":"kept","gsk.g80.motion":"traverse","gsk.arc.no-centre":"alarm",
    "gsk.arc.small-radius":"alarm","gsk.g94.still-axis":"alarm"}})"),
            GONOGO_OK);
}

TEST(GskConfiguration, WhatIsNotImplementedIsNamed) {
  const char* profiles[] = {R"({"colour":"red"})",
                            R"({"units":"furlong"})",
                            R"({"offsets":{"G54":{"x":"1"}}})",
                            R"({"alarm_timing":"program"})",
                            R"({"parameters":{"5922":"30"}})",
                            R"({"parameters":{"5920":"-1"}})",
                            R"({"parameters":{"5920":"360.001"}})",
                            R"({"parameters":{"5921":"-0.001"}})",
                            R"({"initial":{"b":"1"}})",
                            R"({"initial":{"x":"11/3"}})",
                            R"({"initial":{"x":"1e-12"}})",
                            R"({"initial":{"motion":"G94"}})",
                            R"({"x_diameter":"yes"})",
                            R"({"readings":{"gsk.pocket.path":"semicircles"}})",
                            R"({"readings":{"gsk.arc.zero-radius":"none"}})",
                            R"({"readings":{"gsk.rotary-feed-inch":"degrees"}})",
                            R"({"readings":{"gsk.feed-units":"number"}})",
                            R"({"readings":{"gsk.helix.entry-side":"-q"}})",
                            R"({"readings":{"gsk.thread.runout":"spiral"}})",
                            R"({"readings":{"gsk.unheard-of":"any"}})",
                            R"({"readings":[]})"};
  for (const char* profile : profiles) {
    const Session session(profile);
    EXPECT_EQ(session.outcome().create, GONOGO_UNSUPPORTED) << profile;
    EXPECT_NE(session.outcome().note, "") << profile;
  }
}

TEST(GskConfiguration, InitialState) {
  const Outcome outcome = run("X3 Z1 R2.5\nM30\n",
                              R"({"initial":{"x":"1.5","z":"-4","c":"3e1","a":"0.5","f":"75",
                                 "plane":18,"motion":"G3"}})");
  // From (Z-4, X1.5) to (Z1, X1.5): chord 5, R2.5, centre (Z-1.5, X1.5).
  EXPECT_EQ(outcome.records[0], "arc18 c=-1.5,1.5 rot=1 x=1.5 z=1 f=75");
  EXPECT_EQ(outcome.records.back(), "end x=1.5 y=0 z=1 a=0.5 c=30");
}

TEST(GskConfiguration, PowerOnInches) {
  EXPECT_EQ(run("G0 Z1\n", R"({"units":"inch"})").motions(), "rapid z=25.4\n");
}

TEST(GskConfiguration, ParameterDecidesOnDuplicates) {
  EXPECT_EQ(run("G0 X2 X4\n", R"({"parameters":{"3403.6":"0"}})").motions(), "rapid x=2\n");
}

}  // namespace
}  // namespace gonogo::expanders::testing
