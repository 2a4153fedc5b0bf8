// SPDX-License-Identifier: GPL-3.0-or-later
//
// The alarm judge: R 20 against a travel of Z-15 breaks GSK-G94-09 in line 2.
#include <gtest/gtest.h>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::string_view kProgram = "G00 X130 Z5\nG94 X120 Z-10 R20 F300\nG00 X200\n";
const std::string kStart = R"({"k":"rapid","b":1,"to":{"x":"65","z":"5"}})"
                           "\n";
const std::string kMotion = R"({"k":"rapid","b":2,"to":{"z":"10"}})"
                            "\n";

std::string alarm(int block, const char* name) {
  return R"({"k":"alarm","class":")" + std::string(name) + R"(","b":)" + std::to_string(block) +
         R"(,"native":"1"})"
         "\n";
}

TEST(AlarmJudge, TheRightAlarmInTheRightBlockIsGo) {
  EXPECT_EQ(judge_trace(kProgram, kStart + alarm(2, "taper-limit")).kind, VerdictKind::pass_exact);
}

TEST(AlarmJudge, EachWrongAlarmHasItsOwnVerdict) {
  EXPECT_EQ(judge_trace(kProgram, kStart + alarm(2, "value-sign")).kind,
            VerdictKind::fail_alarm_class);
  EXPECT_EQ(judge_trace(kProgram, kStart + alarm(1, "taper-limit")).kind,
            VerdictKind::fail_alarm_spurious);
  EXPECT_EQ(judge_trace(kProgram, kStart + alarm(3, "taper-limit")).kind,
            VerdictKind::fail_alarm_late);
  EXPECT_EQ(judge_trace(kProgram, kStart + kMotion + alarm(2, "taper-limit")).kind,
            VerdictKind::fail_alarm_late);
  EXPECT_EQ(judge_trace(kProgram, kStart).kind, VerdictKind::fail_alarm_missing);
}

TEST(AlarmJudge, MotionOfEarlierBlocksMustHaveCome) {
  EXPECT_EQ(judge_trace(kProgram, alarm(2, "taper-limit")).kind, VerdictKind::fail_geometry);
}

TEST(AlarmJudge, AnAlarmWithoutAFaultIsSpurious) {
  EXPECT_EQ(judge_trace("G00 X130 Z5\n", kStart + alarm(1, "taper-limit")).kind,
            VerdictKind::fail_alarm_spurious);
}

}  // namespace
}  // namespace gonogo::oracle
