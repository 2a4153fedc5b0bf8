// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far the steps of a thread may lead that no text bounds (J-THR-02 to J-THR-06): in every
// plane, of bolts and bores, of both hands. One pass of four turns with the lead 5 about the origin
// from 15 to -5. Bolt: rho_0 = 15 + 3 = 18, pass at 17; bore: rho_0 = 7.5 - 3 = 4.5, pass at 5.5.
// With J 2 and K 30 the polar run-out ends at 19 from the axis, or 3.5, over 30 degrees:
// p 19 cos 30 = 16.454483 and q 9.5, or p 3.031089 and q 1.75, on the side to which the hand turns.
// Its arc leaves tangentially about p -65.992404, or 3.645332 (GSK-G114-11).
#include <functional>
#include <numbers>

#include "milled_thread.hpp"

namespace gonogo::oracle {
namespace {

// Where and how the thread stands.
struct Frame {
  bool external = true;
  int sense = -1;
  std::string_view plane = "G18";
  char p = 'z';
  char q = 'x';
  char d = 'y';

  std::string program() const {
    const int code = (external ? 114 : 116) + (sense < 0 ? 0 : 1);
    // X is a diameter.
    std::string start = "G0 X70 Z70 Y20\n";
    std::string place = "X0 Z0 V-20";
    if (plane == "G17") start = "G0 X70 Y70 Z20\n", place = "X0 Y0 W-20";
    if (plane == "G19") start = "G0 X40 Y70 Z70\n", place = "Y0 Z0 U-40";
    return start + std::string(plane) + "\nG" + std::to_string(code) + " " + place +
           " R-5 I5 J2 K30 P1 D3 F900 E" + (external ? "30" : "15") + "\nM30\n";
  }
};

std::vector<Frame> all_frames() {
  std::vector<Frame> frames;
  for (const bool external : {true, false}) {
    for (const int sense : {-1, 1}) {
      frames.push_back({external, sense, "G17", 'x', 'y', 'z'});
      frames.push_back({external, sense, "G18", 'z', 'x', 'y'});
      frames.push_back({external, sense, "G19", 'y', 'z', 'x'});
    }
  }
  return frames;
}

// The motions of a pass in the frame; `q` counts to the side that the hand turns to.
struct Mill {
  const Frame& frame;
  TraceText& trace;

  void feed(double p, double q, double d) {
    trace.feed({{frame.p, p}, {frame.q, frame.sense * q}, {frame.d, d}});
  }
  void rapid(double p, double q, double d) {
    trace.rapid({{frame.p, p}, {frame.q, frame.sense * q}, {frame.d, d}});
  }
  // `turns`: positive with the hand of the thread.
  void arc(double centre_p, double centre_q, int turns, double p, double q, double d) {
    trace.arc(frame.plane, {{frame.p, centre_p}, {frame.q, frame.sense * centre_q}},
              turns * frame.sense, {{frame.p, p}, {frame.q, frame.sense * q}, {frame.d, d}});
  }
};

using Step = std::function<void(Mill)>;

// The path that `expand` shows; the parts are what the tests change.
struct Pass {
  Step entry = [](Mill m) {
    const double start = m.frame.external ? 18 : 4.5;
    m.arc(start / 2, 0, 1, start, 0, 15);
  };
  Step infeed = [](Mill m) { m.feed(m.frame.external ? 17 : 5.5, 0, 15); };
  Step helix = [](Mill m) { m.arc(0, 0, 4, m.frame.external ? 17 : 5.5, 0, -5); };
  Step run_out = [](Mill m) { polar_to(m, -5); };
  Step way_back = [](Mill m) {
    m.rapid(m.frame.external ? 16.454482672 : 3.031088913, m.frame.external ? 9.5 : 1.75, 15);
  };
  Step away = [](Mill m) { away_to(m, m.frame.external ? 20 : 2.5); };

  static void polar_to(Mill m, double height) {
    if (m.frame.external) {
      m.arc(-65.992404175, 0, 1, 16.454482672, 9.5, height);
    } else {
      m.arc(3.645331761, 0, 1, 3.031088913, 1.75, height);
    }
  }
  static void away_to(Mill m, double p) { m.rapid(p, m.frame.external ? 9.5 : 1.75, 15); }

