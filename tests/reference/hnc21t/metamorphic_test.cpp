// SPDX-License-Identifier: GPL-3.0-or-later
//
// What must not change, or change in a known way, when an HNC program is written in another way.
// The records are compared exactly.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>

#include "hnc_program.hpp"
#include "reference/clause_literal.hpp"
#include "tests/reference/gsk988ta/metamorphic_layout.hpp"
#include "tests/reference/gsk988ta/metamorphic_trace.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

// In a Trace of the plane G18: p is Z and q is X.
constexpr std::array<std::size_t, 2> kPlaceInTrace = {1, 0};

Trace look(const Program& program, const Writing& writing) {
  return testing::look(text(write(program, writing)), machine(program, writing), Plane::g18);
}
Trace look(const std::string& text, const Program& program) {
  return testing::look(text, machine(program, {}), Plane::g18);
}

bool is_renaming(const Seen& seen) {
  return seen.kind == static_cast<int>(Item{Renaming{}}.index());
}

Writing any_writing() {
  Writing writing;
  writing.ends = static_cast<Ends>(*rc::gen::inRange(0, 4));
  writing.diameter = *rc::gen::arbitrary<bool>();
  writing.by_code = *rc::gen::arbitrary<bool>();
  return writing;
}

struct Tally {
  std::map<int, int> blocks;         // by code
  std::map<int, int> repeats;        // by code
  std::map<ClauseId, int> motions;   // by clause
  std::map<AlarmClass, int> alarms;  // by class
  int programs_with_alarm = 0;
  int renamings = 0;
  std::size_t longest = 0;

  void count(const Program& program) {
    for (const Block& block : program.blocks) {
      ++blocks[block.code];
      const bool first = &block == &program.blocks.front();
      if (!first && (&block - 1)->code == block.code) ++repeats[block.code];
    }
  }
  void count(const Trace& trace) {
    longest = std::max(longest, trace.size());
    for (const Seen& seen : trace) {
      ++motions[seen.clause];
      for (const auto& [alarm, clause] : seen.alarms) ++alarms[alarm];
      if (!seen.alarms.empty()) ++programs_with_alarm;
      if (is_renaming(seen)) ++renamings;
    }
  }
};

Tally tally_of_300() {
  Tally tally;
  const rc::Gen<Program> any = programs();
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Program program = any(rc::Random(seed), 100).value();
    tally.count(program);
    tally.count(look(program, {}));
  }
  return tally;
}

// The properties below say little where the programs say little.
TEST(HncMetamorphic, TheProgramsCutAndFewOfThemAlarm) {
  Tally tally = tally_of_300();
  EXPECT_GT(tally.programs_with_alarm, 20);
  EXPECT_LT(tally.programs_with_alarm, 180);
  EXPECT_LT(tally.longest, 2'000U);
  for (const int code : {0, 1, 2, 3, 4, 32, 54, 59, 74, 75, 80, 81, 82, 92}) {
    EXPECT_GT(tally.blocks[code], 10) << "G" << code;
  }
  for (const int code : {32, 74, 75, 80, 81, 82}) EXPECT_GT(tally.repeats[code], 10) << "G" << code;
  for (const AlarmClass alarm :
       {AlarmClass::missing_word, AlarmClass::retract_ratio, AlarmClass::arc_end_point,
        AlarmClass::feed_missing, AlarmClass::lead_missing}) {
    EXPECT_GT(tally.alarms[alarm], 0) << name(alarm);
  }
}

TEST(HncMetamorphic, TheProgramsReachTheMotionsOfEachCycle) {
  Tally tally = tally_of_300();
  for (const ClauseId motion : {"HNC-G80-01"_clause, "HNC-G81-01"_clause, "HNC-G82-01"_clause,
                                "HNC-G82-02"_clause, "HNC-G74-02"_clause, "HNC-G74-03"_clause,
                                "HNC-G75-02"_clause, "HNC-G75-03"_clause, "HNC-G75-04"_clause}) {
    EXPECT_GT(tally.motions[motion], 20) << clause_name(motion);
  }
  EXPECT_GT(tally.renamings, 20);
}

// The start and all work offsets move: the text stays as it is.
RC_GTEST_PROP(HncMetamorphic, AnotherWorkOffsetMovesTheProgram, ()) {
  const Program program = *programs();
  const Place shift = {*rc::gen::inRange<std::int64_t>(-90'000, 90'000),
                       *rc::gen::inRange<std::int64_t>(-90'000, 90'000)};
  const Writing writing = any_writing();
  Trace want = look(program, writing);
  for (Seen& seen : want) {
    if (is_renaming(seen)) continue;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Number by = Number(shift[axis]) / 1'000;
      const std::size_t i = kPlaceInTrace[axis];
      if (seen.named[i]) seen.to[i] += by;
      if (has_centre(seen)) seen.centre[i] += by;
    }
  }
  const Program moved = translated(program, shift);
  RC_ASSERT(text(write(moved, writing)) == text(write(program, writing)));
  RC_ASSERT(look(moved, writing) == want);
}

RC_GTEST_PROP(HncMetamorphic, TheMirrorImageInXOrZHasAllSignsTurned, ()) {
  const Program program = *programs();
  const Writing writing = any_writing();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    Trace want = look(program, writing);
    const std::size_t i = kPlaceInTrace[axis];
    for (Seen& seen : want) {
      seen.to[i] = -seen.to[i];
      seen.centre[i] = -seen.centre[i];
      seen.rot = -seen.rot;
    }
    RC_ASSERT(look(mirrored(program, axis), writing) == want);
  }
}

