// SPDX-License-Identifier: GPL-3.0-or-later
//
// R2, R3: the numbers of records beside their places, and the pieces of a thread.
#include "oracle/motion/labels.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

Number number(const char* text) {
  return *Number::parse(text);
}
Number between(const char* low, const char* high) {
  return Number::between(number(low), number(high));
}
bool is_undecided(const auto& question) {
  try {
    (void)question();
    return false;
  } catch (const exact::Undecided&) {
    return true;
  }
}

// 31.25 / sqrt(629) = 1.2460190981701562...
const Number kLead = number("31.25") / exact::sqrt(629);

Tolerances tolerances_of(const char* increment) {
  Tolerances tolerances;
  tolerances.increment = number(increment);
  return tolerances;
}

TEST(Labels, ADecimalOfWhichNothingIsDeclaredIsRoundedToItsOwnLastPlace) {
  const Tolerances tolerances = tolerances_of("0.0001");
  for (const char* got : {"1.24601909817", "1.246019098170156", "1.2460191", "1.24602", "1.246"}) {
    EXPECT_TRUE(stands_for(number(got), kLead, std::nullopt, tolerances)) << got;
  }
  // Off by one in the last place, and a place coarser than the profile's: 1.2 is off by 0.046.
  for (const char* got : {"1.24601909818", "1.246019098171", "1.2460192", "1.24603", "1.2461",
                          "1.247", "1.25", "1.2", "1"}) {
    EXPECT_FALSE(stands_for(number(got), kLead, std::nullopt, tolerances)) << got;
  }
  // As near, but no decimal.
  EXPECT_FALSE(stands_for(number("1.246") + Number(1) / 60'000, kLead, std::nullopt, tolerances));
}

TEST(Labels, ADecimalThatCanBeWrittenHasToBe) {
  const Tolerances tolerances = tolerances_of("0.001");
  EXPECT_TRUE(stands_for(100, 100, std::nullopt, tolerances));
  for (const char* got : {"100.0004", "99.9999", "100.00001", "100.000000000001"}) {
    EXPECT_FALSE(stands_for(number(got), 100, std::nullopt, tolerances)) << got;
  }
  // The increment is the coarsest rounding.
  EXPECT_TRUE(stands_for(number("0.333"), Number(1) / 3, std::nullopt, tolerances));
  EXPECT_FALSE(stands_for(number("0.33"), Number(1) / 3, std::nullopt, tolerances));
}

TEST(Labels, WhatIsDeclaredCountsInsteadOfTheLastPlace) {
  const Tolerances tolerances = tolerances_of("0.0001");
  EXPECT_TRUE(stands_for(number("1.24603"), kLead, number("0.0001"), tolerances));
  EXPECT_FALSE(stands_for(number("1.2461"), kLead, number("0.0001"), tolerances));
  EXPECT_FALSE(stands_for(number("1.24603"), kLead, number("0.00001"), tolerances));
}

// The last place of 1.25 is 2^-52, and 2^-51 of it two and a half of these.
TEST(Labels, ADoubleMayBeOffByTwoUnitsInTheLastPlace) {
  Tolerances tolerances = tolerances_of("0.0001");
  const Number unit = Number::binary(1, -52);
  EXPECT_TRUE(stands_for(number("1.25") + unit, number("1.25"), std::nullopt, tolerances));
  tolerances.binary64 = true;
  EXPECT_TRUE(stands_for(number("1.25") - unit * 2, number("1.25"), std::nullopt, tolerances));
  EXPECT_FALSE(stands_for(number("1.25") - unit * 5, number("1.25"), std::nullopt, tolerances));
  tolerances.binary64 = false;
  tolerances.exact = true;
  EXPECT_FALSE(stands_for(number("1.25") + unit, number("1.25"), std::nullopt, tolerances));
}

TEST(Labels, AnEnclosureThatHoldsTheNumberIsTheNumber) {
  for (const bool exact : {false, true}) {
    Tolerances tolerances = tolerances_of("0.001");
    tolerances.exact = exact;
    EXPECT_TRUE(stands_for(between("99.9999999999999998", "100.0000000000000002"), 100,
                           std::nullopt, tolerances));
    EXPECT_TRUE(stands_for(between("100", "100.0000000000000002"), 100, std::nullopt, tolerances));
    EXPECT_TRUE(stands_for(between("1.2460190981701562", "1.2460190981701563"), kLead, std::nullopt,
                           tolerances));
    EXPECT_FALSE(
        stands_for(between("100.0001", "100.0001000000000001"), 100, std::nullopt, tolerances));
    EXPECT_FALSE(stands_for(between("99.9", "99.9000000000000001"), 100, std::nullopt, tolerances));
  }
}

TEST(Labels, AnEnclosureIsUndecidedOnlyWhereItsWidthDecides) {
  const Tolerances tolerances = tolerances_of("0.001");
  const Number step = number("0.001");
  const auto told = [&](const char* low, const char* high) {
    return stands_for(between(low, high), 100, step, tolerances);
  };
  EXPECT_TRUE(told("100.0004", "100.0004000000000001"));
  EXPECT_FALSE(told("100.0006", "100.0006000000000001"));
  EXPECT_TRUE(is_undecided([&] { return told("100.0004999999999999", "100.0005000000000001"); }));
}

TEST(Labels, StartAnglesAWholeTurnApartAreTheSame) {
  const Tolerances tolerances = tolerances_of("0.001");
  const auto agree_on = [&](const Number& want, const Number& got) {
    Record one, other;
    one.start = want;
    other.start = got;
    return start_angles_agree(one, other, tolerances);
  };
  EXPECT_TRUE(agree_on(0, 360));
  EXPECT_TRUE(agree_on(270, -90));
  EXPECT_TRUE(agree_on(number("359.999"), number("-0.001")));
  EXPECT_FALSE(agree_on(0, 180));
  EXPECT_FALSE(agree_on(0, number("0.001")));
  EXPECT_TRUE(agree_on(0, between("359.9999999999999999", "360.0000000000000001")));
  EXPECT_FALSE(agree_on(0, between("180", "180.0000000000000001")));
}

std::string thread_in_two(const char* first, const char* second, bool blocks, const char* lead) {
  const std::string line = blocks ? R"("b":2,)" : "";
  const std::string before = blocks ? R"("b":1,)" : "";
  return fmt::format(
      R"({{"k":"rapid",{0}"to":{{"x":"25","z":"4"}}}}
{{"k":"rapid",{1}"to":{{"x":"20"}}}}
{{"k":"thread",{1}"to":{{"z":"-11"}},"lead":"{4}","start":"{2}"}}
{{"k":"thread",{1}"to":{{"z":"-30"}},"lead":"{4}","start":"{3}"}}
{{"k":"rapid",{1}"to":{{"x":"25"}}}}
{{"k":"rapid",{1}"to":{{"z":"4"}}}}
)",
      before, line, first, second, lead);
}

TEST(ThreadPieces, OneThatGoesOnHasTheAngleOfTheFirst) {
  constexpr std::string_view kHncThread = "G00 X50 Z4\nG82 X40 Z-30 P90 F2\n";
  for (const bool blocks : {true, false}) {
    const Judging hnc = {.blocks = blocks, .dialect = "hnc21t"};
    const auto told = [&](const char* first, const char* second) {
      return judge_trace(kHncThread, thread_in_two(first, second, blocks, "2"), hnc).kind;
    };
    EXPECT_EQ(told("90", "90"), VerdictKind::pass_exact) << blocks;
    EXPECT_EQ(told("90", "450"), VerdictKind::pass_exact) << blocks;
    for (const char* second : {"77", "0", "90.001", "270"}) {
      EXPECT_EQ(told("90", second), VerdictKind::fail_geometry) << blocks << second;
    }
    EXPECT_EQ(told("0", "90"), VerdictKind::fail_geometry) << blocks;
  }
}

// From (10, 5) to (12, -20) at 1.25 mm a turn along the path: 1.246... along Z.
constexpr std::string_view kSlanting = "G21 G18 G90 M3\nG0 X10 Z5\nG33 Z-20 X12 K1.25\nM2\n";

std::string slanting(std::string_view lead, const char* second_start = nullptr) {
  const auto piece = [&](const char* to, const char* start) {
    return fmt::format(R"({{"k":"thread","b":3,"to":{{{}}},"lead":{},"start":"{}"}})"
                       "\n",
                       to, lead, start);
  };
  std::string trace = R"({"k":"rapid","b":2,"to":{"x":"10","z":"5"}})"
                      "\n";
  if (second_start != nullptr) {
    trace += piece(R"("x":"11","z":"-7.5")", "0");
    return trace + piece(R"("x":"12","z":"-20")", second_start);
  }
  return trace + piece(R"("x":"12","z":"-20")", "0");
}

TEST(ThreadPieces, ALeadThatIsNoDecimalMayBeGivenAsOne) {
  for (const bool exact : {false, true}) {
    const Judging ngc = {.dialect = "rs274", .exact = exact};
    const auto told = [&](const char* lead) {
      return decision(judge_trace(kSlanting, slanting(lead), ngc).kind);
    };
    EXPECT_EQ(told(R"("1.24601909817")"), Decision::go);
    EXPECT_EQ(told(R"({"root":["0","125/2516","629"]})"), Decision::go);
    EXPECT_EQ(told(R"({"enclosure":["1.2460190981701562","1.2460190981701563"]})"), Decision::go);
    EXPECT_EQ(told(R"("1.25")"), Decision::no_go);
    EXPECT_EQ(told(R"("1.24601909818")"), Decision::no_go);
  }
}

TEST(ThreadPieces, OneOfASlantingThreadHasTheAngleOfTheFirst) {
  const Judging ngc = {.dialect = "rs274"};
  const char* lead = R"("1.24601909817")";
  EXPECT_EQ(decision(judge_trace(kSlanting, slanting(lead, "0"), ngc).kind), Decision::go);
  EXPECT_EQ(judge_trace(kSlanting, slanting(lead, "180"), ngc).kind, VerdictKind::fail_geometry);
}

// The verdicts of a cut and a dwell whose numbers come as enclosures of 4e-16.
TEST(EnclosedLabels, DecideAsTheirNumbersDo) {
  constexpr std::string_view kProgram = "G0 X10 Y0\nG1 X20 F100\nG4 P2\n";
  const auto around = [](const char* low, const char* high) {
    return fmt::format(R"({{"enclosure":["{}","{}"]}})", low, high);
  };
  const auto told = [&](const std::string& feed, const std::string& seconds) {
    const std::string trace = fmt::format(
        R"({{"k":"rapid","b":1,"to":{{"x":"10","y":"0"}}}}
{{"k":"feed","b":2,"to":{{"x":"20"}},"f":{}}}
{{"k":"dwell","b":3,"s":{}}}
)",
        feed, seconds);
    return decision(judge_trace(kProgram, trace, {.dialect = "rs274"}).kind);
  };
  const std::string hundred = around("99.9999999999999998", "100.0000000000000002");
  const std::string two = around("1.9999999999999998", "2.0000000000000002");
  EXPECT_EQ(told(hundred, two), Decision::go);
  EXPECT_EQ(told(around("90", "90.0000000000000002"), two), Decision::no_go);
  EXPECT_EQ(told(hundred, around("3", "3.0000000000000002")), Decision::no_go);
}

}  // namespace
}  // namespace gonogo::oracle
