// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/certificate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "campaign/results.hpp"
#include "oracle/judge/judge_session.hpp"
#include "oracle/records/trace_reader.hpp"
#include "publish/evidence/certificate_files.hpp"
#include "publish/evidence/rejudge.hpp"
#include "publish/evidence/verify.hpp"
#include "tests/publish/evidence/results_files.hpp"

namespace gonogo::oracle::evidence {
namespace {

const std::string kG94Pass =
    R"({"id":"a.1","dialect":"gsk988ta","cycle":"g94","clauses":[],"verdict":"pass-exact"})";
const std::string kG94Known =
    R"j({"id":"b.1","dialect":"gsk988ta","cycle":"g94","clauses":[],"verdict":"xfail",)j"
    R"j("departure":"fail.order","known":"chords","message":"x"})j";
const std::string kWaivers =
    "[[failure]]\ncases = \"b.1\"\nverdict = \"fail.order\"\nreason = \"chords\"\n";

// A NO-GO with program and trace as a campaign writes it: B has to lie R = -5 beyond C on Z, at
// -15, and the subject goes on to -20.
std::string departure() {
  CaseResult result;
  result.id = "gsk.g94.000002";
  result.dialect = "gsk988ta";
  result.cycle = "g94";
  result.program = "O0001\nG00 X60 Z5\nG94 X20 Z-10 R-5 F100\nM30\n";
  result.trace = {R"({"k":"rapid","b":2,"to":{"x":"30","z":"5"}})",
                  R"({"k":"rapid","b":3,"to":{"z":"-20"}})",
                  R"({"k":"feed","b":3,"to":{"x":"10","z":"-10"},"f":"100"})"};
  std::vector<reference::Record> records;
  TraceReader reader;
  for (const std::string& text : result.trace) {
    records.push_back(std::get<reference::Record>(reader.read(text)));
  }
  const auto profile = std::get<reference::Profile>(reference::default_profile(result.dialect));
  const RunTolerances run = run_tolerances(Json::parse(kHeaderLine));
  const Tolerances tolerances = make_tolerances(run.subject, profile, run.grants);
  result.verdict = judge_outcome(profile, result.program, tolerances, records, RunEnd{}).verdict;
  return case_line(result, false);
}

class Certificate : public testing::Test {
 protected:
  std::optional<std::string> write(const std::string& results, const std::string& waivers = "") {
    CertificateSources sources;
    sources.results = scratch_.write("in/results.jsonl", results);
    if (!waivers.empty()) sources.known_failures = scratch_.write("in/known.toml", waivers);
    return write_certificate(sources, folder());
  }
  std::string folder() const { return (scratch_.path() / "certificate").string(); }
  std::vector<Check> verify() const { return verify_certificate(folder(), "", "0.1.0"); }
  // The sentences of what does not hold.
  std::string faults() const {
    std::string text;
    for (const Check& check : verify()) {
      if (check.result == Check::Result::fails) text += check.sentence + "\n";
    }
    return text;
  }
  // Writes a file of the certificate anew and makes its sum fit.
  void forge(const std::string& name, const std::string& text) {
    const std::string before = file_sha256(folder() + "/" + name);
    scratch_.write("certificate/" + name, text);
    std::string sums = scratch_.read("certificate/SHA256SUMS");
    sums.replace(sums.find(before), 64, file_sha256(folder() + "/" + name));
    scratch_.write("certificate/SHA256SUMS", sums);
  }
  Scratch scratch_;
};

TEST_F(Certificate, HoldsWhereItWasWritten) {
  ASSERT_FALSE(write(results_text({kG94Pass, departure()}, "NO-GO")));
  EXPECT_EQ(faults(), "");
  for (const char* name : {"STATEMENT.md", "statement.json", "results.jsonl", "SHA256SUMS"}) {
    EXPECT_TRUE(scratch_.has(std::string("certificate/") + name)) << name;
  }
}

TEST_F(Certificate, SaysWhatCouldNotBeChecked) {
  ASSERT_FALSE(write(results_text({kG94Pass})));
  const auto checks = verify();
  // Its corpus is not here, and its case has no trace.
  EXPECT_EQ(std::ranges::count(checks, Check::Result::unchecked, &Check::result), 2);
}

// sha256sum -c is the judge of the format.
TEST_F(Certificate, SumsAreThoseOfSha256sum) {
  ASSERT_FALSE(write(results_text({kG94Pass})));
  EXPECT_EQ(std::system(("cd '" + folder() + "' && sha256sum --quiet -c SHA256SUMS").c_str()), 0);
}

TEST_F(Certificate, StatementNamesSubjectCorpusDecisionAndWaivers) {
  ASSERT_FALSE(write(results_text({kG94Pass, kG94Known}), kWaivers));
  const std::string text = scratch_.read("certificate/STATEMENT.md");
  for (const char* part : {"# GO", "acme 3.2", "2026.6.0", "gonogo 0.1.0", "- chords (1): `b.1`"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
  const auto json = nlohmann::json::parse(scratch_.read("certificate/statement.json"));
  EXPECT_EQ(json["decision"], "GO");
  EXPECT_EQ(json["waivers"][0]["reason"], "chords");
  EXPECT_EQ(scratch_.read("certificate/waivers.toml"), kWaivers);
  EXPECT_EQ(faults(), "");
}

TEST_F(Certificate, NeedsTheReasonsOfItsWaivers) {
  const auto error = write(results_text({kG94Pass, kG94Known}));
  ASSERT_TRUE(error);
  EXPECT_NE(error->find("b.1 is known to fail"), std::string::npos) << *error;
}

TEST_F(Certificate, IsNotWrittenOfAnIncompleteRun) {
  const auto error = write(std::string(kHeaderLine) + "\n" + kG94Pass + "\n");
  ASSERT_TRUE(error);
  EXPECT_NE(error->find("no footer"), std::string::npos) << *error;
}

TEST_F(Certificate, IsNotWrittenAmongOtherFiles) {
  scratch_.write("certificate/thesis.txt", "years of work");
  const auto error = write(results_text({kG94Pass}));
  ASSERT_TRUE(error);
  EXPECT_NE(error->find("thesis.txt"), std::string::npos) << *error;
  EXPECT_TRUE(scratch_.has("certificate/thesis.txt"));
}

TEST_F(Certificate, ReplacesAnEarlierOne) {
  ASSERT_FALSE(write(results_text({kG94Pass, kG94Known}), kWaivers));
  ASSERT_FALSE(write(results_text({kG94Pass})));
  EXPECT_FALSE(scratch_.has("certificate/waivers.toml"));
  EXPECT_EQ(faults(), "");
}

TEST_F(Certificate, AChangedByteIsFound) {
  ASSERT_FALSE(write(results_text({kG94Pass})));
  std::string text = scratch_.read("certificate/STATEMENT.md");
  text[2] ^= 1;
  scratch_.write("certificate/STATEMENT.md", text);
  EXPECT_NE(faults().find("STATEMENT.md has been changed"), std::string::npos);
}

TEST_F(Certificate, AFileTooManyOrTooFewIsFound) {
  ASSERT_FALSE(write(results_text({kG94Pass})));
  scratch_.write("certificate/more.txt", "x");
  EXPECT_NE(faults().find("more.txt does not stand in SHA256SUMS"), std::string::npos);
  std::filesystem::remove(scratch_.path() / "certificate/statement.json");
  EXPECT_NE(faults().find("statement.json is missing"), std::string::npos);
}

TEST_F(Certificate, AStatementOfSomethingElseIsFoundThoughTheSumsFit) {
  ASSERT_FALSE(write(results_text({kG94Pass, departure()}, "NO-GO")));
  std::string text = scratch_.read("certificate/STATEMENT.md");
  text.replace(text.find("# NO-GO"), 7, "# GO   ");
  forge("STATEMENT.md", text);
  EXPECT_EQ(faults(), "STATEMENT.md is not what the results state.\n");
}

TEST_F(Certificate, ADecisionThatTheCasesDoNotGiveIsFound) {
  ASSERT_FALSE(write(results_text({kG94Pass, departure()}, "GO")));
  EXPECT_NE(faults().find("The footer says decision \"GO\", but the cases come to \"NO-GO\"."),
            std::string::npos)
      << faults();
}

// 1/3 as 0.333: correctly rounded to 0.001, and 0.000333... is up to 0.000333334 off.
const std::string kRounded = R"({"exact":3,"correct":{"count":1,"most":"0.000333334",)"
                             R"("decimals":3,"modes":{"nearest":3,"toward zero":3,"down":3}}})";

// Results of which the footer says that of its coordinates.
std::string rounded_results(const std::string& told) {
  std::string line = kG94Pass;
  line.insert(line.size() - 1, R"(,"coordinates":)" + kRounded);
  std::string text = results_text({line});
  return text.insert(text.rfind(R"("sha256")"), R"("coordinates":{"gsk988ta":)" + told + "},");
}

TEST_F(Certificate, StatesHowCoordinatesAreRounded) {
  ASSERT_FALSE(write(rounded_results(kRounded)));
  EXPECT_EQ(faults(), "");
  EXPECT_NE(scratch_.read("certificate/STATEMENT.md").find("3 exact, 1 correctly rounded"),
            std::string::npos);
  const auto json = nlohmann::json::parse(scratch_.read("certificate/statement.json"));
  EXPECT_EQ(json["coordinates"]["gsk988ta"]["correct"]["decimals"], 3);
}

TEST_F(Certificate, CoordinatesThatTheCasesDoNotGiveAreFound) {
  ASSERT_FALSE(write(rounded_results(R"({"exact":4})")));
  EXPECT_NE(faults().find("The footer says coordinates {\"gsk988ta\":{\"exact\":4}}, but"),
            std::string::npos)
      << faults();
}

TEST_F(Certificate, AVerdictThatProgramAndTraceDoNotGiveIsFound) {
  Json line = Json::parse(departure());
  ASSERT_EQ(line["verdict"], "fail.geometry");
  line["deviation"]["exact"] = "77";
  ASSERT_FALSE(write(results_text({kG94Pass, line.dump()}, "NO-GO")));
  EXPECT_TRUE(faults().starts_with("gsk.g94.000002: the deviation was 77, but judged again it is "))
      << faults();
}

// J-RUN-13: a departure says no more than what is derived.
TEST_F(Certificate, WordsThatTheDepartureDoesNotHaveAreFound) {
  const RunTolerances run = run_tolerances(Json::parse(kHeaderLine));
  const Json own = Json::parse(departure());
  EXPECT_EQ(rejudge(own, run).fault, "");
  const auto fault_with = [&](const char* key, const Json& value) {
    Json line = own;
    line[key] = value;
    return rejudge(line, run).fault;
  };
  for (const auto& [key, value] :
       {std::pair("message", "The gauge has a known defect here."), std::pair("rule", "R8"),
        std::pair("basis", "silent"), std::pair("word", "J"), std::pair("told_under", "k=v"),
        std::pair("feature", "turns"), std::pair("gap", "comparison")}) {
    EXPECT_NE(fault_with(key, value).find(value), std::string::npos) << key;
  }
  EXPECT_NE(fault_with("witness", {{"x", "9"}, {"y", "9"}, {"z", "9"}}), "");
  EXPECT_NE(fault_with("deviation", {{"exact", own["deviation"]["exact"]}, {"mm", "12"}}), "");
  // No reading explains -20 in place of -15; which one would may hang on how the run ended.
  Json line = own;
  line["reading"] = "gsk.g94.in-mode=keep";
  EXPECT_FALSE(rejudge(line, run).judged);
}

// Another gonogo may have said it in other words, and a run may add what came of its second run.
TEST_F(Certificate, AMessageIsHeldWhereItIsOfThisGonogo) {
  const RunTolerances run = run_tolerances(Json::parse(kHeaderLine));
  Json line = Json::parse(departure());
  line["message"] = line["message"].get<std::string>() + " A fresh process gave no answer in time.";
  Wording wording;
  EXPECT_NE(rejudge(line, run, wording).fault, "");
  wording.additions = {" A fresh process gave no answer in time."};
  EXPECT_EQ(rejudge(line, run, wording).fault, "");
  line["message"] = "Words of an earlier gonogo.";
  wording.is_own = false;
  EXPECT_EQ(rejudge(line, run, wording).fault, "");
}

// X60 is a diameter; the pass is derived from the line, for no trace is kept.
TEST_F(Certificate, AKnownFailureThatPassesIsDerivedFromItsLine) {
  const auto line = [](const std::string& verdict, const std::string& x) {
    return R"({"id":"c.1","dialect":"gsk988ta","cycle":"basic","clauses":[],"verdict":")" +
           verdict + R"(","message":"x","program":"G00 X60 Z5\nM30\n",)" +
           R"("trace":[{"k":"rapid","b":1,"to":{"x":")" + x +
           R"(","z":"5"}},{"k":"m","b":2,"m":30}]})";
  };
  const RunTolerances run = run_tolerances(Json::parse(kHeaderLine));
  const Rejudged again = rejudge(Json::parse(line("xpass", "30")), run);
  EXPECT_TRUE(again.judged);
  EXPECT_EQ(again.fault, "");
  EXPECT_FALSE(rejudge(Json::parse(line("xpass", "31")), run).judged);
}