RC_GTEST_PROP(HncMetamorphic, ADiameterIsTwiceTheRadius, ()) {
  const Program program = *programs();
  Writing writing = any_writing();
  writing.diameter = true;
  const Trace diameter = look(program, writing);
  writing.diameter = false;
  RC_ASSERT(look(program, writing) == diameter);
}

RC_GTEST_PROP(HncMetamorphic, ACodeIsAsGoodAsTheStateOfPowerOn, ()) {
  const Program program = *programs();
  Writing writing = any_writing();
  writing.by_code = false;
  const Trace power_on = look(program, writing);
  writing.by_code = true;
  writing.names_g54 = true;
  RC_ASSERT(look(program, writing) == power_on);
}

RC_GTEST_PROP(HncMetamorphic, IncrementsLeadWhereAbsoluteWordsLead, ()) {
  const Program program = *programs();
  Writing writing = any_writing();
  writing.ends = Ends::absolute;
  const Trace absolute = look(program, writing);
  for (const Ends ends : {Ends::letters, Ends::g91, Ends::mixed}) {
    writing.ends = ends;
    RC_ASSERT(look(program, writing) == absolute);
  }
}

// HNC-G82-07: J is in inches always, and F of a thread is a length as a reading says.
RC_GTEST_PROP(HncMetamorphic, AnInchIs254TenthsOfAMillimetre, ()) {
  const Program program = *programs();
  Writing writing = any_writing();
  writing.lengths = Lengths::inch;
  const Trace inch = look(program, writing);
  writing.lengths = Lengths::inch_in_mm;
  RC_ASSERT(look(program, writing) == inch);
}

RC_GTEST_PROP(HncMetamorphic, AnInchLeadIsALeadOf254TenthsOfAMillimetre, ()) {
  const Program program = *programs();
  Writing writing = any_writing();
  const Trace inch = look(program, writing);
  writing.j_as_f = true;
  RC_ASSERT(look(program, writing) == inch);
}

RC_GTEST_PROP(HncMetamorphic, ARepeatHasTheCodeAndTheRetainedWordsWithoutWritingThem, ()) {
  const Program program = *programs();
  Writing writing = any_writing();
  const Trace repeated = look(program, writing);
  writing.repeats = Repeats::spelled_out;
  RC_ASSERT(look(program, writing) == repeated);
}

// So nothing else is retained, but the end point under hnc.missing-axis = keep.
RC_GTEST_PROP(HncMetamorphic, ARepeatIsACycleOfItsOwn, ()) {
  const Program program = *programs();
  RC_PRE(!program.reads("hnc.missing-axis", "keep"));
  Writing writing = any_writing();
  Trace repeated = look(program, writing);
  writing.repeats = Repeats::entered_anew;
  Trace single = look(program, writing);
  // The G00 blocks move the others.
  for (Trace* trace : {&repeated, &single}) {
    for (Seen& seen : *trace) seen.block = 0;
  }
  RC_ASSERT(single == repeated);
}

std::uint32_t any_seed() {
  return *rc::gen::arbitrary<std::uint32_t>();
}

RC_GTEST_PROP(HncMetamorphic, BlanksBetweenAndInWordsMeanNothing, ()) {
  const Program program = *programs();
  Layout layout(any_seed());
  std::string spaced;
  std::string joined;
  for (const Words& words : write(program, {})) {
    spaced += layout.spaced(words) + "\n";
    for (const Word& word : words) joined += word.address + word.number;
    joined += "\n";
  }
  RC_ASSERT(look(spaced, program) == look(program, Writing{}));
  RC_ASSERT(look(joined, program) == look(program, Writing{}));
}

RC_GTEST_PROP(HncMetamorphic, BlockNumbersAndCommentsMeanNothing, ()) {
  const Program program = *programs();
  Layout layout(any_seed());
  std::string text;
  for (const Words& words : write(program, {})) text += layout.commented(words) + "\n";
  RC_ASSERT(look(text, program) == look(program, Writing{}));
}

RC_GTEST_PROP(HncMetamorphic, TheOrderOfWordsMeansNothing, ()) {
  const Program program = *programs();
  Layout layout(any_seed());
  std::vector<Words> blocks = write(program, {});
  for (Words& words : blocks) layout.shuffle(words);
  RC_ASSERT(look(text(blocks), program) == look(program, Writing{}));
}

RC_GTEST_PROP(HncMetamorphic, IdleLinesOnlyMoveTheBlockNumbers, ()) {
  const Program program = *programs();
  Layout layout(any_seed());
  std::string shifted;
  std::vector<std::uint64_t> line_of_block = {0};
  std::uint64_t line = 0;
  for (const Words& words : write(program, {})) {
    for (std::size_t count = layout.below(4); count > 0; --count, ++line) {
      shifted += layout.idle() + layout.line_end();
    }
    line_of_block.push_back(++line);
    std::string block = text({words});
    block.pop_back();
    shifted += block + layout.line_end();
  }
  Trace want = look(program, Writing{});
  for (Seen& seen : want) seen.block = line_of_block.at(seen.block);
  RC_ASSERT(look(shifted, program) == want);
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
