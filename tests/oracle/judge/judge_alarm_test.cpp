// SPDX-License-Identifier: GPL-3.0-or-later
//
// The alarm judge: R 20 against a travel of 5 along X breaks GSK-G90-09 in line 2.
#include <gtest/gtest.h>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::string_view kTaperTooLong = "G00 X130 Z5\nG90 X120 Z-10 R20 F300\nG00 X200\n";
const std::string kMotion = R"({"k":"rapid","b":2,"to":{"z":"10"}})"
                            "\n";

std::string alarm(int block, const char* name) {
  return R"({"k":"alarm","class":")" + std::string(name) + R"(","b":)" + std::to_string(block) +
         R"(,"native":"1"})"
         "\n";
}

TEST(AlarmJudge, TheRightAlarmInTheRightBlockIsGo) {
  EXPECT_EQ(judge_trace(kTaperTooLong, kRapidToStart + alarm(2, "taper-limit")).kind,
            VerdictKind::pass_exact);
}

// R6.
TEST(AlarmJudge, EachWrongAlarmHasItsOwnVerdict) {
  EXPECT_EQ(judge_trace(kTaperTooLong, kRapidToStart + alarm(2, "value-sign")).kind,
            VerdictKind::fail_alarm_class);
  EXPECT_EQ(judge_trace(kTaperTooLong, kRapidToStart + alarm(1, "taper-limit")).kind,
            VerdictKind::fail_alarm_spurious);
  EXPECT_EQ(judge_trace(kTaperTooLong, kRapidToStart + alarm(3, "taper-limit")).kind,
            VerdictKind::fail_alarm_late);
  EXPECT_EQ(judge_trace(kTaperTooLong, kRapidToStart + kMotion + alarm(2, "taper-limit")).kind,
            VerdictKind::fail_alarm_late);
  EXPECT_EQ(judge_trace(kTaperTooLong, kRapidToStart).kind, VerdictKind::fail_alarm_missing);
}

TEST(AlarmJudge, AClassThatThereIsNotIsNamedWithTheNearest) {
  const auto message = [](const char* name) {
    return judge_trace(kTaperTooLong, kRapidToStart + alarm(2, name)).message;
  };
  EXPECT_TRUE(message("taper-limt")
                  .ends_with(" There is no alarm class \"taper-limt\". Did you mean taper-limit?"))
      << message("taper-limt");
  EXPECT_TRUE(
      message("value-sign zzzzzzzzzz").ends_with(" There is no alarm class \"zzzzzzzzzz\"."))
      << message("value-sign zzzzzzzzzz");
  EXPECT_EQ(message("value-sign").find("There is no"), std::string::npos);
}

TEST(AlarmJudge, MotionOfEarlierBlocksMustHaveCome) {
  EXPECT_EQ(judge_trace(kTaperTooLong, alarm(2, "taper-limit")).kind, VerdictKind::fail_geometry);
}

TEST(AlarmJudge, AnAlarmWithoutAFaultIsSpurious) {
  EXPECT_EQ(judge_trace("G00 X130 Z5\n", kRapidToStart + alarm(1, "taper-limit")).kind,
            VerdictKind::fail_alarm_spurious);
}

// R6: what stands before the place that cannot be read.
TEST(AlarmJudge, AFaultBeforeThePlaceThatCannotBeReadIsAsGood) {
  const auto kind = [](std::string_view line, const char* alarm_class) {
    const std::string program = "G0 X1 Y1\n" + std::string(line) + "\nM2\n";
    const std::string moved = R"({"k":"rapid","b":1,"to":{"x":"1","y":"1"}})";
    return judge_trace(program, moved + "\n" + alarm(2, alarm_class), {.dialect = "rs274"}).kind;
  };
  EXPECT_EQ(kind("G0 Y2 Y2#0", "syntax"), VerdictKind::pass_exact);
  EXPECT_EQ(kind("G0 Y2 Y2#0", "duplicate-word"), VerdictKind::pass_exact);
  EXPECT_EQ(kind("Y2 Y2 -1", "duplicate-word"), VerdictKind::pass_exact);
  EXPECT_EQ(kind("G77 -1", "undefined-code"), VerdictKind::pass_exact);
  // Behind that place; nowhere; and what a word behind it may have been.
  EXPECT_EQ(kind("G0 Y2 -1 Y2", "duplicate-word"), VerdictKind::fail_alarm_class);
  EXPECT_EQ(kind("G0 Y2 -1", "conflicting-words"), VerdictKind::fail_alarm_class);
  EXPECT_EQ(kind("G1 -1", "feed-missing"), VerdictKind::fail_alarm_class);
}

