// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-ALM-03, R7: what no text states excuses the other answer to its own
// question, and nothing that stands beside it. Each program is tried with every class of alarm.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

using reference::AlarmClass;

constexpr std::array kAlarmClasses = {
#define GONOGO_ALARM(name, text, sentence) AlarmClass::name,
#include "reference/alarm_classes.def"
};

std::string moved_record(const char* kind, int block, const char* to, const char* more = "") {
  return R"({"k":")" + std::string(kind) + R"(","b":)" + std::to_string(block) + R"(,"to":{)" + to +
         "}" + more + "}\n";
}
std::string traverse(int block, const char* to) {
  return moved_record("rapid", block, to);
}
std::string straight_feed(int block, const char* to) {
  return moved_record("feed", block, to, R"(,"f":"100")");
}
std::string alarm_said(int block, std::string_view alarm_class) {
  return R"({"k":"alarm","b":)" + std::to_string(block) + R"(,"class":")" +
         std::string(alarm_class) + "\"}\n";
}
std::string without_line_numbers(std::string trace) {
  for (std::size_t at = 0; (at = trace.find("\"b\":", at)) != std::string::npos;) {
    trace.erase(at, trace.find(',', at) + 1 - at);
  }
  return trace;
}

// A program of which one block stands on a rule of ours, and what a subject puts out of it.
struct Silent {
  const char* name;
  std::string_view dialect;
  const char* program;
  int block;           // that runs on by the rule, or alarms by it
  std::string before;  // what is due before it
  std::string half;    // of its motion; empty: it has none
  std::string whole;
  std::string behind;  // of the block behind it
  std::vector<AlarmClass> answers;
  std::string_view clause;
  std::vector<AlarmClass> names = {};  // that the alarm by the rule may have instead
};

bool is_other_answer(const Silent& one, AlarmClass alarm_class) {
  return std::ranges::count(one.answers, alarm_class) != 0;
}

// Of three motions along X the second, a traverse or a cut, stands on the rule. X of a lathe is a
// diameter in a program.
Silent second_of_three(const char* name, std::string_view dialect, const char* program,
                       std::vector<AlarmClass> answers, std::string_view clause,
                       std::vector<AlarmClass> names = {}) {
  const bool is_lathe = dialect == "gsk988ta" || dialect == "hnc21t";
  const bool cuts = std::string_view(program).find("\nG1 ") != std::string_view::npos;
  const auto second = cuts ? straight_feed : traverse;
  return {name,
          dialect,
          program,
          2,
          traverse(1, is_lathe ? R"("x":"5")" : R"("x":"10")"),
          second(2, is_lathe ? R"("x":"7")" : R"("x":"15")"),
          second(2, is_lathe ? R"("x":"10")" : R"("x":"20")"),
          traverse(3, is_lathe ? R"("x":"15")" : R"("x":"30")"),
          std::move(answers),
          clause,
          std::move(names)};
}

std::vector<Silent> running_on_a_mill() {
  constexpr std::string_view kCut = "G0 X10\nG1 X20 F100\nG0 X30\n";
  return {
      second_of_three("a cut with a standing spindle, 840D", "sinumerik840d", kCut.data(),
                      {AlarmClass::spindle_stopped}, "SIE-G1-04"),
      second_of_three("a cut with a standing spindle, 802S", "sinumerik802s", kCut.data(),
                      {AlarmClass::spindle_stopped}, "SIE-G1-04"),
      second_of_three("a second H", "sinumerik840d", "G0 X10\nG0 X20 H1 H2\nG0 X30\n",
                      {AlarmClass::duplicate_word}, "SIE-COM-04"),
  };
}

