// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-RUN-13: no word of a header or of a pass is believed that cannot be derived.
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "publish/evidence/verify_cases.hpp"
#include "publish/evidence/verify_parts.hpp"
#include "reference/profile.hpp"
#include "tests/publish/evidence/results_files.hpp"

namespace gonogo::oracle::evidence {
namespace {

// J-RUN-13: what the header says and its command line does, by value.
TEST(HeaderFaults, AreOfValuesAndNotOfTheirSpelling) {
  const auto faults = [](const std::string& told, const std::string& words) {
    return header_faults(
        Json::parse("{" + told + R"("shard":"1/1","argv":["certify",)" + words + "]}"));
  };
  EXPECT_TRUE(faults(R"("strict":true,)", R"("--strict=true")").empty());
  EXPECT_TRUE(faults(R"("strict":true,)", R"("--strict=no","--strict")").empty());
  EXPECT_TRUE(faults("", R"("--strict=false")").empty());
  EXPECT_EQ(faults(R"("strict":true,)", R"("--strict=0")").size(), 1U);
  EXPECT_EQ(faults("", R"("--strict=on")").size(), 1U);
  EXPECT_TRUE(faults(R"("seed":7,)", R"("--seed","007")").empty());
  EXPECT_EQ(faults(R"("seed":8,)", R"("--seed","007")").size(), 1U);
  EXPECT_TRUE(faults(R"("feed_tolerance":"5",)", R"("--feed-tolerance","5.0")").empty());
  EXPECT_EQ(faults("", R"("--feed-tolerance","300")").size(), 1U);
  EXPECT_EQ(faults(R"("feed_tolerance":"5",)", R"("--fail-fast")").size(), 1U);
  EXPECT_TRUE(faults(R"("show_ids":true,)", R"("--show-ids")").empty());
  EXPECT_EQ(faults("", R"("--show-ids")").size(), 1U);
}

// Two shards that show names, merged.
Json merged_header() {
  return Json::parse(
      R"({"show_ids":true,"shard":"1/1","seed":0,"argv":["merge","a","b"],"shards":[)"
      R"({"shard":"1/2","seed":7,"argv":["certify","--show-ids","--shard","1/2"],"fresh":{}},)"
      R"({"shard":"2/2","seed":8,"argv":["certify","--show-ids","--shard=2/2"],"fresh":{}}]})");
}

// J-RUN-13: of a merged run each shard has its command line.
TEST(HeaderFaults, AreOfEachShardOfAMergedRun) {
  EXPECT_TRUE(header_faults(merged_header()).empty());
  const auto faults_with = [](const char* place, const Json& value) {
    Json header = merged_header();
    header[Json::json_pointer(place)] = value;
    return header_faults(header).size();
  };
  const Json granted = {"certify", "--show-ids", "--shard", "2/2", "--chord", "1"};
  EXPECT_EQ(faults_with("/show_ids", false), 2U);
  EXPECT_EQ(faults_with("/shards/1/argv", granted), 1U);
  EXPECT_EQ(faults_with("/shards/1/argv", Json::array()), 1U);
  // Out of its place, and not as it was asked.
  EXPECT_EQ(faults_with("/shards/1/shard", "1/2"), 2U);
  EXPECT_EQ(faults_with("/shards/1/x", 1), 1U);
  EXPECT_EQ(faults_with("/shard", "1/2"), 1U);
  EXPECT_EQ(faults_with("/seed", 7), 1U);
  EXPECT_EQ(faults_with("/shards", Json::array()), 1U);
  EXPECT_EQ(faults_with("/argv", Json::array({"certify", "--show-ids"})), 1U);
  // One of two: its own i/n is then not 1/1.
  EXPECT_GT(faults_with("/shards", Json::array({merged_header()["shards"][0]})), 0U);
}

TEST(HeaderFaults, NoCommandLineIsOne) {
  EXPECT_EQ(header_faults(Json::parse(R"({"shard":"1/1"})")).size(), 1U);
  EXPECT_EQ(header_faults(Json::parse(R"({"shard":"1/1","argv":["report","x"]})")).size(), 1U);
}

TEST(HeaderFaults, AreOfKeysThatNoHeaderHas) {
  for (const char* surplus : {R"({"x":1})", R"({"subject":{"x":1}})", R"({"gauge/commit":"1"})"}) {
    Json header = Json::parse(R"({"shard":"1/1","argv":["certify"]})");
    header.update(Json::parse(surplus));
    EXPECT_EQ(header_faults(header).size(), 1U) << surplus;
  }
}

// A run of what failed adds cases to those that are asked for, and changes nothing else.
TEST(HeaderFaults, AreOfTheSelectionAlsoWhereFailedCasesAreAdded) {
  const auto faults = [](const std::string& selection, const std::string& words) {
    return header_faults(Json::parse(R"({"selection":)" + selection + R"(,"shard":"1/1","argv":[)" +
                                     R"("certify","--failed-of","old")" + words + "]}"))
        .size();
  };
  EXPECT_EQ(faults(R"({"case":"a.1"})", ""), 0U);
  EXPECT_EQ(faults(R"({"cases":["a.1","a.2"]})", R"(,"--case","a.1")"), 0U);
  EXPECT_EQ(faults(R"({"cases":["a.3","a.2"]})", R"(,"--case","a.1")"), 1U);
  EXPECT_EQ(faults(R"({"case":null})", ""), 1U);
  EXPECT_EQ(faults(R"({"case":"a.1","only":["a.*"]})", ""), 1U);
}

// The line of a pass, in a run of that shard; the program makes one motion, and so does its trace.
class PassLine : public testing::Test {
 protected:
  std::string fault(const std::string& more, const std::string& shard = "1/1") const {
    Case test;
    test.id = "a.1";
    test.dialect = "rs274";
    test.program = "G0 X1\nM2\n";
    test.profile = std::get<reference::Profile>(reference::default_profile("rs274"));
    Json header = Json::parse(kHeaderLine);
    header["format"] = 2U;
    header["shard"] = shard;
    scratch_.write("a.1.jsonl", R"({"k":"rapid","b":1,"to":{"x":"1"}})"
                                "\n"
                                R"({"k":"m","b":2,"m":2})"
                                "\n");
    VerdictsAgain again(header, scratch_.path().string(), {});
    again.take(Json::parse(R"({"id":"a.1","dialect":"rs274","cycle":"basic","clauses":[],)"
                           R"("verdict":"pass-exact","coordinates":{"exact":1})" +
                           more + "}"),
               &test);
    Findings findings;
    again.tell(findings);
    const std::vector<Check> checks = findings.take();
    return checks.front().result == Check::Result::fails ? checks.front().sentence : "";
  }

