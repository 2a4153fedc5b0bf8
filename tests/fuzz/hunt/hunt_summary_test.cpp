// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/hunt_summary.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "../identify/secret_subject.hpp"
#include "fuzz/hunt/campaign.hpp"
#include "fuzz/hunt/campaign_page.hpp"
#include "fuzz/hunt/finding_files.hpp"
#include "fuzz/identify/shared_causes.hpp"
#include "hunting.hpp"
#include "subjects/private_folder.hpp"

namespace gonogo::hunt::testing {
namespace {

using identify::testing::TwoFaults;
using oracle::VerdictKind;

Signature signature(const char* clause, const char* what, const char* code,
                    VerdictKind kind = VerdictKind::fail_geometry) {
  return {"rs274", kind, clause, what, code};
}

class HuntSummaries : public ::testing::Test {
 protected:
  const std::string& folder() const { return folder_.path(); }
  // A shard that found these, each in as many programs as its place says.
  void write_shard(const char* name, const std::vector<Signature>& found,
                   std::size_t mended = 0) const {
    CampaignState state;
    state.dialect = "rs274";
    state.subject = "lib:<b>acme</b>.so";
    state.rounds = 3;
    state.count.programs = 100;
    state.features["arc"] = {10, 2, 1};
    state.left_out = "text / \xC3; word E";  // of programs, which may be no UTF-8
    std::size_t times = 0;
    for (const Signature& one : found) {
      ++times;
      state.findings[one] = {"id-" + std::to_string(times), 1, 2, times, mended};
    }
    write_campaign_state(folder() + "/" + name, state);
  }

  // A campaign of one shard that found these.
  HuntSummary grouped(const std::vector<Signature>& found, const Causes& causes = {}) const {
    write_shard("shard-1-of-1", found);
    HuntSummary summary = summarize_campaign(folder());
    group_findings(summary, causes);
    return summary;
  }