std::vector<Silent> running_on_with_odd_words() {
  return {
      {"a cut behind the position of the spindle",
       "sinumerik840d",
       "G0 X10 M3 S600\nSPOS=0\nG1 X20 F100\nG0 X30\n",
       3,
       traverse(1, R"("x":"10")"),
       straight_feed(3, R"("x":"15")"),
       straight_feed(3, R"("x":"20")"),
       traverse(4, R"("x":"30")"),
       {AlarmClass::spindle_stopped},
       "SIE-MOD-09"},
      {"turns of a spindle that stands",
       "sinumerik802s",
       "G0 X10 M3 S600\nM5\nG4 S10\nG0 X30\n",
       3,
       traverse(1, R"("x":"10")"),
       "",
       R"({"k":"dwell","b":3,"s":"1"})"
       "\n",
       traverse(4, R"("x":"30")"),
       {AlarmClass::spindle_stopped},
       "SIE-MOD-09"},
      second_of_three(
          "an edge below zero", "sinumerik840d", "G0 X10\nG0 X20 T1 D-1\nG0 X30\n",
          {AlarmClass::value_sign, AlarmClass::value_out_of_range, AlarmClass::not_an_integer},
          "SIE-COM-05"),
      second_of_three(
          "a feed of zero beside a traverse", "sinumerik802s", "G0 X10\nG0 X20 F0\nG0 X30\n",
          {AlarmClass::value_sign, AlarmClass::value_out_of_range, AlarmClass::feed_missing},
          "SIE-COM-06"),
      second_of_three("an ampersand", "sinumerik802s", "G0 X10\nG0&X20\nG0 X30\n",
                      {AlarmClass::syntax, AlarmClass::undefined_code}, "SIE-LEX-03"),
  };
}

// G80: from A by rapid to B, by feed to C and D.
std::vector<Silent> running_on_a_lathe() {
  return {
      {"a word without effect, GSK",
       "gsk988ta",
       "G00 X10 Z2\nG94 X8 Z0 F100 L7\nG00 X30\n",
       2,
       traverse(1, R"("x":"5","z":"2")"),
       traverse(2, R"("z":"0")"),
       traverse(2, R"("z":"0")") + straight_feed(2, R"("x":"4")") + straight_feed(2, R"("z":"2")") +
           traverse(2, R"("x":"5")"),
       traverse(3, R"("x":"15")"),
       {AlarmClass::unused_word, AlarmClass::conflicting_words},
       "GSK-COM-10"},
      {"a word without effect, HNC",
       "hnc21t",
       "G00 X10\nG80 X8 Z-5 F100 P7\nG00 X30\n",
       2,
       traverse(1, R"("x":"5")"),
       traverse(2, R"("x":"4")"),
       traverse(2, R"("x":"4")") + straight_feed(2, R"("z":"-5")") +
           straight_feed(2, R"("x":"5")") + traverse(2, R"("z":"0")"),
       traverse(3, R"("x":"15")"),
       {AlarmClass::unused_word, AlarmClass::conflicting_words},
       "HNC-COM-07"},
      second_of_three("a speed below zero, GSK", "gsk988ta", "G00 X10\nG00 X20 S-100\nG00 X30\n",
                      {AlarmClass::value_sign, AlarmClass::value_out_of_range}, "GSK-COM-12"),
      second_of_three("a motion beside G80, GSK", "gsk988ta", "G00 X10\nG80 G00 X20\nG00 X30\n",
                      {AlarmClass::duplicate_word, AlarmClass::conflicting_words}, "GSK-MOD-10"),
      second_of_three("a speed below zero, HNC", "hnc21t", "G00 X10\nG00 X20 S-100\nG00 X30\n",
                      {AlarmClass::value_sign, AlarmClass::value_out_of_range}, "HNC-COM-04"),
  };
}

std::vector<Silent> running_on_by_rs274() {
  return {
      {"a comment behind an O word",
       "rs274",
       "G21 G90 F100\nG1 X10\no1 if [1] (note)\nG1 X20\no1 endif\nM2\n",
       3,
       straight_feed(2, R"("x":"10")"),
       "",
       "",
       straight_feed(4, R"("x":"20")"),
       {AlarmClass::syntax},
       "NGC-OWD-09"},
      second_of_three("M6 without a T", "rs274", "G21 G0 X10\nM6 G0 X20\nG0 X30\nM2\n",
                      {AlarmClass::no_tool, AlarmClass::missing_word}, "NGC-COM-14"),
      second_of_three("a pin beyond those of the documents", "rs274",
                      "G21 G0 X10\nM64 P4 G0 X20\nG0 X30\nM2\n",
                      {AlarmClass::value_out_of_range, AlarmClass::value_sign,
                       AlarmClass::not_an_integer, AlarmClass::missing_word},
                      "NGC-COM-15"),
      {"a dwell beside an arc",
       "rs274",
       "G21 G0 X10 F100\nG4 P2 G2 X20 I5\nG0 X30\nM2\n",
       2,
       traverse(1, R"("x":"10")"),
       "",
       R"({"k":"dwell","b":2,"s":"2"})"
       "\n"
       R"({"k":"arc","b":2,"plane":"G17","c":{"x":"15","y":"0"},"rot":-1,"to":{"x":"20","y":"0"},)"
       R"("f":"100"})"
       "\n",
       traverse(3, R"("x":"30")"),
       {AlarmClass::conflicting_words},
       "NGC-G4-03"},
      {"G53 alone",
       "rs274",
       "G21 G0 X10\nG53\nG0 X30\nM2\n",
       2,
       traverse(1, R"("x":"10")"),
       "",
       "",
       traverse(3, R"("x":"30")"),
       {AlarmClass::conflicting_words, AlarmClass::missing_word},
       "NGC-OFS-20"},
  };
}

