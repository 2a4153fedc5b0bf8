// SPDX-License-Identifier: GPL-3.0-or-later
//
// What must not change, or change in a known way, when an RS274/NGC program is written in another
// way or in other axes. The records are compared exactly.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <random>

#include "ngc_program.hpp"
#include "reference/clause_literal.hpp"
#include "tests/reference/path_trace.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

PathTrace look(const Program& program, const Writing& writing) {
  return path_trace(text(write(program, writing)), machine(program, writing));
}

Writing any_writing() {
  Writing writing;
  writing.incremental = any_between(0, 1) == 1;
  writing.absolute_centres = any_between(0, 1) == 1;
  return writing;
}

// The properties below say little where the programs say little.
TEST(NgcMetamorphic, TheProgramsMoveAndFewOfThemAlarm) {
  std::map<ClauseId, int> motions;
  std::map<AlarmClass, int> alarms;
  const rc::Gen<Program> any = programs();
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    for (const PathItem& item : look(any(rc::Random(seed), 100).value(), {})) {
      ++motions[item.clause];
      for (const auto& [alarm, clause] : item.alarms) ++alarms[alarm];
    }
  }
  EXPECT_GT(motions["NGC-ARC-02"_clause] + motions["NGC-ARC-01"_clause], 100);
  EXPECT_GT(motions["NGC-ARC-04"_clause], 100);
  EXPECT_GT(alarms[AlarmClass::arc_end_point], 10);
  EXPECT_GT(alarms[AlarmClass::arc_radius], 10);
  EXPECT_LT(alarms[AlarmClass::arc_end_point] + alarms[AlarmClass::arc_radius], 200);
}

// Exact arcs: the limits of the others do not grow with them.
RC_GTEST_PROP(NgcMetamorphic, ALargerProgramHasALargerPath, ()) {
  const Program program = *two_way_programs();
  Writing writing = any_writing();
  AxesChange change;
  change.scale = static_cast<int>(any_between(2, 9));
  const PathTrace plain = look(program, writing);
  Program larger = program;
  for (Step& step : larger.steps) step.radius *= change.scale;
  writing.axes = change;
  RC_ASSERT(look(larger, writing) == changed(plain, change));
}

// An arc of G20 has limits of its own, so that these are of exact arcs.
RC_GTEST_PROP(NgcMetamorphic, AnInchIs254TenthsOfAMillimetre, ()) {
  const Program program = *two_way_programs();
  Writing writing = any_writing();
  writing.inch = true;
  const PathTrace inch = look(program, writing);
  writing.inch = false;
  writing.inch_in_mm = true;
  PathTrace mm = look(program, writing);
  // F counts inches too.
  for (PathItem& item : mm) item.feed = item.feed * Number::decimal(false, 254, 1);
  RC_ASSERT(mm == inch);
}

RC_GTEST_PROP(NgcMetamorphic, TheDistanceModesAreTwoWaysToWriteOnePath, ()) {
  const Program program = *programs();
  Writing writing;
  const PathTrace absolute = look(program, writing);
  for (const bool centres : {false, true}) {
    for (const bool ends : {false, true}) {
      writing.absolute_centres = centres;
      writing.incremental = ends;
      RC_ASSERT(look(program, writing) == absolute);
    }
  }
}

// Where the radius is a decimal, R leaves no root.
RC_GTEST_PROP(NgcMetamorphic, ARadiusIsACentre, ()) {
  const Program program = *programs();
  Writing writing = any_writing();
  const PathTrace by_centre = look(program, writing);
  writing.centres_by_r = true;
  RC_ASSERT(without_clauses(look(program, writing)) == without_clauses(by_centre));
}

RC_GTEST_PROP(NgcMetamorphic, APathWalkedBackwardsIsThePathReversed, ()) {
  const Program program = *two_way_programs();
  const Writing writing = any_writing();
  const PathTrace there = look(program, writing);
  for (const PathItem& item : there) RC_ASSERT(item.alarms.empty());
  const PathTrace back = look(ngc::reversed(program), writing);
  RC_ASSERT(without_blocks(motions_of(back)) == testing::reversed(there, program.start));
}

RC_GTEST_PROP(NgcMetamorphic, TheOrderOfWordsMeansNothing, ()) {
  const Program program = *programs();
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const Writing writing = any_writing();
  Blocks blocks = write(program, writing);
  for (auto& words : blocks) std::shuffle(words.begin(), words.end(), random);
  RC_ASSERT(path_trace(text(blocks), machine(program, writing)) == look(program, writing));
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
