// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/evidence.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <system_error>

#include "publish/evidence/case_row.hpp"
#include "publish/evidence/junit.hpp"
#include "publish/evidence/sarif.hpp"
#include "publish/evidence/text.hpp"
#include "tests/publish/evidence/results_files.hpp"

namespace gonogo::oracle::evidence {
namespace {

using nlohmann::json;

const std::string kPass =
    R"({"id":"ngc.a.1","dialect":"rs274","cycle":"g1","clauses":[],"verdict":"pass-exact","us":1500000,"attempts":1})";
const std::string kFail =
    R"({"id":"ngc.b.1","dialect":"rs274","cycle":"g1","clauses":[],"verdict":"fail.geometry",)"
    R"("clause":"GSK-G94-02","b":2,"want":"{\"k\":\"rapid\"}","got":"<x>","deviation":{"exact":"1/3","mm":"0.333333333"},)"
    R"("reading":"gsk.x-depth=radius","message":"Ends | elsewhere.","us":2,"attempts":1,"program":"G0 X1\nG0 X2\n","trace":[]})";
const std::string kCrash =
    R"({"id":"ngc.c.1","dialect":"rs274","cycle":"g1","clauses":[],"verdict":"crash","message":"SIGSEGV",)"
    R"("program":{"base64":"R1+90Qo="},"trace":[]})";
const std::string kGap =
    R"({"id":"gsk.d.1","dialect":"gsk988ta","cycle":"g94","clauses":[],"verdict":"oracle-gap","message":"no","program":"G71\n","trace":[]})";
const std::string kExpectedGap =
    R"({"id":"gsk.e.1","dialect":"gsk988ta","cycle":"g94","clauses":[],"verdict":"oracle-gap","expected":true,"message":"no","program":"G71\n","trace":[]})";
const std::string kKnown =
    R"j({"id":"ngc.f.1","dialect":"rs274","cycle":"g1","clauses":[],"verdict":"xfail",)j"
    R"j("message":"x","known":"chords"})j";

// All of them, sorted by id.
std::string all_kinds() {
  return results_text({kGap, kExpectedGap, kPass, kFail, kCrash, kKnown}, "NO-GO");
}

class Evidence : public testing::Test {
 protected:
  void write(const std::string& text) {
    const auto error =
        write_evidence(scratch_.write("in/r.jsonl", text), (scratch_.path() / "out").string());
    ASSERT_FALSE(error) << *error;
  }
  std::string read(const std::string& name) const { return scratch_.read("out/" + name); }
  json sarif() const { return json::parse(read("results.sarif"))["runs"][0]; }
  Scratch scratch_;
};

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST_F(Evidence, ReportFolderHoldsEveryFile) {
  write(all_kinds());
  for (const char* name : {"results.jsonl", "index.html", "junit.xml", "results.sarif",
                           "badge.json", "summary.md", "programs/ngc.b.1.nc"}) {
    EXPECT_TRUE(scratch_.has(std::string("out/") + name)) << name;
  }
  EXPECT_EQ(read("results.jsonl"), all_kinds());
}

TEST_F(Evidence, NoPartOfAFileIsLeft) {
  write(all_kinds());
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch_.path())) {
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
  }
}

TEST_F(Evidence, ProgramsAreThoseThatAreNotGoByteForByte) {
  write(all_kinds());
  EXPECT_EQ(read("programs/ngc.b.1.nc"), "G0 X1\nG0 X2\n");
  EXPECT_EQ(read("programs/ngc.c.1.nc"), "G_\xbd\xd1\n");  // base64 R1+90Qo=
  EXPECT_FALSE(scratch_.has("out/programs/ngc.a.1.nc"));
}

TEST_F(Evidence, ProgramsOfTheRunBeforeAreTakenAwayAndOthersStay) {
  write(all_kinds());
  scratch_.write("out/programs/mine.nc", "M30\n");
  write(results_text({kPass}));
  EXPECT_FALSE(scratch_.has("out/programs/ngc.b.1.nc"));
  EXPECT_TRUE(scratch_.has("out/programs/mine.nc"));
}

TEST_F(Evidence, FaultyResultsAreNotWrittenUp) {
  const auto error = write_evidence(scratch_.write("r.jsonl", results_text({kPass, kPass})),
                                    (scratch_.path() / "out").string());
  ASSERT_TRUE(error);
  EXPECT_NE(error->find("line 3 holds the case ngc.a.1 a second time"), std::string::npos);
  EXPECT_FALSE(scratch_.has("out/index.html"));
  EXPECT_FALSE(scratch_.has("out/junit.xml"));
}