  Verdict judged(const Frame& frame, bool blocks) const {
    TraceText trace(1, 900);
    const double x = frame.plane == "G19" ? 20 : 35;
    trace.rapid({{'x', x},
                 {'y', frame.plane == "G18" ? 20.0 : 70.0},
                 {'z', frame.plane == "G17" ? 20.0 : 70.0}});
    trace.block(3, 900);
    const Mill mill{frame, trace};
    trace.rapid({{frame.p, 0}, {frame.q, 0}}).rapid({{frame.d, 15}});
    for (const Step* step : {&entry, &infeed, &helix, &run_out, &way_back, &away}) (*step)(mill);
    trace.rapid({{frame.d, 20}});
    return judge_trace(frame.program(), trace.text(), Judging{.blocks = blocks});
  }

  void is(const Frame& frame, Decision wanted, std::string_view says = "") const {
    for (const bool blocks : {true, false}) {
      const Verdict verdict = judged(frame, blocks);
      EXPECT_EQ(decision(verdict.kind), wanted)
          << frame.program() << verdict.message << "\ngot " << verdict.got;
      EXPECT_NE(verdict.message.find(says), std::string::npos) << verdict.message;
    }
  }
};

void everywhere(bool external, const Pass& pass, Decision wanted, std::string_view says = "") {
  for (const Frame& frame : all_frames()) {
    if (frame.external == external) pass.is(frame, wanted, says);
  }
}

TEST(ThreadEnvelope, ThePathThatExpandShowsIsGoInEveryPlaneAndOfEitherHand) {
  for (const bool external : {true, false}) everywhere(external, {}, Decision::go);
}

// J-THR-02. rho_0 + J = 20, and 6 mm of a tool's diameter: the infeed begins no farther out than
// 26.
TEST(ThreadEnvelope, AnEntryOrInfeedFarFromTheBoltIsNoGo) {
  const auto from = [](double far) {
    Pass pass;
    pass.entry = [far](Mill m) { m.arc(far / 2, 0, 1, far, 0, 15); };
    return pass;
  };
  everywhere(true, from(26), Decision::go);
  for (const double far : {26.01, 100.0, 10'000.0}) {
    everywhere(true, from(far), Decision::no_go, "farther from the part");
  }
}

// From the axis to (18, 0) round most of a circle that is cut by its chord of 18 at the distance
// `beside` from its centre: it reaches beside + sqrt(81 + beside^2) aside of the chord.
TEST(ThreadEnvelope, AnEntryRoundALargeCircleIsNoGo) {
  const auto round = [](double beside) {
    Pass pass;
    pass.entry = [beside](Mill m) { m.arc(9, -beside, 1, 18, 0, 15); };
    return pass;
  };
  // 5 + 10.3 = 15.3 at p 9; at the farthest sqrt(81 + 25) + 10.3 = 20.6 from the axis.
  everywhere(true, round(5), Decision::go);
  // sqrt(81 + 100) + 13.5 = 26.9; the short way round the same circles is right.
  everywhere(true, round(10), Decision::no_go, "farther from the part");
  everywhere(true, round(5'000), Decision::no_go, "farther from the part");
  everywhere(true, round(-10), Decision::go);
  everywhere(true, round(-5'000), Decision::go);
}

TEST(ThreadEnvelope, AnEntryThroughTheWallOfABoreIsNoGo) {
  const auto round = [](double beside) {
    Pass pass;
    pass.entry = [beside](Mill m) { m.arc(2.25, -beside, 1, 4.5, 0, 15); };
    return pass;
  };
  // Beyond half a turn the circle comes to the wall at a slant, and goes through it.
  for (const double beside : {0.5, 3.0, 5'000.0}) {
    everywhere(false, round(beside), Decision::no_go, "wall of the bore");
  }
  everywhere(false, round(-0.5), Decision::go);
  everywhere(false, round(-3), Decision::go);
  // An entry whose infeed begins in the wall.
  Pass far;
  far.entry = [](Mill m) { m.arc(50, 0, 1, 100, 0, 15); };
  everywhere(false, far, Decision::no_go, "wall of the bore");
}

// R3. In a bore nothing stands in the way of a straight cut from the axis. A turn that keeps to its
// centre by less than the tolerance of 0.001 is no entry; one of twice that is.
TEST(ThreadEnvelope, AnEntryThatHardlyTurnsIsNone) {
  const auto turn_of = [](double radius) {
    return [radius](Mill m) { m.arc(radius, 0, 1, 0, 0, 15); };
  };
  Pass pass;
  for (const double radius : {0.0, 0.0004, 0.001}) {
    pass.entry = turn_of(radius);
    everywhere(false, pass, Decision::no_go, "entry arc is missing");
  }
  pass.entry = turn_of(0.002);
  everywhere(false, pass, Decision::go);
}

// Turns are counted, not records.
TEST(ThreadEnvelope, TurnsOfAnEntryAreCounted) {
  for (const bool external : {true, false}) {
    const double start = external ? 18 : 4.5;
    for (const int turns : {2, 3, 1'000'000'000}) {
      Pass pass;
      pass.entry = [=](Mill m) { m.arc(start / 2, 0, turns, start, 0, 15); };
      everywhere(external, pass, Decision::no_go, "turns round more than once");
    }
    // Half a turn to the other side and half a turn back are one; with a ring between them two.
    for (const bool ring : {false, true}) {
      Pass pass;
      pass.entry = [=](Mill m) {
        m.arc(-start / 4, 0, 1, -start / 2, 0, 15);
        if (ring) m.arc(0, 0, 1, -start / 2, 0, 15);
        m.arc(start / 4, 0, 1, start, 0, 15);
      };
      everywhere(external, pass, ring ? Decision::no_go : Decision::go,
                 ring ? "turns round more than once" : "");
    }
  }
}

// Between the same two places over and over, by flat arcs: each is small, and they never end.
TEST(ThreadEnvelope, AnEntryThatGoesToAndFroIsNoGo) {
  for (const bool external : {true, false}) {
    const double start = external ? 18 : 4.5;
    Pass pass;
    pass.entry = [=](Mill m) {
      m.arc(start / 2, 1'000, 1, start, 0, 15);
      for (int i = 0; i < 20; ++i) {
        m.arc(start / 2, -1'000, 1, 0, 0, 15);
        m.arc(start / 2, 1'000, 1, start, 0, 15);
      }
    };
    everywhere(external, pass, Decision::no_go, "turns back");
  }
}

// J-THR-02. Two semicircles in a row meet in a point, where the tool turns back. A quarter about
// p 1 ends along p; about p 1 + R the next begins upright to that, with (17 - R)^2 + 1 = R^2.
TEST(ThreadEnvelope, AnEntryThatTurnsBackAtACornerIsNoGo) {
  for (const bool external : {true, false}) {
    const double start = external ? 18 : 4.5;
    Pass pass;
    pass.entry = [=](Mill m) {
      m.arc(start / 4, 0, 1, start / 2, 0, 15);
      m.arc(start * 3 / 4, 0, 1, start, 0, 15);
    };
    everywhere(external, pass, Decision::no_go, "turns back");
  }
  Pass upright;
  upright.entry = [](Mill m) {
    m.arc(1, 0, 1, 1, -1, 15);
    m.arc(9.529411765, -1, 1, 18, 0, 15);
  };
  everywhere(true, upright, Decision::go);
}

// By nine tenths of the tolerance a piece.
TEST(ThreadEnvelope, ARotaryAxisThatCreepsIsNoGo) {
  for (const Frame& frame : all_frames()) {
    const double radius = frame.external ? 17 : 5.5;
    const auto helix = [=](double creeps) {
      Pass pass;
      pass.helix = [=](Mill m) {
        for (int i = 1; i <= 8; ++i) {
          const double side = i % 2 != 0 ? -radius : radius;
          m.trace.arc(
              m.frame.plane, {{m.frame.p, 0}, {m.frame.q, 0}}, m.frame.sense,
              {{m.frame.p, side}, {m.frame.q, 0}, {m.frame.d, 15 - 2.5 * i}, {'c', creeps * i}});
        }
      };
      return pass;
    };
    helix(0).is(frame, Decision::go);
    helix(0.0009).is(frame, Decision::no_go, "rotary axis");
  }
}

TEST(ThreadEnvelope, TurnsOfAHelixAreCounted) {
  for (const bool external : {true, false}) {
    const double radius = external ? 17 : 5.5;
    for (const int turns : {3, 5, 1'000'000'000}) {
      Pass pass;
      pass.helix = [=](Mill m) { m.arc(0, 0, turns, radius, 0, -5); };
      everywhere(external, pass, Decision::no_go);
    }
  }
}

// J-THR-05. Over 30 degrees the groove rises by 5 * 30 / 360 = 0.416667, the tolerance is 0.001.
// The arc leaves the material of a bolt at 0.69702 of its sweep, of a bore at 0.68504: it may rise
// by 0.59922 and 0.60969.
TEST(ThreadEnvelope, ARunOutRisesNoMoreThanItsGrooveWhileItIsInTheMaterial) {
  for (const bool external : {true, false}) {
    for (const double rise : {0.4, 0.59}) {
      Pass pass;
      pass.run_out = [=](Mill m) { Pass::polar_to(m, rise - 5); };
      everywhere(external, pass, Decision::go);
    }
    for (const double rise : {0.62, 1.0, 5.0, 20.0}) {
      Pass pass;
      pass.run_out = [=](Mill m) { Pass::polar_to(m, rise - 5); };
      everywhere(external, pass, Decision::no_go, "rises out of its groove");
    }
  }
}

// A bolt's, straight and radially, from 17 by 2 at 30 degrees from the normal: 18 from the axis at
// 0.57210 of the way, where it may have risen by 0.417667: by 0.73006 in all.
TEST(ThreadEnvelope, AStraightRunOutRisesNoMoreEither) {
  for (const double rise : {0.72, 0.74, 20.0}) {
    Pass pass;
    pass.run_out = [=](Mill m) { m.feed(18.732050808, 1, rise - 5); };
    pass.way_back = [](Mill m) { m.rapid(18.732050808, 1, 15); };
    pass.away = [](Mill m) { m.rapid(20, 1, 15); };
    everywhere(true, pass, rise < 0.73 ? Decision::go : Decision::no_go,
               rise < 0.73 ? "" : "rises out of its groove");
  }
}

// Behind the first 0.6 of that way the tool is free, and may rise as it likes: not before it.
TEST(ThreadEnvelope, OutOfTheMaterialARunOutMayRise) {
  for (const double part : {0.5, 0.6}) {
    Pass pass;
    pass.run_out = [=](Mill m) {
      m.feed(17 + std::numbers::sqrt3 * part, part, -5);
      m.feed(18.732050808, 1, 15);
    };
    pass.way_back = [](Mill) {};
    pass.away = [](Mill m) { m.rapid(20, 1, 15); };
    everywhere(true, pass, part > 0.57 ? Decision::go : Decision::no_go,
               part > 0.57 ? "" : "rises out of its groove");
  }
}

TEST(ThreadEnvelope, AWayBackThatLeadsAsideOrDownIsNoGo) {
  for (const bool external : {true, false}) {
    const double p = external ? 16.454482672 : 3.031088913;
    const double q = external ? 9.5 : 1.75;
    for (const double aside : {0.01, 1.0, 1'000.0}) {
      Pass pass;
      pass.way_back = [=](Mill m) {
        m.rapid(p, q + aside, 5);
        m.rapid(p, q, 15);
      };
      everywhere(external, pass, Decision::no_go, "along the depth axis alone");
    }
    // By nine tenths of the tolerance at a time.
    Pass creeping;
    creeping.way_back = [=](Mill m) {
      m.rapid(p, q, 0);
      for (int i = 1; i <= 50; ++i) m.rapid(p, q, -0.0009 * i);
      m.rapid(p, q, 15);
    };
    everywhere(external, creeping, Decision::no_go, "goes down again");
  }
}

// J-THR-06. 20 and 6 beside it.
TEST(ThreadEnvelope, ASafePositionFarFromTheBoltIsNoGo) {
  const auto to = [](double p) {
    Pass pass;
    pass.away = [p](Mill m) { Pass::away_to(m, p); };
    return pass;
  };
  for (const double p : {20.0, 26.0}) everywhere(true, to(p), Decision::go);
  for (const double p : {26.01, 100.0, 5'000.0}) {
    everywhere(true, to(p), Decision::no_go, "farther than the safe position");
  }
}

// 9.5 beside the axis a way along p leads through the part.
TEST(ThreadEnvelope, AWayToTheSafePositionThroughTheBoltIsNoGo) {
  for (const double p : {-20.0, -26.0, -5'000.0}) {
    Pass pass;
    pass.away = [p](Mill m) { Pass::away_to(m, p); };
    everywhere(true, pass, Decision::no_go, "through the part");
  }
}

// From the other side of the bolt, that side is the near one.
TEST(ThreadEnvelope, TheSafePositionIsOnTheSideWhereTheRunOutEnds) {
  const auto away = [](double p) {
    Pass pass;
    pass.entry = [](Mill m) { m.arc(-9, 0, 1, -18, 0, 15); };
    pass.infeed = [](Mill m) { m.feed(-17, 0, 15); };
    pass.helix = [](Mill m) { m.arc(0, 0, 4, -17, 0, -5); };
    pass.run_out = [](Mill m) { m.feed(-18.732050808, -1, -5); };
    pass.way_back = [](Mill m) { m.rapid(-18.732050808, -1, 15); };
    pass.away = [p](Mill m) { m.rapid(p, -1, 15); };
    return pass;
  };
  everywhere(true, away(-20), Decision::go);
  everywhere(true, away(20), Decision::no_go, "through the part");
}

// A bore is free from one wall to the other: no farther along p than 2.5.
TEST(ThreadEnvelope, TheSafePositionOfABoreIsInIt) {
  const auto to = [](double p) {
    Pass pass;
    pass.away = [p](Mill m) { Pass::away_to(m, p); };
    return pass;
  };
  for (const double p : {2.5, 0.0, -2.5}) everywhere(false, to(p), Decision::go);
  everywhere(false, to(-2.6), Decision::no_go, "safe position");
  for (const double p : {4.5, -5.0, 5'000.0, -5'000.0}) {
    everywhere(false, to(p), Decision::no_go, "through the part");
  }
}

// J-THR-01. With 3.5 turns the path that `expand` shows crosses the part from -p to +p, where the
// helix began. It is right as it is named, or on the other side, and no other that crosses is.
TEST(ThreadEnvelope, ThePathOfTheReadingIsRightAsItIsNamed) {
  const std::string program =
      "G0 X70 Z70 Y20\nG18\nG114 X0 Z0 V-17.5 R-5 I5 J2 K0 E30 P1 D3 F900\nG0 X70\n";
  const auto judged = [&](int side, double infeed_from, double safe, std::string reading) {
    TraceText t(1, 900);
    t.rapid({{'x', 35}, {'z', 70}, {'y', 20}}).block(3, 900);
    t.rapid({{'x', 0}, {'z', 0}}).rapid({{'y', 15}});
    t.arc("G18", {{'z', side * infeed_from / 2}, {'x', 0}}, -1,
          {{'z', side * infeed_from}, {'x', 0}});
    t.feed({{'z', side * 17.0}});
    t.arc("G18", {{'z', 0}, {'x', 0}}, -4, {{'z', side * -17.0}, {'x', 0}, {'y', -2.5}});
    t.feed({{'z', side * -19.0}}).rapid({{'y', 15}}).rapid({{'z', side * safe}}).rapid({{'y', 20}});
    t.block(4, 900).rapid({{'x', 35}});
    return decision(judge_trace(program, t.text(), Judging{.reading = std::move(reading)}).kind);
  };
  constexpr const char* kAny = "gsk.thread.path=any";
  constexpr const char* kNamed = "gsk.thread.path=arc";
  for (const int side : {1, -1}) {
    EXPECT_EQ(judged(side, 18, 20, kAny), Decision::go);
    EXPECT_EQ(judged(side, 18, 21, kAny), Decision::no_go);
    EXPECT_EQ(judged(side, 19, 20, kAny), Decision::no_go);
    EXPECT_EQ(judged(side, 19, -20, kAny), Decision::go);
    EXPECT_EQ(judged(side, 18, 20, kNamed), side > 0 ? Decision::go : Decision::no_go);
    EXPECT_EQ(judged(side, 18, -20, kNamed), Decision::no_go);
  }
}

}  // namespace
}  // namespace gonogo::oracle
