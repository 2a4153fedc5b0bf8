// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a thread and a helical pocket may not do between their motions: rings, dives, other ways
// back. G18: p = Z, q = X, d = Y. One pass at 15 + 3 - 1 = 17 about Z0 X0 from Y15 to Y-5 in four
// turns; with K 0 the run-out goes straight out by J to 19.
#include <gtest/gtest.h>

#include "judging.hpp"
#include "own_outcome.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::string_view kThread =
    "G0 X70 Z70 Y20\nG18\nG114 X0 Z0 V-20 R-5 I5 J2 K0 E30 P1 D3 F900\nG0 X70\n";
constexpr std::string_view kHelixPocketWithM35 =
    "G0 X70 Z70 Y30\nG18\nG112 X70 Z70 Y20 I8 L5 D4 F200 M35\n";

TraceText to_the_start() {
  TraceText trace(1, 900);
  trace.rapid({{'x', 35}, {'y', 20}, {'z', 70}}).block(3, 900);
  trace.rapid({{'x', 0}, {'z', 0}}).rapid({{'y', 15}});
  trace.arc("G18", {{'x', 0}, {'z', 9}}, -1, {{'x', 0}, {'z', 18}}).feed({{'z', 17}});
  return trace;
}

TraceText& helix(TraceText& trace) {
  return trace.arc("G18", {{'x', 0}, {'z', 0}}, -4, {{'x', 0}, {'z', 17}, {'y', -5}});
}

TraceText to_the_run_out() {
  TraceText trace = to_the_start();
  helix(trace).feed({{'z', 19}});
  return trace;
}

Verdict home(TraceText trace) {
  trace.block(4, 900).rapid({{'x', 35}});
  return judge_trace(kThread, trace.text());
}

TEST(ThreadReturn, TheTraverseAlongTheDepthAxisIsGo) {
  EXPECT_EQ(
      decision(
          home(to_the_run_out().rapid({{'y', 15}}).rapid({{'z', 20}}).rapid({{'y', 20}})).kind),
      Decision::go);
}

// gsk.thread.path = arc: with a lead of 8, two and a half turns lead to the far side, and the path
// that is shown goes back to +p from there. Half of the infeed, one tolerance, is within the
// tolerance of its end.
TEST(ThreadReturn, AnInfeedOfTwoTolerancesMayComeInPieces) {
  for (const bool in_pieces : {false, true}) {
    TraceText trace(1, 900);
    trace.rapid({{'x', 35}, {'y', 20}, {'z', 70}}).block(3, 900);
    trace.rapid({{'x', 0}, {'z', 0}}).rapid({{'y', 15}});
    trace.arc("G18", {{'x', 0}, {'z', 9}}, -1, {{'x', 0}, {'z', 18}});
    if (in_pieces) trace.feed({{'z', 17.999}});
    trace.feed({{'z', 17.998}});
    trace.arc("G18", {{'x', 0}, {'z', 0}}, -3, {{'x', 0}, {'z', -17.998}, {'y', -5}});
    trace.rapid({{'y', 15}}).rapid({{'z', 18}}).rapid({{'y', 20}}).block(4, 900).rapid({{'x', 35}});
    const Verdict verdict =
        judge_trace("G0 X70 Z70 Y20\nG18\nG114 X0 Z0 V-20 R-5 I8 J0 E30 P0.002 D3 F900\nG0 X70\n",
                    trace.text());
    EXPECT_EQ(decision(verdict.kind), Decision::go) << in_pieces << verdict.message;
  }
}

// A quarter of a turn goes down by 1.25; the ring there would cut a groove.
TEST(ThreadReturn, ARingWithinTheHelixIsNoGo) {
  for (const bool ring : {false, true}) {
    TraceText trace = to_the_start();
    trace.arc("G18", {{'x', 0}, {'z', 0}}, -1, {{'x', -17}, {'z', 0}, {'y', 13.75}});
    if (ring) trace.arc("G18", {{'x', 0}, {'z', 0}}, -1, {{'x', -17}, {'z', 0}});
    helix(trace).feed({{'z', 19}}).rapid({{'y', 15}}).rapid({{'z', 20}}).rapid({{'y', 20}});
    const Verdict verdict = home(trace);
    EXPECT_EQ(decision(verdict.kind), ring ? Decision::no_go : Decision::go) << verdict.message;
  }
}

TEST(ThreadReturn, ADiveBelowTheBottomIsNoGo) {
  const Verdict verdict = home(to_the_run_out()
                                   .rapid({{'y', -40}})
                                   .rapid({{'y', 15}})
                                   .rapid({{'z', 20}})
                                   .rapid({{'y', 20}}));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry);
  EXPECT_EQ(reference::clause_name(verdict.clause), "GSK-G114-10");
}

