// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

int create_hnc(const std::string& profile) {
  return Session(profile, {}, "hnc").outcome().create;
}

TEST(HncConfiguration, DefaultsMayBeWrittenOut) {
  EXPECT_EQ(create_hnc(R"({"dialect":"hnc21t","units":"mm","resolution":"0.001","x_diameter":true,
    "initial":{"x":"0","y":"0","z":"0","a":"0","c":"0","f":"0","plane":"G18","motion":"G00",
    "spindle":"M5"},"offsets":{},"tools":{},"parameters":{"3410":"0.01"},"alarm_timing":"block",
    "block_skip":false,"readings":{"hnc.missing-axis":"reject","hnc.peck.clamp":"none",
    "hnc.g82.starts":"all","hnc.modal.f":"feed","hnc.g75.i":"I","hnc.g82.exit":"rapid",
    "hnc.g82.e-scale":"radius","hnc.peck.from":"last-bottom","hnc.peck.withdraw":"rapid",
    "hnc.g75.steps":"i-plus-1","hnc.g75.end":"start","hnc.g75.mode3":"off",
    "hnc.g75.depth-scale":"radius","hnc.offset.initial":"G54","hnc.lead.unit":"mm",
    "hnc.arc.zero-radius":"alarm","hnc.rewrite":"keep","hnc.empty-block":"none",
    "hnc.g74.x":"none","hnc.g74.mode3":"off","hnc.modal.words":"forgotten",
    "hnc.g32.lead":"alarm","hnc.g82.q":"read","hnc.g75.zero-width":"each","hnc.g82.order":"rising",
    "hnc.feed-units":"length","hnc.feed-change":"kept"}})"),
            GONOGO_OK);
}

TEST(HncConfiguration, EveryReadingMayBeAny) {
  for (const char* key :
       {"hnc.missing-axis",    "hnc.peck.clamp",     "hnc.g82.starts",  "hnc.modal.f",
        "hnc.g75.i",           "hnc.g82.exit",       "hnc.g82.e-scale", "hnc.peck.from",
        "hnc.peck.withdraw",   "hnc.g75.steps",      "hnc.g75.end",     "hnc.g75.mode3",
        "hnc.g75.depth-scale", "hnc.offset.initial", "hnc.lead.unit",   "hnc.arc.zero-radius",
        "hnc.rewrite",         "hnc.empty-block",    "hnc.g74.x",       "hnc.g75.zero-width",
        "hnc.g82.order",       "hnc.feed-units",     "hnc.feed-change", "hnc.g74.mode3",
        "hnc.modal.words",     "hnc.g32.lead",       "hnc.g82.q"}) {
    EXPECT_EQ(create_hnc(R"({"readings":{")" + std::string(key) + R"(":"any"}})"), GONOGO_OK)
        << key;
  }
}

TEST(HncConfiguration, WhatIsNotImplementedIsNamed) {
  const char* profiles[] = {R"({"colour":"red"})",
                            R"({"dialect":"gsk988ta"})",
                            R"({"increment":"ISC"})",
                            R"({"units":"furlong"})",
                            R"({"offsets":{"G53":{"x":"1"}}})",
                            R"({"offsets":{"G54":{"b":"1"}}})",
                            R"({"offsets":{"G54":"1"}})",
                            R"({"tools":{"10":{"radius":"5"}}})",
                            R"({"alarm_timing":"program"})",
                            R"({"parameters":{"5920":"30"}})",
                            R"({"initial":{"plane":"G17"}})",
                            R"({"initial":{"motion":"G71"}})",
                            R"({"initial":{"motion":"G90"}})",
                            R"({"initial":{"x":"11/3"}})",
                            R"({"initial":{"f":"-1"}})",
                            R"({"readings":{"hnc.g75.i":"L"}})",
                            R"({"readings":{"hnc.feed-units":"inches"}})",
                            R"({"readings":{"hnc.missing-axis":"perhaps"}})",
                            R"({"readings":{"gsk.pocket.end":"initial"}})"};
  for (const char* profile : profiles) {
    const Session session(profile, {}, "hnc");
    EXPECT_EQ(session.outcome().create, GONOGO_UNSUPPORTED) << profile;
    EXPECT_NE(session.outcome().note, "") << profile;
  }
}

TEST(HncConfiguration, InitialState) {
  const Outcome outcome =
      run_hnc("X3 Z1 I-1\n", R"({"initial":{"x":"4","z":"9","f":"75","motion":"G80"}})");
  EXPECT_EQ(outcome.motions(), "rapid x=0.5\nfeed x=1.5 z=1 f=75\nfeed x=4 f=75\nrapid z=9\n");
}

}  // namespace
}  // namespace gonogo::expanders::testing
