// SPDX-License-Identifier: GPL-3.0-or-later
//
// That generated programs of rs274 reach every canned cycle and thread, their branches, and what
// is refused of them.
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "fuzz/generate/program_report.hpp"

namespace gonogo::generate {
namespace {

// What so many programs of the default settings hold and reach.
const Distribution& reached() {
  static const Distribution kReached = [] {
    constexpr std::uint64_t kPrograms = 4'000;
    Distribution counts;
    for (std::uint64_t seed = 1; seed <= kPrograms; ++seed) {
      Choices choices(seed);
      count_program(generator_of("rs274").generate(choices, &counts), counts);
    }
    return counts;
  }();
  return kReached;
}

void expect_each(std::initializer_list<const char*> what, std::size_t least) {
  for (const char* each : what) {
    const auto found = reached().find(each);
    EXPECT_GE(found == reached().end() ? 0U : found->second, least) << each;
  }
}

TEST(NgcCyclesGenerator, EveryCycleIsEnteredAndRepeated) {
  for (const int code : {73, 74, 81, 82, 83, 84, 85, 86, 89}) {
    expect_each({("G" + std::to_string(code) + " entry").c_str(),
                 ("G" + std::to_string(code) + " repeated").c_str()},
                200);
  }
  expect_each({"G33 entry", "G331 entry", "G76 entry"}, 200);
}

// Their records show that their blocks ran.
TEST(NgcCyclesGenerator, EveryCycleRuns) {
  expect_each({"clause NGC-CYC", "clause NGC-G73", "clause NGC-G81", "clause NGC-G82",
               "clause NGC-G83", "clause NGC-G84", "clause NGC-G85", "clause NGC-G86",
               "clause NGC-G89", "clause NGC-G33", "clause NGC-G331", "clause NGC-G76"},
              150);
}

TEST(NgcCyclesGenerator, EveryBranchIsDrawnOften) {
  expect_each({"cycle in G17", "cycle in G18", "cycle in G19", "cycle under G90", "cycle under G91",
               "cycle under G98", "cycle under G99", "cycle before G98 and G99", "cycle repeated",
               "cycle repeated by its code", "cycle: a row of holes", "cycle: L in one place",
               "cycle: R above the tool", "cycle: R at the tool", "cycle: R below the tool"},
              500);
  expect_each({"minute pecks", "dwell in a cycle"}, 100);
}

TEST(NgcCyclesGenerator, WhatIsRefusedOfACycleIsDrawn) {
  expect_each({"refused by NGC-CYC-02 missing-word", "refused by NGC-CYC-04 missing-word",
               "refused by NGC-CYC-07 reference-plane", "refused by NGC-CYC-15 not-an-integer",
               "refused by NGC-CYC-18 axis-not-in-plane", "refused by NGC-CYC-20 feed-missing",
               "refused by NGC-CYC-22 value-sign", "refused by NGC-G84-01 direction-conflict",
               "refused by NGC-G84-01 spindle-stopped"},
              10);
  expect_each({"refused by NGC-CYC-15 value-out-of-range", "refused by NGC-CYC-15 value-sign",
               "refused by NGC-G86-01 spindle-stopped"},
              3);
}

TEST(NgcCyclesGenerator, WhatIsRefusedOfAThreadIsDrawn) {
  expect_each({"refused by NGC-G33-02 lead-missing", "refused by NGC-G33-03 conflicting-words",
               "refused by NGC-G33-05 value-sign", "refused by NGC-G76-01 missing-word",
               "refused by NGC-G76-02 axis-not-in-plane", "refused by NGC-G76-02 plane-not-allowed",
               "refused by NGC-G76-03 value-out-of-range", "refused by NGC-G76-03 value-sign"},
              10);
  expect_each({"refused by NGC-G33-01 missing-word", "refused by NGC-G33-04 spindle-stopped",
               "refused by NGC-G76-01 lead-missing", "refused by NGC-G76-03 not-an-integer",
               "refused by NGC-G76-04 spindle-stopped"},
              3);
}

// The program of a cycle is some hundred motions long: no block makes thousands.
TEST(NgcCyclesGenerator, NoProgramIsLong) {
  constexpr std::size_t kMostRecords = 10'000;
  for (std::uint64_t seed = 1; seed <= 4'000; ++seed) {
    Choices choices(seed);
    Distribution counts;
    count_program(generator_of("rs274").generate(choices, nullptr), counts);
    EXPECT_LT(counts["records"], kMostRecords) << seed;
  }
}

}  // namespace
}  // namespace gonogo::generate