// One a dialect; of rs274: a pass of 1.5 s, a failure of 2 us, a crash, a known failure.
TEST_F(Evidence, JunitHasASuiteADialectWithItsNumbers) {
  write(all_kinds());
  const std::string xml = read("junit.xml");
  EXPECT_NE(xml.find("<testsuite name=\"rs274\" tests=\"4\" failures=\"1\" errors=\"1\" "
                     "skipped=\"1\" time=\"1.500002\">"),
            std::string::npos)
      << xml;
  EXPECT_NE(xml.find("<testsuite name=\"gsk988ta\" tests=\"2\" failures=\"0\" errors=\"0\" "
                     "skipped=\"2\""),
            std::string::npos);
  EXPECT_NE(xml.find("<testsuites name=\"gonogo\" tests=\"6\" failures=\"1\" errors=\"1\" "
                     "skipped=\"3\""),
            std::string::npos);
}

TEST_F(Evidence, JunitSaysThatARunIsIncomplete) {
  write(std::string(kHeaderLine) + "\n" + kPass + "\n");
  EXPECT_NE(read("junit.xml").find("<error type=\"incomplete\""), std::string::npos);
}

// A run whose cases are all GO, NO-GO for what its own files say.
std::string stale_run() {
  std::string text = results_text({kPass}, "NO-GO");
  const std::string from = R"("assignments":[])";
  return text.replace(text.find(from), from.size(),
                      from + R"(,"stale":["known failure a <b>: no case has this id",)"
                             R"("alarm map E9: no case met it"])");
}

TEST_F(Evidence, AStaleEntryIsAnErrorOfTheRunInJunit) {
  write(stale_run());
  const std::string xml = read("junit.xml");
  EXPECT_NE(xml.find("<testsuites name=\"gonogo\" tests=\"3\" failures=\"0\" errors=\"2\""),
            std::string::npos)
      << xml;
  EXPECT_NE(xml.find("<testsuite name=\"run\" tests=\"2\" failures=\"0\" errors=\"2\""),
            std::string::npos);
  EXPECT_NE(xml.find("name=\"known failure a &lt;b&gt;: no case has this id\""), std::string::npos);
  EXPECT_EQ(occurrences(xml, "<error type=\"stale\" message=\"An entry of the subject"), 2U);
}

TEST_F(Evidence, AStaleEntryIsAResultOfSarif) {
  write(stale_run());
  const json run = sarif();
  ASSERT_EQ(run["results"].size(), 2U);
  const json& result = run["results"][0];
  EXPECT_EQ(result["ruleId"], "stale");
  EXPECT_EQ(result["level"], "error");
  EXPECT_EQ(result["message"]["text"],
            "An entry of the subject's files is stale: known failure a <b>: no case has this id");
  EXPECT_EQ(result["locations"][0]["logicalLocations"][0]["name"],
            "known failure a <b>: no case has this id");
  EXPECT_NE(result["partialFingerprints"], run["results"][1]["partialFingerprints"]);
  EXPECT_EQ(run["tool"]["driver"]["rules"][0]["id"], "stale");
  // As for any other NO-GO.
  EXPECT_EQ(run["invocations"][0]["executionSuccessful"], true);
}

TEST_F(Evidence, AStaleEntryIsWhatTheBadgeAndTheSummarySayFirst) {
  write(stale_run());
  EXPECT_EQ(json::parse(read("badge.json"))["message"],
            "NO-GO \u00b7 1 known failure is stale, 1 entry of the alarm map is stale \u00b7 1 "
            "judged");
  EXPECT_NE(read("summary.md")
                .find("NO-GO: 1 known failure is stale, 1 entry of the alarm map is "
                      "stale; 1 judged"),
            std::string::npos);
}

