// SPDX-License-Identifier: GPL-3.0-or-later
//
// What must not change, or change in a known way, when a program is written in another way. The
// records are compared exactly.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>

#include "metamorphic_layout.hpp"
#include "metamorphic_trace.hpp"
#include "reference/clause_literal.hpp"

namespace gonogo::reference::testing {
namespace {

Plane any_plane() {
  return static_cast<Plane>(*rc::gen::inRange(0, 3));
}
OpenPaths any_open_paths() {
  return *rc::gen::arbitrary<bool>() ? OpenPaths::judged : OpenPaths::shown;
}
Writing any_writing() {
  Writing writing;
  writing.plane = any_plane();
  writing.diameter = *rc::gen::arbitrary<bool>();
  writing.run_out = *rc::gen::element<std::string_view>("any", "polar", "radial", "tangent");
  writing.flat = *rc::gen::arbitrary<bool>();
  writing.run_out_parameters = *rc::gen::arbitrary<bool>();
  return writing;
}

// What the programs of three hundred seeds do.
struct Tally {
  std::array<int, kStepKinds> steps = {};
  int programs_with_alarm = 0;
  std::map<int, int> first_blocks;   // by code
  std::map<int, int> repeats;        // by code, of blocks without it or after the same one
  std::map<ClauseId, int> motions;   // by clause
  std::map<AlarmClass, int> alarms;  // by class
  int enclosures = 0;                // coordinates that are no rational and no root
  int roots = 0;

  void count(const Model& model) {
    for (const Step& step : model.steps) {
      ++steps[static_cast<std::size_t>(step.kind)];
      for (const CycleBlock& block : step.blocks) {
        ++(&block == &step.blocks.front() ? first_blocks : repeats)[block.code];
      }
    }
  }
  void count(const Trace& trace) {
    for (const Seen& seen : trace) {
      ++motions[seen.clause];
      for (const auto& [alarm, clause] : seen.alarms) ++alarms[alarm];
      if (!seen.alarms.empty()) ++programs_with_alarm;
      for (const Number& to : seen.to) {
        enclosures += to.form() == Number::Form::enclosure ? 1 : 0;
        roots += to.form() == Number::Form::root ? 1 : 0;
      }
    }
  }
};

Tally tally_of_300() {
  Tally tally;
  const rc::Gen<Model> any = models();
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Model model = any(rc::Random(seed), 100).value();
    tally.count(model);
    tally.count(look(model, {}));
  }
  return tally;
}

// The properties below say little where the programs say little.
TEST(Metamorphic, TheProgramsCutAndFewOfThemAlarm) {
  Tally tally = tally_of_300();
  EXPECT_GT(tally.programs_with_alarm, 10);
  EXPECT_LT(tally.programs_with_alarm, 180);
  for (const int count : tally.steps) EXPECT_GT(count, 50);
  for (const int code : {90, 92, 94, 110, 111, 112, 113, 114, 115, 116, 117}) {
    EXPECT_GT(tally.first_blocks[code], 10) << "G" << code;
    EXPECT_GT(tally.repeats[code], 10) << "G" << code;
  }
  for (const AlarmClass alarm :
       {AlarmClass::taper_limit, AlarmClass::direction_conflict, AlarmClass::missing_word,
        AlarmClass::tool_too_large, AlarmClass::depth_exceeds_tool, AlarmClass::feed_missing}) {
    EXPECT_GT(tally.alarms[alarm], 0) << name(alarm);
  }
}

TEST(Metamorphic, TheProgramsReachTheMotionsOfEachCycle) {
  Tally tally = tally_of_300();
  for (const ClauseId motion :
       {"GSK-G90-03"_clause, "GSK-G92-03"_clause, "GSK-G94-03"_clause, "GSK-G110-09"_clause,
        "GSK-G110-17"_clause, "GSK-G112-05"_clause, "GSK-G114-06"_clause, "GSK-G114-11"_clause}) {
    EXPECT_GT(tally.motions[motion], 20) << clause_name(motion);
  }
  EXPECT_GT(tally.enclosures, 50);
  EXPECT_GT(tally.roots, 50);
}

RC_GTEST_PROP(Metamorphic, ATranslatedProgramMovesByTheSameShift, ()) {
  const Model model = *models();
  const Point shift = {*rc::gen::inRange<std::int64_t>(-90'000, 90'000),
                       *rc::gen::inRange<std::int64_t>(-90'000, 90'000),
                       *rc::gen::inRange<std::int64_t>(-90'000, 90'000)};
  const Writing writing = any_writing();
  const OpenPaths open_paths = any_open_paths();
  Trace want = look(model, writing, open_paths);
  for (Seen& seen : want) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Number by = Number(shift[i]) / 1'000;
      if (seen.named[i]) seen.to[i] += by;
      if (i < 2 && has_centre(seen)) seen.centre[i] += by;
    }
    for (Number& depth : seen.depths) depth += Number(shift[2]) / 1'000;
  }
  RC_ASSERT(look(translated(model, shift), writing, open_paths) == want);
}