 private:
  Scratch scratch_;
};

// J-RUN-13: what a pass says besides is derived, or no pass says it.
TEST_F(PassLine, HasNoWordThatNoRunWrites) {
  EXPECT_EQ(fault(""), "");
  const std::string trace = R"(,"trace":[{"k":"rapid","b":1,"to":{"x":"7"}}])";
  const std::string readings =
      R"(,"readings":{"open":["ngc.whole"],"explaining":[],"verdict":"pass-exact"})";
  EXPECT_EQ(fault(R"(,"known":"by design")"), "a.1: a pass has no known.");
  EXPECT_EQ(fault(R"(,"sampled":{"samples":5})"), "a.1: pass-exact has no sampled.");
  EXPECT_EQ(fault(trace), "a.1: pass-exact has no trace.");
  EXPECT_EQ(fault(R"(,"program":"G0 X1\nM2\n")"), "a.1: pass-exact has no program.");
  EXPECT_EQ(fault(R"(,"readings":{"explaining":[],"verdict":"pass-exact","x":"y"})"),
            "a.1: readings has no key x.");
  // No reading is open in it.
  EXPECT_EQ(fault(readings), "a.1: the trace leaves other readings open than the line says.");
}

// Only the readings of the other shards may make it a failure.
TEST_F(PassLine, OfAShardHasNoTraceWhereNoReadingIsOpen) {
  EXPECT_EQ(fault(R"(,"trace":[])", "1/2"), "a.1: pass-exact has no trace.");
}

}  // namespace
}  // namespace gonogo::oracle::evidence
