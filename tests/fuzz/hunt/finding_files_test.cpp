// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/finding_files.hpp"
#include "reference/reading_literal.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "corpus/io/recheck.hpp"
#include "hunting.hpp"
#include "subjects/private_folder.hpp"

namespace gonogo::hunt::testing {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class FindingFiles : public ::testing::Test {
 protected:
  Finding found(const generate::GeneratedProgram& program) {
    oracle::Verdict verdict;
    return finding_of(trial_, program, verdict).value();
  }
  std::string write(const Finding& finding) {
    return write_finding(out_, finding, trial_.examine(finding.reproducer), trial_.info(),
                         {"gonogo 0.0.0", "builtin:gsk+taper-sign", 7});
  }

  Trial trial_{builtin("gsk", "taper-sign"), {}};
  oracle::PrivateFolder folder_;
  std::string out_ = folder_.path() + "/out";
};

TEST_F(FindingFiles, AreACorpusOfTheirOwn) {
  const std::string id = write(found(gsk(kTaper)));
  const oracle::Corpus corpus(out_);
  std::vector<oracle::Case> cases;
  corpus.for_each([&](const oracle::Case& test) { cases.push_back(test); });
  ASSERT_EQ(cases.size(), 1U);
  EXPECT_EQ(cases[0].id, id);
  EXPECT_EQ(cases[0].program, kTaper);
  EXPECT_EQ(cases[0].clauses, std::vector<std::string>{"GSK-G94-02"});
  EXPECT_EQ(cases[0].features, std::vector<std::string>{"g94"});
  EXPECT_FALSE(oracle::recheck(cases[0]));
}

TEST_F(FindingFiles, SayWhereTheyComeFrom) {
  Finding finding = found(gsk(kTaper));
  finding.program = 12;
  const oracle::Case test = case_of(finding, trial_.info(), {"gonogo 0.0.0", "builtin:x", 7});
  EXPECT_NE(test.provenance.find("gonogo 0.0.0 hunt: builtin:x"), std::string::npos);
  EXPECT_NE(test.provenance.find("seed 7, program 12"), std::string::npos);
}

TEST_F(FindingFiles, LieBesideTheVector) {
  const fs::path beside = fs::path(out_) / "findings" / write(found(gsk(kTaper)));
  EXPECT_EQ(bytes_of(beside / "program.nc"), kTaper);
  EXPECT_EQ(bytes_of(beside / "profile.json"), "{\"dialect\":\"gsk988ta\"}\n");
  EXPECT_NE(bytes_of(beside / "trace.jsonl").find("\"k\":\"rapid\""), std::string::npos);
  EXPECT_NE(bytes_of(beside / "verdict.txt").find("fail.geometry GSK-G94-02"), std::string::npos);
  // The sheet marks where the two part.
  EXPECT_NE(bytes_of(beside / "sheet.svg").find("gs-witness"), std::string::npos);
}

TEST_F(FindingFiles, OfTheSameProgramHaveTheSameId) {
  EXPECT_EQ(write(found(gsk(kTaper))), write(found(gsk(kTaper))));
}

TEST_F(FindingFiles, OfTheSameSignatureAreCounted) {
  const std::string first = write(found(gsk(kTaper)));
  const std::string second = write(found(gsk("G00 X90 Z5\nG94 X50 Z-10 R-2 F100\n")));
  EXPECT_TRUE(first.ends_with(".000001"));
  EXPECT_TRUE(second.ends_with(".000002"));
  EXPECT_EQ(oracle::Corpus(out_).files().size(), 2U);
}

TEST_F(FindingFiles, KeepTheMachine) {
  generate::GeneratedProgram program = gsk(kTaper);
  program.profile.x_diameter = false;
  const std::string id = write(found(program));
  const auto cases = oracle::read_vector_file(out_ + "/vectors/gsk988ta/" + id + ".json");
  EXPECT_EQ(cases.at(0).profile, program.profile);
}

// Where a reading is open, a case says what is expected under each of its alternatives.
TEST_F(FindingFiles, ExpectWhatEachOpenReadingSays) {
  Finding finding = found(gsk("G00 X100 Z5\nG94 X50 Z-10 R-2 F100\nG04\nX40\n"));
  const auto key = "gsk.dwell-without-word"_key;
  finding.reproducer.program.profile.readings.set(key, "any");
  const oracle::Case test = case_of(finding, trial_.info(), {});
  ASSERT_EQ(test.expect.size(), reference::reading(key).alternatives.size());
  EXPECT_EQ(test.expect[0].when.at(0).first, reference::reading(key).name);
}

TEST_F(FindingFiles, OfBytesThatAreNotUtf8AreKept) {
  const std::string program = std::string("(\xB5\xB6)\n") + kTaper;
  const std::string id = write(found(gsk(program)));
  const auto cases = oracle::read_vector_file(out_ + "/vectors/gsk988ta/" + id + ".json");
  EXPECT_EQ(cases.at(0).program, program);
}

}  // namespace
}  // namespace gonogo::hunt::testing
