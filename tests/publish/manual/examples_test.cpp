// SPDX-License-Identifier: GPL-3.0-or-later
//
// The examples show what they are there for.
#include "publish/manual/examples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "corpus/io/corpus.hpp"
#include "publish/manual/example_run.hpp"
#include "reference/dialect.hpp"

namespace gonogo::oracle::manual {
namespace {

using reference::Reading;

// A clause of a manual and the class of an alarm that it raises.
using Rule = std::tuple<std::string, std::string>;

// Calls `visit` once with the examples of each file, under the dialect on whose page they stand.
template <typename Visit>
void for_each_file(Visit visit) {
  for (const reference::Dialect& dialect : reference::dialects()) {
    for (const Examples& examples : examples_of(dialect.name)) {
      if (examples.dialect == dialect.name) visit(examples);
    }
  }
}

TEST(Examples, OfCyclesRunToTheirEnd) {
  for_each_file([](const Examples& file) {
    for (const Example& example : file.examples) {
      const ExampleRun trial =
          try_program(example_profile(file.dialect, example.profile), example.program);
      EXPECT_FALSE(trial.alarm) << example.section;
      EXPECT_EQ(trial.not_covered, "") << example.section;
      EXPECT_GE(trial.steps.size(), 3U) << example.section;
    }
  });
}

// A reading without an example, or with one in which a value changes nothing, would be a choice
// that the page does not show.
TEST(Examples, OfReadingsShowWhatEveryValueChanges) {
  std::set<std::string> shown;
  for_each_file([&](const Examples& file) {
    for (const ReadingExample& example : file.readings) {
      const Reading* reading = reference::find_reading(example.name);
      ASSERT_NE(reading, nullptr) << example.name;
      EXPECT_TRUE(shown.insert(example.name).second) << example.name;
      std::vector<std::string> values(reading->alternatives.begin(), reading->alternatives.end());
      values.insert(values.end(), example.values.begin(), example.values.end());
      std::vector<std::vector<ExampleStep>> seen;
      for (const std::string& value : values) {
        reference::Profile profile = example_profile(file.dialect, example.profile);
        choose(profile, example.name, value);
        std::vector<ExampleStep> steps = try_program(profile, example.program).steps;
        EXPECT_EQ(std::ranges::find(seen, steps), seen.end()) << example.name << " = " << value;
        seen.push_back(std::move(steps));
      }
      if (reading->by_properties && reading->alternatives.size() == 1) {
        reference::Profile open = example_profile(file.dialect, example.profile);
        choose(open, example.name, "any");
        EXPECT_FALSE(try_program(open, example.program).limits.empty()) << example.name;
      } else {
        EXPECT_GT(values.size(), 1U) << example.name;
      }
    }
  });
  for (const Reading& reading : reference::readings()) {
    EXPECT_TRUE(shown.contains(std::string(reading.name))) << reading.name << " has no example";
  }
}

TEST(Examples, OfAlarmsRaiseThem) {
  for_each_file([](const Examples& file) {
    for (const AlarmExample& example : file.alarms) {
      const ExampleRun trial =
          try_program(example_profile(file.dialect, example.profile), example.program);
      ASSERT_TRUE(trial.alarm) << example.clause << ": " << example.program;
      const reference::Alarm& alarm = trial.alarm->alarms.front();
      EXPECT_EQ(reference::clause_name(alarm.clause), example.clause) << example.program;
      EXPECT_EQ(reference::name(alarm.alarm), example.alarm) << example.program;
    }
  });
}

// The rule that a case breaks first, under its profile.
std::optional<Rule> broken_rule(const Case& test) {
  const ExampleRun trial = try_program(test.profile, test.program);
  if (!trial.alarm) return std::nullopt;
  const reference::Alarm& alarm = trial.alarm->alarms.front();
  return Rule{reference::clause_name(alarm.clause), reference::name(alarm.alarm)};
}

TEST(Examples, HaveEveryAlarmThatTheCorpusProvokes) {
  std::set<Rule> shown;
  for_each_file([&](const Examples& file) {
    for (const AlarmExample& example : file.alarms) shown.insert({example.clause, example.alarm});
  });
  std::size_t provoked = 0;
  std::set<Rule> missing;
  Corpus(std::string(GONOGO_SOURCE_DIR) + "/corpus").for_each([&](const Case& test) {
    if (!expects_alarm(test)) return;
    if (const auto rule = broken_rule(test)) {
      ++provoked;
      if (!shown.contains(*rule)) missing.insert(*rule);
    }
  });
  EXPECT_GT(provoked, 5000U);
  for (const auto& [clause, alarm] : missing) {
    ADD_FAILURE() << clause << " raises " << alarm
                  << " in the corpus; add an [[alarm]] to publish/manual/examples";
  }
}

}  // namespace
}  // namespace gonogo::oracle::manual
