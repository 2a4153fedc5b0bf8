// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the corpus covers: clauses, readings, alarms, planes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "corpus_testing.hpp"
#include "oracle/judge/judge_session.hpp"
#include "oracle/records/features.hpp"
#include "reference/descriptor.hpp"
#include "reference/dialect.hpp"
#include "reference/reading.hpp"

namespace gonogo::testing {
namespace {

using oracle::Case;
using oracle::Expectation;

std::string outcome(const Expectation& expectation) {
  Expectation bare = expectation;
  bare.when.clear();
  return expectation_json(bare);
}

std::string outcome_with(const Case& test, std::string_view reading, std::string_view value) {
  reference::Profile profile = test.profile;
  EXPECT_FALSE(set_reading(profile, reading, value).has_value());
  return outcome(oracle::expectation_of(profile, test.program));
}

TEST(Coverage, EveryClauseIsListedByAGroup) {
  std::set<std::string> listed;
  for (const auto& [id, test] : checked_in_cases()) {
    listed.insert(test.clauses.begin(), test.clauses.end());
  }
  for (const reference::Clause& clause : reference::clauses()) {
    EXPECT_TRUE(listed.contains(std::string(clause.id))) << clause.id;
  }
}

// J-ALM-01: what moves rests on a text or follows from one. Else a wrong path could be an advice.
TEST(Coverage, NoMotionRestsOnARuleOfOurs) {
  std::size_t records = 0;
  for (const auto& [id, test] : checked_in_cases()) {
    for (const Expectation& expectation : test.expect) {
      for (const reference::Record& record : expectation.records) {
        if (record.clause == reference::kNoClause) continue;
        ++records;
        EXPECT_NE(reference::clause(record.clause).basis(), reference::Basis::silent)
            << id << " " << reference::clause_name(record.clause);
      }
    }
  }
  EXPECT_GT(records, 50'000U);
}

// J-RUN-01: an M function of a line without an M is the cycle's own.
TEST(Coverage, EveryCycleThatPassesOnMFunctionsSaysSo) {
  std::map<std::string, std::set<std::string>> flagged;
  for (const reference::Dialect& dialect : reference::dialects()) {
    for (const reference::Code& code : dialect.descriptor->codes) {
      if (code.passes_m) flagged[std::string(dialect.name)].emplace(code.feature);
    }
  }
  std::map<std::string, std::set<std::string>> seen;
  for (const auto& [id, test] : checked_in_cases()) {
    std::vector<std::string> lines{""};
    for (std::size_t i = 0; i < test.program.size(); ++i) {
      const bool is_crlf = test.program.compare(i, 2, "\r\n") == 0;
      const bool ends = test.program[i] == '\n' || (test.program[i] == '\r' && !is_crlf);
      lines.back() += test.program[i];
      if (ends) lines.emplace_back();
    }
    for (const Expectation& expectation : test.expect) {
      // Where a CR ends no line (NGC-COM-13) the numbers are others.
      const bool has_these_lines =
          !test.profile.takes_cr_for_blank() &&
          std::ranges::count(expectation.when,
                             std::pair<std::string, std::string>("ngc.lone-cr", "blank")) == 0;
      for (const reference::Record& record : expectation.records) {
        if (record.kind != reference::RecordKind::m || !has_these_lines) continue;
        if (lines.at(record.block - 1).find_first_of("Mm") != std::string::npos) continue;
        const std::set<std::string>& cycles = flagged[test.dialect];
        const auto own = std::ranges::find_if(
            test.features, [&](const auto& feature) { return cycles.contains(feature); });
        ASSERT_NE(own, test.features.end()) << id;
        seen[test.dialect].insert(*own);
      }
    }
  }
  EXPECT_EQ(seen, flagged);
}

TEST(Coverage, EveryExpectationSaysOnWhatItStands) {
  std::set<reference::Basis> bases;
  for (const auto& [id, test] : checked_in_cases()) {
    for (const Expectation& expectation : test.expect) {
      ASSERT_TRUE(expectation.basis.has_value()) << id;
      bases.insert(*expectation.basis);
    }
  }
  EXPECT_EQ(bases.size(), 3U);
}

// J-ALM-03: an unstated clause excuses a departure, so that a corpus of such cases would say
// nothing. Two in a hundred are made for the rules themselves.
TEST(Coverage, FewCasesRestOnARuleOfOurs) {
  std::map<std::string, std::array<std::size_t, 2>> counts;  // all, and those that do
  for (const auto& [id, test] : checked_in_cases()) {
    const bool is_silent = test.expect.front().basis == reference::Basis::silent;
    ++counts[test.dialect][0];
    if (is_silent) ++counts[test.dialect][1];
  }
  EXPECT_EQ(counts.size(), 5U);
  for (const auto& [dialect, count] : counts) {
    EXPECT_LT(50 * count[1], count[0]) << dialect << ": " << count[1] << " of " << count[0];
    EXPECT_GT(count[1], 0U) << dialect;
  }
}

// The clause that a record or an alarm of the reference names is hit, not what a group claims.
TEST(Coverage, TheRecordsNameAllClausesThatMoveSomething) {
  std::set<std::string_view> named;
  for (const auto& [id, test] : checked_in_cases()) {
    for (const Expectation& expectation : test.expect) {
      for (const reference::Record& record : expectation.records) {
        named.insert(reference::clause_name(record.clause));
      }
    }
  }
  for (const std::string_view clause :
       {"GSK-G94-02",  "GSK-G94-03",  "GSK-G94-04",  "GSK-G94-05",  "GSK-G90-02",  "GSK-G90-03",
        "GSK-G90-04",  "GSK-G90-05",  "GSK-G92-02",  "GSK-G92-03",  "GSK-G92-04",  "GSK-G92-05",
        "GSK-G110-06", "GSK-G110-07", "GSK-G110-08", "GSK-G110-09", "GSK-G110-10", "GSK-G110-11",
        "GSK-G110-13", "GSK-G110-14", "GSK-G110-17", "GSK-G112-03", "GSK-G112-04", "GSK-G112-05",
        "GSK-G112-06", "GSK-G112-07", "GSK-G114-05", "GSK-G114-06", "GSK-G114-07", "GSK-G114-11",
        "GSK-COM-05",  "GSK-MOD-08",  "SIE-G1-01",   "SIE-ARC-02",  "SIE-ARC-03",  "SIE-ARC-04",
        "SIE-ARC-05",  "SIE-ARC-06",  "SIE-ARC-08",  "SIE-ARC-09",  "SIE-CIP-01",  "SIE-CT-01",
        "SIE-MOD-03",  "SIE-LC82-01", "SIE-LC75-04"}) {
    EXPECT_TRUE(named.contains(clause)) << clause;
  }
}

// An open reading is expected under its first alternative where nothing else is said.
TEST(Coverage, EveryAlternativeOfAReadingIsSetByAProfileOrIsTheDefault) {
  for (const reference::Reading& reading : reference::readings()) {
    std::set<std::string> set;
    for (const auto& [id, test] : checked_in_cases()) {
      set.emplace(test.profile.readings.get(reading.key));
    }
    EXPECT_TRUE(set.contains(std::string(reading.fallback))) << reading.name;
    EXPECT_GE(set.size(), 2U) << reading.name;
    const bool is_open = reading.fallback == "any" && !reading.by_properties;
    if (is_open) set.emplace(reading.alternatives.front());
    for (const std::string_view alternative : reading.alternatives) {
      EXPECT_TRUE(set.contains(std::string(alternative))) << reading.name << "=" << alternative;
    }
  }
}

// The judge looks for open readings of the dialect alone: others are open by default, too.
TEST(Coverage, NoProgramTouchesAReadingOfAnotherDialect) {
  for (const auto& [id, test] : checked_in_cases()) {
    for (const reference::ReadingKey key : oracle::touched_by(test.profile, test.program)) {
      const reference::Reading& reading = reference::reading(key);
      EXPECT_TRUE(reading.belongs_to(test.dialect)) << id << ": " << reading.name;
    }
  }
}

TEST(Coverage, TwoAlternativesOfAReadingAreToldApartByACase) {
  for (const reference::Reading& reading : reference::readings()) {
    std::vector<std::string> values(reading.alternatives.begin(), reading.alternatives.end());
    if (reading.is_length) values.push_back("1");
    for (std::size_t a = 0; a < values.size(); ++a) {
      for (std::size_t b = a + 1; b < values.size(); ++b) {
        bool differs = false;
        for (const auto& [id, test] : checked_in_cases()) {
          if (!reading.belongs_to(test.dialect)) continue;
          differs = outcome_with(test, reading.name, values[a]) !=
                    outcome_with(test, reading.name, values[b]);
          if (differs) break;
        }
        EXPECT_TRUE(differs) << reading.name << ": " << values[a] << ", " << values[b];
      }
    }
  }
}

// A case states outcomes of all alternatives of a reading, or of none.
TEST(Coverage, ACaseThatStatesAnOpenReadingStatesEachOutcome) {
  std::set<std::string_view> stated_somewhere;
  for (const auto& [id, test] : checked_in_cases()) {
    std::map<std::string, std::set<std::string>> stated;
    for (const Expectation& expectation : test.expect) {
      for (const auto& [name, value] : expectation.when) stated[name].insert(value);
    }
    for (const auto& [name, values] : stated) {
      const reference::Reading& reading = *reference::find_reading(name);
      EXPECT_EQ(values.size(), reading.alternatives.size()) << id << " " << name;
      stated_somewhere.insert(reading.name);
    }
  }
  for (const std::string_view name :
       {"sie.arc.correct", "sie.cr.tolerance", "sie.g70.f", "hnc.missing-axis", "ngc.g80-beside"}) {
    EXPECT_TRUE(stated_somewhere.contains(name)) << name;
  }
}

// Every class that these cycles can raise, as the single fault of a case; but arc-radius,
// depth-exceeds-tool, lead-missing, not-an-integer, retract-pair, retract-ratio, step-too-large and
// taper-limit never stand without the class that another reader gives (J-ALM-04).
TEST(Coverage, EveryAlarmClassStandsAlone) {
  std::set<std::string_view> alone;
  for (const auto& [id, test] : checked_in_cases()) {
    for (const Expectation& expectation : test.expect) {
      std::set<std::string_view> classes;
      for (const oracle::ExpectedAlarm& alarm : expectation.alarms) {
        classes.insert(name(alarm.alarm));
      }
      if (classes.size() == 1) alone.insert(*classes.begin());
    }
  }
  const std::set<std::string_view> want = {"syntax",
                                           "undefined-code",
                                           "duplicate-word",
                                           "conflicting-words",
                                           "missing-word",
                                           "value-out-of-range",
                                           "value-sign",
                                           "tool-too-large",
                                           "direction-conflict",
                                           "axis-not-in-plane",
                                           "arc-end-point",
                                           "feed-missing",
                                           "plane-not-allowed",
                                           "arc-intermediate-point",
                                           "arc-tangent",
                                           "spindle-stopped",
                                           "no-tool",
                                           "reference-plane",
                                           "unused-word",
                                           "program-end",
                                           "machining-type",
                                           "direction-parameter",
                                           "allowance-too-large",
                                           "pocket-size"};
  EXPECT_EQ(alone, want);
}

TEST(Coverage, EachCycleRunsInEachPlane) {
  for (const char* cycle :
       {"g94", "g90", "g92", "g110", "g112", "g114", "g116", "lcyc75", "lcyc82"}) {
    for (const char* plane : {"plane=G17", "plane=G18", "plane=G19"}) {
      bool found = false;
      for (const auto& [id, test] : checked_in_cases()) {
        found = found || (test.cycle == cycle &&
                          std::ranges::find(test.tags_tway, plane) != test.tags_tway.end());
      }
      EXPECT_TRUE(found) << cycle << " " << plane;
    }
  }
}

TEST(Coverage, EveryLimitHasItsThreeSides) {
  // group and comment before the colon -> signs seen
  std::map<std::string, std::set<std::string>> sides;
  for (const auto& [id, test] : checked_in_cases()) {
    for (const std::string& sign : test.tags_sign) {
      if (sign.starts_with("limit:")) sides[test.group].insert(sign);
    }
  }
  EXPECT_GE(sides.size(), 8U);
  for (const auto& [group, signs] : sides) EXPECT_EQ(signs.size(), 3U) << group;
}

TEST(Coverage, EveryFeatureOfAGroupIsInTheVocabulary) {
  std::set<std::string> known;
  for (const oracle::Feature& feature : oracle::feature_vocabulary()) {
    known.insert(std::string(feature.dialect) + "/" + std::string(feature.name));
  }
  for (const auto& [id, test] : checked_in_cases()) {
    for (const std::string& feature : test.features) {
      EXPECT_TRUE(known.contains(test.dialect + "/" + feature) || known.contains("/" + feature))
          << id << ": " << feature;
    }
  }
}

TEST(Coverage, EveryCodeThatIsNotReadIsExpectedToBeAGap) {
  int gaps = 0;
  for (const auto& [id, test] : checked_in_cases()) {
    for (const Expectation& expectation : test.expect) {
      if (!expectation.not_covered) continue;
      ++gaps;
      EXPECT_FALSE(expectation.records.empty()) << id << ": records before it are judged";
    }
  }
  EXPECT_GE(gaps, 5);
}

}  // namespace
}  // namespace gonogo::testing
