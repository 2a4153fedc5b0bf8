// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is asked of one list of operations in every dialect, the references have to do, of which
// each reads its own maker's text only.
#include "fuzz/relations/operation.hpp"

#include <gtest/gtest.h>

#include "fuzz/relations/operation_path.hpp"
#include "reference/dialect.hpp"
#include "related.hpp"

namespace gonogo::relations::testing {
namespace {

constexpr std::uint64_t kSeedOfLists = 20261125;
constexpr std::size_t kMostOfAList = 1'000;
const Number kNothing = 0;

std::vector<Leg> legs_in(std::string_view dialect, const std::string& text) {
  const generate::GeneratedProgram program = program_of(dialect, text);
  const oracle::ReferenceRun run =
      oracle::run_reference(program.profile, program.text, kMostOfAList);
  EXPECT_EQ(run.end.kind, oracle::RunEnd::Kind::ok) << dialect << "\n" << text;
  return legs_of(trace_of(run), reference::Position{});
}

struct Written {
  std::string way;
  std::string text;
  std::vector<Leg> legs;
};

std::vector<Written> in_every_way(const OperationList& list) {
  std::vector<Written> all;
  for (const reference::Dialect& dialect : reference::dialects()) {
    for (const bool has_cycles : {false, true}) {
      const std::string text = written(list, {dialect.name, has_cycles});
      if (text.empty()) continue;
      all.push_back({std::string(dialect.name) + (has_cycles ? " with cycles" : ""), text,
                     legs_in(dialect.name, text)});
    }
  }
  return all;
}

TEST(Operations, GiveOnePathInEveryDialectWithCyclesAndWithout) {
  program::Dice dice(kSeedOfLists);
  std::size_t pairs = 0;
  for (int i = 0; i < 300; ++i) {
    const MachineKind machine = i % 2 == 0 ? MachineKind::lathe : MachineKind::mill;
    const OperationList list = draw_operations(dice, machine);
    const std::vector<Written> all = in_every_way(list);
    for (const Written& each : all) {
      const auto difference = first_difference(all.front().legs, each.legs, kNothing);
      EXPECT_FALSE(difference) << all.front().way << "\n"
                               << all.front().text << each.way << "\n"
                               << each.text << "want " << difference->want << "\ngot "
                               << difference->got;
      for (const Breach& breach : breaches(list, each.legs, kNothing)) {
        ADD_FAILURE() << name(breach.rule) << " " << breach.record << " at " << breach.witness
                      << "\n"
                      << each.way << "\n"
                      << each.text;
      }
      ++pairs;
    }
  }
  // Lathes in five dialects, two of them with cycles; mills in three, of which pecks in one only.
  EXPECT_GT(pairs, 1'400U);
}

// A face of 3 mm from X30 to X10 with a taper of 1 mm, by hand: to Z -3 - 1, to the corner, out to
// Z2 and back to X30. Lathes of diameters are told X60 and X20.
OperationList a_face() {
  OperationList list;
  list.machine = MachineKind::lathe;
  list.bar = 25;
  Operation face;
  face.kind = OperationKind::face;
  face.feed = 100;
  face.start = {2, 30};
  face.end = {-3, 10};
  face.taper = -1;
  list.operations.push_back(face);
  return list;
}

TEST(Operations, AFaceIsWrittenWithTheMakersCycle) {
  EXPECT_EQ(written(a_face(), {"gsk988ta", true}),
            "G18 G21 M3 S500\nG98\nG0 Z2 X60\nG94 Z-3 X20 R-1 F100\nG0 Z2 X60\nM30\n");
  EXPECT_EQ(written(a_face(), {"hnc21t", true}),
            "G90 G21 G36 M3 S500\nG94\nG0 Z2 X60\nG81 Z-3 X20 K-1 F100\nG0 Z2 X60\nM30\n");
  EXPECT_EQ(written(a_face(), {"rs274", true}),
            "G18 G90 G91.1 G21 G40 G80 M3 S500\nG94\nG0 Z2 X30\nG0 Z-4\nG1 Z-3 X10 F100\n"
            "G1 Z2 F100\nG0 X30\nM30\n");
  EXPECT_FALSE(has_cycle_for(a_face(), "rs274"));
  EXPECT_TRUE(has_cycle_for(a_face(), "gsk988ta"));
}

// hnc.modal.words: K of the first may be in force in the second.
TEST(Operations, AStraightFaceBehindATaperSaysThatItHasNone) {
  OperationList list = a_face();
  list.operations.push_back(list.operations.front());
  list.operations.back().taper = 0;
  EXPECT_EQ(written(list, {"hnc21t", true}),
            "G90 G21 G36 M3 S500\nG94\nG0 Z2 X60\nG81 Z-3 X20 K-1 F100\nG0 Z2 X60\n"
            "G94\nG0 Z2 X60\nG81 Z-3 X20 K0 F100\nG0 Z2 X60\nM30\n");
}

TEST(Operations, ATurningCycleThatRetractsAtRapidIsSeenInStock) {
  const std::string fast = "G18\nG94\nG0 X30 Z2\nG0 Z-4\nG1 Z-3 X10 F100\nG0 Z2\nG0 X30\nM2\n";
  const auto found = breaches(a_face(), legs_in("rs274", fast), kNothing);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].rule, Rule::traverse_in_stock);
  EXPECT_EQ(found[0].block, 6U);
  EXPECT_EQ(found[0].witness, "X10.000000 Y0.000000 Z-3.000000");
}

TEST(Operations, ACutBeyondTheCornerIsSeen) {
  const std::string deep = "G18\nG94\nG0 X30 Z2\nG0 Z-4\nG1 Z-3 X9.999 F100\nG1 Z2\nG0 X30\nM2\n";
  const auto found = breaches(a_face(), legs_in("rs274", deep), kNothing);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].rule, Rule::beyond_contour);
  // Within what the control resolves it is none.
  EXPECT_TRUE(breaches(a_face(), legs_in("rs274", deep), Number::decimal(false, 1, 3)).empty());
}

