// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/campaign.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "hunting.hpp"
#include "subjects/private_folder.hpp"

namespace gonogo::hunt::testing {
namespace {

namespace fs = std::filesystem;

class HuntCampaigns : public ::testing::Test {
 protected:
  std::string in(const fs::path& name) const { return (folder_.path() / name).string(); }

  static CampaignState wanted(std::size_t shard = 1) {
    CampaignState state;
    state.dialect = "rs274";
    state.subject = "builtin:ngc+offsets-absolute";
    state.programs_of_round = 100;
    state.shard = shard;
    state.shards = 2;
    return state;
  }
  static HuntCampaign campaign(const std::string& folder, const CampaignState& state = wanted()) {
    return {folder, state, builtin("ngc", "offsets-absolute"), {}, {}, "gonogo"};
  }
  static bool go_on(const Hunt&) { return true; }
  static void say_nothing(const Finding&, const std::string&) {}
  static std::string text_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  oracle::PrivateFolder folder_;
};

TEST_F(HuntCampaigns, OneThatIsBrokenOffFindsWhatOneThatIsNotFinds) {
  HuntCampaign whole = campaign(in("whole"));
  for (int round = 0; round < 3; ++round) EXPECT_TRUE(whole.round(say_nothing, go_on));
  ASSERT_GT(whole.state().findings.size(), 1U);

  {
    HuntCampaign broken = campaign(in("broken"));
    EXPECT_TRUE(broken.round(say_nothing, go_on));
    int left = 40;
    EXPECT_FALSE(broken.round(say_nothing, [&](const Hunt&) { return --left > 0; }));
  }
  HuntCampaign resumed = campaign(in("broken"));
  EXPECT_EQ(resumed.state().rounds, 1U);
  for (int round = 0; round < 2; ++round) EXPECT_TRUE(resumed.round(say_nothing, go_on));
  EXPECT_EQ(text_of(in("broken/hunt.json")), text_of(in("whole/hunt.json")));
  for (const auto& [signature, finding] : resumed.state().findings) {
    const fs::path program = fs::path("findings") / finding.id / "program.nc";
    EXPECT_EQ(text_of(in("broken" / program)), text_of(in("whole" / program)));
  }
}

// In the rounds of a campaign the flicker is one finding, and what the fault shows each time stands
// beside it as what it is.
TEST_F(HuntCampaigns, AFlickerOfOnePercentIsToldAsSuchAndHidesNoFault) {
  CampaignState state = wanted();
  state.programs_of_round = 400;
  std::size_t runs = 0;
  HuntCampaign campaign(
      in("flicker"), state,
      [&] {
        return std::make_unique<Flickering>(builtin("ngc", "radius-sign-ignored")(), true, runs);
      },
      {}, {}, "gonogo");
  for (int round = 0; round < 3; ++round) EXPECT_TRUE(campaign.round(say_nothing, go_on));
  std::size_t flickers = 0;
  std::size_t of_the_fault = 0;
  Trial steady(builtin("ngc", "radius-sign-ignored"), {});
  for (const auto& [signature, finding] : campaign.state().findings) {
    if (signature.what == "flicker") {
      EXPECT_EQ(signature.kind, oracle::VerdictKind::state_leak);
      ++flickers;
      continue;
    }
    // Not the flicker under the name of a failure that stays: without it the program departs, too.
    const Reproducer reproducer = read_reproducer(in("flicker/findings/") + finding.id, "rs274");
    const auto verdict = steady.run_alone(reproducer);
    ASSERT_TRUE(verdict);
    EXPECT_EQ(decision(verdict->kind), oracle::Decision::no_go) << signature.text() << "\n"
                                                                << reproducer.program.text;
    if (signature.clause == "NGC-ARC-04") ++of_the_fault;
  }
  EXPECT_EQ(flickers, 1U);
  EXPECT_GE(of_the_fault, 1U);
}

TEST_F(HuntCampaigns, AFindingIsToldOnceAndCountedAlways) {
  HuntCampaign campaign = HuntCampaigns::campaign(in("one"));
  std::set<Signature> told;
  for (int round = 0; round < 3; ++round) {
    campaign.round(
        [&](const Finding& finding, const std::string&) {
          EXPECT_TRUE(told.insert(finding.signature).second) << finding.signature.text();
        },
        go_on);
  }
  bool again = false;
  for (const auto& [signature, finding] : campaign.state().findings) {
    EXPECT_TRUE(told.contains(signature));
    EXPECT_GE(finding.times, finding.last - finding.first + 1 > 1 ? 2U : 1U);
    again = again || finding.last > finding.first;
  }
  EXPECT_TRUE(again);
}

TEST_F(HuntCampaigns, ShardsTryOtherPrograms) {
  HuntCampaign first = campaign(in("first"));
  HuntCampaign second = campaign(in("second"), wanted(2));
  first.round(say_nothing, go_on);
  second.round(say_nothing, go_on);
  EXPECT_NE(first.state().inputs, second.state().inputs);
}

TEST_F(HuntCampaigns, AnotherHuntInTheFolderIsRefused) {
  campaign(in("one")).round(say_nothing, go_on);
  CampaignState other = wanted();
  other.seed = 2;
  EXPECT_THROW(campaign(in("one"), other), std::invalid_argument);
  other = wanted();
  other.subject = "builtin:ngc";
  EXPECT_THROW(campaign(in("one"), other), std::invalid_argument);
}

TEST_F(HuntCampaigns, ASpoiltFileIsSaidToBeOne) {
  campaign(in("one")).round(say_nothing, go_on);
  std::ofstream(in("one/hunt.json")) << "{\"format\": 1,";
  EXPECT_THROW(campaign(in("one")), std::invalid_argument);
}

}  // namespace
}  // namespace gonogo::hunt::testing