std::vector<Silent> running_on() {
  std::vector<Silent> all = running_on_a_mill();
  for (auto* const more : {running_on_with_odd_words, running_on_a_lathe, running_on_by_rs274}) {
    std::ranges::move(more(), std::back_inserter(all));
  }
  return all;
}

std::vector<Silent> alarming() {
  return {
      second_of_three("a centre beside G1", "sinumerik840d",
                      "G0 X10 S500 M3\nG1 X20 I3 F100\nG0 X30\n", {AlarmClass::conflicting_words},
                      "SIE-COM-02",
                      {AlarmClass::syntax, AlarmClass::undefined_code, AlarmClass::unused_word}),
      second_of_three("a speed below zero, 802S", "sinumerik802s", "G0 X10\nG0 X20 S-100\nG0 X30\n",
                      {AlarmClass::value_sign}, "SIE-COM-03", {AlarmClass::value_out_of_range}),
      second_of_three("X beside U, GSK", "gsk988ta", "G00 X10\nG00 X20 U2\nG00 X30\n",
                      {AlarmClass::conflicting_words}, "GSK-COM-09", {AlarmClass::duplicate_word}),
      second_of_three("X beside U, HNC", "hnc21t", "G00 X10\nG00 X20 U2\nG00 X30\n",
                      {AlarmClass::conflicting_words}, "HNC-COM-03", {AlarmClass::duplicate_word}),
      second_of_three("G53 under G91", "rs274", "G21 G0 X10\nG91 G53 G0 X20\nG90 G0 X30\nM2\n",
                      {AlarmClass::conflicting_words}, "NGC-OFS-14"),
  };
}

Verdict judged_silent(const Silent& one, const std::string& trace, bool blocks = true,
                      bool strict = false) {
  return judge_trace(one.program, blocks ? trace : without_line_numbers(trace),
                     {.blocks = blocks, .dialect = one.dialect, .strict = strict});
}

VerdictKind kind_said(const Silent& one, const std::string& trace, bool blocks = true) {
  return judged_silent(one, trace, blocks).kind;
}

class RunsOnBySilence : public testing::TestWithParam<Silent> {};
class AlarmsBySilence : public testing::TestWithParam<Silent> {};

TEST_P(RunsOnBySilence, WhichExcusesTheAlarmOfThatRuleAlone) {
  const Silent& one = GetParam();
  EXPECT_EQ(decision(kind_said(one, one.before + one.whole + one.behind)), Decision::go);
  for (const bool blocks : {true, false}) {
    for (const AlarmClass each : kAlarmClasses) {
      const std::string trace = one.before + alarm_said(one.block, reference::name(each));
      const Verdict verdict = judged_silent(one, trace, blocks);
      EXPECT_EQ(name(verdict.kind), is_other_answer(one, each) ? "advice" : "fail.alarm-spurious")
          << reference::name(each) << ": " << verdict.message;
      if (!is_other_answer(one, each)) continue;
      EXPECT_EQ(reference::clause_name(verdict.clause), one.clause);
    }
  }
}

TEST_P(RunsOnBySilence, WhichExcusesNoAlarmThatHasNoClass) {
  const Silent& one = GetParam();
  const std::string native =
      R"({"k":"alarm","b":)" + std::to_string(one.block) + R"(,"native":"PS0010"})" + "\n";
  EXPECT_EQ(decision(kind_said(one, one.before + native)), Decision::no_go);
}

