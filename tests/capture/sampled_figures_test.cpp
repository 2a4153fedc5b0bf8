// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is told beside a verdict of samples: noise, the tolerance from which on it is GO, the worst
// deviation; corners that may be cut; columns by other names.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/capture/sampling.hpp"
#include "tests/has.hpp"

namespace gonogo::oracle {
namespace {

constexpr const char* kProgram = "G17 G00 X20 Y0\nG01 X40 F600\nY10\n";

SampledMachine machine_of_two_lines() {
  SampledMachine machine(0.004);
  machine.stand(0.2).line({10, 0, 0}, 6000).line({20, 0, 0}, 600).line({20, 10, 0}, 600);
  machine.stand(0.4);
  return machine;
}

// Uniform noise of at most two thousandths, seed fixed.
std::vector<SampledMachine::Row> noisy(std::vector<SampledMachine::Row> rows, double most) {
  std::mt19937 random(28);
  const auto draw = [&] {
    constexpr double kHalf = 2147483647.5;
    return (static_cast<double>(random()) / kHalf - 1) * most;
  };
  for (auto& row : rows) row.at = {row.at.x + draw(), row.at.y + draw(), row.at.z + draw()};
  return rows;
}

TEST(SampledFigures, AToleranceFinerThanTheNoiseIsNoNoGo) {
  SampledMachine machine = machine_of_two_lines();
  const Verdict verdict = judge_samples({kProgram}, csv_of(noisy(machine.rows(), 0.002)));
  EXPECT_EQ(verdict.kind, VerdictKind::oracle_gap) << verdict.message;
  ASSERT_NE(verdict.sampled, nullptr);
  const Number from = *Number::parse(verdict.sampled->go_from);
  EXPECT_GT(from, Number::millionths(1'500));
  EXPECT_LE(from, Number::millionths(2'000));  // never off by more than the noise
  const Number noise = *Number::parse(verdict.sampled->noise);
  EXPECT_GT(noise, Number::millionths(1'500));
  EXPECT_LE(noise, Number::millionths(3'000));
  EXPECT_TRUE(has(verdict.message, "--tolerance"));
}

TEST(SampledFigures, ADepartureThatNoiseDoesNotExplainStaysNoGo) {
  SampledMachine machine = machine_of_two_lines();
  auto rows = noisy(machine.rows(), 0.002);
  for (auto& row : rows) row.at.z += row.at.x > 15 ? 0.02 : 0;
  const Verdict verdict = judge_samples({kProgram}, csv_of(rows));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry);
  EXPECT_GE(*Number::parse(verdict.sampled->go_from), Number::millionths(20'000));
  const Verdict granted = judge_samples({.program = kProgram, .tolerance = "0.01"}, csv_of(rows));
  EXPECT_EQ(granted.kind, VerdictKind::fail_geometry);
}

// All cuts 0.008 too low, to the digit: from there on it is GO, and not a step before.
TEST(SampledFigures, GoFromIsTheLeastTolerance) {
  SampledMachine machine = machine_of_two_lines();
  auto rows = machine.rows();
  for (auto& row : rows) row.at.z -= row.at.x > 10.5 ? 0.008 : 0;
  const Verdict verdict = judge_samples({kProgram}, csv_of(rows));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry);
  EXPECT_EQ(verdict.sampled->go_from, "0.008");
  EXPECT_TRUE(has(verdict.message, "GO from 0.008 mm up."));
}

TEST(SampledFigures, AGoSaysHowFarOffItWasAndWhere) {
  SampledMachine machine = machine_of_two_lines();
  auto rows = machine.rows();
  for (auto& row : rows) row.at.z += row.at.y > 4 && row.at.y < 5 ? 0.0007 : 0;
  const Verdict verdict = judge_samples({kProgram}, csv_of(rows));
  EXPECT_EQ(verdict.kind, VerdictKind::pass_tolerance) << verdict.message;
  EXPECT_EQ(verdict.sampled->worst, "0.0007");
  EXPECT_EQ(verdict.sampled->worst_block, 3U);
  EXPECT_TRUE(has(verdict.sampled->worst_at, "0.0007"));
}

// The samples are 0.05 mm beside the path: no coordinate of theirs is exact.
TEST(SampledFigures, SamplesHaveNoCountsOfCoordinates) {
  SampledMachine machine;
  machine.line({10, 0, 0.05}, 600).line({10, 10, 0.05}, 600);
  auto rows = machine.rows();
  for (auto& row : rows) row.at.z = 0.05;
  const Verdict verdict = judge_samples(
      {.program = "G1 X10 F600\nY10\nM2\n", .dialect = "rs274", .tolerance = "0.1"}, csv_of(rows));
  EXPECT_EQ(verdict.kind, VerdictKind::pass_tolerance) << verdict.message;
  EXPECT_FALSE(verdict.coordinates);
}

// The corner at (20, 0) rounded by a quarter of radius r: off the path by r (1 - sqrt(1/2)) at
// most on each axis, 0.29 r.
std::string rounded_corner(double radius) {
  SampledMachine machine(0.001);
  machine.line({10, 0, 0}, 6000).line({20 - radius, 0, 0}, 600);
  machine.turn({20 - radius, radius, 0}, 90, 600);
  machine.line({20, 10, 0}, 600).stand(0.1);
  return machine.csv();
}

TEST(SampledBlend, ACornerCutWithinTheAllowanceIsGoAndOneBeyondIsNot) {
  const std::string cut = rounded_corner(0.1);
  EXPECT_EQ(judge_samples({kProgram}, cut).kind, VerdictKind::fail_geometry);
  SampledCase granted{kProgram};
  granted.blend = "0.05";
  EXPECT_EQ(judge_samples(granted, cut).kind, VerdictKind::pass_tolerance)
      << judge_samples(granted, cut).message;
  granted.blend = "0.02";
  EXPECT_EQ(judge_samples(granted, cut).kind, VerdictKind::fail_geometry);
}

// Away from a corner the allowance grants nothing: neither a bulge amid a motion nor a whole motion
// beside its place.
TEST(SampledBlend, ElsewhereNothingIsGranted) {
  SampledCase granted{kProgram};
  granted.blend = "0.05";
  SampledMachine machine = machine_of_two_lines();
  auto bulge = machine.rows();
  for (auto& row : bulge) row.at.y += row.at.x > 14 && row.at.x < 15 ? 0.01 : 0;
  EXPECT_EQ(judge_samples(granted, csv_of(bulge)).kind, VerdictKind::fail_geometry);
  auto beside = machine.rows();
  for (auto& row : beside) row.at.z += row.at.x > 10.001 && row.at.x < 19.999 ? 0.01 : 0;
  EXPECT_EQ(judge_samples(granted, csv_of(beside)).kind, VerdictKind::fail_geometry);
}

TEST(SampledColumns, OtherNamesSeparatorsUnitsAndCommasAreRead) {
  SampledMachine machine = machine_of_two_lines();
  std::string text = "Trace of the axes\nTime[ms];Load;X_act;Y_act;Z_act\n";
  for (const auto& [time, at] : machine.rows()) {
    std::string row = std::to_string(time * 1000) + ";1,5;" + std::to_string(at.x * 2) + ";" +
                      std::to_string(at.y) + ";" + std::to_string(at.z / 25.4) + "\n";
    for (char& each : row) each = each == '.' ? ',' : each;
    text += row;
  }
  SampledCase named{kProgram};
  named.columns = "t=Time[ms],x=X_act:diameter,y=Y_act,z=Z_act:in";
  EXPECT_EQ(judge_samples(named, text).kind, VerdictKind::pass_tolerance)
      << judge_samples(named, text).message;
  // Not said, it stays NO-GO, with what to look at.
  named.columns = "t=Time[ms],x=X_act,y=Y_act,z=Z_act:in";
  const Verdict twice = judge_samples(named, text);
  EXPECT_EQ(twice.kind, VerdictKind::fail_geometry);
  EXPECT_TRUE(has(twice.message, "x=NAME:diameter"));
}

TEST(SampledColumns, WhatCannotBeReadIsNamed) {
  SampleColumns columns;
  EXPECT_NE(read_columns("q=Time", columns)->find("\"q=Time\""), std::string::npos);
  EXPECT_NE(read_columns("x=X:furlong", columns)->find("furlong"), std::string::npos);
  EXPECT_NE(read_columns("y=Y:diameter", columns)->find("diameter"), std::string::npos);
  EXPECT_NE(read_columns("z=A,z=B", columns)->find("twice"), std::string::npos);
  SampledCase named{kProgram};
  named.columns = "t=Time,x=X";
  EXPECT_THROW(judge_samples(named, "t,x\n0,0\n"), SampleFault);
  EXPECT_THROW(judge_samples(named, "Time,Y\n0,0\n"), SampleFault);
}

}  // namespace
}  // namespace gonogo::oracle
