// SPDX-License-Identifier: GPL-3.0-or-later
//
// What reaches a planted fault, and what triggers it.
#include "fuzz/hunt/witness.hpp"

#include <gtest/gtest.h>

#include "hunting.hpp"

namespace gonogo::hunt::testing {
namespace {

// What became of the fault when one program was run.
Witness after(const char* fault, const std::string& text) {
  auto witness = std::make_shared<Witness>();
  witness->reached_count = [fault] { return expanders::count("gsk", fault).value().reached; };
  const auto subject = witnessed(builtin("gsk", fault), builtin("gsk"), witness)();
  subject->configure(defaults("gsk988ta"));
  subject->run("case", text, [](const reference::Record&) { return true; });
  return *witness;
}

TEST(Witness, AProgramWithoutTheCycleDoesNotReachItsFault) {
  const Witness witness = after("taper-sign", "G00 X100 Z5\nG01 X50 F100\n");
  EXPECT_FALSE(witness.is_reached);
  EXPECT_FALSE(witness.is_triggered);
}

// A face cut without R takes the line that turns the taper round, and 0 is its own negative.
TEST(Witness, AFaceCutWithoutATaperReachesTheSignOfTheTaperAndDoesNotTriggerIt) {
  const Witness witness = after("taper-sign", "G00 X100 Z5\nG94 X50 Z-10 F100\n");
  EXPECT_TRUE(witness.is_reached);
  EXPECT_FALSE(witness.is_triggered);
}

TEST(Witness, AFaceCutWithATaperTriggersIt) {
  const Witness witness = after("taper-sign", kTaper);
  EXPECT_TRUE(witness.is_reached);
  EXPECT_TRUE(witness.is_triggered);
}

// The travel along Z is 15, so that only R = -15 and R = 15 tell <= from <.
TEST(Witness, ATaperOfJustTheTravelTriggersTheStrictComparison) {
  EXPECT_FALSE(after("taper-equality-refused", kTaper).is_triggered);
  EXPECT_TRUE(after("taper-equality-refused", "G00 X100 Z5\nG94 X50 Z-10 R15 F100\n").is_triggered);
}

TEST(Witness, AnAlarmOfAnotherBlockIsAnotherAnswer) {
  const std::string lacks_feed = "G00 X100 Z5\nG01 X50\n";
  EXPECT_TRUE(after("alarm-next-block", lacks_feed).is_triggered);
  EXPECT_FALSE(after("alarm-next-block", "G00 X100 Z5\n").is_triggered);
}

TEST(Witness, ARunThatTheSinkBreaksOffIsComparedAsFarAsItWent) {
  auto witness = std::make_shared<Witness>();
  const auto subject = witnessed(builtin("gsk", "taper-sign"), builtin("gsk"), witness)();
  subject->configure(defaults("gsk988ta"));
  subject->run("case", kTaper, [](const reference::Record&) { return false; });
  EXPECT_FALSE(witness->is_triggered);  // the first record is the G00 before the cycle
}

// The mistake that the bench has to be free of: the witness beside asks the fault-free expander,
// whose switch is another one.
TEST(Witness, TheExpanderBesideDoesNotCountAsReached) {
  auto witness = std::make_shared<Witness>();
  witness->reached_count = [] { return expanders::count("gsk", "taper-sign").value().reached; };
  const auto subject = witnessed(builtin("gsk"), builtin("gsk"), witness)();
  subject->configure(defaults("gsk988ta"));
  subject->run("case", kTaper, [](const reference::Record&) { return true; });
  EXPECT_FALSE(witness->is_reached);
  EXPECT_FALSE(witness->is_triggered);
}

}  // namespace
}  // namespace gonogo::hunt::testing
