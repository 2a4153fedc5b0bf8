// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-CMP-12: a departure names a motion that the subject has sent, the one that went wrong, and not
// the one that shows it; and J-READ-01: it names the readings under which it is one.
#include <algorithm>

#include "milled_thread.hpp"
#include "own_outcome.hpp"

namespace gonogo::oracle {
namespace {

struct Told {
  std::string_view got;  // in the trace: the record of it is the one that is named
  std::string_view rule;
  std::string_view deviation;  // exact
  std::string_view message;
};

// The record is the line of the trace that holds `got`, which stands there once.
void expect_told(const Verdict& verdict, const std::string& trace, const Told& expected) {
  const std::size_t at = trace.find(expected.got);
  ASSERT_NE(at, std::string::npos) << trace;
  const auto record = static_cast<std::size_t>(
      std::count(trace.begin(), trace.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_EQ(verdict.record, record) << verdict.got;
  EXPECT_NE(verdict.got.find(expected.got), std::string::npos) << verdict.got;
  EXPECT_EQ(name(rule_of(verdict)), expected.rule);
  EXPECT_EQ(verdict.deviation_exact, expected.deviation);
  EXPECT_EQ(verdict.message, expected.message);
}

constexpr std::string_view kFiveTurns = "G00 X70 Z70 Y30\nG18\nG112 X70 Z70 Y20 I8 L5 D4 F200\n";

// GSK-G112-05: from Y30, 2 mm a turn, to Y20. Four of the five turns end at Y22, 2 mm too high.
TEST(ToldMotion, AHelixThatEndsAboveTheBottomIsNamedAndNotTheArcBehindIt) {
  TraceText trace(1, 200);
  trace.rapid({{'x', 35}, {'y', 30}, {'z', 70}}).block(3, 200);
  trace.arc("G18", {{'z', 72}, {'x', 35}}, -1, {{'z', 74}, {'x', 35}});
  trace.arc("G18", {{'z', 70}, {'x', 35}}, -4, {{'z', 74}, {'x', 35}, {'y', 22}});
  TraceText ends = trace;
  const Told helix = {"\"rot\":-4", "R2", "2", "The helix ends before the bottom of the pocket."};
  expect_told(judge_trace(kFiveTurns, ends.text()), ends.text(), helix);
  trace.arc("G18", {{'z', 72}, {'x', 35}}, -1, {{'z', 70}, {'x', 35}}).rapid({{'y', 30}});
  expect_told(judge_trace(kFiveTurns, trace.text()), trace.text(), helix);
}

// A hundredth of a millimetre in a hundred turns: a turn fewer leads to the same place.
TEST(ToldMotion, AHelixWithATurnFewerSaysHowManyCame) {
  TraceText trace(1, 200);
  trace.rapid({{'x', 20}, {'y', 30}, {'z', 10}}).block(2, 200);
  trace.rapid({{'x', 10}, {'y', 10}});
  trace.arc("G17", {{'x', 10}, {'y', 9}}, -1, {{'x', 10}, {'y', 8}});
  trace.arc("G17", {{'x', 10}, {'y', 10}}, -99, {{'x', 10}, {'y', 8}, {'z', 9.99}});
  trace.arc("G17", {{'x', 10}, {'y', 9}}, -1, {{'x', 10}, {'y', 10}}).rapid({{'z', 10}});
  const Verdict verdict =
      judge_trace("G17 G00 X40 Y30 Z10\nG112 X20 Y10 W-0.01 I6 L100 D4 F200\n", trace.text());
  expect_told(
      verdict, trace.text(),
      {"\"rot\":-99", "R2", "",
       "The helix ends beside the place that its whole turns lead to. It makes 99 of 100 turns."});
}

// Behind the five turns half an arc about their centre, and the way up.
TraceText half_a_flat_circle() {
  TraceText trace(1, 200);
  trace.rapid({{'x', 35}, {'y', 30}, {'z', 70}}).block(3, 200);
  trace.arc("G18", {{'z', 72}, {'x', 35}}, -1, {{'z', 74}, {'x', 35}});
  trace.arc("G18", {{'z', 70}, {'x', 35}}, -5, {{'z', 74}, {'x', 35}, {'y', 20}});
  trace.arc("G18", {{'z', 70}, {'x', 35}}, -1, {{'z', 66}, {'x', 35}}).rapid({{'y', 30}});
  return trace;
}

// Half a turn of the flat circle of radius 4 leads from Z74 to Z66, 8 mm from where
// the whole one ends.
TEST(ToldMotion, AFlatCircleThatEndsHalfWayIsNamed) {
  const TraceText trace = half_a_flat_circle();
  Judging judging;
  judging.reading = "gsk.helix.flat=on";
  const Verdict verdict = judge_trace(kFiveTurns, trace.text(), judging);
  expect_told(verdict, trace.text(),
              {"\"z\":\"66", "R2", "8", "The cut ends before it is where it has to end."});
}

// The manual's thread: from Y15, 5 mm a turn, to Y-5. Three of the four turns end at Y0.
TEST(ToldMotion, AHelixOfAThreadThatEndsEarlyIsNamed) {
  Thread thread;
  thread.radii = {17.5};
  thread.turns = 3;
  const std::string trace = thread.text();
  expect_told(judge(thread), trace,
              {"\"rot\":-3", "R8", "5", "The helix ends before the bottom of the thread."});
}

// A circle of radius 10 about the origin from X10, three times round.
constexpr std::string_view kThreeTurns = "G0 X10 S400 M3\nG2 I-10 TURN=2 F100\nG0 Z5\n";
std::string three_turns(int rot) {
  TraceText trace(1, 0);
  trace.rapid({{'x', 10}}).block(2, 100);
  trace.arc("G17", {{'x', 0}, {'y', 0}}, rot, {{'x', 10}, {'y', 0}});
  return trace.block(3, 0).rapid({{'z', 5}}).text();
}

TEST(ToldMotion, WholeTurnsThatAreMissingAreCounted) {
  const std::string trace = three_turns(-1);
  expect_told(judge_trace(kThreeTurns, trace, {.dialect = "sinumerik840d"}), trace,
              {"\"rot\":-1", "R2", "",
               "The cut ends before it is where it has to end. It makes 1 of 3 turns."});
}

TEST(ToldMotion, WholeTurnsTooManyAreCounted) {
  const Verdict verdict = judge_trace(kThreeTurns, three_turns(-5), {.dialect = "sinumerik840d"});
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry);
  EXPECT_EQ(verdict.message, "The arc goes beyond its end. It makes 5 turns in place of 3.");
}

// An arc of radius 5 over a chord of 0.001, no longer than the tolerance; the long one turns about
// Y10 in place of Y0.
TEST(ToldMotion, AMotionOfABlockWhoseOwnIsTooSmallToSeeIsHeldAgainstThat) {
  const std::string trace =
      R"({"k":"rapid","b":1,"to":{"x":"10","y":"5"}})"
      "\n"
      R"({"k":"arc","b":2,"plane":"G17","c":{"x":"10.0005","y":"10"},"rot":-1,)"
      R"("to":{"x":"10.001","y":"5"},"f":"100"})"
      "\n";
  for (const std::string_view behind : {"", "G4 F1\n"}) {
    const std::string program =
        "G0 X10 Y5 S400 M3\nG2 X10.001 Y5 CR=5 F100\n" + std::string(behind);
    const Verdict verdict = judge_trace(program, trace, {.dialect = "sinumerik840d"});
    EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
    EXPECT_EQ(name(rule_of(verdict)), "R2");
    EXPECT_EQ(reference::clause_name(verdict.clause), "SIE-ARC-04");
    EXPECT_NE(verdict.want.find("arc"), std::string::npos) << verdict.want;
    EXPECT_EQ(verdict.record, 1U);
  }
}

// GSK-G94-02: the first traverse goes to Y50.001 - 0.002, a micrometre off; with the other sign to
// Y50.003.
TEST(ToldMotion, OfSeveralThatAreTooSmallToSeeTheFirstOfItsKindIsDue) {
  TraceText trace(1);
  trace.rapid({{'x', 10}, {'y', 50}, {'z', 100}}).block(2, 120).rapid({{'y', 50.003}});
  trace.feed({{'y', 50.001}, {'z', 100}}).feed({{'y', 50}});
  const Verdict verdict =
      judge_trace("G19 G00 Y50 Z100 X20 F120\nG94 Y50.001 Z100 R-0.002\n", trace.text());
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_EQ(reference::clause_name(verdict.clause), "GSK-G94-02");
  EXPECT_EQ(verdict.record, 1U);
}

// The subject reads X and U as lengths, and leads 1 mm too far behind the pocket.
TEST(ToldReadings, ADepartureUnderAReadingThatExpandDoesNotShowNamesIt) {
  constexpr std::string_view kProgram =
      "G19 G00 Y5 Z8 X40\nG110 V7.5 W-15 U-9 R-3 I6 L3 Q2 P0.5 D4 F300\nG00 Y0\n";
  for (const std::string_view depth : {"radius", "diameter"}) {
    OwnOutcome own = own_outcome(kProgram, profile_of("gsk988ta", {{"gsk.x-depth", depth}}));
    const auto last = std::ranges::find(own.records.rbegin(), own.records.rend(), RecordKind::rapid,
                                        &Record::kind);
    ASSERT_NE(last, own.records.rend());
    last->to[reference::Axis::y] += 1;
    const reference::Profile open = profile_of("gsk988ta", {{"gsk.x-depth", "any"}});
    const Verdict verdict =
        judge_outcome(open, kProgram, exact_terms(open), own.records, own.end).verdict;
    EXPECT_EQ(decision(verdict.kind), Decision::no_go);
    EXPECT_EQ(verdict.block, 3U) << verdict.message;
    const bool is_shown = depth == "diameter";
    EXPECT_EQ(verdict.told_under, is_shown ? "" : "gsk.x-depth=radius");
    EXPECT_EQ(verdict.message.ends_with(" That is as gsk.x-depth=radius has it."), !is_shown)
        << verdict.message;
  }
}

// Behind the helix an arc about its centre is half of the flat circle of one alternative, and no
// semicircle of the other, which `expand` shows: both depart in the pocket.
TEST(ToldReadings, OfDeparturesThatComeEquallyFarThatOfThePathShownIsTold) {
  const TraceText trace = half_a_flat_circle();
  Judging judging;
  judging.reading = "gsk.helix.flat=any";
  const Verdict verdict = judge_trace(kFiveTurns, trace.text(), judging);
  EXPECT_EQ(verdict.told_under, "");
  EXPECT_EQ(verdict.record, 3U) << verdict.message;
  EXPECT_EQ(reference::clause_name(verdict.clause), "GSK-G112-06");
}

}  // namespace
}  // namespace gonogo::oracle