// The page is longer than this, and the other views are not.
TEST_F(Evidence, NoViewOfAnotherRunStaysWhereADiskIsFull) {
  write(all_kinds());
  const std::string next = scratch_.write("in/next.jsonl", results_text({kPass}));
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{1U << 15, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(write_evidence(next, (scratch_.path() / "out").string()), std::system_error);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_FALSE(scratch_.has("out/index.html"));
  EXPECT_EQ(read("results.jsonl"), results_text({kPass}));
  EXPECT_EQ(json::parse(read("badge.json"))["message"], "GO \u00b7 1 judged");
}

TEST(Junit, EveryVerdictHasItsPlace) {
  const std::map<std::string, JunitMark> places = {
      {"crash", JunitMark::error},           {"timeout", JunitMark::error},
      {"out-of-memory", JunitMark::error},   {"protocol", JunitMark::error},
      {"oracle-error", JunitMark::error},    {"skip", JunitMark::skipped},
      {"oracle-gap", JunitMark::skipped},    {"xfail", JunitMark::skipped},
      {"pass-exact", JunitMark::passed},     {"pass-rounded", JunitMark::passed},
      {"pass-tolerance", JunitMark::passed}, {"pass-properties", JunitMark::passed},
      {"advice", JunitMark::skipped}};
  for (std::string_view verdict : verdict_names()) {
    CaseRow row;
    row.kind = *verdict_kind(verdict);
    const auto place = places.find(std::string(verdict));
    EXPECT_EQ(junit_mark(row), place == places.end() ? JunitMark::failure : place->second)
        << verdict;
  }
}

TEST_F(Evidence, SarifTellsFailuresUndecidedAndKnownFailures) {
  write(all_kinds());
  std::map<std::string, json> by_case;
  const json run = sarif();
  for (const json& result : run["results"]) {
    by_case[result["properties"]["case"]] = result;
  }
  ASSERT_EQ(by_case.size(), 4U);  // neither the pass nor the gap that is expected
  EXPECT_EQ(by_case["ngc.b.1"]["level"], "error");
  EXPECT_EQ(by_case["gsk.d.1"]["kind"], "open");
  EXPECT_EQ(by_case["gsk.d.1"]["level"], "none");
  EXPECT_EQ(by_case["ngc.f.1"]["suppressions"][0]["justification"], "chords");
}

TEST_F(Evidence, SarifRuleIsTheClauseWithItsDocumentOrTheVerdict) {
  write(all_kinds());
  const json run = sarif();
  const json& rules = run["tool"]["driver"]["rules"];
  for (const json& result : run["results"]) {
    EXPECT_EQ(rules[result["ruleIndex"].get<std::size_t>()]["id"], result["ruleId"]);
  }
  bool found = false;
  for (const json& rule : rules) {
    if (rule["id"] != "GSK-G94-02") continue;
    found = true;
    EXPECT_EQ(rule["properties"]["document"], "GSK 988TA programming, G94 radial cutting cycle");
    EXPECT_NE(rule["shortDescription"]["text"].get<std::string>().find("Traverse from A to B"),
              std::string::npos);
  }
  EXPECT_TRUE(found);
}

TEST_F(Evidence, SarifPointsToTheLineOfTheProgram) {
  write(all_kinds());
  const json run = sarif();
  for (const json& result : run["results"]) {
    if (result["properties"]["case"] != "ngc.b.1") continue;
    const json& place = result["locations"][0]["physicalLocation"];
    EXPECT_EQ(place["artifactLocation"]["uri"], "programs/ngc.b.1.nc");
    EXPECT_EQ(place["region"]["startLine"], 2);
    const std::string message = result["message"]["text"];
    EXPECT_NE(message.find("Got: <x>"), std::string::npos);
    EXPECT_NE(message.find("0.333333333 mm (exactly 1/3)"), std::string::npos);
    EXPECT_NE(message.find("GO under the reading: gsk.x-depth=radius"), std::string::npos);
  }
}

// The fingerprint depends on case and rule: a new deviation is the same finding.
TEST_F(Evidence, SarifFingerprintSurvivesOtherNumbers) {
  write(results_text({kFail}, "NO-GO"));
  const json before = sarif()["results"][0]["partialFingerprints"];
  std::string moved = kFail;
  moved.replace(moved.find("1/3"), 3, "2/3");
  write(results_text({moved}, "NO-GO"));
  EXPECT_EQ(sarif()["results"][0]["partialFingerprints"], before);
  std::string other = kFail;
  other.replace(other.find("GSK-G94-02"), 10, "GSK-G94-03");
  write(results_text({other}, "NO-GO"));
  EXPECT_NE(sarif()["results"][0]["partialFingerprints"], before);
}

TEST_F(Evidence, BadgeIsGreenForGoAndRedWithTheNumberForNoGo) {
  write(results_text({kPass}));
  json badge = json::parse(read("badge.json"));
  EXPECT_EQ(badge["schemaVersion"], 1);
  EXPECT_EQ(badge["message"], "GO \u00b7 1 judged");
  EXPECT_EQ(badge["color"], "brightgreen");
  write(all_kinds());
  badge = json::parse(read("badge.json"));
  EXPECT_EQ(badge["message"], "NO-GO \u00b7 1 of 3 judged is GO, 1 known to fail");
  EXPECT_EQ(badge["color"], "red");
}

// J-RUN-01: what was granted, and which part it is, stands in the badge, and it is not green.
TEST_F(Evidence, BadgeIsNotGreenForAPartOrForWhatWasGranted) {
  const auto badge_with = [&](const std::string& from, const std::string& to) {
    std::string text = results_text({kPass});
    text.replace(text.find(from), from.size(), to);
    write(text);
    return json::parse(read("badge.json"));
  };
  json badge = badge_with(R"("tolerance":null)", R"("tolerance":"1000")");
  EXPECT_EQ(badge["message"], "GO \u00b7 1 judged \u00b7 tolerance 1000 mm");
  EXPECT_EQ(badge["color"], "yellowgreen");
  badge = badge_with(R"("shard":"1/1")", R"("shard":"1/300","selection":{"case":"ngc.a.1"})");
  EXPECT_EQ(badge["message"], "GO \u00b7 1 judged \u00b7 shard 1/300, case ngc.a.1");
  EXPECT_EQ(badge["color"], "yellowgreen");
  badge = badge_with(R"("features":["blocks","m"])", R"("features":["blocks"])");
  EXPECT_EQ(badge["message"], "GO \u00b7 1 judged \u00b7 without M functions");
  EXPECT_EQ(badge["color"], "yellowgreen");
  EXPECT_NE(read("summary.md").find("**GO: 1 judged; not compared: M functions**"),
            std::string::npos);
}

// `error` to everything and a file of known failures made it "GO: 99 judged", and green.
TEST_F(Evidence, KnownFailuresAloneAreNoGo) {
  write(results_text({kKnown}, "UNDECIDED"));
  const json badge = json::parse(read("badge.json"));
  EXPECT_EQ(badge["message"], "UNDECIDED \u00b7 0 judged, 1 known to fail");
  EXPECT_EQ(badge["color"], "yellow");
}

const std::string kSkip =
    R"({"id":"ngc.s.1","dialect":"rs274","cycle":"g2","features":["arc"],"clauses":[],"verdict":"skip",)"
    R"("feature":"arc","message":"The subject does not declare arc in rs274."})";
const std::string kAdvice =
    R"({"id":"ngc.t.1","dialect":"rs274","cycle":"g1","features":["basic"],"clauses":[],"verdict":"advice",)"
    R"("departure":"fail.alarm-missing","clause":"NGC-G0-01","basis":"silent","b":1,)"
    R"("message":"No alarm came.","program":"G0 X1\n","trace":[]})";
const std::string kDeclared =
    R"({"id":"ngc.u.1","dialect":"rs274","cycle":"g1","features":["basic"],"clauses":[],)"
    R"("verdict":"fail.declaration","message":"It declares basic, and skips it.","program":"G0 X1\n","trace":[]})";

// J-RUN-01, J-RUN-05.
TEST_F(Evidence, ASkipIsNotGreenAndIsToldEverywhere) {
  write(results_text({kPass, kSkip}));
  const json badge = json::parse(read("badge.json"));
  EXPECT_EQ(badge["message"], "GO \u00b7 1 judged, 1 not claimed");
  EXPECT_EQ(badge["color"], "yellowgreen");
  const std::string summary = read("summary.md");
  EXPECT_NE(summary.find("**GO: 1 judged; not claimed: arc (1 case)**"), std::string::npos)
      << summary;
  EXPECT_NE(summary.find("| skip | neither | 1 |"), std::string::npos) << summary;
  EXPECT_NE(summary.find("- arc: 1 case of rs274"), std::string::npos) << summary;
  const std::string junit = read("junit.xml");
  EXPECT_NE(
      junit.find("<property name=\"head\" value=\"GO: 1 judged; not claimed: arc (1 case)\"/>"),
      std::string::npos)
      << junit;
}

// J-RUN-04, J-RUN-14: a note, a skipped test case, a group of its own; never a failure.
TEST_F(Evidence, AnAdviceIsListedAndIsNoFailure) {
  write(results_text({kPass, kAdvice}));
  EXPECT_EQ(json::parse(read("badge.json"))["message"], "GO \u00b7 1 judged, 1 advice");
  const std::string junit = read("junit.xml");
  EXPECT_NE(junit.find("tests=\"2\" failures=\"0\" errors=\"0\" skipped=\"1\""), std::string::npos);
  EXPECT_NE(junit.find("<skipped message=\"advice (fail.alarm-missing): No alarm came.\"/>"),
            std::string::npos)
      << junit;
  const json results = sarif()["results"];
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results[0]["level"], "note");
  EXPECT_EQ(results[0]["properties"]["departure"], "fail.alarm-missing");
  EXPECT_EQ(results[0]["properties"]["basis"], "silent");
  const std::string summary = read("summary.md");
  EXPECT_NE(summary.find("- `NGC-G0-01`, would be fail.alarm-missing, 1 case: "), std::string::npos)
      << summary;
  EXPECT_EQ(summary.find("## Findings"), std::string::npos);
  EXPECT_EQ(read("programs/ngc.t.1.nc"), "G0 X1\n");
}

