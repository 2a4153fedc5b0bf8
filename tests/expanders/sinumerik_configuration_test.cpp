// SPDX-License-Identifier: GPL-3.0-or-later
// Profiles of the expander of sinumerik840d, and what it says of itself.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "expanders/registry.hpp"
#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

int create_sinumerik(const char* profile) {
  return Session(profile, {}, "sinumerik").outcome().create;
}

TEST(SinumerikConfiguration, ThePowerOnState) {
  EXPECT_EQ(run_sinumerik("X1\n", R"({"initial":{"motion":"G00"}})").motions(), "rapid x=1\n");
  EXPECT_EQ(run_sinumerik("X1\n", R"({"initial":{"motion":"G01","f":"50"}})").motions(),
            "feed x=1 f=50\n");
  EXPECT_EQ(run_sinumerik("G91 G0 Y1 A1\n", R"({"initial":{"x":"7","y":"2.5","a":"-3"}})").all(),
            "answer 0\n1 rapid y=3.5 a=-2\n1 end x=7 y=3.5 z=0 a=-2 c=0\n");
  EXPECT_EQ(run_sinumerik("G2 Y2 J1 F1\n", R"({"initial":{"plane":"G19"}})").motions(),
            "arc19 c=1,0 rot=-1 y=2 z=0 f=1\n");
  EXPECT_EQ(run_sinumerik("G0 X1\n", R"({"units":"inch"})").motions(), "rapid x=25.4\n");
}

TEST(SinumerikConfiguration, DefaultsWrittenOutAreAccepted) {
  EXPECT_EQ(create_sinumerik(R"({"dialect":"sinumerik840d","units":"mm","increment":"ISB",
      "resolution":"0.001","x_diameter":false,"initial":{"x":"0","y":"0","z":"0","a":"0","c":"0",
      "f":"0","plane":"G17","motion":"none","spindle":"0"},"offsets":{},"tools":{},
      "parameters":{"CIRCLE_ERROR_CONST":"0.01","CIRCLE_ERROR_FACTOR":"0.001"},"readings":
      {"sie.arc.correct":"any","sie.cr.tolerance":"0","sie.spindle":"off",
      "sie.initial-motion":"g1","sie.g70.f":"mm"},"alarm_timing":"block","block_skip":false})"),
            GONOGO_OK);
}

// X of an end, absolute or not; the centre is a length.
TEST(SinumerikConfiguration, XIsADiameterWhereTheMachineSaysSo) {
  const char* profile = R"({"x_diameter":true})";
  EXPECT_EQ(run_sinumerik("G0 X20 Y3\nG91 X10\n", profile).motions(),
            "rapid x=10 y=3\nrapid x=15\n");
  EXPECT_EQ(run_sinumerik("G2 X20 Y0 I5 J0 F1\n", profile).motions(),
            "arc17 c=5,0 rot=-1 x=10 y=0 f=1\n");
}

TEST(SinumerikConfiguration, WhatIsNotImplementedIsRefused) {
  for (const char* profile :
       {R"({"x_diameter":1})", R"({"offsets":{"G54":{"x":"1"}}})",
        R"({"initial":{"motion":"G04"}})", R"({"readings":{"sie.arc.correct":"other"}})",
        R"({"readings":{"hnc.g75.i":"I"}})", R"({"alarm_timing":"program"})", R"({"unknown":1})",
        R"({"initial":{"f":"-1"}})", R"({"parameters":{"3410":"1"}})",
        R"({"parameters":{"CIRCLE_ERROR_CONST":"-1"}})", R"({"initial":{"x":"2000000000"}})"}) {
    EXPECT_EQ(create_sinumerik(profile), GONOGO_UNSUPPORTED) << profile;
  }
}

TEST(SinumerikConfiguration, ToolsAndReadingsOf802S) {
  auto created802s = [](const char* profile) {
    return Session(profile, {}, "sinumerik802s").outcome().create;
  };
  EXPECT_EQ(created802s(R"({"dialect":"sinumerik802s","tools":{"10":{"radius":"5"}},"readings":
      {"sie.g158":"any","sie.rpl-equals":"required","sie.g258":"absolute","sie.corner":"clamp",
      "sie.spindle":"alarm","sie.infeed":"equal"}})"),
            GONOGO_OK);
  for (const char* profile :
       {R"({"dialect":"sinumerik840d"})", R"({"tools":{"T":{"radius":"5"}}})",
        R"({"tools":{"1":{"radius":"-5"}}})", R"({"tools":{"1":{"length":"5"}}})",
        R"({"readings":{"sie.infeed":"other"}})", R"({"readings":{"sie.finish.levels":"one"}})"}) {
    EXPECT_EQ(created802s(profile), GONOGO_UNSUPPORTED) << profile;
  }
  EXPECT_EQ(create_sinumerik(R"({"tools":{"1":{"radius":"5"}}})"), GONOGO_UNSUPPORTED);
}

TEST(SinumerikConfiguration, DescribesItself) {
  const gonogo_text text = find("sinumerik")->describe();
  const auto json = nlohmann::json::parse(text.data, text.data + text.size);
  std::vector<std::string> features = {"basic", "arc", "cr", "ar",          "polar", "planes",
                                       "helix", "cip", "ct", "expressions", "rotary"};
  EXPECT_EQ(json["dialects"]["sinumerik840d"], features);
  features.insert(features.end(), {"frames", "lcyc82", "lcyc75"});
  EXPECT_EQ(json["dialects"]["sinumerik802s"], features);
  EXPECT_EQ(json["numeric"]["resolution"], "0.001");
}

TEST(SinumerikConfiguration, EveryRunStartsFromPowerOn) {
  Session session("{}", {}, "sinumerik");
  const Outcome first = session.run("G0 X=R1+1\nY=R1\n");
  session.run("R1=5 G91 G70 G18 G2 G95 F9 S5 M3\nG111 X5\n");
  EXPECT_EQ(session.run("G0 X=R1+1\nY=R1\n").all(), first.all());
}

}  // namespace
}  // namespace gonogo::expanders::testing
