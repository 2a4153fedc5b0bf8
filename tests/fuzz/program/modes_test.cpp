// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/modes.hpp"

#include <gtest/gtest.h>

namespace gonogo::program {
namespace {

using reference::Kind;
using reference::Plane;
using Codes = std::vector<std::string>;

ProgramText cut(const char* dialect, const char* program) {
  return {std::get<reference::Profile>(reference::default_profile(dialect)), program};
}

// What each line runs.
Codes codes_run(const char* dialect, const char* program) {
  Codes codes;
  for (const TextBlock& block : cut(dialect, program).blocks) {
    codes.emplace_back(block.modes.code_name());
  }
  return codes;
}

TEST(ProgramModes, ACodeStaysInForceUntilTheNextOfItsKind) {
  EXPECT_EQ(codes_run("gsk988ta", "G00 X1\nG94 X2 Z3\nX4\nG99 F1\nG01 Z5\n"),
            (Codes{"G0", "G94", "G94", "G94", "G1"}));
}

TEST(ProgramModes, ACodeOfItsBlockLeavesTheMotionInForce) {
  const ProgramText program = cut("gsk988ta", "G17 G20\nG94 X1\nX2\nG4 X1\nX3\n");
  EXPECT_EQ(program.code_at(2), "G94");
  EXPECT_NE(program.blocks[1].modes.own, nullptr);
  EXPECT_EQ(program.code_at(3), "G94");
  EXPECT_EQ(program.blocks[2].modes.own, nullptr);
  EXPECT_EQ(program.code_at(4), "G4");
  EXPECT_EQ(program.code_at(5), "G94");
  EXPECT_EQ(program.code_at(6), "");
  EXPECT_EQ(program.blocks[4].modes.plane, Plane::g17);
  EXPECT_TRUE(program.blocks[4].modes.inch);
}

TEST(ProgramModes, TheSameCodeIsAnotherThingInAnotherDialect) {
  EXPECT_EQ(codes_run("gsk988ta", "G90 X1\n"), Codes{"G90"});
  EXPECT_EQ(codes_run("hnc21t", "G90 X1\n"), Codes{"G0"});
  EXPECT_TRUE(cut("gsk988ta", "G90 X1\n").blocks[0].modes.in_cycle());
  EXPECT_FALSE(cut("hnc21t", "G91 X1\n").blocks[0].modes.in_cycle());
  EXPECT_TRUE(cut("hnc21t", "G91 X1\n").blocks[0].modes.incremental);
}

// SIE-POL-01: they put the pole, and no motion in force.
TEST(ProgramModes, APoleIsNoMotion) {
  EXPECT_EQ(codes_run("sinumerik840d", "G1 X1 F9\nG111 X5 Y5\nAP=30 RP=5\n"),
            (Codes{"G1", "G111", "G1"}));
  EXPECT_TRUE(cut("sinumerik802s", "G110 X5 Y5\n").blocks[0].modes.is_of(Kind::pole));
  EXPECT_TRUE(cut("gsk988ta", "G110 X5 Y5\n").blocks[0].modes.is_of(Kind::cycle));
}

// NGC-MOD-01, GSK-MOD-06: what it says is that no cycle is in force. On HNC it is one.
TEST(ProgramModes, ACancellingG80IsNoCycle) {
  EXPECT_FALSE(cut("rs274", "G80\n").blocks[0].modes.in_cycle());
  EXPECT_FALSE(cut("gsk988ta", "G90 X1 F9\nG80\nX2\n").blocks[2].modes.in_cycle());
  EXPECT_TRUE(cut("hnc21t", "G80 X1 Z1 F9\n").blocks[0].modes.in_cycle());
}

// NGC-COM-03 under ngc.g80-beside = ignored; GSK-MOD-06.
TEST(ProgramModes, AG80BesideAMotionLeavesTheMotion) {
  EXPECT_EQ(codes_run("rs274", "G0 G80 X1\n"), Codes{"G0"});
  EXPECT_EQ(codes_run("rs274", "G80 G0 X1\n"), Codes{"G0"});
}

TEST(ProgramModes, ACycleThatIsCalledByItsNameHoldsForItsBlock) {
  EXPECT_EQ(codes_run("sinumerik802s", "G0 X1\nLCYC82\nX2\n"), (Codes{"G0", "LCYC82", "G0"}));
  EXPECT_EQ(codes_run("sinumerik840d", "LCYC82\nCIP X1 I1=2\n"), (Codes{"", "CIP"}));
}

// HNC-G82-07, GSK-G92-06: F is the lead.
TEST(ProgramModes, AThreadIsWhereFIsALead) {
  EXPECT_TRUE(cut("hnc21t", "G32 X1 F2\n").blocks[0].modes.in_thread());
  EXPECT_TRUE(cut("gsk988ta", "G92 X1 F2\n").blocks[0].modes.in_thread());
  EXPECT_FALSE(cut("hnc21t", "G80 X1 F2\n").blocks[0].modes.in_thread());
}

TEST(ProgramModes, ACodeOfRs274ThatIsNearlyWholeIsTheOneThatItCountsAs) {
  reference::Profile profile = std::get<reference::Profile>(reference::default_profile("rs274"));
  ASSERT_FALSE(set_reading(profile, "ngc.whole", "nist"));
  const ProgramText program(profile, "G91.00001 G1.00001 X1 F9\n");
  EXPECT_EQ(program.code_at(1), "G1");
  EXPECT_TRUE(program.blocks[0].modes.incremental);
}

TEST(ProgramModes, ALineThatIsLeftOutChangesNothing) {
  reference::Profile profile = std::get<reference::Profile>(reference::default_profile("rs274"));
  profile.block_skip = true;
  EXPECT_EQ(ProgramText(profile, "G0 X1\n/G1 X2 F9\nX3\n").code_at(3), "G0");
}

TEST(ProgramModes, AWordIsWhatTheCodeInForceMakesOfIt) {
  using reference::Role;
  const auto role = [](const ProgramText& program, std::size_t line, const char* name) {
    const TextBlock& block = program.blocks[line];
    return block.role_of(*block.find(name), *program.table)->role;
  };
  const ProgramText gsk = cut("gsk988ta", "G94 X1 R2 F9\nG4 X1\nG110 R3 F9\nG92 F9\n");
  EXPECT_EQ(role(gsk, 0, "R"), Role::along_p);
  EXPECT_EQ(role(gsk, 1, "X"), Role::time);
  EXPECT_EQ(role(gsk, 2, "R"), Role::along_d);
  EXPECT_EQ(role(gsk, 2, "F"), Role::feed);
  EXPECT_EQ(role(gsk, 3, "F"), Role::lead);
  // A dwell of RS274 stands beside the motion in force.
  const ProgramText ngc = cut("rs274", "G0\nG4 P1 X2\n");
  EXPECT_EQ(role(ngc, 1, "P"), Role::time);
  EXPECT_EQ(role(ngc, 1, "X"), Role::place);
}

}  // namespace
}  // namespace gonogo::program
