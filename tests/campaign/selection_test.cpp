// SPDX-License-Identifier: GPL-3.0-or-later
//
// A case under the certifier's profile (--profile) and readings (--reading).
#include "campaign/selection.hpp"

#include <gtest/gtest.h>

#include "reference/dialect.hpp"

namespace gonogo::oracle {
namespace {

reference::Profile machine(const std::string& json) {
  return std::get<reference::Profile>(reference::profile_from_json(json));
}

Case case_with(const std::string& profile) {
  Case test;
  test.id = "hnc.basic.000001";
  test.dialect = "hnc21t";
  test.profile = machine(profile);
  return test;
}

// The profile of the case under a certifier's, as JSON; "left out" where they contradict each
// other.
std::string under_profile(const std::string& own, const std::string& certifiers) {
  CampaignOptions options;
  options.profile = machine(certifiers);
  const std::optional<Case> test = under(options, case_with(own));
  return test ? reference::profile_json(test->profile) : "left out";
}

TEST(Selection, KeysOfTheCertifierAndOfTheCaseHoldTogether) {
  EXPECT_EQ(under_profile(R"({"dialect":"hnc21t","x_diameter":false})",
                          R"({"dialect":"hnc21t","initial":{"f":"100"}})"),
            reference::profile_json(
                machine(R"({"dialect":"hnc21t","x_diameter":false,"initial":{"f":"100"}})")));
  EXPECT_EQ(
      under_profile(R"({"dialect":"hnc21t","initial":{"x":"5"}})",
                    R"({"dialect":"hnc21t","initial":{"f":"100"}})"),
      reference::profile_json(machine(R"({"dialect":"hnc21t","initial":{"x":"5","f":"100"}})")));
}

TEST(Selection, ACaseThatContradictsTheCertifierIsLeftOut) {
  EXPECT_EQ(under_profile(R"({"dialect":"hnc21t","x_diameter":false,"initial":{"x":"5"}})",
                          R"({"dialect":"hnc21t","initial":{"x":"6"}})"),
            "left out");
  EXPECT_EQ(under_profile(R"({"dialect":"hnc21t"})", R"({"dialect":"rs274"})"), "left out");
}

// The file says what is so by default; without it the machine may be either.
TEST(Selection, WhatTheCertifierSaysHoldsAlsoWhereItIsTheDefault) {
  const std::string machines = R"({"dialect":"hnc21t","x_diameter":true,
                                   "readings":{"hnc.peck.from":"last-bottom"}})";
  CampaignOptions options;
  options.profile = machine(machines);
  EXPECT_TRUE(under(options, case_with(R"({"dialect":"hnc21t","x_diameter":false})")));
  options.profile_keys = reference::keys_of_json(machines);
  EXPECT_TRUE(under(options, case_with(R"({"dialect":"hnc21t"})")));
  EXPECT_FALSE(under(options, case_with(R"({"dialect":"hnc21t","x_diameter":false})")));
  EXPECT_FALSE(
      under(options, case_with(R"({"dialect":"hnc21t","readings":{"hnc.peck.from":"withdrawn"}})")));
}

TEST(Selection, KeysOfAProfileAreThoseThatItsTextHas) {
  EXPECT_EQ(reference::keys_of_toml("dialect = \"rs274\"\ninitial = { f = \"100\" }\n"
                                    "[readings]\nngc.peck.d = \"barred\"\n"),
            (std::vector<reference::ProfileKey>{
                {"dialect"}, {"initial", "f"}, {"readings", "ngc.peck.d"}}));
}

TEST(Selection, AReadingOfTheCertifierReplacesTheDefaultButNotTheCasesOwn) {
  CampaignOptions options;
  options.readings = {"hnc.peck.from=withdrawn", "gsk.thread.runout=radial"};
  const auto own = [&](const std::string& profile) -> std::string {
    const std::optional<Case> test = under(options, case_with(profile));
    return test ? std::string(
                      test->profile.readings.get(reference::find_reading("hnc.peck.from")->key))
                : "left out";
  };
  EXPECT_EQ(own(R"({"dialect":"hnc21t"})"), "withdrawn");
  EXPECT_EQ(own(R"({"dialect":"hnc21t","readings":{"hnc.peck.from":"withdrawn"}})"), "withdrawn");
  options.readings = {"hnc.peck.from=start"};
  EXPECT_EQ(own(R"({"dialect":"hnc21t","readings":{"hnc.peck.from":"withdrawn"}})"), "left out");
}

}  // namespace
}  // namespace gonogo::oracle
