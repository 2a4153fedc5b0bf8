// SPDX-License-Identifier: GPL-3.0-or-later
//
// What must not change, or change in a known way, when a SINUMERIK program is written in another
// way or in other axes. The records are compared exactly.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "sie_program.hpp"
#include "tests/reference/path_trace.hpp"

namespace gonogo::reference::testing::sie {
namespace {

PathTrace look(const Program& program, const Writing& writing) {
  return path_trace(text(write(program, writing)), machine(program, writing));
}
PathTrace look(const std::string& text, const Program& program) {
  return path_trace(text, machine(program, {}));
}

Ends any_ends() {
  return static_cast<Ends>(any_between(0, 3));
}
Writing any_writing() {
  Writing writing;
  writing.ends = any_ends();
  writing.absolute_centres = any_between(0, 1) == 1;
  return writing;
}

struct Tally {
  std::array<int, kKinds> steps = {};
  std::map<ClauseId, int> motions;
  std::map<AlarmClass, int> alarms;
  int programs_with_alarm = 0;
};

Tally tally_of_300() {
  Tally tally;
  const rc::Gen<Program> any = programs();
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Program program = any(rc::Random(seed), 100).value();
    for (const Step& step : program.steps) ++tally.steps[static_cast<std::size_t>(step.kind)];
    for (const PathItem& item : look(program, {})) {
      ++tally.motions[item.clause];
      for (const auto& [alarm, clause] : item.alarms) ++tally.alarms[alarm];
      if (!item.alarms.empty()) ++tally.programs_with_alarm;
    }
  }
  return tally;
}

// The properties below say little where the programs say little.
TEST(SieMetamorphic, TheProgramsMoveAndFewOfThemAlarm) {
  Tally tally = tally_of_300();
  EXPECT_GT(tally.programs_with_alarm, 20);
  EXPECT_LT(tally.programs_with_alarm, 150);
  for (const int count : tally.steps) EXPECT_GT(count, 30);
  for (const AlarmClass alarm : {AlarmClass::arc_end_point, AlarmClass::arc_radius,
                                 AlarmClass::arc_tangent, AlarmClass::arc_intermediate_point}) {
    EXPECT_GT(tally.alarms[alarm], 0) << name(alarm);
  }
}

RC_GTEST_PROP(SieMetamorphic, ALargerProgramHasLargerLimits, ()) {
  const Program program = *programs();
  const Writing writing = any_writing();
  AxesChange change;
  change.scale = static_cast<int>(any_between(2, 9));
  const Program larger = scaled(program, change.scale);
  Profile profile = machine(larger, writing);
  profile.parameters["CIRCLE_ERROR_CONST"] = Number::millionths(10'000) * change.scale;
  RC_ASSERT(path_trace(text(write(larger, writing)), profile) ==
            changed(look(program, writing), change));
}

RC_GTEST_PROP(SieMetamorphic, AnInchIs254TenthsOfAMillimetre, ()) {
  const Program program = *programs();
  Writing writing = any_writing();
  writing.lengths = Lengths::inch;
  const PathTrace inch = look(program, writing);
  writing.lengths = Lengths::inch_in_mm;
  RC_ASSERT(look(program, writing) == inch);
}

RC_GTEST_PROP(SieMetamorphic, IncrementsLeadWhereAbsoluteWordsLead, ()) {
  const Program program = *programs();
  Writing writing;
  const PathTrace absolute = look(program, writing);
  for (const Ends ends : {Ends::incremental, Ends::ac_and_ic, Ends::mixed}) {
    writing.ends = ends;
    RC_ASSERT(look(program, writing) == absolute);
  }
}

RC_GTEST_PROP(SieMetamorphic, ACentreIsAnIncrementOrAPlace, ()) {
  const Program program = *programs();
  Writing writing = any_writing();
  writing.absolute_centres = false;
  const PathTrace increments = look(program, writing);
  writing.absolute_centres = true;
  RC_ASSERT(look(program, writing) == increments);
}

RC_GTEST_PROP(SieMetamorphic, ParametersAndExpressionsStandForNumbers, ()) {
  const Program program = *programs();
  Writing writing = any_writing();
  const PathTrace numbers = without_blocks(look(program, writing));
  for (const Values values : {Values::parameters, Values::expressions}) {
    writing.values = values;
    // Poles have their assignments in a block before.
    RC_ASSERT(without_blocks(look(program, writing)) == numbers);
  }
}

RC_GTEST_PROP(SieMetamorphic, APoleIsWhereItIsWhateverItIsCountedFrom, ()) {
  const Program program = *programs();
  Writing writing = any_writing();
  const PathTrace relative = look(program, writing);
  writing.poles_from_zero = true;
  RC_ASSERT(look(program, writing) == relative);
}

// Programs of nothing but flat arcs and lines have the planes that their axes say.
RC_GTEST_PROP(SieMetamorphic, TheAxesOfTheEndPointChooseThePlane, ()) {
  Program program = *programs();
  const auto cannot = [](const Step& step) {
    return step.kind > Kind::radius || (step.kind >= Kind::centre && step.is_helix());
  };
  std::erase_if(program.steps, cannot);
  Vector at = program.start;
  for (Step& step : program.steps) {
    const Vector by = at - step.from;
    for (Vector* place : {&step.from, &step.to, &step.centre}) *place = *place + by;
    step.astray = false;
    at = step.to;
  }
  Writing writing = any_writing();
  const auto bare = [](const PathTrace& trace) { return without_blocks(without_clauses(trace)); };
  const PathTrace by_code = bare(look(program, writing));
  writing.planes_by_axes = true;
  RC_ASSERT(bare(look(program, writing)) == by_code);
}

RC_GTEST_PROP(SieMetamorphic, APathWalkedBackwardsIsThePathReversed, ()) {
  const Program program = *two_way_programs();
  const Writing writing = any_writing();
  const PathTrace there = look(program, writing);
  for (const PathItem& item : there) RC_ASSERT(item.alarms.empty());
  const PathTrace back = look(sie::reversed(program), writing);
  RC_ASSERT(without_blocks(motions_of(back)) == testing::reversed(there, program.start));
}

RC_GTEST_PROP(SieMetamorphic, BlanksCaseAndCommentsMeanNothing, ()) {
  const Program program = *programs();
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const auto one_in = [&](unsigned count) { return random() % count == 0; };
  std::string laid_out;
  for (const auto& words : write(program, any_writing())) {
    laid_out += one_in(4) ? "/ " : one_in(4) ? "N70 " : one_in(4) ? "ECKE_1: " : "";
    for (std::string word : words) {
      if (one_in(3)) std::transform(word.begin(), word.end(), word.begin(), ::tolower);
      const std::size_t equals = word.find('=');
      if (equals != std::string::npos && one_in(3)) word.replace(equals, 1, " =\t");
      laid_out += word + (one_in(3) ? "  " : " ");
    }
    laid_out += one_in(3) ? "; X99 (\xB0\xA1\r\n" : "\n";
  }
  RC_ASSERT(without_blocks(look(laid_out, program)) == without_blocks(look(program, Writing{})));
}

RC_GTEST_PROP(SieMetamorphic, TheOrderOfWordsMeansNothing, ()) {
  const Program program = *programs();
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const Writing writing = any_writing();
  Blocks blocks = write(program, writing);
  for (auto& words : blocks) std::shuffle(words.begin(), words.end(), random);
  RC_ASSERT(look(text(blocks), program) == look(program, writing));
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
