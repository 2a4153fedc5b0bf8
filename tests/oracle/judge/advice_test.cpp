// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-ALM-01, J-ALM-03, R7: a departure from what no text states is an advice, and NO-GO under
// strict. The table has the programs on which a second careful reader of the manuals did something
// else.
#include <gtest/gtest.h>

#include <cctype>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

// One program, what a subject does with it, and what that would be if a text stated the rule.
struct Disputed {
  const char* name;
  std::string_view dialect;
  const char* program;
  std::string trace;
  VerdictKind departure;
  std::string_view clause;
  const char* reading = "";  // "k=v" where an open reading has to be settled first
};

std::string subject_alarm(int block, const char* name) {
  return R"({"k":"alarm","class":")" + std::string(name) + R"(","b":)" + std::to_string(block) +
         "}\n";
}

std::string rapid_x(int block, const char* x) {
  return R"({"k":"rapid","b":)" + std::to_string(block) + R"(,"to":{"x":")" + x + "\"}}\n";
}

std::string feed_x(int block, const char* x) {
  return R"({"k":"feed","b":)" + std::to_string(block) + R"(,"to":{"x":")" + x +
         R"("},"f":"100"})"
         "\n";
}

std::string dwell(int block, const char* seconds) {
  return R"({"k":"dwell","b":)" + std::to_string(block) + R"(,"s":")" + seconds + "\"}\n";
}

constexpr VerdictKind kMissing = VerdictKind::fail_alarm_missing;
constexpr VerdictKind kSpurious = VerdictKind::fail_alarm_spurious;
constexpr VerdictKind kClass = VerdictKind::fail_alarm_class;
constexpr std::string_view kGsk = "gsk988ta";
constexpr std::string_view kHnc = "hnc21t";
constexpr std::string_view kSie = "sinumerik840d";