// J-RUN-04: what a text would make of it is asked of an advice alone.
TEST_F(Evidence, SarifSaysOfAnAdviceAloneWhatATextWouldMakeOfIt) {
  std::string known = kKnown;
  known.insert(known.size() - 1, R"(,"departure":"fail.order","program":"G0 X1\n","trace":[])");
  write(results_text({known, kAdvice}));
  const json run = sarif();
  ASSERT_EQ(run["results"].size(), 2U);
  const auto message = [&](std::size_t i) {
    return run["results"][i]["message"]["text"].get<std::string>();
  };
  EXPECT_NE(message(0).find("\nIt is known to fail with fail.order: chords"), std::string::npos)
      << message(0);
  EXPECT_EQ(message(0).find("if a text"), std::string::npos);
  EXPECT_NE(message(1).find("\nIt would be fail.alarm-missing if a text of the manual stated it."),
            std::string::npos)
      << message(1);
}

TEST_F(Evidence, WhatIsDeclaredAndSkippedIsListed) {
  write(results_text({kPass, kDeclared}, "NO-GO"));
  const std::string summary = read("summary.md");
  EXPECT_NE(summary.find("declared, but skipped: g1 of rs274 (1 case)"), std::string::npos)
      << summary;
  EXPECT_NE(summary.find("## Declared, but skipped"), std::string::npos) << summary;
}

