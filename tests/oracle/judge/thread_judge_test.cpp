// SPDX-License-Identifier: GPL-3.0-or-later
//
// The thread judge on the manual's own examples.
#include <algorithm>
#include <functional>

#include "milled_thread.hpp"
#include "own_outcome.hpp"

namespace gonogo::oracle {
namespace {

TEST(ThreadJudge, TheManualsExternalThreadWithThePolarRunOutIsGo) {
  expect_go(Thread{});
  expect_go(Thread{}, {.reading = "gsk.thread.runout=polar"});
}

TEST(ThreadJudge, TheManualsInternalThreadWithThePolarRunOutIsGo) {
  expect_go(internal());
  expect_go(internal(), {.reading = "gsk.thread.runout=polar"});
}

TEST(ThreadJudge, ThePolarRunOutMayBeStraightWhereItKeepsOffThePass) {
  // Internal: the chord between two points of a disc lies in it.
  Thread thread = internal();
  thread.run_out = Thread::RunOut::line;
  expect_go(thread, {.reading = "gsk.thread.runout=polar"});
  // External: it cuts into the circle of the pass. 17.5 and 19.5 over 30 degrees: the chord comes
  // as near as 17.2 to the axis.
  thread = Thread{};
  thread.run_out = Thread::RunOut::line;
  expect_no_go(thread, "GSK-G114-10", "deeper than its pass");
}

// Of the last pass of gsk.g116.000029. From (0, 6.5) off the axis the way along p to 5.5 leads
// through the wall, 7 off it, as it does on the named path alone.
TEST(ThreadJudge, InABoreTheRunOutOfTheNamedPathTurnsWithTheHelix) {
  constexpr std::string_view kProgram =
      "G17 G00 X8 Y6 Z20\nG117 X15.5 V-11 W-4.5 R-3 I1.5 J1.5 K90 E20 P1 Q0.4 D3 F300\n";
  reference::Profile profile = profile_of("gsk988ta");
  profile.x_diameter = false;
  OwnOutcome own = own_outcome(kProgram, profile);
  const auto judged = [&] {
    return decision(
        judge_outcome(profile, kProgram, exact_terms(profile), own.records, own.end).verdict.kind);
  };
  EXPECT_EQ(judged(), Decision::go);
  const auto last =
      std::ranges::find(own.records.rbegin(), own.records.rend(), RecordKind::arc, &Record::kind);
  ASSERT_NE(last, own.records.rend());
  last->rot = -last->rot;
  EXPECT_EQ(judged(), Decision::no_go);
}

TEST(ThreadJudge, ARadialRunOutThatClearsTheThreadIsGo) {
  // 2 cos 30 = 1.73 along the normal, more than t_2 = 1.
  Thread thread;
  thread.run_out = Thread::RunOut::radial;
  expect_go(thread);
  expect_go(thread, {.reading = "gsk.thread.runout=radial"});
  expect_no_go(thread, "GSK-G114-11", "another point", {.reading = "gsk.thread.runout=polar"});
}

TEST(ThreadJudge, ATangentRunOutThatClearsTheThreadIsGo) {
  // 2 sin 30 = 1 and 2 cos 30 = 1.73 along the tangent: radius sqrt(18^2 + 1.73^2) = 18.08 > 18.
  Thread thread;
  thread.run_out = Thread::RunOut::tangent;
  expect_go(thread);
  expect_go(thread, {.reading = "gsk.thread.runout=tangent"});
}

// J-THR-05.
TEST(ThreadJudge, TheTangentRunOutOfTheManualsInternalThreadGougesByItself) {
  // Pass 1 ends at (4, 1.73) from the axis: radius 4.36 < 4.5 is free. Pass 2 ends at (4.5, 1.73):
  // radius 4.82 > 4.5, so that the traverse up touches the thread.
  Thread thread = internal();
  thread.run_out = Thread::RunOut::tangent;
  EXPECT_EQ(judge(thread, {.reading = "gsk.thread.runout=tangent"}).kind, VerdictKind::oracle_gap);
  // The polar one keeps off.
  expect_no_go(thread, "GSK-G114-10", "through the part", {.reading = "gsk.thread.runout=any"});
}

// 18 + 2 from the axis, and 6 of a tool's diameter beside it; on the side where the run-out ends.
TEST(ThreadJudge, TheSafePositionMayLieFartherOut) {
  for (double safe : {20.0, 23.5, 26.0}) {
    Thread thread;
    thread.safe = safe;
    expect_go(thread);
    thread.start_degrees = 180;
    thread.safe = -safe;
    expect_go(thread);
  }
}

// rho_0 - J = 2.5.
TEST(ThreadJudge, TheSafePositionInABoreMayLieOnEitherSide) {
  for (double safe : {2.5, -2.5, 0.0, 1.25}) {
    Thread thread = internal();
    thread.safe = safe;
    expect_go(thread);
  }
}

// 9.75 from the axis along q: at 17 along p the tool stands 19.6 from it, at 3 from it in a bore.
TEST(ThreadJudge, ASafePositionTooNearToThePartIsNoGo) {
  Thread thread;
  thread.safe = 17;
  expect_no_go(thread, "GSK-G114-10", "safe position");
  thread = internal();
  thread.safe = 2.6;
  expect_no_go(thread, "GSK-G114-10", "safe position");
}

TEST(ThreadJudge, AHelixInPartsIsTheSameHelix) {
  for (int pieces : {2, 3, 4, 16, 400}) {
    Thread thread;
    thread.pieces = pieces;
    expect_go(thread);
  }
}

TEST(ThreadJudge, TheHelixMayStartAtAnotherAngle) {
  for (double degrees : {45.0, 90.0, 123.4, 270.0}) {
    Thread thread;
    thread.start_degrees = degrees;
    thread.near_side = true;
    expect_go(thread);
    thread = internal();
    thread.start_degrees = degrees;
    thread.safe = 0;
    thread.pieces = 7;
    expect_go(thread, {.reading = "gsk.thread.runout=polar"});
  }
}

// Every end and centre rounded to the increment, which is the tolerance: helices of 3.6 turns,
// whose ends are off by the rounding of both ends.
TEST(ThreadJudge, RoundedPointsAreGoAtAnyAngle) {
  constexpr std::string_view kPartial =
      "G0 X70 Z70 Y20\nG18\nG114 X0 Z0 V-18 R-5 I5 J2 K30 E30 P1 Q0.5 D3 F900\nG0 X70\n";
  for (int i = 0; i < 360; ++i) {
    Thread thread;
    thread.decimals = 3;
    thread.start_degrees = i + 0.37;
    thread.near_side = true;
    thread.bottom = -3;
    thread.turns = 3.6;
    thread.pieces = i % 3 + 1;
    const Verdict verdict = judge_trace(kPartial, thread.text(), "gsk.thread.runout=polar");
    ASSERT_EQ(decision(verdict.kind), Decision::go)
        << thread.start_degrees << " " << verdict.message << verdict.got << verdict.deviation_mm;
  }
}

// What `expand` shows is one of the admissible paths, with its numbers as they are.
TEST(ThreadJudge, ThePathThatExpandShowsIsGo) {
  for (const char* block : {"G114 X0 Z0 V-20 R-5 I5 J2 K30 E30 P1 Q0.5 D3 F900",
                            "G115 X0 Z0 V-18 R-5 I5 J2 K30 E30 P1 D3 F900",
                            "G116 X70 Z70 V-20 R-5 I5 J2 K30 E15 P1 Q0.5 D3 F900",
                            "G117 X70 Z70 V-17.3 R-5 I1.7 J2 K41 E15 P1 Q0.3 D3 F900",
                            "G114 X0 Z0 V-20 I5 J0 E30 P1 Q0.5 D3 F900",
                            "G17 G114 X0 Y0 Z-3 R-1 I2 J3 K45 E9 P2 D3 F9"}) {
    for (const char* reading : {"gsk.thread.runout=any", "gsk.thread.runout=polar",
                                "gsk.thread.runout=radial", "gsk.thread.path=arc"}) {
      reference::Profile profile;
      const std::string_view text = reading;
      set_reading(profile, text.substr(0, text.find('=')), text.substr(text.find('=') + 1));
      const std::string program =
          "G0 X70 Z70 Y30\nG18\n" + std::string(block) + "\nG0 X80 W5\nG50 Z0\nG0 Z3\n";
      ProgramInput input(program);
      reference::Expander expander(profile, input.lines, reference::OpenPaths::shown);
      std::vector<Record> records;
      while (const reference::Item* item = expander.next()) {
        if (auto* record = std::get_if<Record>(item)) records.push_back(*record);
      }
      SubjectInfo subject;
      subject.features = {"blocks"};
      const Tolerances tolerances = make_tolerances(subject, profile);
      const Verdict verdict =
          judge_outcome(profile, program, tolerances, records, RunEnd{}).verdict;
      EXPECT_EQ(decision(verdict.kind), Decision::go)
          << block << reading << verdict.message << "\nwant " << verdict.want << "\ngot "
          << verdict.got << verdict.witness;
    }
  }
}

TEST(ThreadJudge, TheToolMayNotReturnStraightToTheInitialPlane) {
  Thread thread;
  thread.way_back = Thread::Return::to_initial;
  expect_no_go(thread, "GSK-G114-10", "safe position");
}

TEST(ThreadJudge, WithoutBlockNumbersTheTraverseToTheInitialPlaneEndsTheThread) {
  expect_go(Thread{}, {.blocks = false});
}

TEST(ThreadJudge, WithoutBlockNumbersAnInitialPlaneAtTheRPlaneIsAGap) {
  const std::string program =
      "G0 X70 Z70 Y15\nG18\nG114 X0 Z0 V-20 I5 J2 K30 E30 P1 Q0.5 D3 F900\nG0 X70\n";
  Thread thread;
  thread.initial = 15;
  thread.safe = 21;
  EXPECT_EQ(judge_trace(program, thread.text(), Judging{.blocks = false}).kind,
            VerdictKind::oracle_gap);
  EXPECT_EQ(judge_trace(program, thread.text()).kind, VerdictKind::pass_properties);
  // That of the reading ends at 18 + 2.
  thread.safe = 20;
  EXPECT_EQ(judge_trace(program, thread.text(), Judging{.blocks = false}).kind,
            VerdictKind::pass_properties);
}

// J-THR-09. The path that is named ends at 18 + 2 = 20 along Z: the traverse of the next block,
// Z30, may be told in one with the last of the thread, but no way to another place.
TEST(ThreadJudge, WithoutBlockNumbersTheNextTraverseMayGoOnFromTheNamedEnd) {
  const auto verdict = [](const std::string& next, double to) {
    const std::string program =
        "G0 X70 Z70 Y15\nG18\nG114 X0 Z0 V-20 I5 J2 K30 E30 P1 D3 F900\nG0 " + next + "\n";
    TraceText trace(1, 900);
    trace.rapid({{'x', 35}, {'z', 70}, {'y', 15}}).block(3, 900).rapid({{'x', 0}, {'z', 0}});
    trace.arc("G18", {{'z', 9}, {'x', 0}}, -1, {{'z', 18}, {'x', 0}}).feed({{'z', 17}});
    const Thread thread;
    thread.helix(trace, 17);
    thread.leave(trace, 17);
    trace.rapid({{'y', 15}}).rapid({{'z', to}});
    return judge_trace(program, trace.text(),
                       Judging{.reading = "gsk.thread.path=arc", .blocks = false});
  };
  EXPECT_EQ(verdict("Z30", 30).kind, VerdictKind::pass_properties) << verdict("Z30", 30).message;
  EXPECT_EQ(decision(verdict("Z30", 29).kind), Decision::no_go);
  EXPECT_EQ(decision(verdict("X70", 30).kind), Decision::no_go);
}

TEST(ThreadJudge, TheDiameterTakenAsARadiusIsNoGo) {
  // 30 + 3 - 0.5 = 32.5.
  Thread thread;
  thread.radii = {32.5, 32};
  expect_no_go(thread, "GSK-G114-06", "another radius");
  EXPECT_EQ(judge(thread).deviation_mm, "15");
}

TEST(ThreadJudge, ALastPassThatIsTooDeepIsNoGo) {
  Thread thread;
  thread.radii = {17.5, 16.9};
  expect_no_go(thread, "GSK-G114-04", "deeper than the thread");
  EXPECT_EQ(judge(thread).deviation_mm, "0.1");
}

// J-THR-04.
TEST(ThreadJudge, ALeadOnePercentOffIsNoGo) {
  for (int pieces : {1, 4, 16}) {
    Thread thread;
    thread.pieces = pieces;
    thread.lead = 5.05;
    expect_no_go(thread, "GSK-G114-06", "lead");
    thread.turns = 20 / 5.05;
    expect_no_go(thread, "GSK-G114-06", "lead");
  }
}

TEST(ThreadJudge, OneTurnShortIsNoGo) {
  Thread thread;
  thread.turns = 3;
  expect_no_go(thread, "GSK-G114-06", "before the bottom");
  thread.lead = 20.0 / 3;
  expect_no_go(thread, "GSK-G114-06", "number of turns");
}

TEST(ThreadJudge, TheOppositeSenseIsNoGo) {
  Thread thread;
  thread.sense = 1;
  expect_no_go(thread, "GSK-G114-09", "wrong way");
}

TEST(ThreadJudge, NotReturningToTheRPlaneBetweenPassesIsNoGo) {
  Thread thread;
  thread.way_back = Thread::Return::none;
  EXPECT_EQ(decision(judge(thread).kind), Decision::no_go);
  EXPECT_EQ(reference::clause_name(judge(thread).clause), "GSK-G114-10");
}

TEST(ThreadJudge, ARunOutIntoTheWallIsNoGo) {
  Thread thread;
  thread.run_out_radius = -0.5;
  expect_no_go(thread, "GSK-G114-10", "deeper than its pass");
  thread = internal();
  thread.run_out_radius = -0.5;
  expect_no_go(thread, "GSK-G114-10", "deeper than its pass");
}

TEST(ThreadJudge, ATraverseThroughThePartIsNoGo) {
  // From the run-out on one side to the safe position on the other: the box holds the part.
  Thread thread;
  thread.way_back = Thread::Return::tilted;
  thread.safe = -20;
  expect_no_go(thread, "GSK-G114-10", "along the depth axis alone");
}

TEST(ThreadJudge, AWrongFeedIsAFeedFailure) {
  Thread thread;
  thread.feed = 899;
  const Verdict verdict = judge(thread);
  EXPECT_EQ(verdict.kind, VerdictKind::fail_feed);
  EXPECT_EQ(reference::clause_name(verdict.clause), "GSK-G114-08");
}

TEST(ThreadJudge, AMissingPassIsNoGo) {
  Thread thread;
  thread.radii = {17};
  expect_no_go(thread, "GSK-G114-04", "missing");
  thread.radii = {17.5};
  expect_no_go(thread, "GSK-G114-04", "missing");
}

TEST(ThreadJudge, APassTooManyIsNoGo) {
  Thread thread;
  thread.radii = {17.5, 17.5, 17};
  expect_no_go(thread, "GSK-G114-04", "again");
  thread.radii = {17.5, 17, 17};
  expect_no_go(thread, "GSK-G114-04", "again");
}

// J-THR-01. The arc from 17 to 19 over 30 degrees has a radius of 83. A third of it is a chord of
// 3.2, with a sagitta of 3.2^2 / (8 * 83) = 0.015, and slopes by 1.6 / 83 = 0.019 into the pass,
// 17 * 0.019^2 / 2 = 0.003 deep.
TEST(ThreadJudge, AChordOfTheRunOutMayCutDeeperByWhatIsGranted) {
  Thread thread;
  thread.run_out = Thread::RunOut::three_chords;
  expect_go(thread, {.chord = "0.02"});
  expect_no_go(thread, "GSK-G114-10", "deeper than its pass");
  expect_no_go(thread, "GSK-G114-10", "deeper than its pass", {.chord = "0.001"});
}

TEST(ThreadJudge, ChordsAreGoWhenTheCertifierGrantsThem) {
  // 100 chords a turn: sagitta 17.5 (1 - cos 1.8 degrees) = 0.0086.
  auto trace = [](double tolerance_of_end) {
    TraceText text(1, 900);
    text.rapid({{'x', 35}, {'z', 70}, {'y', 20}}).block(3, 900);
    text.rapid({{'x', 0}, {'z', 0}}).rapid({{'y', 15}});
    const Thread thread;
    Thread::Point from{0, 0};
    for (double radius : thread.radii) {
      thread.enter(text, from);
      thread.infeed(text, radius);
      for (int i = 1; i <= 400; ++i) {
        const Thread::Point to = thread.at(radius, -3.6 * i);
        const double end = i == 400 ? tolerance_of_end : 0;
        text.feed({{'z', to.z}, {'x', to.x}, {'y', 15 - i * 0.05 - end}});
      }
      from = thread.leave(text, radius);
      from.z = 20;
      text.rapid({{'y', 15}}).rapid({{'z', 20}});
    }
    text.rapid({{'y', 20}}).block(4, 900).rapid({{'x', 35}});
    return text.text();
  };
  const Judging granted{.chord = "0.01"};
  const Verdict verdict = judge_trace(kExternal, trace(0), granted);
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message << verdict.got;
  EXPECT_EQ(decision(judge_trace(kExternal, trace(0)).kind), Decision::no_go);
  EXPECT_EQ(decision(judge_trace(kExternal, trace(0.02), granted).kind), Decision::no_go);
}

TEST(ThreadJudge, BlocksAfterTheThreadStartWhereTheSubjectLeftIt) {
  // A safe position of its own at Z25: the increment W10 after it leads to Z35.
  const std::string program =
      "G0 X70 Z70 Y20\nG18\nG114 X0 Z0 V-20 R-5 I5 J2 K30 E30 P1 Q0.5 D3 F900\nG0 W10\n";
  auto trace = [](double z) {
    Thread thread;
    thread.safe = 25;
    std::string text = thread.text();
    text.erase(text.rfind("{\"k\":\"rapid\",\"b\":4"));
    return text + TraceText(4).rapid({{'z', z}}).text();
  };
  EXPECT_EQ(decision(judge_trace(program, trace(35)).kind), Decision::go);
  EXPECT_EQ(decision(judge_trace(program, trace(30)).kind), Decision::no_go);
}

TEST(ThreadJudge, ARenamingAfterTheThreadHoldsForBothSides) {
  const std::string program =
      "G0 X70 Z70 Y15\nG18\nG114 X0 Z0 V-20 I5 J2 K30 E30 P1 Q0.5 D3 F900\nG50 Z0\nG0 Z10\n";
  Thread thread;
  thread.initial = 15;
  std::string text = thread.text();
  text.erase(text.rfind("{\"k\":\"rapid\",\"b\":4"));
  const Verdict verdict = judge_trace(program, text + TraceText(5).rapid({{'z', 10}}).text());
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
}

TEST(ThreadJudge, TheNamedPathIsGoOnlyAsItIsNamed) {
  // The semicircle to Z18, along Z to the pass, and back along Z to 18 + 2 = 20.
  auto trace = [](bool semicircle) {
    TraceText text(1, 900);
    text.rapid({{'x', 35}, {'z', 70}, {'y', 20}}).block(3, 900);
    text.rapid({{'x', 0}, {'z', 0}}).rapid({{'y', 15}});
    const Thread thread;
    Thread::Point from{0, 0};
    for (double radius : thread.radii) {
      if (semicircle) {
        text.arc("G18", {{'z', (from.z + 18) / 2}, {'x', from.x / 2}}, -1, {{'z', 18}, {'x', 0}});
      } else {
        text.feed({{'z', 18}, {'x', 0}});
      }
      text.feed({{'z', radius}});
      thread.helix(text, radius);
      const Thread::Point end = thread.leave(text, radius);
      text.rapid({{'y', 15}}).rapid({{'z', 20}});
      from = {20, end.x};
    }
    text.rapid({{'y', 20}}).block(4, 900).rapid({{'x', 35}});
    return text.text();
  };
  const std::string named = "gsk.thread.path=arc";
  const Verdict verdict = judge_trace(kExternal, trace(true), named);
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message << verdict.got;
  EXPECT_EQ(decision(judge_trace(kExternal, trace(false), named).kind), Decision::no_go);
  // From the other side.
  Thread other;
  other.start_degrees = 180;
  other.safe = -20;
  EXPECT_EQ(decision(judge_trace(kExternal, other.text()).kind), Decision::go);
  EXPECT_EQ(decision(judge_trace(kExternal, other.text(), named).kind), Decision::no_go);
}

}  // namespace
}  // namespace gonogo::oracle
