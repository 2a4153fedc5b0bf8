// SPDX-License-Identifier: GPL-3.0-or-later
//
// What must not change, or change in a known way, when a program of hole cycles is written in
// another way or in another plane. The records are compared exactly.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "cycle_program.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

using Steps = std::vector<TraceStep>;

Steps look(const HoleProgram& program, const HoleWriting& writing,
           const std::vector<std::array<Number, 3>>& ends = {}) {
  return trace_steps(write(program, writing, ends), machine(program, writing));
}

// Where the tool stands after each of the first steps, thousandths along the axes of G17.
std::vector<std::array<Number, 3>> ends_of(const HoleProgram& program) {
  std::vector<std::array<Number, 3>> ends;
  HoleProgram part;
  part.start = program.start;
  for (const HoleStep& step : program.steps) {
    part.steps.push_back(step);
    const Steps steps = look(part, {});
    std::array<Number, 3> at = {program.start[0], program.start[1], program.start[2]};
    if (!steps.empty()) {
      for (std::size_t i = 0; i < 3; ++i) at[i] = steps.back().at[i] * 1'000;
    }
    ends.push_back(at);
  }
  return ends;
}

// The properties below say little where the programs say little.
TEST(NgcCycleMetamorphic, TheProgramsDrillAndNoneAlarms) {
  std::map<char, int> kinds;
  std::map<int, int> codes;
  const rc::Gen<HoleProgram> any = hole_programs();
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const HoleProgram program = any(rc::Random(seed), 100).value();
    for (const HoleStep& step : program.steps) ++codes[step.code];
    for (const TraceStep& step : look(program, {})) ++kinds[step.kind];
  }
  EXPECT_EQ(codes.size(), 10U);
  for (const auto& [code, count] : codes) EXPECT_GT(count, 30) << code;
  EXPECT_GT(kinds['R'], 1'000);
  EXPECT_GT(kinds['F'], 1'000);
  EXPECT_GT(kinds['D'], 100);
  EXPECT_GT(kinds['M'], 1'000);
  EXPECT_EQ(kinds['!'] + kinds['?'], 0);
}

RC_GTEST_PROP(NgcCycleMetamorphic, StepsAreAnotherWayToWritePlaces, ()) {
  const HoleProgram program = *hole_programs();
  HoleWriting writing;
  const Steps absolute = look(program, writing);
  writing.incremental = true;
  RC_ASSERT(look(program, writing, ends_of(program)) == absolute);
}

RC_GTEST_PROP(NgcCycleMetamorphic, ThePlanesAreOnePermutationOfTheAxes, ()) {
  const HoleProgram program = *hole_programs();
  const Steps plain = look(program, {});
  for (const Plane plane : {Plane::g18, Plane::g19}) {
    HoleWriting writing;
    writing.plane = plane;
    Steps other = look(program, writing);
    const PlaneAxes axes = axes_of(plane);
    for (TraceStep& step : other) {
      step.at = {step.at[index(axes.p)], step.at[index(axes.q)], step.at[index(axes.d)]};
    }
    RC_ASSERT(other == plain);
  }
}

// The clearance of pecks is the same in both units.
RC_GTEST_PROP(NgcCycleMetamorphic, AnInchIs127FifthsOfAMillimetre, ()) {
  const HoleProgram program = *hole_programs();
  HoleWriting writing;
  writing.inch = true;
  const Steps inch = look(program, writing);
  writing.inch = false;
  writing.inch_in_mm = true;
  Steps mm = look(program, writing);
  for (TraceStep& step : mm) {
    if (step.kind == 'F') step.value = step.value * num("127/5");
  }
  RC_ASSERT(mm == inch);
}

RC_GTEST_PROP(NgcCycleMetamorphic, WordsInForceMayBeWrittenOut, ()) {
  const HoleProgram program = *hole_programs();
  HoleWriting writing;
  const Steps written = look(program, writing);
  writing.without_known = true;
  RC_ASSERT(look(program, writing) == written);
}

RC_GTEST_PROP(NgcCycleMetamorphic, TheOrderOfWordsMeansNothing, ()) {
  const HoleProgram program = *hole_programs();
  HoleWriting writing;
  writing.without_known = true;
  const Steps plain = look(program, writing);
  writing.shuffled = *rc::gen::inRange<std::uint64_t>(1, 1'000'000);
  RC_ASSERT(look(program, writing) == plain);
}

// L holes of a block are as many blocks. After the first of them the tool stands where a hole has
// left it, and R counts from there.
RC_GTEST_PROP(NgcCycleMetamorphic, LHolesAreAsManyBlocks, ()) {
  HoleProgram program = *hole_programs();
  program.steps.resize(1);
  const HoleStep& step = program.steps.front();
  const auto count = any_between(1, 4);
  for (const bool incremental : {false, true}) {
    HoleWriting writing;
    writing.incremental = incremental;
    std::string block = write(program, writing);
    block.insert(block.find("\nM2"), fmt::format(" L{}", count));
    const Steps together = trace_steps(block, machine(program, writing));
    // Each with its M function before it: those of the blocks behind the first are left out.
    std::string blocks = write(program, writing);
    blocks.erase(blocks.find("M2\n"));
    const Number left_at = look(program, {}).back().at[2];
    const std::string r = (Number(step.r_plane) / 1'000 - left_at).text();
    for (std::int64_t k = 1; k < count; ++k) {
      blocks += fmt::format(
          "X{} Y{}", (Number(step.place[0] - (incremental ? program.start[0] : 0)) / 1'000).text(),
          (Number(step.place[1] - (incremental ? program.start[1] : 0)) / 1'000).text());
      if (incremental) blocks += " R" + r;
      blocks += "\n";
    }
    RC_ASSERT(trace_steps(blocks + "M2\n", machine(program, writing)) == together);
  }
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
