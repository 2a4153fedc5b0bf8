// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each verdict names the rule of the relation that is broken, each gap its reason.
#include <gtest/gtest.h>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

Judging of_dialect(std::string_view dialect) {
  Judging judging;
  judging.dialect = dialect;
  return judging;
}

constexpr std::string_view kTurningPrograms = "G00 X130 Z5\nG01 Z-28 F100\n";

// The trace of kTurningPrograms with one thing wrong.
TEST(VerdictRule, IsThatOfPlaceLabelOrTraverse) {
  const auto rule = [](const TraceText& trace) {
    return rule_of(judge_trace(kTurningPrograms, trace.text()));
  };
  TraceText right(1);
  right.rapid({{'x', 65}, {'z', 5}}).block(2, 100).feed({{'z', -28}});
  EXPECT_EQ(rule(right), RelationRule::none);
  TraceText place(1);
  place.rapid({{'x', 65}, {'z', 5}}).block(2, 100).feed({{'z', -28}, {'x', 66}});
  EXPECT_EQ(rule(place), RelationRule::place);
  TraceText traverse(1);
  traverse.rapid({{'x', 65}, {'z', 4.9}}).block(2, 100).feed({{'z', -28}});
  EXPECT_EQ(rule(traverse), RelationRule::traverse);
  TraceText feed(1);
  feed.rapid({{'x', 65}, {'z', 5}}).block(2, 101).feed({{'z', -28}});
  EXPECT_EQ(rule(feed), RelationRule::label);
  TraceText kind(1);
  kind.rapid({{'x', 65}, {'z', 5}}).block(2, 100).rapid({{'z', -28}});
  EXPECT_EQ(rule(kind), RelationRule::label);
}

// R5: an M function is an event without length, and so is the end. R6: an alarm comes when all that
// is due before it has come.
TEST(VerdictRule, OfWhatIsMissingIsThatOfTheEventThatComesInstead) {
  Judging judging;
  judging.m = true;
  TraceText no_m(1);
  no_m.rapid({{'x', 65}, {'z', 5}}).block(3, 100).feed({{'z', -28}});
  const Verdict missing = judge_trace("G00 X130 Z5\nM3\nG01 Z-28 F100\n", no_m.text(), judging);
  EXPECT_EQ(missing.kind, VerdictKind::fail_geometry) << missing.message;
  EXPECT_EQ(rule_of(missing), RelationRule::event);
  TraceText ends(1);
  ends.rapid({{'x', 65}, {'z', 5}});
  const Verdict early = judge_trace(kTurningPrograms, ends.text());
  EXPECT_EQ(early.kind, VerdictKind::fail_geometry) << early.message;
  EXPECT_EQ(rule_of(early), RelationRule::event);
  const Verdict alarm = judge_trace("G1 X1 F100\nG0 X1 X2\n",
                                    R"({"k":"alarm","class":"duplicate-word","b":2})"
                                    "\n",
                                    of_dialect("rs274"));
  EXPECT_EQ(alarm.kind, VerdictKind::fail_geometry) << alarm.message;
  EXPECT_EQ(rule_of(alarm), RelationRule::alarm);
}

// R8: only where a helical pocket begins on its circle is open; R1 to R5 decide the rest. Centre
// Z70 X35, R plane Y30, a semicircle to Z74 and five turns down to Y20; or another feed of the
// entry.
TEST(VerdictRule, OfAHelicalPocketIsThatOfItsMotions) {
  const auto rule = [](double feed, double bottom) {
    TraceText trace(1);
    trace.rapid({{'x', 35}, {'y', 30}, {'z', 70}}).block(3, feed);
    trace.arc("G18", {{'z', 72}, {'x', 35}}, -1, {{'z', 74}, {'x', 35}});
    trace.arc("G18", {{'z', 70}, {'x', 35}}, -5, {{'z', 74}, {'x', 35}, {'y', bottom}});
    trace.arc("G18", {{'z', 72}, {'x', 35}}, -1, {{'z', 70}, {'x', 35}}).rapid({{'y', 30}});
    return name(rule_of(
        judge_trace("G00 X70 Z70 Y30\nG18\nG112 X70 Z70 Y20 I8 L5 D4 F200\n", trace.text())));
  };
  EXPECT_EQ(rule(200, 20), "");
  EXPECT_EQ(rule(200, 20.5), "R2");
  EXPECT_EQ(rule(300, 20), "R3");
}

TEST(VerdictRule, OfARuleWithoutAnotherNameIsThatOfTheKind) {
  const auto rule = [](VerdictKind kind) {
    Verdict verdict;
    verdict.kind = kind;
    return name(rule_of(verdict));
  };
  EXPECT_EQ(rule(VerdictKind::fail_geometry), "R2");
  EXPECT_EQ(rule(VerdictKind::fail_feed), "R3");
  EXPECT_EQ(rule(VerdictKind::fail_order), "R5");
  EXPECT_EQ(rule(VerdictKind::fail_region), "R8");
  EXPECT_EQ(rule(VerdictKind::advice), "R7");
  for (const VerdictKind kind :
       {VerdictKind::fail_alarm_missing, VerdictKind::fail_alarm_spurious,
        VerdictKind::fail_alarm_class, VerdictKind::fail_alarm_late, VerdictKind::unmapped_alarm}) {
    EXPECT_EQ(rule(kind), "R6");
  }
  for (const VerdictKind kind : {VerdictKind::pass_exact, VerdictKind::crash, VerdictKind::protocol,
                                 VerdictKind::fail_reading, VerdictKind::oracle_gap}) {
    EXPECT_EQ(rule(kind), "");
  }
}

// GSK-G110: a level with another feed breaks a condition of the free step, R8, and no label of a
// path that is given.
TEST(VerdictRule, OfAFreeStepIsItsConditionWithItsClause) {
  TraceText trace(1);
  trace.rapid({{'x', 20}, {'y', 30}, {'z', 10}}).block(2, 200);
  trace.rapid({{'x', 10}, {'y', 10}}).rapid({{'z', 9}}).feed({{'z', 7}});
  trace.block(2, 300).feed({{'x', 11}});
  const Verdict verdict =
      judge_trace("G17 G00 X40 Y30 Z10\nG110 X20 Y10 W-2 R-1 I6 L4 Q2 D4 F200\n", trace.text());
  EXPECT_EQ(verdict.kind, VerdictKind::fail_feed) << verdict.message;
  EXPECT_EQ(rule_of(verdict), RelationRule::free_step);
  EXPECT_NE(verdict.clause, reference::kNoClause);
}

TEST(GapReasons, TellWhatIsNotReadFromWhatTheProfileLacks) {
  const auto reason = [](std::string_view program) {
    return judge_trace(program, "", of_dialect("rs274")).gap;
  };
  EXPECT_EQ(reason("G21 G90 G94\nG41 D1 G1 X60 F100\n"), GapReason::not_covered);
  EXPECT_EQ(reason("G21 G90 G94\nG43 H7\nG0 X1\n"), GapReason::profile_lacks);
}

}  // namespace
}  // namespace gonogo::oracle