// Under the path as arcs, with an infeed and a J of the size of the tolerance: the traverse to the
// safe position at 18.511 is too small to see, but the arc from there to 18.509 is not (a soak run
// found the false NO-GO, seed 767485). Two passes at 18.508 and 18.507, J 0.002.
TEST(ThreadReturn, AnArcIsFollowedFromWhereTheToolStands) {
  constexpr std::string_view kShallow =
      "G0 X70 Z70 Y20\nG18\nG114 X0 Z0 V-20 R-5 I5 J0.002 K0 E30 P0.002 Q0.001 D3.509 F900\n"
      "G0 X70\n";
  TraceText trace(1, 900);
  trace.rapid({{'x', 35}, {'y', 20}, {'z', 70}}).block(3, 900);
  trace.rapid({{'x', 0}, {'z', 0}}).rapid({{'y', 15}});
  trace.arc("G18", {{'x', 0}, {'z', 9.2545}}, -1, {{'x', 0}, {'z', 18.509}}).feed({{'z', 18.508}});
  trace.arc("G18", {{'x', 0}, {'z', 0}}, -4, {{'x', 0}, {'z', 18.508}, {'y', -5}});
  trace.feed({{'z', 18.51}}).rapid({{'y', 15}}).rapid({{'z', 18.511}});
  trace.arc("G18", {{'x', 0}, {'z', 18.51}}, -1, {{'x', 0}, {'z', 18.509}}).feed({{'z', 18.507}});
  trace.arc("G18", {{'x', 0}, {'z', 0}}, -4, {{'x', 0}, {'z', 18.507}, {'y', -5}});
  trace.feed({{'z', 18.509}}).rapid({{'y', 15}}).rapid({{'z', 18.511}}).rapid({{'y', 20}});
  trace.block(4, 900).rapid({{'x', 35}});
  const Verdict verdict = judge_trace(kShallow, trace.text(), "gsk.thread.path=arc");
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
}

// A bore of rho_0 = 30 - 3 = 27 and a pass at 28: straight inwards by 60 is the far wall, 4 mm deep
// in it (a soak run found the NO-GO, seed 20529932). Inwards by 30 is not.
TEST(ThreadReturn, ARunOutThatItsReadingLeadsIntoTheWallIsAGap) {
  const reference::Profile profile = profile_of("gsk988ta", {{"gsk.thread.runout", "radial"}});
  const std::string bore = "G0 X70 Z70 Y20\nG18\nG116 X0 Z0 V-20 R-5 I5 K0 E60 P1 D3 F900 ";
  EXPECT_EQ(judge_own(bore + "J60\n", profile).kind, VerdictKind::oracle_gap);
  EXPECT_EQ(judge_own(bore + "J30\n", profile).kind, VerdictKind::pass_properties);
}

TEST(ThreadReturn, AnotherWayToTheInitialPlaneIsNoGo) {
  const TraceText back = to_the_run_out().rapid({{'y', 15}}).rapid({{'z', 20}});
  TraceText diagonal = back;
  diagonal.feed({{'y', 20}, {'z', 50}});
  TraceText overshoot = back;
  overshoot.rapid({{'y', 500}}).rapid({{'y', 20}});
  const TraceText from_the_bottom = to_the_run_out().feed({{'y', 20}, {'z', 60}});
  for (const TraceText& trace : {diagonal, overshoot, from_the_bottom}) {
    EXPECT_EQ(decision(home(trace).kind), Decision::no_go) << trace.text();
  }
}

// Without block numbers the traverse home and the next block's are one motion to the judge.
TEST(ThreadReturn, WithoutBlockNumbersTheNextTraverseMayFollowTheReturn) {
  Judging judging;
  judging.blocks = false;
  TraceText trace = to_the_run_out();
  trace.rapid({{'y', 15}}).rapid({{'z', 20}}).rapid({{'y', 20}}).rapid({{'y', 100}});
  trace.rapid({{'x', 35}});
  const Verdict verdict = judge_trace(
      "G0 X70 Z70 Y20\nG18\nG114 X0 Z0 V-20 R-5 I5 J2 K0 E30 P1 D3 F900\n"
      "G0 Y100\nX70\n",
      trace.text(), judging);
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
}

// G112: semicircle of radius 2 out to Z74, five turns of radius 4 down to Y20, and back.
Decision with_clamp_at(int place) {
  TraceText trace(1, 200);
  auto clamp = [&](int here) {
    if (here == place) trace.line(R"({"k":"m","b":3,"m":35})");
  };
  trace.rapid({{'x', 35}, {'y', 30}, {'z', 70}}).block(3, 200);
  clamp(0);
  trace.rapid({{'x', 35}, {'z', 70}});
  clamp(1);
  trace.arc("G18", {{'x', 35}, {'z', 72}}, -1, {{'x', 35}, {'z', 74}});
  clamp(2);
  trace.arc("G18", {{'x', 35}, {'z', 70}}, -5, {{'x', 35}, {'z', 74}, {'y', 20}});
  trace.arc("G18", {{'x', 35}, {'z', 72}}, -1, {{'x', 35}, {'z', 70}}).rapid({{'y', 30}});
  clamp(3);
  Judging judging;
  judging.m = true;
  return decision(judge_trace(kHelixPocketWithM35, trace.text(), judging).kind);
}

TEST(HelixPocketJudge, TheClampHasToCloseBeforeTheToolCuts) {
  EXPECT_EQ(with_clamp_at(0), Decision::go);
  EXPECT_EQ(with_clamp_at(1), Decision::go);
  EXPECT_EQ(with_clamp_at(2), Decision::no_go);
  EXPECT_EQ(with_clamp_at(3), Decision::no_go);
}

TEST(HelixPocketJudge, ASixthCircleAtTheRPlaneIsNoGo) {
  TraceText trace(1, 200);
  trace.rapid({{'x', 35}, {'y', 30}, {'z', 70}}).block(3, 200);
  trace.arc("G18", {{'x', 35}, {'z', 72}}, -1, {{'x', 35}, {'z', 74}});
  trace.arc("G18", {{'x', 35}, {'z', 70}}, -1, {{'x', 35}, {'z', 74}});
  trace.arc("G18", {{'x', 35}, {'z', 70}}, -5, {{'x', 35}, {'z', 74}, {'y', 20}});
  trace.arc("G18", {{'x', 35}, {'z', 72}}, -1, {{'x', 35}, {'z', 70}}).rapid({{'y', 30}});
  EXPECT_EQ(decision(judge_trace(kHelixPocketWithM35, trace.text()).kind), Decision::no_go);
}

}  // namespace
}  // namespace gonogo::oracle