// J-ALM-04. The departure tells clause, word and sentence of one alarm.
TEST(AlarmJudge, TakesEitherClassOfARuleOfRs274ThatHasTwo) {
  constexpr std::string_view kNoHoles = "F100\nG81 X1 Z-1 R1 L0\nM2\n";
  const auto verdict = [&](const char* classes) {
    return judge_trace(kNoHoles, alarm(2, classes), {.dialect = "rs274"});
  };
  EXPECT_EQ(verdict("value-out-of-range").kind, VerdictKind::pass_exact);
  EXPECT_EQ(verdict("value-sign").kind, VerdictKind::pass_exact);
  const Verdict other = verdict("missing-word");
  EXPECT_EQ(other.kind, VerdictKind::fail_alarm_class);
  EXPECT_EQ(other.want, R"({"k":"alarm","b":2,"any_of":["value-out-of-range","value-sign"]})");
  EXPECT_EQ(other.word.text(), "L");
}

TEST(AlarmJudge, AnAlarmOfSeveralClassesIsRightWhereOneIs) {
  EXPECT_EQ(judge_trace(kTaperTooLong, kRapidToStart + alarm(2, "unused-word taper-limit")).kind,
            VerdictKind::pass_exact);
  EXPECT_EQ(judge_trace(kTaperTooLong, kRapidToStart + alarm(2, "unused-word value-sign")).kind,
            VerdictKind::fail_alarm_class);
  // R6: before a place that cannot be read.
  constexpr std::string_view kUnreadable = "G0 Y2 Y2#0\nM2\n";
  EXPECT_EQ(judge_trace(kUnreadable, alarm(1, "no-tool duplicate-word"), {.dialect = "rs274"}).kind,
            VerdictKind::pass_exact);
}

// The block that alarms has an M function of its own, of which no text says whether it is passed
// on.
constexpr std::string_view kProgramWithM = "M3 S500\nG00 X130 Z5 M8\nG90 X120 Z-10 R20 F300 M9\n";
const std::string kRapidInLine2 = R"({"k":"rapid","b":2,"to":{"x":"65","z":"5"}})"
                                  "\n";

std::string m_function(int block, int number) {
  return R"({"k":"m","b":)" + std::to_string(block) + R"(,"m":)" + std::to_string(number) + "}\n";
}

VerdictKind kind_with_m(const std::string& trace, bool blocks = true) {
  return judge_trace(kProgramWithM, trace + alarm(3, "taper-limit"), {.blocks = blocks, .m = true})
      .kind;
}

TEST(AlarmJudge, MFunctionsOfEarlierBlocksMustHaveCome) {
  EXPECT_EQ(kind_with_m(m_function(1, 3) + kRapidInLine2 + m_function(2, 8)),
            VerdictKind::pass_exact);
  for (const bool blocks : {true, false}) {
    EXPECT_EQ(kind_with_m(kRapidInLine2 + m_function(2, 8), blocks), VerdictKind::fail_geometry);
    EXPECT_EQ(kind_with_m(m_function(1, 3) + kRapidInLine2, blocks), VerdictKind::fail_geometry);
    EXPECT_EQ(kind_with_m(kRapidInLine2, blocks), VerdictKind::fail_geometry);
  }
}

TEST(AlarmJudge, NoMFunctionMayComeThatIsNotDueBeforeTheAlarm) {
  EXPECT_EQ(kind_with_m(m_function(1, 3) + kRapidInLine2 + m_function(2, 8) + m_function(2, 5)),
            VerdictKind::fail_geometry);
  EXPECT_EQ(kind_with_m(m_function(1, 4) + kRapidInLine2 + m_function(2, 8)),
            VerdictKind::fail_geometry);
}

// R6.
TEST(AlarmJudge, MFunctionsOfTheBlockThatAlarmsMayComeOrNot) {
  for (const bool blocks : {true, false}) {
    EXPECT_EQ(
        kind_with_m(m_function(1, 3) + kRapidInLine2 + m_function(2, 8) + m_function(3, 9), blocks),
        VerdictKind::pass_exact);
    // Each as often as the block names it.
    EXPECT_EQ(kind_with_m(m_function(1, 3) + kRapidInLine2 + m_function(2, 8) + m_function(3, 9) +
                              m_function(3, 9),
                          blocks),
              VerdictKind::fail_geometry);
  }
}