// X of the lathes is a diameter in the program and a radius in the trace.
// NOLINTNEXTLINE(readability-function-size): a table.
std::vector<Disputed> disputed() {
  const std::string sie = rapid_x(1, "10");
  const std::string lathe = rapid_x(1, "5");
  return {
      {"F0 is no feed, GSK", kGsk, "G01 X10 F100\nG01 X20 F0\n", feed_x(1, "5") + feed_x(2, "10"),
       kMissing, "GSK-COM-08"},
      {"F0 is no feed, HNC", kHnc, "G01 X10 F100\nG01 X20 F0\n", feed_x(1, "5") + feed_x(2, "10"),
       kMissing, "HNC-COM-04"},
      {"a feed below zero, GSK", kGsk, "G01 X10 F100\nG01 X20 F-5\n",
       feed_x(1, "5") + feed_x(2, "10"), kMissing, "GSK-COM-08"},
      {"a feed below zero, HNC", kHnc, "G01 X10 F100\nG01 X20 F-5\n",
       feed_x(1, "5") + feed_x(2, "10"), kMissing, "HNC-COM-04"},
      {"a word of CIP beside CT", kSie, "G1 X10 F100\nCT X20 I1=15\n",
       feed_x(1, "10") + feed_x(2, "20"), kMissing, "SIE-COM-02"},
      {"a centre beside G1", kSie, "G0 X10\nG1 X20 I3 F100\n", sie + feed_x(2, "20"), kMissing,
       "SIE-COM-02"},
      {"a centre beside G0", kSie, "G0 X10\nG0 X20 J3\n", sie + rapid_x(2, "20"), kMissing,
       "SIE-COM-02"},
      {"G2 in G17 with K0", kSie, "G0 X10\nG17 G2 X20 Y0 I5 K0 F100\n",
       sie + R"({"k":"arc","b":2,"plane":"G17","c":{"x":"15","y":"0"},"rot":-1,)"
             R"("to":{"x":"20","y":"0"},"f":"100"})"
             "\n",
       kMissing, "SIE-ARC-14"},
      {"an M function beside a pole", kSie, "G0 X10\nG111 X20 M8\nX30\n", sie + rapid_x(3, "30"),
       kMissing, "SIE-POL-03"},
      {"a feed beside a pole", kSie, "G0 X10\nG111 X20 F100\nX30\n", sie + rapid_x(3, "30"),
       kMissing, "SIE-POL-03"},
      {"a motion code beside a pole", kSie, "G0 X10 F100\nG1 G110 X20\nX30\n",
       sie + feed_x(3, "30"), kMissing, "SIE-POL-03"},
      {"a motion code beside a milling cycle", kGsk,
       "G18 G00 X70 Z70 Y30\nG01 G112 X70 Z70 Y20 I8 L5 D4 F200\n",
       R"({"k":"rapid","b":1,"to":{"x":"35","y":"30","z":"70"}})"
       "\n",
       kMissing, "GSK-MOD-09"},
      {"two M functions, GSK", kGsk, "G00 X10\nM08 M03\nX20\n", lathe + rapid_x(3, "10"), kMissing,
       "GSK-COM-11", "gsk.duplicate=alarm"},
      {"two M functions, HNC", kHnc, "G00 X10\nM08 M03\nX20\n", lathe + rapid_x(3, "10"), kMissing,
       "HNC-COM-02"},
      {"two M functions, SINUMERIK", kSie, "G0 X10\nM3 M8\nX20\n",
       sie + subject_alarm(2, "duplicate-word"), kSpurious, "SIE-COM-04"},
      {"M30 M30, GSK", kGsk, "G00 X10\nM30 M30\n", lathe, kMissing, "GSK-COM-11",
       "gsk.duplicate=alarm"},
      {"M30 M30, SINUMERIK", kSie, "G0 X10\nM30 M30\n", sie + subject_alarm(2, "duplicate-word"),
       kSpurious, "SIE-COM-04"},
      {"S-100, SINUMERIK", kSie, "G0 X10\nS-100\nX20\n", sie + rapid_x(3, "20"), kMissing,
       "SIE-COM-03"},
      {"S-100, GSK", kGsk, "G00 X10\nS-100\nX20\n", lathe + subject_alarm(2, "value-sign"),
       kSpurious, "GSK-COM-12"},
      {"S-100, HNC", kHnc, "G00 X10\nS-100\nX20\n", lathe + subject_alarm(2, "value-sign"),
       kSpurious, "HNC-COM-04"},
      {"a dwell without a time, GSK", kGsk, "G00 X10\nG04\nX20\n", lathe + rapid_x(3, "10"),
       kMissing, "GSK-COM-12"},
      {"a dwell without a time, HNC", kHnc, "G00 X10\nG04\nX20\n", lathe + rapid_x(3, "10"),
       kMissing, "HNC-COM-04"},
      {"a dwell without a time, SINUMERIK", kSie, "G0 X10\nG4\nX20\n", sie + rapid_x(3, "20"),
       kMissing, "SIE-MOD-06"},
      {"a code that moves nothing beside a dwell", kSie, "G0 X10\nG4 F1 G90\nX20\n",
       sie + dwell(2, "1") + rapid_x(3, "20"), kMissing, "SIE-MOD-10"},
      {"a code that moves nothing beside a dwell, without a dwell", kSie,
       "G0 X10\nG4 F1 G90\nX20\n", sie + rapid_x(3, "20"), kMissing, "SIE-MOD-10"},
      {"a dwell below zero, GSK", kGsk, "G00 X10\nG04 P-100\nX20\n",
       lathe + dwell(2, "0.1") + rapid_x(3, "10"), VerdictKind::fail_alarm_missing, "GSK-COM-12"},
      {"a dwell below zero and an alarm of a later block, GSK", kGsk,
       "G98 G00 X40 Z2\nM03 S500\nG04 P-100\nG01 Z-20 F100\nG02 X50 Z-30\nM30\n",
       R"({"k":"rapid","b":1,"to":{"x":"20","z":"2"}})"
       "\n"
       R"({"k":"feed","b":4,"to":{"z":"-20"},"f":"100"})"
       "\n" +
           subject_alarm(5, "missing-word"),
       VerdictKind::fail_alarm_late, "GSK-COM-12"},
      {"a dwell below zero, HNC", kHnc, "G00 X10\nG04 P-100\nX20\n", lathe + rapid_x(3, "10"),
       kMissing, "HNC-COM-04"},
      {"a dwell below zero, SINUMERIK", kSie, "G0 X10\nG4 F-1\nX20\n", sie + rapid_x(3, "20"),
       kMissing, "SIE-MOD-06"},
      {"R1000", kSie, "G0 X10\nR1000=5\nX20\n", sie + rapid_x(3, "20"), kMissing, "SIE-PAR-02"},
      {"CIP=0 as an undefined code", kSie, "G0 X10\nCIP=0\n",
       sie + subject_alarm(2, "undefined-code"), kClass, "SIE-LEX-02"},
      {"G=1 as an undefined code", kSie, "G0 X10\nG=1 X20 F100\n",
       sie + subject_alarm(2, "undefined-code"), kClass, "SIE-LEX-02"},
      {"R1000 as an undefined code", kSie, "G0 X10\nR1000=5\nX20\n",
       sie + subject_alarm(2, "undefined-code"), kClass, "SIE-PAR-02"},
      {"R1000 as no word", kSie, "G0 X10\nR1000=5\nX20\n", sie + subject_alarm(2, "syntax"), kClass,
       "SIE-PAR-02"},
      {"S-100 out of range, SINUMERIK", kSie, "G0 X10\nS-100\nX20\n",
       sie + subject_alarm(2, "value-out-of-range"), kClass, "SIE-COM-03"},
      {"an M function beside a pole as no block", kSie, "G0 X10\nG111 X20 M8\nX30\n",
       sie + subject_alarm(2, "syntax"), kClass, "SIE-POL-03"},
      {"a dwell without a time as no block", kSie, "G0 X10\nG4\nX20\n",
       sie + subject_alarm(2, "syntax"), kClass, "SIE-MOD-06"},
      {"another plane under a rotation as a conflict", "sinumerik802s",
       "G17 G0 X10\nG258 RPL=30\nG18\n", sie + subject_alarm(3, "conflicting-words"), kClass,
       "SIE-FRM-05"},
      {"a dwell of LCYC82 out of range", "sinumerik802s",
       "G0 X10 F100\nR101=5 R102=2 R103=0 R104=-10 R105=-1\nLCYC82\n",
       sie + subject_alarm(3, "value-out-of-range"), kClass, "SIE-LC82-04"},
      {"a word beside LCYC82 as no block", "sinumerik802s",
       "G0 X10 F100\nR101=5 R102=2 R103=0 R104=-10 R105=0\nLCYC82 M8\n",
       sie + subject_alarm(3, "syntax"), kClass, "SIE-LC82-05"},
      {"an infeed of zero out of range", "sinumerik802s",
       "G0 X10 S300 M3 T1 D1\nR101=5 R102=2 R103=0 R104=-10 R116=0 R117=0 R118=60 R119=40 R120=8\n"
       "R121=0 R122=120 R123=300 R124=0 R125=0 R126=2 R127=1\nLCYC75\n",
       sie + subject_alarm(4, "value-out-of-range"), kClass, "SIE-LC75-15"},
      {"X beside U as a word twice, HNC", kHnc, "G00 X10\nG00 X20 U2\n",
       lathe + subject_alarm(2, "duplicate-word"), kClass, "HNC-COM-03"},
      {"F-5 out of range, GSK", kGsk, "G00 X10\nG01 X20 F-5\n",
       lathe + subject_alarm(2, "value-out-of-range"), kClass, "GSK-COM-08"},
      {"two signs as a value", kSie, "G0 X10\nX=- -(27.466)\n", sie + rapid_x(2, "27.466"),
       kMissing, "SIE-LEX-02"},
      {"a repeated O number", kGsk, "O0001\nO0002\nG00 X10\n", subject_alarm(2, "syntax"),
       kSpurious, "GSK-COM-13"},
      {"blocks behind a second %", kGsk, "%\nG00 X10\n%\nG00 X20\n",
       rapid_x(2, "5") + rapid_x(4, "10"), VerdictKind::fail_overrun, "GSK-COM-13"},
      {"an alarm behind a second %", kGsk, "%\nG00 X10\n%\nG15\n",
       rapid_x(2, "5") + subject_alarm(4, "undefined-code"), kSpurious, "GSK-COM-13"},
      {"a sign of a word without effect", kGsk, "G00 X130 Z5\nG94 X120 Z-10 F300 K-1\n",
       kRapidToStart, kMissing, "GSK-COM-10"},
      {"a word without effect, GSK", kGsk, "G00 X10\nG94 X8 Z0 F100 K1\n",
       lathe + subject_alarm(2, "conflicting-words"), kSpurious, "GSK-COM-10"},
      {"a word without effect, HNC", kHnc, "G00 X10\nG80 X8 Z-5 F100 K1\n",
       lathe + subject_alarm(2, "conflicting-words"), kSpurious, "HNC-COM-07"},
      {"a subroutine met after its call", "rs274",
       "#1=7\no100 call [3]\nG0 Y#1\no100 sub\nG0 X#1\no100 endsub\nM2\n",
       rapid_x(5, "3") + R"({"k":"rapid","b":3,"to":{"x":"3","y":"7"}})" + "\n" +
           subject_alarm(4, "syntax"),
       kSpurious, "NGC-OWD-11"},
      {"H1 H2", kSie, "G0 X10\nH1 H2\nX20\n", sie + subject_alarm(2, "duplicate-word"), kSpurious,
       "SIE-COM-04"},
      {"a cut with a standing spindle", kSie, "G0 X10\nG1 X20 F100\n",
       sie + subject_alarm(2, "spindle-stopped"), kSpurious, "SIE-G1-04"},
  };
}