TEST_F(Certificate, FreshProgramsThatTheCommandLineDoesNotAskForAreFound) {
  const auto faults_with = [&](const std::string& words) {
    std::string text = results_text({kG94Pass});
    const auto put = [&](const std::string& from, const std::string& to) {
      text.replace(text.find(from), from.size(), to);
    };
    put(R"("argv":["certify",)", R"("argv":["certify",)" + words);
    text.insert(text.rfind(R"("sha256")"),
                R"("fresh":{"gsk988ta":{"wanted":1,"programs":1,"judged":1}},)");
    EXPECT_FALSE(write(text));
    return faults();
  };
  EXPECT_EQ(faults_with(""), "");
  EXPECT_EQ(faults_with(R"("--fresh","1",)"), "");
  const std::string none = "of gsk988ta, 1 of them judged, but 0 are due.";
  EXPECT_NE(faults_with(R"("--fresh","0",)").find(none), std::string::npos);
  EXPECT_NE(faults_with(R"("--fail-fast",)").find(none), std::string::npos);
}

TEST_F(Certificate, AKeyThatNoFooterHasIsFound) {
  std::string text = results_text({kG94Pass});
  text.insert(text.rfind(R"("sha256")"), R"("remark":"all was well",)");
  ASSERT_FALSE(write(text));
  EXPECT_EQ(faults(), "A footer has no /remark.\n");
}