TEST_P(RunsOnBySilence, WhichExcusesNoAlarmInAnotherBlock) {
  const Silent& one = GetParam();
  const std::string_view right = reference::name(one.answers.front());
  EXPECT_EQ(decision(kind_said(one, one.before + alarm_said(one.block + 1, right))),
            Decision::no_go);
  EXPECT_EQ(decision(kind_said(one, one.before + alarm_said(one.block - 1, right))),
            Decision::no_go);
  EXPECT_EQ(decision(kind_said(one, one.before + one.whole + alarm_said(one.block + 1, right))),
            Decision::no_go);
  EXPECT_EQ(decision(kind_said(one, alarm_said(one.block, right))), Decision::no_go);  // too early
}

// However far it came, and for any line that it names.
TEST_P(RunsOnBySilence, WhichExcusesNoAlarmThatComesAfterItsMotion) {
  const Silent& one = GetParam();
  const std::string right = alarm_said(one.block, reference::name(one.answers.front()));
  for (const std::string& moved : {one.half, one.whole, one.whole + one.behind}) {
    if (moved.empty()) continue;
    EXPECT_EQ(name(kind_said(one, one.before + moved + right)), "fail.alarm-late");
    EXPECT_EQ(decision(kind_said(one, one.before + moved + right, false)), Decision::no_go);
  }
}

TEST_P(AlarmsBySilence, WhichExcusesASubjectThatRunsOn) {
  const Silent& one = GetParam();
  for (const bool blocks : {true, false}) {
    for (const std::string& moved : {std::string(), one.half, one.whole, one.whole + one.behind}) {
      const Verdict verdict = judged_silent(one, one.before + moved, blocks);
      EXPECT_EQ(name(verdict.kind), "advice") << moved;
      EXPECT_EQ(verdict.departure, VerdictKind::fail_alarm_missing);
      EXPECT_EQ(reference::clause_name(verdict.clause), one.clause);
    }
    EXPECT_EQ(decision(kind_said(one, one.behind, blocks)), Decision::no_go);  // before it
  }
}

// R7: where only the class of the alarm is ours, another name of it is an advice.
std::string_view kind_of_name(const Silent& one, AlarmClass alarm_class) {
  if (is_other_answer(one, alarm_class)) return "pass-exact";
  return std::ranges::count(one.names, alarm_class) != 0 ? "advice" : "fail.alarm-class";
}

TEST_P(AlarmsBySilence, WhichExcusesNoAlarmOfAnotherClassOrBlock) {
  const Silent& one = GetParam();
  for (const AlarmClass each : kAlarmClasses) {
    const std::string trace = one.before + alarm_said(one.block, reference::name(each));
    EXPECT_EQ(name(kind_said(one, trace)), kind_of_name(one, each)) << reference::name(each);
    for (const std::string& moved : {std::string(), one.half, one.whole, one.whole + one.behind}) {
      const std::string later =
          one.before + moved + alarm_said(one.block + 1, reference::name(each));
      EXPECT_EQ(name(kind_said(one, later)), "fail.alarm-late") << reference::name(each);
    }
  }
}

