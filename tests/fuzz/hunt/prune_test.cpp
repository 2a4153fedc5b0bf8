// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/prune.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "fuzz/hunt/campaign.hpp"
#include "fuzz/hunt/coverage.hpp"
#include "hunting.hpp"
#include "subjects/private_folder.hpp"

namespace gonogo::hunt::testing {
namespace {

namespace fs = std::filesystem;

std::set<std::uint64_t> shown_by(const std::vector<generate::GeneratedProgram>& programs) {
  std::set<std::uint64_t> shown;
  for (const auto& program : programs) {
    const auto own = coverage_of(program, kMostCostInHunt);
    if (own) shown.insert(own->features.begin(), own->features.end());
  }
  return shown;
}

class Prunings : public ::testing::Test {
 protected:
  HuntCampaign campaign(const char* fault) const {
    CampaignState wanted;
    wanted.dialect = "gsk988ta";
    wanted.subject = "acme";
    wanted.programs_of_round = 150;
    return {folder_, wanted, builtin("gsk", fault), {}, {}, "gonogo"};
  }
  // A round; the ids that it told.
  std::vector<std::string> round(const char* fault) const {
    std::vector<std::string> told;
    campaign(fault).round([&](const Finding&, const std::string& id) { told.push_back(id); },
                          [](const Hunt&) { return true; });
    return told;
  }
  Pruned prune(const char* fault) const {
    Trial trial(builtin("gsk", fault), {});
    return prune_campaign(folder_, trial);
  }
  CampaignState state() const { return read_campaign_state(folder_).value(); }

  oracle::PrivateFolder private_;
  std::string folder_ = private_.path() + "/campaign";
};

TEST_F(Prunings, FewerProgramsShowAllThatWasShown) {
  round("inch-feed");
  round("inch-feed");
  const auto before = read_inputs(folder_, state());
  const Pruned pruned = prune("inch-feed");
  const auto after = read_inputs(folder_, state());
  EXPECT_EQ(pruned.inputs_before, before.size());
  EXPECT_EQ(pruned.inputs, after.size());
  EXPECT_LT(after.size(), before.size());
  EXPECT_EQ(shown_by(after), shown_by(before));
  EXPECT_EQ(pruned.features, shown_by(after).size());
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder_ + "/inputs")) {
    files += entry.is_regular_file() ? 1U : 0U;
  }
  EXPECT_EQ(files, 2 * after.size());
  // Pruned again nothing goes, and the hunt goes on from there.
  EXPECT_EQ(prune("inch-feed").inputs, after.size());
  round("inch-feed");
  EXPECT_EQ(state().rounds, 3U);
}

TEST_F(Prunings, AProgramThatShowsNothingOfItsOwnIsNotNeeded) {
  const auto needed = needed_programs({gsk("G00 X100 Z5\nG94 X50 Z-10 F100\nM30\n"),
                                       gsk("G00 X100 Z5\nG94 X50 Z-10 F100\n"),
                                       gsk("G00 X200 Z10\nG94 X50 Z-10 F100\n")});
  ASSERT_FALSE(needed.empty());
  EXPECT_EQ(needed.front().text, "G00 X100 Z5\nG94 X50 Z-10 F100\n");
  EXPECT_TRUE(std::ranges::none_of(
      needed, [](const auto& program) { return program.text.starts_with("G00 X200"); }));
}

TEST_F(Prunings, WhatStillDepartsStands) {
  const auto told = round("inch-feed");
  ASSERT_FALSE(told.empty());
  const Pruned pruned = prune("inch-feed");
  ASSERT_EQ(pruned.findings.size(), told.size());
  for (const TriedFinding& finding : pruned.findings) {
    EXPECT_EQ(finding.stand, FindingStand::stands) << finding.id;
  }
  for (const auto& [signature, finding] : state().findings) EXPECT_TRUE(finding.stands());
}

TEST_F(Prunings, WhatIsMendedIsMarkedAndToldAgainWhereItComesBack) {
  const auto told = round("inch-feed");
  ASSERT_FALSE(told.empty());
  for (const TriedFinding& finding : prune("").findings) {
    EXPECT_EQ(finding.stand, FindingStand::mended) << finding.id;
  }
  for (const auto& [signature, finding] : state().findings) EXPECT_EQ(finding.mended, 1U);
  // Mended, it does not come back.
  EXPECT_TRUE(round("").empty());
  const CampaignState mended = state();
  // With the fault in again it is news, and what is told stands.
  const auto again = round("inch-feed");
  ASSERT_FALSE(again.empty());
  const CampaignState after = state();
  std::size_t stand = 0;
  for (const auto& [signature, finding] : after.findings) {
    if (!finding.stands()) continue;
    ++stand;
    EXPECT_EQ(finding.last, 3U);
    const auto before = mended.findings.find(signature);
    if (before == mended.findings.end()) continue;
    EXPECT_EQ(finding.first, 1U);
    EXPECT_GT(finding.times, before->second.times);
  }
  EXPECT_EQ(stand, again.size());
}

TEST_F(Prunings, AFolderWithoutAHuntIsRefused) {
  EXPECT_THROW(prune(""), std::runtime_error);
}

}  // namespace
}  // namespace gonogo::hunt::testing