// R6: no alarm behind what is left undone makes it right, so that nothing behind it leaves the
// verdict open: a block that is not covered, a loop without end, readings by the dozen.
TEST(AlarmJudge, AnAlarmBeforeWhatIsDueIsDecidedWhateverStandsBehind) {
  const auto kind = [](std::string_view dialect, std::string_view program, int block,
                       const std::string& done = m_function(1, 3)) {
    return judge_trace(program, done + alarm(block, "syntax"), {.m = true, .dialect = dialect})
        .kind;
  };
  constexpr VerdictKind kSpurious = VerdictKind::fail_alarm_spurious;
  const std::string_view uncovered = "G21 G90 F100 M3 S100\nG0 X5\nG1 X10\nG41 G1 X20\nM2\n";
  EXPECT_EQ(kind("rs274", uncovered, 1), kSpurious);
  EXPECT_EQ(kind("rs274", uncovered, 2), kSpurious);
  EXPECT_EQ(kind("rs274", uncovered, 3), kSpurious);
  EXPECT_EQ(kind("rs274", "F100 M3 S100\nG1 X5\nO1 while [1 EQ 1]\nO1 endwhile\nM2\n", 2),
            kSpurious);
  EXPECT_EQ(
      kind("hnc21t",
           "M03\nG00 X50 Z5\nG75 X30 Z-4 R1 Q3 I2 F50\nG82 X40 Z-20 R1 E1 F2 C2 P90\nM30\n", 2),
      kSpurious);
  // A cut that is broken off before a block that is not covered.
  const std::string begun = m_function(1, 3) + R"({"k":"rapid","b":2,"to":{"x":"5"}})" + "\n" +
                            R"({"k":"feed","b":3,"to":{"x":"7"},"f":"100"})" + "\n";
  EXPECT_EQ(kind("rs274", uncovered, 3, begun), kSpurious);
  // All that is due has come: what the block that is not covered does, nobody knows.
  const std::string whole = m_function(1, 3) + R"({"k":"rapid","b":2,"to":{"x":"5"}})" + "\n" +
                            R"({"k":"feed","b":3,"to":{"x":"10"},"f":"100"})" + "\n";
  EXPECT_EQ(kind("rs274", uncovered, 4, whole), VerdictKind::oracle_gap);
}

TEST(AlarmJudge, AnEarlyAlarmIsToldWithThatOfTheProgram) {
  const Verdict said = judge_trace("G00 X130 Z5\nG00 X120\nG90 X110 Z-10 R40 F300\n",
                                   kRapidToStart + alarm(2, "taper-limit"));
  EXPECT_EQ(said.kind, VerdictKind::fail_alarm_spurious);
  EXPECT_EQ(said.message, "The alarm comes in a block before the right one.");
  EXPECT_NE(said.want.find("taper-limit"), std::string::npos);
}

// The first departure decides.
// NGC-G86-02: each of the two holes, which drill nothing, stops the spindle and turns it on again.
// The block names M3, and no M5 (R6).
TEST(AlarmJudge, MFunctionsOfACycleMustHaveComeBeforeAnAlarmOfItsBlock) {
  const std::string program = "M3 S500\nG91 G99 G86 R0 Z0 Y0 L2 P3 M3 F100\n";
  const std::string dwell = R"({"k":"dwell","b":2,"s":"3"})"
                            "\n";
  const Judging judging = {.reading = "ngc.program-end=needed", .m = true, .dialect = "rs274"};
  const std::string first =
      m_function(1, 3) + m_function(2, 3) + dwell + m_function(2, 5) + m_function(2, 3) + dwell;
  const std::string end = alarm(2, "program-end");
  const auto kind = [&](const std::string& rest) {
    return judge_trace(program, first + rest + end, judging).kind;
  };
  EXPECT_EQ(kind(m_function(2, 5) + m_function(2, 3)), VerdictKind::pass_exact);
  EXPECT_EQ(kind(m_function(2, 3)), VerdictKind::fail_geometry);
  EXPECT_EQ(kind(""), VerdictKind::fail_geometry);
}

TEST(AlarmJudge, MissingMotionComesBeforeAnMFunctionBehindIt) {
  EXPECT_EQ(kind_with_m(m_function(1, 3)), VerdictKind::fail_geometry);
}

// The reference drops an arc of one increment; the subject's is no motion after the alarm.
TEST(AlarmJudge, AnArcTooSmallToSeeBeforeTheAlarmIsNoLateMotion) {
  const Verdict verdict = judge_trace("G00 G19 X0 Y67.6 Z5 F461\nG03 V0.001 W0 R3.6\nY-39.001\n",
                                      R"({"k":"rapid","b":1,"to":{"x":"0","y":"67.6","z":"5"}}
{"k":"arc","b":2,"plane":"G19","c":{"y":"67.6005","z":"8.599999965"},"rot":1,"to":{"y":"67.601","z":"5"},"f":"461"}
{"k":"alarm","b":3,"class":"missing-word"}
)");
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
}

}  // namespace
}  // namespace gonogo::oracle