RC_GTEST_PROP(Metamorphic, APlaneOnlyNamesTheAxes, ()) {
  const Model model = *models();
  const OpenPaths open_paths = any_open_paths();
  Writing writing = any_writing();
  writing.diameter = true;
  writing.incremental = *rc::gen::arbitrary<bool>();
  writing.plane = Plane::g18;
  const Trace want = look(model, writing, open_paths);
  for (const Plane plane : {Plane::g17, Plane::g19}) {
    writing.plane = plane;
    RC_ASSERT(look(model, writing, open_paths) == want);
  }
}

RC_GTEST_PROP(Metamorphic, ADiameterIsTwiceTheRadius, ()) {
  const Model model = *models();
  const OpenPaths open_paths = any_open_paths();
  Writing writing = any_writing();
  writing.incremental = *rc::gen::arbitrary<bool>();
  writing.diameter = true;
  const Trace diameter = look(model, writing, open_paths);
  writing.diameter = false;
  RC_ASSERT(look(model, writing, open_paths) == diameter);
}

RC_GTEST_PROP(Metamorphic, AnInchIs254TenthsOfAMillimetre, ()) {
  const Model model = *models();
  Writing writing = any_writing();
  writing.incremental = *rc::gen::arbitrary<bool>();
  const OpenPaths open_paths = any_open_paths();
  writing.lengths = Lengths::inch;
  const Trace inch = look(model, writing, open_paths);
  writing.lengths = Lengths::inch_in_mm;
  RC_ASSERT(look(model, writing, open_paths) == inch);
}

// Left out, for what the manual says: along p and q from where a thread has left the tool (its safe
// position and run-out are no counts), and words that a cutting cycle retains while the tool moves
// elsewhere (a retained increment is taken from A again, GSK-MOD-07).
RC_GTEST_PROP(Metamorphic, IncrementsLeadWhereAbsoluteWordsLead, ()) {
  const Model model = *models();
  Writing writing = any_writing();
  const OpenPaths open_paths = any_open_paths();
  const Trace absolute = look(model, writing, open_paths);
  writing.incremental = true;
  RC_ASSERT(look(model, writing, open_paths) == absolute);
}

RC_GTEST_PROP(Metamorphic, TheOtherSenseIsTheMirrorImageInQ, ()) {
  const Model model = *models();
  const Writing writing = any_writing();
  const OpenPaths open_paths = any_open_paths();
  Trace want = look(model, writing, open_paths);
  for (Seen& seen : want) {
    seen.to[1] = -seen.to[1];
    seen.centre[1] = -seen.centre[1];
    seen.rot = -seen.rot;
  }
  RC_ASSERT(look(mirrored_in_q(model), writing, open_paths) == want);
}

RC_GTEST_PROP(Metamorphic, ACycleUpwardsIsTheMirrorImageInD, ()) {
  const Model model = *models();
  const Writing writing = any_writing();
  const OpenPaths open_paths = any_open_paths();
  Trace want = look(model, writing, open_paths);
  for (Seen& seen : want) {
    seen.to[2] = -seen.to[2];
    for (Number& depth : seen.depths) depth = -depth;
  }
  RC_ASSERT(look(mirrored_in_d(model), writing, open_paths) == want);
}

RC_GTEST_PROP(Metamorphic, ARepeatHasTheCodeAndTheRetainedWordsWithoutWritingThem, ()) {
  const Model model = *models();
  const OpenPaths open_paths = any_open_paths();
  Writing writing = any_writing();
  writing.incremental = *rc::gen::arbitrary<bool>();
  const Trace repeated = look(model, writing, open_paths);
  writing.repeats = Repeats::spelled_out;
  RC_ASSERT(look(model, writing, open_paths) == repeated);
}