TEST_F(Evidence, SummaryHasDecisionTotalsFailuresAndCommands) {
  write(all_kinds());
  const std::string text = read("summary.md");
  EXPECT_TRUE(text.starts_with("# NO-GO: acme 3.2\n")) << text;
  EXPECT_NE(text.find("| fail.geometry | NO-GO | 1 |"), std::string::npos) << text;
  EXPECT_NE(text.find("gonogo certify --subject 'pipe:./acme --fast' --case ngc.b.1\n"),
            std::string::npos);
  EXPECT_NE(text.find("Ends \\| elsewhere."), std::string::npos);
  EXPECT_NE(text.find("1 x oracle-gap, smallest: gsk.d.1"), std::string::npos) << text;
  EXPECT_EQ(text.find("gsk.e.1"), std::string::npos);
  EXPECT_NE(text.find("## What this run did not check"), std::string::npos);
}

TEST_F(Evidence, SummarySaysThatARunIsIncomplete) {
  write(std::string(kHeaderLine) + "\n" + kPass + "\n");
  EXPECT_TRUE(read("summary.md").starts_with("# INCOMPLETE: acme 3.2\n"));
}

TEST_F(Evidence, JunitNamesEachFindingOnceASuiteAndAtEachOfItsCases) {
  std::vector<std::string> lines;
  for (int i = 10; i < 13; ++i) {
    std::string line = kFail;
    line.replace(line.find("ngc.b.1"), 7, "ngc.b." + std::to_string(i));
    lines.push_back(line);
  }
  write(results_text(lines, "NO-GO"));
  const std::string junit = read("junit.xml");
  EXPECT_EQ(occurrences(junit, "<property name=\"finding\" value=\"3 x fail.geometry"), 1U);
  EXPECT_EQ(occurrences(junit, "\nfinding    fail.geometry"), 3U);
}