class EveryDisputed : public testing::TestWithParam<Disputed> {};

TEST_P(EveryDisputed, IsAnAdviceAndUnderStrictNoGo) {
  const Disputed& one = GetParam();
  const Verdict verdict =
      judge_trace(one.program, one.trace, {.reading = one.reading, .dialect = one.dialect});
  EXPECT_EQ(name(verdict.kind), name(VerdictKind::advice)) << verdict.message;
  EXPECT_EQ(verdict.departure, one.departure) << name(verdict.departure.value_or(verdict.kind));
  EXPECT_EQ(reference::clause_name(verdict.clause), one.clause);
  EXPECT_EQ(decision(verdict.kind), Decision::neither);
  const Verdict strict = judge_trace(
      one.program, one.trace, {.reading = one.reading, .dialect = one.dialect, .strict = true});
  EXPECT_EQ(name(strict.kind), name(one.departure)) << strict.message;
  EXPECT_EQ(reference::clause_name(strict.clause), one.clause);
  EXPECT_FALSE(strict.departure.has_value());
}

INSTANTIATE_TEST_SUITE_P(Programs, EveryDisputed, testing::ValuesIn(disputed()),
                         [](const testing::TestParamInfo<Disputed>& one) {
                           std::string text;
                           for (const char c : std::string(one.param.name)) {
                             text += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
                           }
                           return text;
                         });