TEST_F(Certificate, StatesWhatWasToldAndGrantedBesides) {
  std::string text = results_text({kG94Pass});
  const std::string from = R"("chord":null,)";
  text.replace(text.find(from), from.size(), from + R"("feed_tolerance":"300","show_ids":true,)");
  ASSERT_FALSE(write(text));
  const Json root = Json::parse(scratch_.read("certificate/statement.json"));
  EXPECT_EQ(root["feed_tolerance"], "300");
  EXPECT_EQ(root["show_ids"], true);
  const std::string page = scratch_.read("certificate/STATEMENT.md");
  EXPECT_NE(page.find("- Feed tolerance: 300 %, granted by the certifier\n"), std::string::npos);
  EXPECT_NE(page.find("- Names of cases: are told to the subject"), std::string::npos);
  EXPECT_NE(page.find("granted: feed tolerance 300 %, names of cases"), std::string::npos);
}

// J-RUN-02: the subject declares exact numbers, of which nothing is capped.
TEST_F(Certificate, CappedNumbersThatTheDeclarationsDoNotGiveAreFound) {
  const auto with_capped = [](const std::string& list) {
    std::string text = results_text({kG94Pass});
    const std::string from = R"("chord":null,)";
    return text.replace(text.find(from), from.size(), from + R"("capped":)" + list + ",");
  };
  ASSERT_FALSE(write(with_capped("[]")));
  EXPECT_EQ(faults(), "");
  ASSERT_FALSE(
      write(with_capped(R"([{"dialect":"gsk988ta","what":"chord","declared":"5","counts":"0"}])")));
  EXPECT_TRUE(faults().starts_with("The header says capped ")) << faults();
}

TEST_F(Certificate, ResultsOfAnotherRunAreFound) {
  ASSERT_FALSE(write(results_text({kG94Pass})));
  std::string other = kG94Pass;
  other.replace(other.find("a.1"), 3, "z.9");
  forge("results.jsonl", results_text({other}));
  EXPECT_NE(faults().find("The statement is of other results"), std::string::npos) << faults();
}

TEST_F(Certificate, ARunOfTheSubjectThatDiffersIsFound) {
  const std::string before = scratch_.write("old", results_text({kG94Pass}));
  std::string line = kG94Pass;
  line.replace(line.find("pass-exact"), 10, "pass-rounded");
  const std::string after = scratch_.write("new", results_text({line}));
  EXPECT_EQ(same_cases(before, before)[0].result, Check::Result::holds);
  EXPECT_EQ(same_cases(before, after)[0].result, Check::Result::fails);
}

}  // namespace
}  // namespace gonogo::oracle::evidence