// So nothing else is retained: not L of the helix, R and P of the pockets, any word of a thread.
RC_GTEST_PROP(Metamorphic, ARepeatIsACycleOfItsOwn, ()) {
  const Model model = *models();
  const OpenPaths open_paths = any_open_paths();
  Writing writing = any_writing();
  writing.incremental = *rc::gen::arbitrary<bool>();
  Trace repeated = look(model, writing, open_paths);
  writing.repeats = Repeats::entered_anew;
  Trace single = look(model, writing, open_paths);
  // The G80 blocks move the others.
  for (Trace* trace : {&repeated, &single}) {
    for (Seen& seen : *trace) seen.block = 0;
  }
  RC_ASSERT(single == repeated);
}

std::uint32_t any_seed() {
  return *rc::gen::arbitrary<std::uint32_t>();
}

RC_GTEST_PROP(Metamorphic, BlanksBetweenAndInWordsMeanNothing, ()) {
  const Model model = *models();
  Layout layout(any_seed());
  std::string program;
  for (const Words& words : write(model, {})) program += layout.spaced(words) + "\n";
  RC_ASSERT(look(program, machine(model, {}), Plane::g18) == look(model, {}));
}

RC_GTEST_PROP(Metamorphic, WordsWithoutBlanksMeanTheSame, ()) {
  const Model model = *models();
  std::string program = text(write(model, {}));
  std::erase(program, ' ');
  RC_ASSERT(look(program, machine(model, {}), Plane::g18) == look(model, {}));
}

RC_GTEST_PROP(Metamorphic, BlockNumbersAndCommentsMeanNothing, ()) {
  const Model model = *models();
  Layout layout(any_seed());
  std::string program;
  for (const Words& words : write(model, {})) program += layout.commented(words) + "\n";
  RC_ASSERT(look(program, machine(model, {}), Plane::g18) == look(model, {}));
}

RC_GTEST_PROP(Metamorphic, TheOrderOfWordsMeansNothing, ()) {
  const Model model = *models();
  Layout layout(any_seed());
  std::vector<Words> blocks = write(model, {});
  for (Words& words : blocks) layout.shuffle(words);
  RC_ASSERT(look(text(blocks), machine(model, {}), Plane::g18) == look(model, {}));
}

RC_GTEST_PROP(Metamorphic, LeadingAndTrailingZerosMeanNothing, ()) {
  const Model model = *models();
  Layout layout(any_seed());
  std::vector<Words> blocks = write(model, {});
  for (Words& words : blocks) {
    for (Word& word : words) {
      const std::size_t first = word.number.starts_with('-') ? 1 : 0;
      word.number.insert(first, layout.below(4), '0');
      if (word.number.find('.') != std::string::npos) word.number.append(layout.below(20), '0');
    }
  }
  RC_ASSERT(look(text(blocks), machine(model, {}), Plane::g18) == look(model, {}));
}

RC_GTEST_PROP(Metamorphic, IdleLinesOnlyMoveTheBlockNumbers, ()) {
  const Model model = *models();
  Layout layout(any_seed());
  std::string program;
  std::vector<std::uint64_t> line_of_block = {0};
  std::uint64_t line = 0;
  for (const Words& words : write(model, {})) {
    for (std::size_t count = layout.below(4); count > 0; --count, ++line) {
      program += layout.idle() + layout.line_end();
    }
    line_of_block.push_back(++line);
    std::string block = text({words});
    block.pop_back();
    program += block + layout.line_end();
  }
  Trace want = look(model, {});
  for (Seen& seen : want) seen.block = line_of_block.at(seen.block);
  RC_ASSERT(look(program, machine(model, {}), Plane::g18) == want);
}

RC_GTEST_PROP(Metamorphic, EveryLineEndMeansTheSame, ()) {
  const Model model = *models();
  const std::string program = text(write(model, {}));
  const Trace want = look(model, {});
  for (const char* line_end : {"\r", "\r\n"}) {
    std::string other;
    for (const char byte : program) other += byte == '\n' ? line_end : std::string(1, byte);
    RC_ASSERT(look(other, machine(model, {}), Plane::g18) == want);
  }
}

}  // namespace
}  // namespace gonogo::reference::testing