// What a subject without line numbers says is placed by its motions.
TEST(Advice, NeedsNoLineNumbers) {
  const std::string trace = R"({"k":"rapid","to":{"x":"5"}})"
                            "\n"
                            R"({"k":"alarm","class":"value-sign"})"
                            "\n";
  EXPECT_EQ(judge_trace("G00 X10\nS-100\nG00 X20\n", trace, {.blocks = false}).kind,
            VerdictKind::advice);
  EXPECT_EQ(judge_trace("S-100\nG00 X10\nG00 X20\n", trace, {.blocks = false}).kind,
            VerdictKind::fail_alarm_spurious);
}

// J-ALM-01: a block that breaks a rule of a text as well. Q-6 is no depth of a peck, and X stands
// beside U.
TEST(Advice, IsNoneWhereTheBlockAlsoBreaksARuleOfAText) {
  const std::string begin = R"({"k":"rapid","b":1,"to":{"x":"0","z":"2"}})"
                            "\n";
  const Verdict verdict =
      judge_trace("G00 X0 Z2\nG74 Z-17 R1 Q-6 U1 X2 F50\n", begin, {.dialect = kHnc});
  EXPECT_EQ(verdict.kind, VerdictKind::fail_alarm_missing);
  EXPECT_EQ(reference::clause_name(verdict.clause), "HNC-G74-01");
}