std::string silent_name(const testing::TestParamInfo<Silent>& one) {
  std::string text;
  for (const char c : std::string(one.param.name)) {
    text += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return text;
}
INSTANTIATE_TEST_SUITE_P(Programs, RunsOnBySilence, testing::ValuesIn(running_on()), silent_name);
INSTANTIATE_TEST_SUITE_P(Programs, AlarmsBySilence, testing::ValuesIn(alarming()), silent_name);

// R7: what departs before an unstated alarm goes first.
TEST_P(AlarmsBySilence, WhichExcusesNothingBeforeIt) {
  const Silent& one = GetParam();
  const std::string dwell =
      R"({"k":"dwell","b":)" + std::to_string(one.block - 1) + R"(,"s":"1"})" + "\n";
  for (const std::string& behind : {std::string(), one.whole, one.whole + one.behind}) {
    EXPECT_EQ(decision(kind_said(one, one.before + dwell + behind)), Decision::no_go);
    EXPECT_EQ(
        decision(kind_said(one, one.before + traverse(one.block - 1, R"("z":"99")") + behind)),
        Decision::no_go);
  }
}

// R7: X40 beside U2 alarms, and K1 has no effect: a control that says so of K1 answers
// another question the other way.
TEST(Silence, ExcusesTheAlarmOfARuleBesideAnotherFault) {
  const Judging judging{.dialect = "hnc21t"};
  const char* program = "G00 X50 Z5\nG80 X40 U2 Z-20 K1 F100\n";
  const std::string before = traverse(1, R"("x":"25","z":"5")");
  EXPECT_EQ(judge_trace(program, before + alarm_said(2, "conflicting-words"), judging).kind,
            VerdictKind::pass_exact);
  const Verdict verdict = judge_trace(program, before + alarm_said(2, "unused-word"), judging);
  EXPECT_EQ(verdict.kind, VerdictKind::advice);
  EXPECT_EQ(reference::clause_name(verdict.clause), "HNC-COM-07");
  EXPECT_EQ(judge_trace(program, before + alarm_said(2, "value-sign"), judging).kind,
            VerdictKind::fail_alarm_class);
}

// A text has the missing feed as an alarm, and none has the spindle.
TEST(Silence, ExcusesTheAlarmOfARuleBesideAFaultOfAText) {
  const Judging judging{.dialect = "sinumerik840d"};
  const auto kind = [&](std::string_view alarm_class) {
    return judge_trace("G0 X10\nG1 X20\n", traverse(1, R"("x":"10")") + alarm_said(2, alarm_class),
                       judging)
        .kind;
  };
  EXPECT_EQ(kind("feed-missing"), VerdictKind::pass_exact);
  EXPECT_EQ(kind("spindle-stopped"), VerdictKind::advice);
  EXPECT_EQ(kind("syntax"), VerdictKind::fail_alarm_class);
}

// SIE-COM-06: the feed of a cut is zero; of which class that is no text says.
TEST(Silence, ExcusesTheValueOfAFeedThatIsMissingForItIsZero) {
  const Judging judging{.dialect = "sinumerik840d"};
  for (const char* program : {"G0 X10 M3 S600\nG1 X20 F0\n", "G0 X10 M3 S600 F0\nG1 X20\n"}) {
    const auto kind = [&](std::string_view alarm_class) {
      return judge_trace(program, traverse(1, R"("x":"10")") + alarm_said(2, alarm_class), judging)
          .kind;
    };
    EXPECT_EQ(kind("feed-missing"), VerdictKind::pass_exact);
    EXPECT_EQ(kind("value-sign"), VerdictKind::advice);
    EXPECT_EQ(kind("value-out-of-range"), VerdictKind::advice);
    EXPECT_EQ(kind("syntax"), VerdictKind::fail_alarm_class);
  }
}

// R7. Line 3 is the second %; behind it X moves to a diameter of 20.
TEST(Silence, OfTheEndExcusesWhatTheRestOfTheProgramDoes) {
  for (const std::string_view dialect : {"gsk988ta", "hnc21t"}) {
    const Judging judging{.dialect = dialect};
    const char* program = "%\nG00 X10\n%\nG00 X20\nG01 X30 F100\n";
    const auto kind = [&](const std::string& behind) {
      return judge_trace(program, traverse(2, R"("x":"5")") + behind, judging).kind;
    };
    const std::string next = traverse(4, R"("x":"10")");
    EXPECT_EQ(kind(""), VerdictKind::pass_exact);
    EXPECT_EQ(kind(next + straight_feed(5, R"("x":"15")")), VerdictKind::advice);
    EXPECT_EQ(kind(traverse(4, R"("x":"11")")), VerdictKind::fail_geometry);
    EXPECT_EQ(kind(next), VerdictKind::fail_geometry);
    EXPECT_EQ(kind(next + straight_feed(5, R"("x":"16")")), VerdictKind::fail_geometry);
    EXPECT_EQ(kind(next + straight_feed(5, R"("x":"15")") + traverse(6, R"("x":"9")")),
              VerdictKind::fail_overrun);
    EXPECT_EQ(kind(alarm_said(3, "syntax")), VerdictKind::advice);
    EXPECT_EQ(kind(alarm_said(3, "value-sign")), VerdictKind::fail_alarm_spurious);
    EXPECT_EQ(kind(alarm_said(4, "syntax")), VerdictKind::fail_alarm_spurious);
    EXPECT_EQ(kind(next + alarm_said(3, "syntax")), VerdictKind::fail_alarm_late);
  }
}

// R7. Line 2 alarms by a rule of ours, line 4 by one of a text.
TEST(Silence, ExcusesTheNextAlarmOfASubjectThatRunsOn) {
  const auto kind = [](int block, std::string_view alarm_class) {
    const std::string moved = traverse(1, R"("x":"5")") + traverse(2, R"("x":"10")");
    return judge_trace("G00 X10\nG00 X20 U2\nG00 X30\nG01 X40\n",
                       moved + traverse(3, R"("x":"15")") + alarm_said(block, alarm_class),
                       {.dialect = "gsk988ta"})
        .kind;
  };
  EXPECT_EQ(kind(4, "feed-missing"), VerdictKind::advice);
  EXPECT_EQ(kind(4, "syntax"), VerdictKind::fail_alarm_late);
  EXPECT_EQ(kind(3, "feed-missing"), VerdictKind::fail_alarm_late);
  EXPECT_EQ(kind(2, "conflicting-words"), VerdictKind::fail_alarm_late);
}

// Under hnc.g75.i = P the word P is missing, and no text says so; under I the motions are due, and
// whoever runs on makes these.
TEST(Silence, ExcusesNoMotionsWhereAnotherAlternativeHasThem) {
  constexpr const char* kProgram = "M3 S300\nG00 X60 Z4\nG75 X40 Z-10 I2 R1 Q3 F100\nM30\n";
  const std::string begin = traverse(2, R"("x":"30","z":"4")");
  const auto kind = [&](const std::string& trace, const char* reading) {
    return judge_trace(kProgram, begin + trace, {.reading = reading, .dialect = "hnc21t"}).kind;
  };
  const std::string garbage = traverse(3, R"("x":"-5","z":"-100")");
  EXPECT_EQ(kind(garbage, "hnc.g75.i=any"), VerdictKind::fail_geometry);
  EXPECT_EQ(kind("", "hnc.g75.i=any"), VerdictKind::fail_geometry);
  EXPECT_EQ(kind(alarm_said(3, "missing-word"), "hnc.g75.i=any"), VerdictKind::pass_exact);
  // Where the reading is known, there is no other alternative.
  EXPECT_EQ(kind(garbage, "hnc.g75.i=P"), VerdictKind::advice);
}

// R7: a spindle below zero is our alarm; a control that runs the block takes its F, and comes to
// the arc whose radius is too short.
TEST(Silence, ARunOnKeepsWhatElseTheBlockSays) {
  const std::string ran = R"({"k":"m","b":1,"m":3}
{"k":"rapid","b":2,"to":{"x":"0","y":"0","z":"0"}}
{"k":"feed","b":3,"to":{"x":"5"},"f":"100"}
)";
  const auto kind = [&](std::string_view alarm_class) {
    return judge_trace("M3 S-100 F100\nG0 X0 Y0 Z0\nG1 X5\nG2 X10 CR=1\nM30\n",
                       ran + R"({"k":"alarm","b":4,"class":")" + std::string(alarm_class) + "\"}\n",
                       {.m = true, .dialect = "sinumerik840d"})
        .kind;
  };
  EXPECT_EQ(kind("arc-radius"), VerdictKind::advice);
  EXPECT_EQ(decision(kind("syntax")), Decision::no_go);
}

