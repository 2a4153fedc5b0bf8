// SPDX-License-Identifier: GPL-3.0-or-later
//
// Causes of departures, tried on planted faults: the names are those of what a fault does.
#include "fuzz/identify/attribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "attributed.hpp"

namespace gonogo::identify {
namespace {

using testing::attribute_fault;
using testing::builtin;
using testing::case_of;
using testing::checked_in_corpus;
using testing::Planted;

class PlantedFault : public ::testing::TestWithParam<Planted> {};

TEST_P(PlantedFault, IsExplainedByItsCause) {
  const Planted& planted = GetParam();
  const Attribution found = attribute_fault(planted);
  EXPECT_GT(found.departures, 0U);
  EXPECT_NE(std::ranges::find(found.complete, std::string(planted.cause), &Cause::name),
            found.complete.end())
      << attribution_text(found);
}

// Some programs show the fault in another way: R126=0 that a reading takes for 3, and CR without
// LF.
TEST(Attribution, NamesWhatExplainsTheMost) {
  for (const Planted& planted : {Planted{"sinumerik", "pocket-sense-flipped", "s802.lcyc75.000037",
                                         "R126 takes 2 for 3, and 3 for 2"},
                                 Planted{"ngc", "cr-lf-counted-twice", "ngc.amendments.000144",
                                         "CR LF counts as two lines"}}) {
    const Attribution found = attribute_fault(planted);
    const auto cause = std::ranges::find(found.partial, std::string(planted.cause), &Cause::name);
    ASSERT_NE(cause, found.partial.end()) << attribution_text(found);
    EXPECT_EQ(cause->departures, found.partial.front().departures) << attribution_text(found);
  }
}

// The fault's own description says what it does: the cause is that in the words of a variant.
INSTANTIATE_TEST_SUITE_P(
    Expanders, PlantedFault,
    ::testing::Values(
        Planted{"ngc", "g18-sense-flipped", "ngc.arc-distance.000013",
                "every arc in G18 turns the other way"},
        Planted{"ngc", "radius-sign-ignored", "ngc.arc-r.000005",
                "R of G2 G3 is taken without its sign"},
        Planted{"ngc", "offsets-absolute", "ngc.arc-distance.000028",
                "I J K are taken as absolute"},
        Planted{"ngc", "g18-offsets-swapped", "ngc.arc-distance.000013",
                "I and K change places in G18"},
        Planted{"ngc", "helix-flat", "ngc.arc-distance.000042",
                "the third axis of an arc is ignored"},
        Planted{"ngc", "inch-offsets-unscaled", "ngc.arc-distance.000040",
                "I J K of G2 G3 is not converted from inches"},
        Planted{"ngc", "feed-after-motion", "ngc.arc-distance.000001",
                "F holds from the next block on"},
        Planted{"ngc", "g98-g99-swapped", "ngc.cycles.000094", "G98 and G99 change places"},
        Planted{"ngc", "end-ignored", "ngc.m.000021", "the end of the program is ignored"},
        Planted{"ngc", "alarm-next-block", "ngc.alarm.000001", "alarms name the block after"},
        Planted{"ngc", "end-point-unchecked", "ngc.arc-distance.000011",
                "arc-end-point of NGC-ARC-03 is not checked"},
        Planted{"ngc", "g76-h-total", "ngc.threading.v1-t2f2-s1.000002", "H counts one too few"},
        Planted{"ngc", "g76-equal-infeed", "ngc.threading.v1-t2f2-s1.000002",
                "R of G76 is ignored"},
        Planted{"ngc", "g33-lead-along-z", "ngc.threads.000060",
                "the lead of G33 G33.1 comes out along Z, not along the longest axis"},
        Planted{"ngc", "g86-without-dwell", "ngc.dwelling.v1-t2f2-s1.000004",
                "the dwells of G86 are left out"},
        Planted{"ngc", "q-not-sticky", "ngc.cycles.000104",
                "Q has to stand in every block of a cycle"},
        Planted{"sinumerik", "centre-ac-ignored", "s840.arcs.000044", "AC of I J K is ignored"},
        Planted{"sinumerik", "centre-absolute", "s840.arcs.000041",
                "I J K is taken as AC under G90"},
        Planted{"sinumerik", "cip-intermediate-absolute", "s840.cip.000026",
                "I1 J1 K1 is taken as AC under G91"},
        Planted{"sinumerik", "capitals-only", "s840.expressions.000024",
                "small letters are refused"},
        Planted{"sinumerik", "pocket-sides-swapped", "s802.lcyc75.000025",
                "R118 and R119 change places outside G17"},
        Planted{"sinumerik", "g158-keeps-rotation", "s802.frames.000006",
                "a translation leaves the rotation in force"},
        Planted{"gsk", "turning-words-leak", "gsk.g90.000089",
                "what one of G90 G92 G94 retains stays in force under another"},
        Planted{"gsk", "step-equality-accepted", "gsk.g110.alarm.000005",
                "L of G110 on a limit counts as a trifle smaller, < for <= or the other way "
                "round"},
        Planted{"gsk", "missing-step-down-accepted", "gsk.g110.alarm.000069",
                "GSK-G110-02 does without Q"},
        Planted{"hnc", "peck-running-sum", "hnc.pecks.000001", "Q is summed up in binary64"}),
    testing::name_of);

TEST(Departure, HasNoCauseWhereNothingDeparts) {
  for (const auto& [expander, id] :
       {std::pair("gsk", "gsk.arc.000029"), std::pair("hnc", "hnc.pecks.000001"),
        std::pair("ngc", "ngc.arc-distance.000001"), std::pair("sinumerik", "s840.ar.000011")}) {
    const auto subject = builtin(expander);
    const Attribution found = attribute(*subject, checked_in_corpus(), case_of(id), {});
    EXPECT_GT(found.programs.size(), 10U) << expander;
    EXPECT_EQ(found.departures, 0U) << expander;
    EXPECT_TRUE(found.complete.empty() && found.partial.empty()) << expander;
  }
}

TEST(Departure, SaysInNumbersWhatACauseExplains) {
  const Attribution found = attribute_fault({"ngc", "radius-sign-ignored", "ngc.arc-r.000005", ""});
  ASSERT_FALSE(found.complete.empty());
  EXPECT_EQ(found.complete.front().departures, found.departures);
  EXPECT_EQ(found.complete.front().passes, found.programs.size() - found.departures);
}

// Pecks that never end: thousands of records, held against hundreds of mistakes.
TEST(Departure, IsGivenUpWhereItsTrialsTakeMoreRecordsThanTheyMay) {
  const auto subject = builtin("ngc", "g18-sense-flipped");
  const ProgramAsked asked = case_of("ngc.arc-distance.000013");
  ExplanationOptions options;
  options.most_records = 100;
  const Attribution found = attribute(*subject, checked_in_corpus(), asked, options);
  EXPECT_TRUE(found.given_up);
  EXPECT_GT(found.departures, 0U);
  EXPECT_TRUE(found.complete.empty() && found.partial.empty());
  options.most_records = 1'000'000;
  const Attribution whole = attribute(*subject, checked_in_corpus(), asked, options);
  EXPECT_FALSE(whole.given_up);
  EXPECT_FALSE(whole.complete.empty());
}

}  // namespace
}  // namespace gonogo::identify