// R7.
TEST(Advice, ComesBehindADepartureInMotion) {
  const char* program = "G0 X10\nX15\nG1 X20 I3 F100\n";
  EXPECT_EQ(
      judge_trace(program, rapid_x(1, "10") + rapid_x(2, "16") + feed_x(3, "20"), {.dialect = kSie})
          .kind,
      VerdictKind::fail_geometry);
  // The motion of line 2 is missing.
  EXPECT_EQ(judge_trace(program, rapid_x(1, "10") + subject_alarm(3, "conflicting-words"),
                        {.dialect = kSie})
                .kind,
            VerdictKind::fail_geometry);
  EXPECT_EQ(judge_trace("G0 X10\nX15\nG0 X20 H1 H2\n",
                        rapid_x(1, "10") + subject_alarm(3, "duplicate-word"), {.dialect = kSie})
                .kind,
            VerdictKind::fail_geometry);
}

TEST(Advice, SaysThatWhatFollowsIsNotJudged) {
  const Verdict verdict =
      judge_trace("G0 X10\nS-100\nX20\n", rapid_x(1, "10") + rapid_x(3, "999"), {.dialect = kSie});
  EXPECT_EQ(verdict.kind, VerdictKind::advice);
  EXPECT_NE(verdict.message.find("is not judged"), std::string::npos) << verdict.message;
}

TEST(Advice, IsNoneWhereATextStatesTheRule) {
  // R 20 against a travel of 5 along X: GSK-G90-09.
  EXPECT_EQ(judge_trace("G00 X130 Z5\nG90 X120 Z-10 R20 F300\n", kRapidToStart).kind,
            VerdictKind::fail_alarm_missing);
  // Note 1 of G94 orders the alarm.
  EXPECT_EQ(judge_trace("G00 X130 Z5\nG94 X120 Z-10 Y1 F300\n", kRapidToStart).kind,
            VerdictKind::fail_alarm_missing);
}

// J-ALM-03: nothing excuses how a subject runs.
TEST(Advice, IsNoCrash) {
  const reference::Profile profile =
      std::get<reference::Profile>(reference::default_profile("sinumerik840d"));
  RunEnd end;
  for (const RunEnd::Kind kind : {RunEnd::Kind::crash, RunEnd::Kind::timeout,
                                  RunEnd::Kind::protocol, RunEnd::Kind::out_of_memory}) {
    end.kind = kind;
    const Verdict verdict = judge_outcome(profile, std::string_view("S-100\n"), Tolerances{},
                                          std::span<const Record>(), end)
                                .verdict;
    EXPECT_EQ(decision(verdict.kind), Decision::no_go) << name(verdict.kind);
  }
}

// R6: where no rule of ours lets the block run, the clause is that of its first record.
TEST(SpuriousAlarm, NamesTheClauseUnderWhichTheProgramIsRight) {
  const Verdict verdict = judge_trace("G00 X130 Z5\nG94 X120 Z-10 F300\n",
                                      kRapidToStart + subject_alarm(2, "taper-limit"));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_alarm_spurious);
  EXPECT_EQ(reference::clause_name(verdict.clause), "GSK-G94-02");
}