// Two holes to Z-6 from an R plane at Z1, initial level Z5.
OperationList two_holes(bool ends_at_r) {
  OperationList list;
  Operation holes;
  holes.kind = OperationKind::holes;
  holes.feed = 100;
  holes.level = 5;
  holes.r = 1;
  holes.depth = -6;
  holes.ends_at_r = ends_at_r;
  holes.places = {{10, 0}, {20, 0}};
  list.operations.push_back(holes);
  return list;
}

std::vector<Rule> rules_broken(const OperationList& list, const std::string& text) {
  std::vector<Rule> rules;
  for (const Breach& breach : breaches(list, legs_in("rs274", text), kNothing)) {
    rules.push_back(breach.rule);
  }
  return rules;
}

TEST(Operations, HolesAreLeftAtTheLevelThatIsAskedFor) {
  const std::string with_g98 = "G0 Z5\nG98 G81 X10 Y0 Z-6 R1 F100\nX20\nG80\nM2\n";
  const std::string with_g99 = "G0 Z5\nG99 G81 X10 Y0 Z-6 R1 F100\nX20\nG80\nM2\n";
  EXPECT_TRUE(rules_broken(two_holes(false), with_g98).empty());
  EXPECT_TRUE(rules_broken(two_holes(true), with_g99).empty());
  EXPECT_EQ(rules_broken(two_holes(true), with_g98), std::vector<Rule>{Rule::retract_level});
  EXPECT_EQ(rules_broken(two_holes(false), with_g99), std::vector<Rule>{Rule::retract_level});
}

TEST(Operations, AHoleThatIsDroppedOrShallowIsSeen) {
  EXPECT_EQ(rules_broken(two_holes(false), "G0 Z5\nG98 G81 X10 Y0 Z-6 R1 F100\nG80\nM2\n"),
            std::vector<Rule>{Rule::not_cut});
  EXPECT_EQ(rules_broken(two_holes(false), "G0 Z5\nG98 G81 X10 Y0 Z-6 R1 F100\nX20 Z-5\nG80\nM2\n"),
            std::vector<Rule>{Rule::not_cut});
}

TEST(Operations, ATraverseIntoAHoleGoesNoDeeperThanItWasCut) {
  const std::string head = "G0 Z5\nG0 X20\nG1 Z-6 F100\nG0 Z5\nG0 X10\nG1 Z-2 F100\nG0 Z1\n";
  const std::string tail = "G1 Z-6\nG0 Z5\nM2\n";
  EXPECT_TRUE(rules_broken(two_holes(false), head + "G0 Z-2\n" + tail).empty());
  EXPECT_EQ(rules_broken(two_holes(false), head + "G0 Z-2.001\n" + tail),
            std::vector<Rule>{Rule::traverse_in_stock});
  // Across, below the top.
  EXPECT_EQ(rules_broken(two_holes(false), head + "G0 Z-1\nG0 X11\nG0 X10\nG0 Z5\n" + tail),
            (std::vector<Rule>{Rule::retract_level, Rule::traverse_in_stock}));
}

TEST(Operations, NoCutTakesMoreThanOnePeck) {
  OperationList list = two_holes(false);
  list.operations[0].hole = HoleKind::peck;
  list.operations[0].peck = 3;
  const std::string pecks = "G0 Z5\nG98 G83 X10 Y0 Z-6 R1 Q3 F100\nX20\nG80\nM2\n";
  EXPECT_TRUE(rules_broken(list, pecks).empty());
  // The way of drawing G83 without pecks.
  const std::string drilled = "G0 Z5\nG98 G81 X10 Y0 Z-6 R1 F100\nX20\nG80\nM2\n";
  EXPECT_EQ(rules_broken(list, drilled), std::vector<Rule>{Rule::peck_too_deep});
  EXPECT_TRUE(written(list, {"rs274", false}).empty());
}

// A subject may say within which bounds a place lies.
TEST(Operations, WhatCannotBeToldFromALimitIsNoBreachAndNoDifference) {
  std::vector<Leg> legs = legs_in("rs274", "G0 Z5\nG0 X10\nG0 Z1\nM2\n");
  ASSERT_EQ(legs.size(), 3U);
  std::vector<Leg> enclosed = legs;
  enclosed[2].to[reference::Axis::z] = Number::between(-1, 3);
  EXPECT_FALSE(first_difference(legs, enclosed, kNothing));
  EXPECT_TRUE(breaches(two_holes(false), enclosed, kNothing).empty());
  // That the holes are not there is told where the search comes to its end.
  EXPECT_EQ(breaches(two_holes(false), legs, kNothing).size(), 1U);
}

}  // namespace
}  // namespace gonogo::relations::testing
