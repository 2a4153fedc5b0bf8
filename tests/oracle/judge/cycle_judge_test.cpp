// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traces of canned cycles and threads written by hand: M functions among motions (R5),
// leads, alarms that are found late, and how many combinations of readings there are.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "oracle/judge/judge_session.hpp"
#include "word_trace.hpp"

namespace gonogo::oracle {
namespace {

const std::string kG86 = "M3 F100\nG98 G86 X5 Z-4 R2 P1 M8\nX9\nM2\n";
const WordTrace kG86Trace = {"M1,3", "M2,8",   "R2,0,2", "R2,5,2", "F2,5,-4", "D2,1",
                             "M2,5", "R2,5,2", "M2,3",   "R3,9,2", "F3,9,-4", "D3,1",
                             "M3,5", "R3,9,2", "M3,3",   "M4,2"};

TEST(CycleJudge, TheStopOfASpindleHasItsPlace) {
  ASSERT_EQ(judged_words(kG86, kG86Trace).kind, VerdictKind::pass_exact);
  // Before the dwell, before the cut, behind the way out; of either hole.
  for (const auto& [from, to] : std::vector<std::pair<std::size_t, std::size_t>>{
           {6, 5}, {6, 4}, {6, 3}, {6, 7}, {8, 7}, {8, 9}, {12, 11}, {12, 13}, {14, 13}}) {
    for (const bool blocks : {true, false}) {
      const Verdict verdict =
          judged_words(kG86, with_word_moved(kG86Trace, from, to), {.blocks = blocks, .m = true});
      EXPECT_FALSE(is_go_of_cycle(verdict)) << from << " to " << to;
      EXPECT_EQ(verdict.kind, VerdictKind::fail_order) << from << " to " << to;
    }
  }
}

// NGC-MOD-01: coolant comes before the motions of its block.
TEST(CycleJudge, AnMFunctionOfAWordHasOne) {
  for (const std::size_t to : {2U, 3U, 4U, 6U}) {
    EXPECT_EQ(judged_words(kG86, with_word_moved(kG86Trace, 1, to)).kind, VerdictKind::fail_order)
        << to;
  }
}

TEST(CycleJudge, ThatIsMissingIsADeparture) {
  for (const int number : {6, 8, 12, 14}) {
    const auto place = static_cast<std::size_t>(number);
    WordTrace trace = kG86Trace;
    trace.erase(trace.begin() + number);
    EXPECT_EQ(judged_words(kG86, trace).kind, VerdictKind::fail_geometry) << number;
    WordTrace other = kG86Trace;
    other[place] = other[place].substr(0, 3) + "4";
    EXPECT_EQ(judged_words(kG86, other).kind, VerdictKind::fail_geometry) << number;
    WordTrace twice = kG86Trace;
    twice.insert(twice.begin() + number, kG86Trace[place]);
    EXPECT_EQ(judged_words(kG86, twice).kind, VerdictKind::fail_geometry) << number;
  }
}

TEST(CycleJudge, NobodyLooksWithoutTheFeature) {
  WordTrace trace = kG86Trace;
  std::erase_if(trace, [](const std::string& word) { return word[0] == 'M'; });
  EXPECT_TRUE(is_go_of_cycle(judged_words(kG86, trace, {})));
  EXPECT_TRUE(is_go_of_cycle(judged_words(kG86, with_word_moved(kG86Trace, 6, 3), {})));
}

TEST(CycleJudge, PiecesRoundAnMFunctionAreWhole) {
  WordTrace trace = kG86Trace;
  trace.insert(trace.begin() + 7, "R2,5,0");
  trace.insert(trace.begin() + 4, "F2,5,0");
  EXPECT_TRUE(is_go_of_cycle(judged_words(kG86, trace)));
  trace.insert(trace.begin() + 8, "R2,5,-4");  // negligible, before M5 and behind it
  EXPECT_TRUE(is_go_of_cycle(judged_words(kG86, trace)));
  // M5 between two pieces of the cut.
  WordTrace early = kG86Trace;
  early.insert(early.begin() + 4, {"F2,5,0", "M2,5"});
  early.erase(early.begin() + 8);
  EXPECT_EQ(judged_words(kG86, early).kind, VerdictKind::fail_order);
}

const std::string kG84 = "M3 F100\nG99 G84 X0 Z-4 R0\nM2\n";
const WordTrace kG84Trace = {"M1,3", "F2,0,-4", "M2,5", "M2,4", "F2,0,0", "M2,5", "M2,3", "M3,2"};

TEST(CycleJudge, ATapTurnsBackAtTheBottom) {
  ASSERT_EQ(judged_words(kG84, kG84Trace).kind, VerdictKind::pass_exact);
  for (std::size_t from : {2U, 3U, 5U, 6U}) {
    for (std::size_t to = 1; to < 8; ++to) {
      if (to == from) continue;
      EXPECT_FALSE(is_go_of_cycle(judged_words(kG84, with_word_moved(kG84Trace, from, to))))
          << from << " to " << to;
    }
  }
  // A hole without depth: only the M functions are left, in their order.
  const std::string flat = "M3 F100\nG99 G84 X0 Z0 R0 M8\nM2\n";
  EXPECT_TRUE(
      is_go_of_cycle(judged_words(flat, {"M1,3", "M2,8", "M2,5", "M2,4", "M2,5", "M2,3", "M3,2"})));
  EXPECT_FALSE(
      is_go_of_cycle(judged_words(flat, {"M1,3", "M2,5", "M2,8", "M2,4", "M2,5", "M2,3", "M3,2"})));
}

// M3 of the block comes behind motions that the subject need not show, and has to be told from the
// M functions of the tap, which are due next.
TEST(CycleJudge, MFunctionsBehindMotionsTooSmallToSee) {
  const std::string program = "F100\nG0 X0.0001\nG1 X0.0001\nG84 M3 M8 P1 Z0 R0\nM2\n";
  const WordTrace functions = {"M4,3", "M4,8", "M4,5", "M4,4", "D4,1", "M4,5", "M4,3", "M5,2"};
  WordTrace shown = functions;
  shown.insert(shown.begin(), "R2,0.0001,0");
  for (const bool blocks : {true, false}) {
    const Judging judging = {.blocks = blocks, .m = true};
    EXPECT_TRUE(is_go_of_cycle(judged_words(program, shown, judging)));
    EXPECT_TRUE(is_go_of_cycle(judged_words(program, functions, judging)));
    // One of the tap behind its dwell.
    EXPECT_FALSE(is_go_of_cycle(judged_words(program, with_word_moved(shown, 4, 5), judging)));
    EXPECT_FALSE(is_go_of_cycle(judged_words(program, with_word_moved(shown, 2, 4), judging)));
  }
}

TEST(CycleJudge, AThreadIsItsLineAndItsLead) {
  const std::string program = "M3\nG33 X3 Z4 K5\nG33.1 Z9 K2\nM2\n";
  const WordTrace right = {"M1,3", "T2,3,4,4", "T3,3,9,2", "M3,4", "T3,3,4,2", "M3,3", "M4,2"};
  ASSERT_EQ(judged_words(program, right).kind, VerdictKind::pass_exact);
  WordTrace pieces = right;
  pieces.insert(pieces.begin() + 1, "T2,1.5,2,4");
  EXPECT_TRUE(is_go_of_cycle(judged_words(program, pieces)));
  WordTrace lead = right;
  lead[1] = "T2,3,4,5";  // along the path, not along the longer axis
  EXPECT_EQ(judged_words(program, lead).kind, VerdictKind::fail_feed);
  WordTrace cut = right;
  cut[1] = "F2,3,4";
  EXPECT_FALSE(is_go_of_cycle(judged_words(program, cut)));
  WordTrace end = right;
  end[4] = "T3,3,4.1,2";
  EXPECT_EQ(judged_words(program, end).kind, VerdictKind::fail_geometry);
  EXPECT_EQ(judged_words(program, with_word_moved(right, 3, 2)).kind, VerdictKind::fail_order);
}

// R6: what a reading has moved of a block before it finds the fault.
TEST(CycleJudge, AnAlarmThatIsFoundLate) {
  const std::string program = "F100\nG86 X5 Z-4 R2 P1\nM2\n";
  const WordTrace moves = {"R2,0,2", "R2,5,2", "A2"};
  EXPECT_TRUE(is_go_of_cycle(judged_words(program, {"A2"})));
  EXPECT_EQ(judged_words(program, moves).kind, VerdictKind::fail_alarm_late);
  const Judging late = {.reading = "ngc.cycle.alarm-at=late"};
  EXPECT_TRUE(is_go_of_cycle(judged_words(program, moves, late)));
  EXPECT_FALSE(is_go_of_cycle(judged_words(program, {"A2"}, late)));
  EXPECT_FALSE(is_go_of_cycle(judged_words(program, {"R2,0,2", "A2"}, late)));
  EXPECT_EQ(judged_words(program, {"R2,0,2", "R2,5,2", "F2,5,-4", "A2"}, late).kind,
            VerdictKind::fail_alarm_late);
}

// A spindle that is stopped where none may be: the M function comes too early, and then an alarm.
TEST(CycleJudge, AnAlarmInPlaceOfAnMFunction) {
  EXPECT_EQ(judged_words(kG84, {"M1,3", "F2,0,-4", "A2"}).kind, VerdictKind::fail_alarm_spurious);
}

reference::Profile all_of_rs274_open() {
  reference::Profile profile = std::get<reference::Profile>(reference::default_profile("rs274"));
  for (const reference::Reading& reading : reference::readings()) {
    if (reading.belongs_to("rs274")) profile.readings.set(reading.key, "any");
  }
  return profile;
}

// R9: 64 are judged.
TEST(CycleJudge, AProgramOfPecksHasFewAssignments) {
  const auto count = [](std::string_view program) {
    const Assignments assignments = assignments_of(all_of_rs274_open(), ProgramText{program});
    EXPECT_FALSE(assignments.too_many) << program;
    return assignments.choices.size();
  };
  EXPECT_EQ(count("F100\nG0 Z10\nG98 G81 X1 Z-5 R2\nX2\nM2\n"), 1U);
  // Two ways out, and with four clearances or none a way back: 2 * (4 + 1) * 2 of the dwell.
  EXPECT_LE(count("F100\nG0 Z2\nG98 G83 X1 Z-5 R0 Q2\nM2\n"), 20U);
  EXPECT_LE(count("F100\nG0 Z2\nG99 G83 X1 Z-5 R0 Q2\nX2\nX3\nM2\n"), 10U);
  EXPECT_LE(count("F100\nG0 Z2\nG83 X1 Z-5 R0 Q2\nX2\nM2\n"), 40U);
  EXPECT_LE(count("F100\nG0 Z2\nG99 G73 X1 Z-5 R2 Q2\nX2\nX3\nM2\n"), 8U);
}

}  // namespace
}  // namespace gonogo::oracle