// `alarm_timing`: a control that checks at load alarms with no motion at all.
TEST(Silence, ExcusesTheSameAtLoad) {
  const auto kind = [](const char* timing, std::uint64_t block, std::string_view alarm_class) {
    const auto profile = reference::profile_from_json(
        R"({"dialect":"sinumerik840d","alarm_timing":")" + std::string(timing) + "\"}");
    RunEnd end;
    end.kind = RunEnd::Kind::alarm;
    end.alarm.block = block;
    end.alarm.alarm_class = alarm_class;
    return judge_outcome(std::get<reference::Profile>(profile),
                         std::string_view("G0 X10\nG0 X20\nG1 X30 F100\nG0 X0\n"), Tolerances{},
                         std::span<const Record>(), end)
        .verdict.kind;
  };
  EXPECT_EQ(kind("program", 3, "spindle-stopped"), VerdictKind::advice);
  EXPECT_EQ(kind("program", 3, "syntax"), VerdictKind::fail_alarm_spurious);
  EXPECT_EQ(kind("program", 2, "spindle-stopped"), VerdictKind::fail_alarm_spurious);
  EXPECT_EQ(kind("program", 4, "spindle-stopped"), VerdictKind::fail_alarm_spurious);
  EXPECT_EQ(kind("block", 3, "spindle-stopped"), VerdictKind::fail_geometry);
}

}  // namespace
}  // namespace gonogo::oracle
