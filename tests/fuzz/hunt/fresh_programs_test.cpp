// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a table of answers is worth beside programs that no table has.
#include "fuzz/hunt/fresh_programs.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "hunting.hpp"
#include "subjects/private_folder.hpp"

namespace gonogo::hunt {
namespace {

constexpr std::size_t kPrograms = 150;

class FreshPrograms : public ::testing::Test {
 private:
  oracle::PrivateFolder folder_;

 protected:
  std::string folder_of_departures_ = folder_.path() + "/departures";
};

// Answers the programs that it knows by their text as the one within does, and alarms on others.
class LooksUp : public WrappedSubject {
 public:
  LooksUp(std::unique_ptr<oracle::Subject> inner, const std::set<std::string>& known)
      : WrappedSubject(std::move(inner)), known_(known) {}
  oracle::RunEnd run(std::string_view id, std::string_view program,
                     const oracle::RecordSink& sink) override {
    if (known_.contains(std::string(program))) return WrappedSubject::run(id, program, sink);
    oracle::RunEnd end;
    end.kind = oracle::RunEnd::Kind::alarm;
    end.alarm.alarm_class = "syntax";
    end.alarm.block = 1;
    return end;
  }

 private:
  const std::set<std::string>& known_;
};

FreshOptions options_of(const std::string& dialect, std::uint64_t seed) {
  FreshOptions options;
  options.hunt.dialect = dialect;
  options.hunt.seed = seed;
  options.programs = kPrograms;
  options.time = std::chrono::minutes(5);
  return options;
}

const Provenance kTold{"gonogo 0", "builtin:gsk", 7};

TEST_F(FreshPrograms, AnHonestExpanderAnswersThemInEveryDialectUnderEverySeed) {
  for (const generate::Generator& generator : generate::generators()) {
    const std::string expander(generator.expander);
    for (const std::uint64_t seed : {11U, 22U, 33U}) {
      SCOPED_TRACE(std::string(generator.dialect) + " " + std::to_string(seed));
      const FreshAnswers answers =
          ask_fresh(testing::builtin(expander.c_str()),
                    options_of(std::string(generator.dialect), seed), folder_of_departures_, kTold);
      EXPECT_FALSE(answers.departure.has_value());
      EXPECT_EQ(answers.count.programs, kPrograms);
      EXPECT_GT(answers.count.judged, kPrograms / 2);
    }
  }
  EXPECT_FALSE(std::filesystem::exists(folder_of_departures_));
}

// The table has a program; the one that shows the departure is another, and lies in a corpus.
TEST_F(FreshPrograms, ATableOfAnswersDepartsOnTheFirstOfThem) {
  const std::set<std::string> table = {testing::kTaper};
  const SubjectMaker inner = testing::builtin("gsk");
  const auto looks_up = [&] { return std::make_unique<LooksUp>(inner(), table); };
  const FreshAnswers answers =
      ask_fresh(looks_up, options_of("gsk988ta", 7), folder_of_departures_, kTold);
  ASSERT_TRUE(answers.departure.has_value());
  EXPECT_LT(answers.count.programs, 20U);
  const oracle::CaseResult& line = *answers.departure;
  EXPECT_EQ(decision(line.verdict.kind), oracle::Decision::no_go);
  EXPECT_TRUE(oracle::is_fresh(line.id)) << line.id;
  EXPECT_FALSE(table.contains(line.program));
  const oracle::Corpus corpus(folder_of_departures_);
  std::map<std::string, std::string> programs;
  corpus.for_each([&](const oracle::Case& test) { programs[test.id] = test.program; });
  EXPECT_EQ(programs, (std::map<std::string, std::string>{{line.id, line.program}}));
}

TEST_F(FreshPrograms, NoneIsBegunBehindTheTime) {
  FreshOptions options = options_of("gsk988ta", 7);
  options.time = std::chrono::milliseconds(0);
  const FreshAnswers answers =
      ask_fresh(testing::builtin("gsk"), options, folder_of_departures_, kTold);
  EXPECT_EQ(answers.count, (oracle::FreshCount{kPrograms, 0, 0}));
}

}  // namespace
}  // namespace gonogo::hunt