// The seed's arc B: its radii differ by 0.0038, and the centre of the start's radius stands at
// (89.998058560, 69.996728481) (facts of the manual's example, 6.2). 0.0015 beside it no text says
// that it is too coarse; 0.0025 beside it the arc is another one.
std::string seed_arc(const char* centre_x, const char* behind) {
  return R"({"k":"rapid","b":1,"to":{"x":"133","y":"44.48"}}
{"k":"arc","b":2,"plane":"G17","c":{"x":")" +
         std::string(centre_x) +
         R"(","y":"69.996728481"},"rot":-1,"to":{"x":"115","y":"113.3"},"f":"100"}
{"k":"rapid","b":3,"to":{"x":")" +
         behind + "\"}}\n";
}
constexpr const char* kSeedArc = "G0 X133 Y44.48\nG2 X115 Y113.3 I-43 J25.52 F100\nG0 X0\n";

Verdict judge_seed_arc(const std::string& trace, bool strict = false) {
  return judge_trace(
      kSeedArc, trace,
      {.reading = "sie.arc.correct=start-radius", .dialect = kSie, .strict = strict});
}

TEST(Advice, OfACorrectedCentreDoesNotEndTheJudgement) {
  EXPECT_EQ(decision(judge_seed_arc(seed_arc("89.998058560", "0")).kind), Decision::go);
  const Verdict advice = judge_seed_arc(seed_arc("89.999558560", "0"));
  EXPECT_EQ(advice.kind, VerdictKind::advice) << advice.message;
  EXPECT_EQ(advice.departure, VerdictKind::fail_geometry);
  EXPECT_EQ(reference::clause_name(advice.clause), "SIE-ARC-15");
  EXPECT_EQ(judge_seed_arc(seed_arc("89.999558560", "0"), true).kind, VerdictKind::fail_geometry);
  EXPECT_EQ(judge_seed_arc(seed_arc("89.999558560", "1")).kind, VerdictKind::fail_geometry);
  EXPECT_EQ(judge_seed_arc(seed_arc("90.000558560", "0")).kind, VerdictKind::fail_geometry);
}

// R7: the silence is about the centre alone.
TEST(Advice, OfACorrectedCentreExcusesNoFeedAndNoTurn) {
  const auto changed = [](std::string_view from, std::string_view to) {
    std::string trace = seed_arc("89.999558560", "0");
    trace.replace(trace.find(from), from.size(), to);
    return decision(judge_seed_arc(trace).kind);
  };
  EXPECT_EQ(changed(R"("f":"100")", R"("f":"101")"), Decision::no_go);
  EXPECT_EQ(changed(R"("rot":-1)", R"("rot":-2)"), Decision::no_go);
  EXPECT_EQ(changed(R"("rot":-1)", R"("rot":1)"), Decision::no_go);
}

// NGC-OFS-14 is silent. A loop leads back to line 4, whose M8 comes again and again.
TEST(Silence, RunsOnInALoop) {
  constexpr std::string_view kProgram =
      "G21 F100\n#1=0\no1 while [#1 LT 3]\nG1 X[#1+1] M8\no2 if [#1 EQ 1]\nG53 G91 G1 X3\nG90\n"
      "o2 endif\n#1=[#1+1]\no1 endwhile\nM2\n";
  const std::string m8 = R"({"k":"m","b":4,"m":8})"
                         "\n";
  const std::string m2 = R"({"k":"m","b":11,"m":2})";
  const Judging rs274{.m = true, .dialect = "rs274"};
  const std::string begin = m8 + feed_x(4, "1") + m8 + feed_x(4, "2");
  EXPECT_EQ(judge_trace(kProgram, begin + m8 + feed_x(4, "3") + m2, rs274).kind,
            VerdictKind::advice);
}

// NGC-FED-03: no text says that a feed a revolution needs a turning spindle. Y0 of the first time
// round is too small to see, and the alarm may come there as well as the time after.
TEST(Silence, AlarmsBeforeAMotionTooSmallToSeeInALoop) {
  constexpr std::string_view kProgram =
      "G21 G95 F0.1\n#1=0\no1 while [#1 LT 3]\nG1 X[#1+1]\nG1 Y#1\n#1=[#1+1]\no1 endwhile\nM2\n";
  const std::string moved = R"({"k":"feed","b":4,"to":{"x":"1"},"f":"0.1","fm":"rev"})"
                            "\n";
  const auto said = [&](int block) {
    return judge_trace(kProgram, moved + subject_alarm(block, "spindle-stopped"),
                       {.dialect = "rs274"})
        .kind;
  };
  EXPECT_EQ(said(5), VerdictKind::advice);
  EXPECT_EQ(decision(said(6)), Decision::no_go);
}

// SIE-COM-02: no text says that a speed below zero alarms. Who runs on comes to the alarm of line
// 4, with line numbers and without; an alarm that the program has nowhere is none.
TEST(Silence, RunsOnToALaterAlarmOfTheProgram) {
  constexpr std::string_view kProgram = "G1 X1 F100\nS-5 X3\nX10\nX20 AP=400\nX30\n";
  const auto said = [&](bool blocks, std::string_view alarm) {
    const std::string trace = feed_x(1, "1") + feed_x(2, "3") + feed_x(3, "10") +
                              subject_alarm(4, std::string(alarm).c_str());
    return judge_trace(kProgram, trace, {.blocks = blocks, .dialect = kSie}).kind;
  };
  for (const bool blocks : {true, false}) {
    EXPECT_EQ(said(blocks, "value-out-of-range"), VerdictKind::advice);
    EXPECT_EQ(decision(said(blocks, "duplicate-word")), Decision::no_go);
  }
}

}  // namespace
}  // namespace gonogo::oracle
