// SPDX-License-Identifier: GPL-3.0-or-later
//
// R7 on the lathes: each rule that no text states, with the alarm of a control that has it the
// other way, and the same alarm where the question does not arise. Readings are as `expand` shows
// them.
#include <gtest/gtest.h>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

std::string lathe_moved(const char* kind, int block, const std::string& to, const char* more = "") {
  return R"({"k":")" + std::string(kind) + R"(","b":)" + std::to_string(block) + R"(,"to":{)" + to +
         "}" + more + "}\n";
}
std::string lathe_traverse(int block, const std::string& to) {
  return lathe_moved("rapid", block, to);
}
std::string lathe_feed(int block, const std::string& to) {
  return lathe_moved("feed", block, to, R"(,"f":"100")");
}
std::string lathe_alarm(int block, std::string_view alarm_class) {
  return R"({"k":"alarm","b":)" + std::to_string(block) + R"(,"class":")" +
         std::string(alarm_class) + "\"}\n";
}

// G00 X50 Z5, where X is a diameter.
const std::string kLatheStart = lathe_traverse(1, R"("x":"25","z":"5")");
// G80 X40 Z-20 F100 from there.
const std::string kLatheTurned = kLatheStart + lathe_traverse(2, R"("x":"20")") +
                                 lathe_feed(2, R"("x":"20","z":"-20")") +
                                 lathe_feed(2, R"("x":"25")") + lathe_traverse(2, R"("z":"5")");

Verdict judged_lathe(std::string_view dialect, const std::string& program,
                     const std::string& trace) {
  return judge_trace(program, trace, {.dialect = dialect});
}

// The kind, and behind an advice its clause.
std::string lathe_answer(std::string_view dialect, const std::string& program,
                         const std::string& trace) {
  const Verdict verdict = judged_lathe(dialect, program, trace);
  std::string text(name(verdict.kind));
  if (verdict.kind == VerdictKind::advice) {
    text += " " + std::string(reference::clause_name(verdict.clause));
  }
  return text;
}

TEST(LatheSilence, OfACycleWithoutTravelExcusesTheMissingWord) {
  const std::string program = "G00 X50 Z5\nG80 X40 Z-20 F100\n";
  for (const char* block : {"G80 F50", "G80", "I-2"}) {
    const std::string whole = program + block + "\nX38 Z-20\n";
    EXPECT_EQ(lathe_answer("hnc21t", whole, kLatheTurned + lathe_alarm(3, "missing-word")),
              "advice HNC-MOD-05")
        << block;
    EXPECT_EQ(lathe_answer("hnc21t", whole, kLatheTurned + lathe_alarm(3, "syntax")),
              "fail.alarm-spurious");
  }
  for (const char* block : {"M08", "S300", "G21", "F50"}) {
    const std::string whole = program + block + "\nX38 Z-20\n";
    EXPECT_EQ(lathe_answer("hnc21t", whole, kLatheTurned + lathe_alarm(3, "missing-word")),
              "fail.alarm-spurious")
        << block;
  }
  EXPECT_EQ(lathe_answer("hnc21t", "G00 X50 Z5\nG80 F50\nX38 Z-20\n",
                         kLatheStart + lathe_alarm(2, "missing-word")),
            "advice HNC-MOD-05");
}

// What a block of G82 says behind G00 X50 Z5 and a thread to X40 Z-20.
std::string lathe_thread(const std::string& first, const std::string& second,
                         const char* alarm_class, const std::string& run_out = "") {
  const std::string lead = R"(,"lead":")" +
                           std::string(first.find('J') != std::string::npos ? "25.4" : "2") +
                           R"(","start":"0")";
  const std::string cut = lathe_traverse(2, R"("x":"20")") +
                          lathe_moved("thread", 2, R"("x":"20","z":"-20")", lead.c_str()) +
                          (run_out.empty() ? "" : lathe_moved("thread", 2, run_out, lead.c_str())) +
                          lathe_traverse(2, R"("x":"25")") + lathe_traverse(2, R"("z":"5")");
  return lathe_answer("hnc21t", "G00 X50 Z5\nG82 X40 Z-20 " + first + "\n" + second + "\n",
                      kLatheStart + cut + lathe_alarm(3, alarm_class));
}