TEST_F(Evidence, SarifNamesProgramsFromTheReportAndExplainsEachRule) {
  write(all_kinds());
  const json run = json::parse(read("results.sarif"))["runs"][0];
  EXPECT_TRUE(run["originalUriBaseIds"].contains("REPORT"));
  for (const json& rule : run["tool"]["driver"]["rules"]) {
    EXPECT_FALSE(rule["help"]["text"].get<std::string>().empty()) << rule;
  }
}

// An address of the pages is given, and is not.
TEST_F(Evidence, SarifLinksToThePagesOnlyWhereTheyCanBeRead) {
  write(all_kinds());
  const auto driver = [&](std::string_view address) {
    SarifWriter sarif(scratch_.path() / "out/own.sarif", json::object(), address);
    CaseRow row;
    row.id = "gsk.g94.000001";
    row.dialect = "gsk988ta";
    row.kind = VerdictKind::fail_geometry;
    row.clause = "GSK-G94-02";
    sarif.add(row, nullptr);
    sarif.finish("");
    return json::parse(read("own.sarif"))["runs"][0]["tool"]["driver"];
  };
  const json linked = driver("https://example.org/gonogo");
  EXPECT_EQ(linked["informationUri"], "https://example.org/gonogo");
  EXPECT_EQ(linked["rules"][0]["helpUri"],
            "https://example.org/gonogo/docs/dialects/gsk988ta.md#gsk-g94-02");
  const json alone = driver("");
  EXPECT_FALSE(alone.contains("informationUri"));
  EXPECT_FALSE(alone["rules"][0].contains("helpUri"));
}

TEST_F(Evidence, SummaryNamesAFindingOnceWithItsSmallestCase) {
  std::vector<std::string> lines;
  for (int i = 10; i < 25; ++i) {
    std::string line = kFail;
    line.replace(line.find("ngc.b.1"), 7, "ngc.b." + std::to_string(i));
    lines.push_back(line);
  }
  write(results_text(lines, "NO-GO"));
  EXPECT_EQ(occurrences(read("summary.md"), "\n### "), 1U);
  EXPECT_NE(read("summary.md").find("### 15 x fail.geometry"), std::string::npos);
}

TEST(CaseRow, SaysWhatEarlierLinesLeaveInForce) {
  nlohmann::ordered_json line = {{"id", "a"},
                                 {"dialect", "rs274"},
                                 {"verdict", "fail.alarm-spurious"},
                                 {"program", "G91\nG81 X1 Z-5 R2\nX1\n"},
                                 {"b", 3U}};
  const std::string told =
      "G81 of line 2 (NGC-MOD-01); Z-5 R2 of line 2 (NGC-CYC-03); G91 of line 1 (NGC-DIS-01)";
  EXPECT_EQ(in_force_of(case_row(line)), told);
  line.erase("b");  // then it is the line of what is wanted
  EXPECT_EQ(in_force_of(case_row(line)), "");
  line["want"] = R"({"k":"rapid","b":3})";
  EXPECT_EQ(in_force_of(case_row(line)), told);
  line["verdict"] = "pass-exact";
  EXPECT_EQ(in_force_of(case_row(line)), "");
}

TEST(EvidenceText, FileStemOfAnUnsafeIdStaysInItsFolder) {
  EXPECT_EQ(file_stem("gsk.g94.000001"), "gsk.g94.000001");
  for (const char* id :
       {"../../etc/passwd", "/etc/passwd", ".", "..", "", ".hidden", "a/b", "a b", "-rf", "\xff"}) {
    const std::string stem = file_stem(id);
    EXPECT_EQ(stem.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                     "0123456789._-"),
              std::string::npos)
        << id;
    EXPECT_NE(stem.front(), '.') << id;
    EXPECT_NE(stem.front(), '-') << id;
  }
  EXPECT_NE(file_stem("a/b"), file_stem("a_b"));
  EXPECT_NE(file_stem("a/b"), file_stem("a b"));
  EXPECT_LE(file_stem(std::string(5'000, 'x')).size(), 120U);
}

TEST(EvidenceText, MarkdownFencesCannotBeClosedFromInside) {
  EXPECT_EQ(markdown_fence("a\n```\nb"), "````\na\n```\nb\n````\n");
  EXPECT_EQ(markdown_code("a`b"), "`` a`b ``");
}

TEST(EvidenceText, NumbersAreGroupedByThree) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1'000), "1,000");
  EXPECT_EQ(grouped(1'234'567), "1,234,567");
}

}  // namespace
}  // namespace gonogo::oracle::evidence