  oracle::PrivateFolder folder_;
};

// Of the finding with three symptoms.
std::string cause_of_three(const HuntSummary& summary) {
  for (const CampaignFinding& finding : summary.findings) {
    if (finding.symptoms.size() == 3) return cause_text(finding);
  }
  return "none has three symptoms";
}

const Signature kFirst = signature("NGC-ARC-02", "arc/arc", "G2");
const Signature kAlike = signature("NGC-ARC-02", "arc/arc", "G3");
const Signature kOtherShape = signature("NGC-ARC-02", "arc/feed", "G2");
const Signature kOtherClause = signature("NGC-ARC-05", "arc/arc", "G2");
const Signature kOtherKind =
    signature("NGC-ARC-02", "alarm/arc-radius", "G2", VerdictKind::fail_alarm_spurious);

TEST_F(HuntSummaries, FacesOfOneCauseAreOneFinding) {
  write_shard("shard-1-of-1", {kFirst, kOtherShape, kOtherClause, kOtherKind});
  HuntSummary summary = summarize_campaign(folder());
  EXPECT_EQ(findings_text(summary), "4 findings, 4 symptoms");
  Causes causes;
  for (const Signature& one : {kFirst, kOtherShape, kOtherClause, kOtherKind}) {
    causes[one] = {"so", "It explains 4 of 4."};
  }
  group_findings(summary, causes);
  EXPECT_EQ(findings_text(summary), "1 finding, 4 symptoms");
  EXPECT_EQ(cause_text(summary.findings.front()), "Behaves as if: so. It explains 4 of 4.");
  // A wrong path before a wrong alarm, and in how many programs, that of most first.
  EXPECT_EQ(summary.findings.front().symptoms.front().programs, 3U);
  EXPECT_EQ(summary.findings.front().symptoms.back().programs, 4U);
  EXPECT_EQ(summary.findings.front().programs(), 10U);
}

TEST_F(HuntSummaries, BytesThatAreNoTextArePutOutAsSuch) {
  write_shard("shard-1-of-1", {kFirst});
  const HuntSummary summary = summarize_campaign(folder());
  EXPECT_EQ(summary.left_out, std::vector<std::string>{"text / \xEF\xBF\xBD; word E"});
}

TEST_F(HuntSummaries, TwoCausesAreTwoFindings) {
  const HuntSummary summary =
      grouped({kFirst, kAlike, kOtherClause},
              {{kFirst, {"one", ""}}, {kAlike, {"another", ""}}, {kOtherClause, {"one", ""}}});
  EXPECT_EQ(findings_text(summary), "2 findings, 3 symptoms");
}

TEST_F(HuntSummaries, WhatNothingExplainsIsAFindingForEachStep) {
  const Signature crash{"rs274", VerdictKind::crash, "", "signal 11", ""};
  const Signature hang{"rs274", VerdictKind::timeout, "", "timeout", ""};
  const HuntSummary summary =
      grouped({kFirst, kAlike, kOtherShape, kOtherClause, kOtherKind, crash, hang});
  EXPECT_EQ(findings_text(summary), "5 findings, 7 symptoms");
  for (const CampaignFinding& finding : summary.findings) {
    EXPECT_TRUE(finding.cause.empty());
    if (finding.symptoms.size() == 1) continue;
    std::set<Signature> signatures;
    for (const Symptom& symptom : finding.symptoms) signatures.insert(symptom.signature);
    EXPECT_EQ(signatures, std::set({kFirst, kAlike, kOtherShape}));
  }
}

TEST_F(HuntSummaries, AlarmsOfOneClassThatAreNotDueAreOneFinding) {
  using enum VerdictKind;
  const HuntSummary summary =
      grouped({signature("NGC-CYC-12", "rapid/missing-word", "G81", fail_alarm_spurious),
               signature("NGC-COM-01", "alarm/missing-word", "G73", fail_alarm_spurious),
               signature("NGC-COM-02", "alarm/missing-word", "G84", fail_alarm_class),
               signature("NGC-ARC-02", "arc/arc-radius", "G2", fail_alarm_spurious),
               signature("NGC-ARC-02", "alarm/arc", "G2", fail_alarm_late)});
  EXPECT_EQ(findings_text(summary), "3 findings, 5 symptoms");
  EXPECT_EQ(cause_of_three(summary),
            "No one mistake that was tried explains it; each is an alarm missing-word that is not "
            "due.");
}

TEST_F(HuntSummaries, MotionsBeyondTheirBlockAreOneFinding) {
  const HuntSummary summary =
      grouped({signature("NGC-CYC-12", "rapid/feed of an earlier block", "G82"),
               signature("NGC-G33-01", "thread/rapid of an earlier block", "G33"),
               signature("", "end/feed", "G83", VerdictKind::fail_overrun), kOtherShape});
  EXPECT_EQ(findings_text(summary), "2 findings, 4 symptoms");
  EXPECT_EQ(cause_of_three(summary),
            "No one mistake that was tried explains it; each makes a motion more than its block "
            "asks for.");
}

TEST_F(HuntSummaries, OneThatIsExplainedIsNotOfThoseOfItsShape) {
  const HuntSummary summary = grouped({kFirst, kAlike}, {{kFirst, {"so", ""}}});
  EXPECT_EQ(findings_text(summary), "2 findings, 2 symptoms");
}

TEST_F(HuntSummaries, ShardsAreCountedTogetherAndAFaceOnce) {
  write_shard("shard-1-of-2", {kFirst, kOtherClause});
  write_shard("shard-2-of-2", {kOtherClause, kFirst}, 3);
  append_round_time(folder() + "/shard-2-of-2",
                    {1, std::chrono::system_clock::time_point(std::chrono::seconds(1'000'000)),
                     std::chrono::seconds(4), 100});
  const HuntSummary summary = summarize_campaign(folder());
  EXPECT_EQ(summary.shards, 2U);
  EXPECT_EQ(summary.rounds, 6U);
  EXPECT_EQ(summary.count.programs, 200U);
  EXPECT_EQ(summary.features.at("arc").judged, 20U);
  EXPECT_EQ(summary.features.at("arc").skipped, 4U);
  ASSERT_EQ(summary.findings.size(), 2U);
  for (const CampaignFinding& finding : summary.findings) {
    EXPECT_EQ(finding.programs(), 3U);
    EXPECT_TRUE(finding.stands());  // in the first shard
    EXPECT_TRUE(finding.symptoms.front().folder.starts_with("shard-1-of-2/"));
    ASSERT_TRUE(finding.symptoms.front().first_seen);
    EXPECT_EQ(date_text(*finding.symptoms.front().first_seen), "1970-01-12 13:46 UTC");
    EXPECT_FALSE(finding.symptoms.front().last_seen);  // no time of round 2 is known
  }
}

TEST_F(HuntSummaries, WhatIsMendedIsTold) {
  write_shard("shard-1-of-1", {kFirst, kOtherClause}, 3);
  const HuntSummary summary = summarize_campaign(folder());
  EXPECT_EQ(summary.standing(), 0U);
  EXPECT_EQ(findings_text(summary), "0 findings; 2 mended");
}

TEST_F(HuntSummaries, CausesAreReadAsTheyWereWritten) {
  EXPECT_TRUE(read_known_causes(folder()).asked.empty());
  const HuntSummary summary =
      grouped({kFirst, kAlike, kOtherShape}, {{kFirst, {"so", "It explains 1 of 2."}}});
  write_campaign_summary(folder(), summary);
  const KnownCauses known = read_known_causes(folder());
  EXPECT_EQ(known.asked, std::set({kFirst, kAlike, kOtherShape}));
  ASSERT_EQ(known.causes.size(), 1U);
  EXPECT_EQ(known.causes.at(kFirst).text(), "Behaves as if: so. It explains 1 of 2.");
  std::ofstream(folder() + "/campaign.json") << "{\"format\": 1, \"findings\": [{}]}";
  EXPECT_TRUE(read_known_causes(folder()).asked.empty());
}

// Causes of what is mended were found before, with other programs.
TEST_F(HuntSummaries, TheEvidenceIsThatOfASymptomThatStands) {
  write_shard("shard-1-of-2", {kFirst, kOtherClause}, 3);
  write_shard("shard-2-of-2", {kAlike});
  HuntSummary summary = summarize_campaign(folder());
  group_findings(
      summary,
      {{kFirst, {"so", "old."}}, {kAlike, {"so", "new."}}, {kOtherClause, {"so", "old."}}});
  ASSERT_EQ(summary.findings.size(), 1U);
  EXPECT_EQ(cause_text(summary.findings.front()), "Behaves as if: so. new.");
}

TEST_F(HuntSummaries, ThePageShowsWhatASubjectIsCalledAsText) {
  write_shard("shard-1-of-1", {kFirst});
  const PageFolder in{folder(), [](const std::string& finding) { return "see " + finding; }};
  const std::string page = campaign_page(in, summarize_campaign(folder()));
  EXPECT_NE(page.find("&lt;b&gt;acme"), std::string::npos);
  EXPECT_EQ(page.find("<b>acme"), std::string::npos);
  // Its program is not there: that is said in its place.
  EXPECT_NE(page.find("profile.json"), std::string::npos);
}

TEST_F(HuntSummaries, ACampaignOnASubjectWithTwoFaultsHasTwoFindings) {
  CampaignState wanted;
  wanted.dialect = "rs274";
  wanted.subject = "two faults";
  wanted.programs_of_round = 700;
  const std::string shard = folder() + "/shard-1-of-1";
  HuntCampaign campaign(
      shard, wanted, [] { return std::make_unique<TwoFaults>(); }, {}, {}, "gonogo");
  ASSERT_TRUE(
      campaign.round([](const Finding&, const std::string&) {}, [](const Hunt&) { return true; }));
  HuntSummary summary = summarize_campaign(folder());
  ASSERT_GT(summary.findings.size(), 5U);  // each symptom is one, until they are grouped

  std::vector<Signature> symptoms;
  std::vector<identify::ProgramAsked> asked;
  for (const CampaignFinding& finding : summary.findings) {
    const Symptom& symptom = finding.symptoms.front();
    const auto program = read_reproducer(folder() + "/" + symptom.folder, "rs274").program;
    symptoms.push_back(symptom.signature);
    asked.push_back({symptom.folder, program.text, program.profile});
  }
  std::vector<identify::ProgramAsked> others;
  for (const auto& input : read_inputs(shard, campaign.state())) {
    if (others.size() < 100) others.push_back({"input", input.text, input.profile});
  }
  TwoFaults subject;
  const auto found = identify::find_shared_causes(subject, asked, others, {});
  Causes causes;
  for (const identify::SharedCause& cause : found.causes) {
    for (const std::size_t symptom : cause.symptoms) causes[symptoms[symptom]] = cause.told();
  }
  group_findings(summary, causes);
  ASSERT_EQ(summary.findings.size(), 2U) << finding_list_text(summary);
  const std::set<std::string> told = {summary.findings[0].cause.name,
                                      summary.findings[1].cause.name};
  EXPECT_EQ(told,
            (std::set<std::string>{"I J K are taken as absolute", identify::testing::kDwellCause}));
}

TEST(RoundTimes, ALineThatWasBrokenOffSaysNothingAndSpoilsNoOther) {
  const oracle::PrivateFolder folder;
  const auto at = [](int seconds) {
    return std::chrono::system_clock::time_point(std::chrono::seconds(seconds));
  };
  append_round_time(folder.path(), {1, at(100), std::chrono::seconds(2), 50});
  std::ofstream(folder.path() + "/rounds.jsonl", std::ios::app) << "{\"round\":2,\"en";
  append_round_time(folder.path(), {2, at(200), std::chrono::milliseconds(1500), 60});
  append_round_time(folder.path(), {2, at(300), std::chrono::seconds(1), 60});
  const std::vector<RoundTime> times = read_round_times(folder.path());
  ASSERT_EQ(times.size(), 2U);
  EXPECT_EQ(times[0].ended, at(100));
  EXPECT_EQ(times[1].ended, at(300));
  EXPECT_EQ(times[1].programs, 60U);
}

}  // namespace
}  // namespace gonogo::hunt::testing
