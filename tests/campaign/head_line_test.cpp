// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the head line of a run says.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "campaign/known_failures.hpp"
#include "campaign/tally.hpp"
#include "campaign_testing.hpp"

namespace gonogo::oracle {
namespace {

CaseFacts of_feature(std::string id, VerdictKind verdict, const std::string& feature) {
  CaseFacts made = facts(std::move(id), verdict);
  made.head.features = {feature};
  if (verdict == VerdictKind::skip) made.head.feature = feature;
  return made;
}

// J-RUN-04, J-RUN-05.
TEST(Tally, AdvicesAndSkipsChangeNothingButTheHeadLine) {
  CaseFacts advice = of_feature("c", VerdictKind::advice, "g94");
  advice.head.clause = "GSK-G94-02";
  advice.head.departure = "fail.geometry";
  const RunAnswer go = answer({of_feature("a", VerdictKind::pass_exact, "basic"),
                               of_feature("b", VerdictKind::pass_exact, "g94"), advice,
                               of_feature("d", VerdictKind::skip, "g110"),
                               of_feature("e", VerdictKind::skip, "g90")});
  EXPECT_EQ(go.exit_code, 0);
  EXPECT_EQ(go.judged, 2U);
  EXPECT_EQ(go.head,
            "GO for basic, g94 (1 of 2 cases) of gsk988ta: 2 judged, 1 advice; not claimed: g90, "
            "g110 (2 cases)");
  EXPECT_EQ(go.scope.short_head("GO"),
            "GO \xC2\xB7 basic, g94 (1 of 2 cases) of gsk988ta \xC2\xB7 2 judged, 1 advice, 2 not "
            "claimed");
  ASSERT_EQ(go.scope.advices().size(), 1U);
  EXPECT_EQ(go.scope.advices().begin()->first.clause, "GSK-G94-02");
  EXPECT_EQ(go.scope.advices().begin()->second.first, std::vector<std::string>{"c"});
}

// J-RUN-01.
TEST(Tally, ANoGoSaysWhatFailedAndWhatDidNot) {
  const RunAnswer no_go = answer({of_feature("a", VerdictKind::fail_geometry, "g94"),
                                  of_feature("b", VerdictKind::pass_exact, "g94"),
                                  of_feature("c", VerdictKind::pass_exact, "basic"),
                                  of_feature("d", VerdictKind::fail_feed, "g110")});
  EXPECT_EQ(no_go.head,
            "NO-GO: g94 of gsk988ta fails 1 of 2 cases, g110 1 of 1; GO: basic of gsk988ta; 2 of 4 "
            "judged are GO");
  EXPECT_EQ(no_go.scope.short_head("NO-GO"),
            "NO-GO \xC2\xB7 g94 of gsk988ta fails 1 of 2 cases, g110 1 of 1 \xC2\xB7 GO: basic of "
            "gsk988ta \xC2\xB7 2 of 4 judged are GO");
}

// The feature that fails most stands first, and a line for a terminal names but a few.
TEST(Tally, TheHeadLineBeginsWithWhatFailsMostAndFoldsLongLists) {
  std::vector<CaseFacts> cases;
  for (int i = 0; i < 11; ++i) {
    const std::string feature = fmt::format("g{}", 80 + i);
    cases.push_back(of_feature(fmt::format("a{:02}", i), VerdictKind::pass_exact, feature));
  }
  cases.push_back(of_feature("b", VerdictKind::fail_feed, "arc"));
  cases.push_back(of_feature("c", VerdictKind::fail_geometry, "g110"));
  cases.push_back(of_feature("d", VerdictKind::fail_geometry, "g110"));
  const RunAnswer no_go = answer(cases);
  const std::string failing =
      "NO-GO: g110 of gsk988ta fails 2 of 2 cases, arc 1 of 1; GO: g80, g81, g82, g83, g84, g85, "
      "g86, g87";
  EXPECT_EQ(no_go.head, failing + ", g88, g89, g90 of gsk988ta; 11 of 14 judged are GO");
  EXPECT_EQ(no_go.folded_head,
            failing + " and 3 more features of gsk988ta; 11 of 14 judged are GO");
  EXPECT_EQ(no_go.scope.short_head("NO-GO"),
            "NO-GO \xC2\xB7 g110 of gsk988ta fails 2 of 2 cases, arc 1 of 1 \xC2\xB7 GO: g80, g81, "
            "g82, g83 and 7 more features of gsk988ta \xC2\xB7 11 of 14 judged are GO");
}

// A badge has little room: of many dialects it names fewer features each.
TEST(Tally, TheShortHeadNamesAFeatureOfEachDialectThatIsGo) {
  std::vector<CaseFacts> cases = {of_feature("a", VerdictKind::fail_geometry, "g94")};
  for (const char* dialect : {"hnc21t", "rs274"}) {
    for (const char* feature : {"arc", "basic", "g74", "g80"}) {
      cases.push_back(of_feature(dialect + std::string(feature), VerdictKind::pass_exact, feature));
      cases.back().head.dialect = dialect;
    }
  }
  EXPECT_EQ(
      answer(cases).scope.short_head("NO-GO"),
      "NO-GO \xC2\xB7 g94 of gsk988ta fails 1 of 1 case \xC2\xB7 GO: arc and 3 more features of "
      "hnc21t; arc and 3 more features of rs274 \xC2\xB7 8 of 9 judged are GO");
}

// Nearly every case needs basic: it is to blame where nothing else can be, and GO only without a
// NO-GO.
TEST(Tally, BasicIsToBlameWhereACaseNeedsNothingElse) {
  CaseFacts both = of_feature("a", VerdictKind::fail_geometry, "g94");
  both.head.features = {"basic", "g94"};
  const CaseFacts sound = of_feature("b", VerdictKind::pass_exact, "basic");
  EXPECT_EQ(answer({both, sound}).head,
            "NO-GO: g94 of gsk988ta fails 1 of 1 case; 1 of 2 judged is GO");
  EXPECT_EQ(answer({both, sound, of_feature("c", VerdictKind::fail_geometry, "basic")}).head,
            "NO-GO: basic of gsk988ta fails 2 of 3 cases, g94 1 of 1; 1 of 3 judged is GO");
}

// J-RUN-14: three cases of three that are advices are not GO.
TEST(Tally, AFeatureOfWhichTheGreaterPartWasNotJudgedIsNotGo) {
  const RunAnswer none = answer({of_feature("a", VerdictKind::advice, "g94"),
                                 of_feature("b", VerdictKind::advice, "g94"),
                                 of_feature("c", VerdictKind::advice, "g94")});
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_EQ(none.head,
            "UNDECIDED: 0 judged, 3 advices; not judged for the most part: g94 (0 of 3 cases)");
  CaseFacts refused = of_feature("d", VerdictKind::skip, "lcyc75");
  refused.head.feature.clear();  // it refuses the profile
  const RunAnswer some =
      answer({of_feature("a", VerdictKind::pass_exact, "basic"),
              of_feature("b", VerdictKind::pass_exact, "lcyc75"), refused, refused});
  EXPECT_EQ(some.exit_code, 0);
  EXPECT_EQ(
      some.head,
      "GO for basic of gsk988ta: 2 judged; not claimed: 2 cases; not judged for the most part: "
      "lcyc75 (1 of 3 cases)");
}

// J-RUN-01.
TEST(Tally, WhatWasGrantedStandsInTheHeadLine) {
  Tally tally;
  tally.add(of_feature("a", VerdictKind::pass_exact, "g94"));
  const auto header = nlohmann::ordered_json::parse(
      R"({"tolerance":"1000","chord":"0.1","blend":"0.2","known_failures":"ab","strict":true,)"
      R"("shard":"1/300","selection":{"only":["g*"],"case":null,"cycles":["g94"]},)"
      R"("readings":["gsk.g94.in-mode=keep"],"subject":{"features":[]},"seed":12})");
  EXPECT_EQ(tally.finish({}, conditions_of(header)).head,
            "GO for g94 of gsk988ta: 1 judged; granted: tolerance 1000 mm, chord 0.1 mm, blend 0.2 "
            "mm, known failures, reading gsk.g94.in-mode=keep; a part: shard 1/300, glob g*, cycle "
            "g94; not compared: M functions, source lines; strict; seed 12");
}

// J-RUN-01. A subject that knows the names of the cases can look their answers up.
TEST(RunConditions, AFeedToleranceAnAlarmMapAndNamesOfCasesAreGrants) {
  const auto header =
      nlohmann::ordered_json::parse(R"({"feed_tolerance":"300","alarm_map":"cd","show_ids":true})");
  const RunConditions conditions = conditions_of(header);
  EXPECT_EQ(conditions.text(), "; granted: feed tolerance 300 %, alarm map, names of cases");
  EXPECT_EQ(conditions.short_text(), "feed tolerance 300 %, alarm map, names of cases");
  EXPECT_FALSE(conditions.are_none());
  EXPECT_TRUE(conditions_of(nlohmann::ordered_json::parse(R"({"alarm_map":null})")).are_none());
}

// J-RUN-01. Each is a NO-GO by itself.
TEST(Tally, StaleEntriesStandBeforeWhatIsGo) {
  const std::string failure = "known failure ngc.a.*: no case has this id";
  const std::string alarm = stale_alarm("E9");
  const auto head = [](const std::vector<std::string>& stale) {
    return answer({of_feature("a", VerdictKind::pass_exact, "basic")}, stale).head;
  };
  EXPECT_EQ(head({failure}), "NO-GO: 1 known failure is stale; GO: basic of gsk988ta; 1 judged");
  EXPECT_EQ(head({failure, failure, alarm}),
            "NO-GO: 2 known failures are stale, 1 entry of the alarm map is stale; GO: basic of "
            "gsk988ta; 1 judged");
  const RunAnswer fails =
      answer({of_feature("a", VerdictKind::fail_geometry, "g94")}, {alarm, alarm});
  EXPECT_EQ(
      fails.head,
      "NO-GO: g94 of gsk988ta fails 1 of 1 case; 2 entries of the alarm map are stale; 0 of 1 "
      "judged are GO");
  EXPECT_EQ(fails.scope.short_head("NO-GO", {failure}),
            "NO-GO \xC2\xB7 g94 of gsk988ta fails 1 of 1 case \xC2\xB7 1 known failure is stale "
            "\xC2\xB7 0 of 1 judged are GO");
}

// J-RUN-01. G74, G84, G86 and G33.1 of RS274/NGC turn the spindle round or stop it in the hole
// (NGC-G84-02, NGC-G86-02, NGC-G331-02); the other dialects have no such cycle.
TEST(RunConditions, CyclesWhoseMFunctionsWereNotComparedAreNamed) {
  const auto not_compared = [](const std::string& subject, const std::string& asked = "[]") {
    return conditions_of(nlohmann::ordered_json::parse(R"({"subject":)" + subject +
                                                       R"(,"selection":{"dialects":)" + asked +
                                                       "}}"))
        .text();
  };
  EXPECT_EQ(not_compared(R"({"features":["blocks"],"dialects":{"rs274":["g81","g84","g74"]}})"),
            "; not compared: M functions (g74, g84 of rs274 pass some on themselves)");
  EXPECT_EQ(not_compared(R"({"features":["blocks"],"dialects":{"rs274":[],"gsk988ta":[]}})"),
            "; not compared: M functions (g33.1, g74, g84, g86 of rs274 pass some on themselves)");
  const std::string all = R"({"features":["blocks"],"dialects":null})";
  EXPECT_EQ(not_compared(all), not_compared(R"({"features":["blocks"],"dialects":{"rs274":[]}})"));
  EXPECT_EQ(not_compared(all, R"(["gsk988ta"])"), "; not compared: M functions");
  EXPECT_EQ(not_compared(R"({"features":["blocks"],"dialects":{"rs274":["g81"]}})"),
            "; not compared: M functions");
  EXPECT_EQ(not_compared(R"({"features":["blocks","m"],"dialects":{"rs274":["g84"]}})"), "");
}

// 5,243 skips and one pass read "5,244 GO" once.
TEST(Tally, ThousandsOfSkipsAreNoneOfThemGo) {
  Tally tally;
  tally.add(of_feature("a", VerdictKind::pass_exact, "g94"));
  for (int i = 0; i < 5'243; ++i) {
    tally.add(of_feature("b" + std::to_string(i), VerdictKind::skip, "basic"));
  }
  const RunAnswer go = tally.finish({});
  EXPECT_EQ(go.judged, 1U);
  EXPECT_EQ(go.head, "GO for g94 of gsk988ta: 1 judged; not claimed: basic (5,243 cases)");
}

}  // namespace
}  // namespace gonogo::oracle
