// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/site/site.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <system_error>

#include "campaign/results_reader.hpp"
#include "publish/report/escape.hpp"
#include "publish/site/run.hpp"
#include "tests/publish/evidence/results_files.hpp"

namespace gonogo::oracle::site {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string line(const std::string& id, const std::string& verdict, const std::string& rest = "") {
  return fmt::format(
      R"({{"id":"{}","dialect":"rs274","cycle":"g81","clauses":["NGC-G81-01"],"verdict":"{}"{}}})",
      id, verdict, rest);
}

// Departs at the clause by so much.
std::string departure(const std::string& id, const std::string& by,
                      const std::string& verdict = "fail.geometry") {
  return line(id, verdict,
              fmt::format(R"(,"clause":"NGC-G81-01","b":2,"want":"{{\"k\":\"feed\"}}",)"
                          R"("got":"{{\"k\":\"rapid\"}}","deviation":{{"exact":"{0}","mm":"{0}"}},)"
                          R"("message":"It goes elsewhere.","us":7,"attempts":1,)"
                          R"("program":"G81 X1\n","trace":[])",
                          by));
}

class Site : public testing::Test {
 protected:
  // Results of a version of a subject.
  Source results(const std::string& name, const std::string& version,
                 const std::vector<std::string>& cases) {
    std::string text = results_text(cases);
    replace(text, R"("name":"acme","version":"3.2")",
            fmt::format(R"("name":"{}","version":"{}")", name, version));
    return {scratch_.write(fmt::format("{}-{}-{}.jsonl", name.size(), version, ++files_), text), "",
            ""};
  }
  static void replace(std::string& text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, what.size(), with);
  }
  SiteOptions options(std::vector<Source> sources, const std::string& out = "site") {
    return {std::move(sources), (scratch_.path() / out).string(), "Title", true, {}};
  }
  std::map<std::string, std::string> files_of(const std::string& out) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(scratch_.path() / out)) {
      if (!entry.is_regular_file()) continue;
      const std::string name = fs::relative(entry.path(), scratch_.path()).string();
      files[name.substr(out.size() + 1)] = scratch_.read(name);
    }
    return files;
  }
  static std::string why_not(const SiteOptions& options) {
    try {
      write_site(options);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
  Scratch scratch_;
  int files_ = 0;
};

TEST_F(Site, CountsOfEachRunAreThoseOfItsLines) {
  const Gathered all =
      gather({results("acme", "1",
                      {line("a", "pass-exact"), departure("b", "1"), line("c", "skip"),
                       line("d", "oracle-gap"), line("e", "pass-rounded")})},
             {});
  ASSERT_EQ(all.runs.size(), 1U);
  const Counts& counts = all.runs[0].counts;
  EXPECT_EQ(counts[Outcome::go], 2U);
  EXPECT_EQ(counts[Outcome::no_go], 1U);
  EXPECT_EQ(counts[Outcome::skip], 1U);
  EXPECT_EQ(counts[Outcome::undecided], 1U);
  EXPECT_EQ(counts.cases(), 5U);
  EXPECT_EQ(counts.answered(), 3U);
  const ClauseCounts& clause = all.runs[0].clauses.at("NGC-G81-01");
  EXPECT_EQ(clause.passed, 2U);
  EXPECT_EQ(clause.departed, 1U);
  EXPECT_EQ(clause.undecided, 1U);
}

TEST_F(Site, DepartureOfTwoRunsIsToldOnceWithBoth) {
  const Gathered all = gather({results("a", "1", {departure("x", "1"), departure("y", "2")}),
                               results("b", "1", {departure("y", "3"), departure("z", "4")}),
                               results("c", "1", {line("x", "pass-exact")})},
                              {});
  ASSERT_EQ(all.departures.list().size(), 1U);
  const Departure& departure = *all.departures.list()[0];
  EXPECT_EQ(departure.cases, 3U);  // y is one case
  ASSERT_EQ(departure.shares.size(), 2U);
  EXPECT_EQ(departure.shares.at(0).cases, 2U);
  EXPECT_EQ(departure.shares.at(1).first, "y");
}

TEST_F(Site, KnownFailureIsTheSameDepartureAsAnUnknownOne) {
  const std::string known = line(
      "x", "xfail",
      R"x(,"departure":"fail.geometry","clause":"NGC-G81-01","b":2,"want":"{\"k\":\"feed\"}",)x"
      R"x("got":"{\"k\":\"rapid\"}","deviation":{"exact":"1","mm":"1"},)x"
      R"x("message":"Known: it rounds (down) (fail.geometry: It goes elsewhere.)")x");
  const Gathered all =
      gather({results("a", "1", {known}), results("b", "1", {departure("x", "1")})}, {});
  ASSERT_EQ(all.departures.list().size(), 1U);
  const Departure& departure = *all.departures.list()[0];
  EXPECT_EQ(departure.shares.at(0).known, 1U);
  EXPECT_EQ(departure.shares.at(1).known, 0U);
  ASSERT_EQ(all.runs[0].reasons.size(), 1U);
  EXPECT_EQ(all.runs[0].reasons.begin()->first, "it rounds (down)");
  EXPECT_TRUE(all.runs[0].reasons.begin()->second.verdicts.contains("fail.geometry"));
  EXPECT_EQ(all.votes.ballots().at(Ballot::against), 1U);
}

TEST_F(Site, VersionsAreInTheOrderInWhichPeopleCount) {
  const auto go = std::vector{line("a", "pass-exact")};
  const Gathered all = gather({results("acme", "10", go), results("b", "1", go),
                               results("acme", "9", go), results("acme", "9.1", go)},
                              {});
  std::vector<std::string> titles;
  for (const auto& run : all.runs) titles.push_back(run.title());
  EXPECT_EQ(titles, (std::vector<std::string>{"acme 9", "acme 9.1", "acme 10", "b 1"}));
  EXPECT_EQ(all.voters, (std::vector<std::size_t>{2, 3}));
  ASSERT_EQ(all.steps.size(), 2U);
}

TEST_F(Site, StepTellsWhatIsLostMendedAndMoved) {
  const Gathered all =
      gather({results("acme", "1",
                      {line("a", "pass-exact"), departure("b", "1"), departure("c", "1"),
                       departure("d", "1"), line("e", "skip"), line("f", "pass-exact")}),
              results("acme", "2",
                      {departure("a", "1"), line("b", "pass-exact"), departure("c", "2"),
                       departure("d", "1"), departure("e", "1"), line("f", "advice")})},
             {});
  ASSERT_EQ(all.steps.size(), 1U);
  const Step& step = all.steps[0];
  EXPECT_EQ(step.lost.first, (std::vector<std::string>{"a", "f"}));  // J-RUN-16
  EXPECT_EQ(step.mended.first, std::vector<std::string>{"b"});
  EXPECT_EQ(step.moved.first, std::vector<std::string>{"c"});
  EXPECT_EQ(step.compared, 5U);  // e was skipped
}

TEST_F(Site, SlowestCasesAndRateAreThoseOfTheLines) {
  std::vector<std::string> cases;
  for (int i = 0; i < 20; ++i) {
    cases.push_back(line(fmt::format("c{:02}", i), "pass-exact",
                         fmt::format(R"(,"us":{},"attempts":1)", 100 * (i + 1))));
  }
  const Gathered all = gather({results("acme", "1", cases)}, {});
  const Speed& speed = all.runs[0].speed;
  ASSERT_EQ(speed.slowest().size(), 10U);
  EXPECT_EQ(speed.slowest().front().id, "c19");
  EXPECT_EQ(speed.slowest().back().id, "c10");
  EXPECT_EQ(speed.microseconds(), 21'000U);
  EXPECT_NEAR(speed.rate(), 20 / 0.021, 1e-6);
  // The tenth of twenty took 1,000; a class of times is a twelfth wide.
  EXPECT_GT(speed.below(50), 1'000U);
  EXPECT_LE(speed.below(50), 1'090U);
}

TEST_F(Site, SameResultsGiveTheSameBytesInWhateverOrder) {
  std::vector<Source> sources = {
      results("a", "1", {departure("x", "1"), departure("y", "2")}),
      results("a", "2", {departure("x", "1"), line("y", "pass-exact")}),
      results("b", "1", {line("x", "pass-exact"), departure("y", "2")}),
  };
  write_site(options(sources, "one"));
  std::ranges::reverse(sources);
  write_site(options(sources, "two"));
  EXPECT_EQ(files_of("one"), files_of("two"));
  EXPECT_EQ(files_of("one").size(), 8U + 3U);
}

TEST_F(Site, TextOfResultsStaysText) {
  const std::string evil = R"(<img src=x onerror=alert(1)>&\"')";
  write_site(options(
      {results("a", "1", {line("x", "crash", R"(,"clause":"<b>","message":")" + evil + "\"")}),
       results("<script>alert(2)</script>", "1", {line("x", "pass-exact")})}));
  for (const auto& [file, text] : files_of("site")) {
    if (!file.ends_with(".html") || file.starts_with("runs/")) continue;
    EXPECT_EQ(text.find("<img"), std::string::npos) << file;
    EXPECT_EQ(text.find("<script>alert"), std::string::npos) << file;
    EXPECT_EQ(text.find("<b>"), std::string::npos) << file;
  }
}

TEST_F(Site, JsonHasTheNumbersOfThePages) {
  write_site(options({results("a", "1", {departure("x", "1"), line("y", "pass-exact")}),
                      results("b", "1", {departure("x", "1"), line("y", "pass-exact")})}));
  const Json json = Json::parse(scratch_.read("site/site.json"));
  EXPECT_EQ(json["format"], 1);
  EXPECT_EQ(json["cases"], 2);
  EXPECT_EQ(json["runs"][0]["counts"]["go"], 1);
  EXPECT_EQ(json["departures"][0]["runs"].size(), 2U);
  EXPECT_EQ(json["vote"]["ballots"]["against"], 1);
  EXPECT_EQ(json["vote"]["pairs"][0]["depart_alike"], 1);
  EXPECT_NE(scratch_.read("site/summary.md").find("| a | 1 | 2 | 1 | 0 | 0 | 0 | 1 | 0 | 0 |"),
            std::string::npos);
}

// ---- what makes no site ----

TEST_F(Site, ResultsWithoutFooterAreRefusedUnlessPartial) {
  Source source = results("a", "1", {line("x", "pass-exact")});
  std::string text = scratch_.read(fs::path(source.path).filename());
  text.erase(text.find("{\"decision\""));
  source.path = scratch_.write("cut.jsonl", text);
  SiteOptions wanted = options({source});
  EXPECT_NE(why_not(wanted).find("cut.jsonl is incomplete"), std::string::npos);
  EXPECT_FALSE(scratch_.has("site"));
  wanted.gather.partial = true;
  const Gathered all = write_site(wanted);
  EXPECT_EQ(all.runs[0].decision, "INCOMPLETE");
  EXPECT_EQ(all.notes.size(), 1U);
}

TEST_F(Site, LineThatIsCutOffIsRefusedInAnyCase) {
  Source source = results("a", "1", {line("x", "pass-exact"), line("y", "pass-exact")});
  std::string text = scratch_.read(fs::path(source.path).filename());
  text.resize(text.find("\"y\"") + 2);
  source.path = scratch_.write("cut.jsonl", text);
  SiteOptions wanted = options({source});
  wanted.gather.partial = true;
  EXPECT_NE(why_not(wanted).find("line 3 is cut off"), std::string::npos);
}

TEST_F(Site, EqualNamesAreRefusedUnlessRenamed) {
  std::vector<Source> sources = {results("a", "1", {line("x", "pass-exact")}),
                                 results("a", "1", {line("x", "pass-exact")})};
  EXPECT_NE(why_not(options(sources)).find("are both of a 1"), std::string::npos);
  sources[1].name = "b";
  EXPECT_EQ(why_not(options(sources)), "");
}

TEST_F(Site, OtherCorpusIsRefusedUnlessMixed) {
  Source other = results("b", "1", {line("x", "pass-exact")});
  std::string text = scratch_.read(fs::path(other.path).filename());
  replace(text, R"("version":"2026.6.0","sha256":"c0ffee")",
          R"("version":"2026.7.0","sha256":"decaf")");
  other.path = scratch_.write("other.jsonl", text);
  SiteOptions wanted = options({results("a", "1", {line("x", "pass-exact")}), other});
  EXPECT_NE(why_not(wanted).find("2026.7.0"), std::string::npos);
  wanted.gather.mixed_corpus = true;
  EXPECT_EQ(write_site(wanted).notes.size(), 1U);
}

TEST_F(Site, PageOfAReportIsNotWrittenOver) {
  const Source source = results("a", "1", {line("x", "pass-exact")});
  scratch_.write("report/index.html", "a report");
  EXPECT_NE(why_not(options({source}, "report")).find("not of a site"), std::string::npos);
  EXPECT_EQ(files_of("report").size(), 1U);
  EXPECT_EQ(why_not(options({source})), "");
  EXPECT_EQ(why_not(options({source})), "");  // a site is written anew
}

TEST_F(Site, WhatLiesThereIsUntouchedWhenASiteCannotBeWritten) {
  const Source source = results("a", "1", {line("x", "pass-exact")});
  write_site(options({source}));
  const auto before = files_of("site");
  // A folder is in the way of a page.
  fs::remove(scratch_.path() / "site/vote.html");
  fs::create_directories(scratch_.path() / "site/vote.html/mine");
  EXPECT_THROW(write_site(options({results("b", "1", {departure("x", "1")})})), std::system_error);
  auto after = files_of("site");
  auto wanted = before;
  wanted.erase("vote.html");
  EXPECT_EQ(after, wanted);  // nothing else was left behind either
}

TEST(CaseHead, OfFormat1SplitsReasonAndMessageOfWhatIsKnown) {
  const auto parts = [](std::string message) {
    std::string known;
    split_known_message("crash", known, message);
    return known + "|" + message;
  };
  EXPECT_EQ(parts("Known: it (once) falls (crash: It ended.)"), "it (once) falls|It ended.");
  EXPECT_EQ(parts("Known: it falls (crash: It ended (9).); 1 of 3 runs failed so."),
            "it falls|It ended (9).");
  // Not of this program, or of one that did not say which verdict is known.
  EXPECT_EQ(parts("Somebody knows."), "Somebody knows.|");
  EXPECT_EQ(parts("Known: it falls"), "it falls|");
}

TEST(FolderStem, IsPlainAndNeverEmpty) {
  EXPECT_EQ(folder_stem("LinuxCNC rs274 2.9.0~pre1"), "linuxcnc-rs274-2.9.0-pre1");
  EXPECT_EQ(folder_stem("../../etc"), "etc");
  EXPECT_EQ(folder_stem("端面"), "run");
}

}  // namespace
}  // namespace gonogo::oracle::site