TEST(LatheSilence, OfAnotherLeadExcusesThatTheyExcludeEachOther) {
  EXPECT_EQ(lathe_thread("J1", "X39 Z-20 F2", "conflicting-words"), "advice HNC-G82-08");
  EXPECT_EQ(lathe_thread("F2", "X39 Z-20 J1", "conflicting-words"), "advice HNC-G82-08");
  EXPECT_EQ(lathe_thread("F2", "X39 Z-20 F3", "conflicting-words"), "fail.alarm-spurious");
  EXPECT_EQ(lathe_thread("J1", "X39 Z-20 F2", "retract-pair"), "fail.alarm-spurious");
}

// The run-out ends 1 beyond C along Z and along X.
TEST(LatheSilence, OfALoneRunOutWordExcusesThePair) {
  const std::string run_out = R"("x":"21","z":"-21")";
  EXPECT_EQ(lathe_thread("R-1 E1 F2", "X39 Z-20 E1.2", "retract-pair", run_out),
            "advice HNC-G82-12");
  EXPECT_EQ(lathe_thread("R-1 E1 F2", "X39 Z-20 R-2", "retract-pair", run_out),
            "advice HNC-G82-12");
  EXPECT_EQ(lathe_thread("R-1 E1 F2", "X39 Z-20", "retract-pair", run_out), "fail.alarm-spurious");
  EXPECT_EQ(lathe_thread("F2", "X39 Z-20 R0", "retract-pair"), "advice HNC-G82-12");
  EXPECT_EQ(lathe_thread("R-1 E1 F2", "X39 Z-20 R-2 E2", "retract-pair", run_out),
            "fail.alarm-spurious");
}

// From X50 Z5: 1 along Z is 25 times 0.04 along X. To X10 the radius changes by 20 and the diameter
// by 40, to Z-20 Z by 25. To X49 it changes by less, whichever way it is measured.
TEST(LatheSilence, OfTheLongAxisExcusesTheRatioOfTheOther) {
  const auto said = [](const char* words) {
    return lathe_answer("hnc21t", "G00 X50 Z5\nG82 " + std::string(words) + " F2\n",
                        kLatheStart + lathe_alarm(2, "retract-ratio"));
  };
  EXPECT_EQ(said("X10 Z-20 R-1 E0.04"), "advice HNC-G82-13");
  EXPECT_EQ(said("X49 Z-20 R-1 E0.04"), "fail.alarm-spurious");
  EXPECT_EQ(said("X10 Z-20 R-1 E0.05"), "fail.alarm-spurious");
}

// In lower case, and unreadable in capitals too.
TEST(LatheSilence, OfLowerCaseExcusesASubjectThatReadsIt) {
  for (const std::string_view dialect : {"gsk988ta", "hnc21t"}) {
    EXPECT_EQ(lathe_answer(dialect, "g00 x50 z5\n", lathe_alarm(1, "syntax")), "pass-exact");
    const bool is_gsk = dialect == "gsk988ta";
    EXPECT_EQ(lathe_answer(dialect, "g00 x50 z5\n", kLatheStart),
              is_gsk ? "advice GSK-COM-14" : "advice HNC-COM-08");
    EXPECT_EQ(lathe_answer(dialect, "g00 x50 z5 x@\n", kLatheStart), "fail.alarm-missing");
    EXPECT_EQ(lathe_answer(dialect, "G00 X50 Z5 X@\n", kLatheStart), "fail.alarm-missing");
  }
}

}  // namespace
}  // namespace gonogo::oracle
