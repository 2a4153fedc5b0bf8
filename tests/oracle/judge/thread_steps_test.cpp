// SPDX-License-Identifier: GPL-3.0-or-later
//
// The steps of a thread in the order of the text, and nothing else (J-THR-01 to J-THR-09,
// GSK-G114-10, GSK-G114-14, GSK-CYC-01): each departure by name, each way that the text admits.
#include <array>
#include <functional>

#include "milled_thread.hpp"

namespace gonogo::oracle {
namespace {

using Cut = std::function<void(TraceText&)>;

// The manual's external thread, of one pass at 17 with J and K as given; the parts are what the
// tests change. Without a part of its own it is the path that `expand` shows with K 0: a semicircle
// to Z18, in to Z17, four turns to Y-5, straight out to 17 + J.
struct Path {
  std::string_view words = "J2 K0";
  Cut entry = [](TraceText& t) { t.arc("G18", {{'z', 9}, {'x', 0}}, -1, {{'z', 18}, {'x', 0}}); };
  Cut infeed = [](TraceText& t) { t.feed({{'z', 17}}); };
  Cut helix = [](TraceText& t) {
    t.arc("G18", {{'z', 0}, {'x', 0}}, -4, {{'z', 17}, {'x', 0}, {'y', -5}});
  };
  Cut run_out = [](TraceText& t) { t.feed({{'z', 19}}); };
  Cut way_back = [](TraceText& t) { t.rapid({{'y', 15}}); };
  Cut away = [](TraceText& t) { t.rapid({{'z', 20}}); };

  Verdict judged(const Judging& judging = {}) const {
    const std::string program = "G0 X70 Z70 Y20\nG18\nG114 X0 Z0 V-20 R-5 I5 E30 P1 D3 F900 " +
                                std::string(words) + "\nG0 X70\n";
    TraceText t(1, 900);
    t.rapid({{'x', 35}, {'z', 70}, {'y', 20}}).block(3, 900);
    t.rapid({{'x', 0}, {'z', 0}}).rapid({{'y', 15}});
    for (const Cut* each : {&entry, &infeed, &helix, &run_out, &way_back, &away}) (*each)(t);
    t.rapid({{'y', 20}}).block(4, 900).rapid({{'x', 35}});
    return judge_trace(program, t.text(), judging);
  }
};

const Cut kNothing = [](TraceText&) {};

void is_go(const Path& path, const Judging& judging = {}) {
  const Verdict verdict = path.judged(judging);
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message << "\ngot " << verdict.got;
}

void is_no_go(const Path& path, std::string_view says, const Judging& judging = {}) {
  const Verdict verdict = path.judged(judging);
  EXPECT_EQ(decision(verdict.kind), Decision::no_go) << verdict.message;
  EXPECT_NE(verdict.message.find(says), std::string::npos) << verdict.message;
}

TEST(ThreadSteps, ThePathThatExpandShowsIsGo) {
  is_go({});
}

TEST(ThreadSteps, ATraverseStraightToThePassRadiusIsNoGo) {
  is_no_go({.entry = kNothing,
            .infeed =
                [](TraceText& t) {
                  t.rapid({{'z', 17}});
                }},
           "entry arc is missing");
}

TEST(ThreadSteps, AMissingEntryArcIsNoGo) {
  is_no_go({.entry = kNothing}, "entry arc is missing");
  is_no_go({.entry =
                [](TraceText& t) {
                  t.feed({{'x', 5}}).feed({{'z', 18}, {'x', 0}});
                }},
           "entry is no arc");
}

TEST(ThreadSteps, AMissingInfeedIsNoGo) {
  // The arc leads straight to the radius of the pass.
  is_no_go({.entry =
                [](TraceText& t) {
                  t.arc("G18", {{'z', 8.5}, {'x', 0}}, -1, {{'z', 17}, {'x', 0}});
                },
            .infeed = kNothing},
           "infeed is missing");
}

TEST(ThreadSteps, AnInfeedOfTwoCutsBehindTheArcIsToldAsWhatItIs) {
  // A millimetre into the material and back; and aside, no deeper than the pass.
  is_no_go({.infeed =
                [](TraceText& t) {
                  t.feed({{'z', 16}}).feed({{'z', 17}});
                }},
           "The infeed goes deeper than its pass.");
  is_no_go({.infeed =
                [](TraceText& t) {
                  t.feed({{'z', 17.5}, {'x', 0.3}}).feed({{'z', 17}, {'x', 0}});
                }},
           "The infeed is not one straight cut.");
}

TEST(ThreadSteps, AnInfeedByAnArcIsNoGo) {
  is_no_go({.infeed =
                [](TraceText& t) {
                  t.arc("G18", {{'z', 17.5}, {'x', 0}}, -1, {{'z', 17}, {'x', 0}});
                }},
           "infeed is missing");
}

TEST(ThreadSteps, ATraverseAsInfeedIsNoGo) {
  is_no_go({.infeed = [](TraceText& t) { t.rapid({{'z', 17}}); }}, "where the infeed is due");
}

// A full turn at the R plane before or after the semicircle.
TEST(ThreadSteps, ARingAtTheRPlaneIsNoGo) {
  is_no_go({.entry =
                [](TraceText& t) {
                  t.arc("G18", {{'z', 9}, {'x', 0}}, -2, {{'z', 18}, {'x', 0}});
                }},
           "turns round more than once");
  is_no_go({.entry =
                [](TraceText& t) {
                  t.arc("G18", {{'z', 9}, {'x', 0}}, -1, {{'z', 18}, {'x', 0}});
                  t.arc("G18", {{'z', 0}, {'x', 0}}, -1, {{'z', 18}, {'x', 0}});
                }},
           "turns round more than once");
}

TEST(ThreadSteps, TheEntryArcMayHaveAnySideRadiusAndPieces) {
  // From the centre to -p, and then the helix from there.
  Path other_side;
  other_side.entry = [](TraceText& t) {
    t.arc("G18", {{'z', -9}, {'x', 0}}, -1, {{'z', -18}, {'x', 0}});
  };
  other_side.infeed = [](TraceText& t) { t.feed({{'z', -17}}); };
  other_side.helix = [](TraceText& t) {
    t.arc("G18", {{'z', 0}, {'x', 0}}, -4, {{'z', -17}, {'x', 0}, {'y', -5}});
  };
  other_side.run_out = [](TraceText& t) { t.feed({{'z', -19}}); };
  other_side.away = [](TraceText& t) { t.rapid({{'z', -20}}); };
  is_go(other_side);
  // The other sense; a flat arc about (9, -40); two quarters.
  is_go({.entry = [](TraceText& t) {
    t.arc("G18", {{'z', 9}, {'x', 0}}, 1, {{'z', 18}, {'x', 0}});
  }});
  is_go({.entry = [](TraceText& t) {
    t.arc("G18", {{'z', 9}, {'x', -40}}, -1, {{'z', 18}, {'x', 0}});
  }});
  is_go({.entry = [](TraceText& t) {
    t.arc("G18", {{'z', 9}, {'x', 0}}, -1, {{'z', 9}, {'x', 9}});
    t.arc("G18", {{'z', 9}, {'x', 0}}, -1, {{'z', 18}, {'x', 0}});
  }});
}

// 60 chords of a semicircle of 9: sagitta 9 (1 - cos 1.5 degrees) = 0.0031.
TEST(ThreadSteps, ChordsOfTheEntryArcAreGoWhereTheyAreGranted) {
  Path path;
  path.entry = [](TraceText& t) {
    for (int i = 1; i <= 60; ++i) {
      const double angle = std::numbers::pi * (1 - i / 60.0);
      t.feed({{'z', 9 + 9 * std::cos(angle)}, {'x', 9 * std::sin(angle)}});
    }
  };
  is_go(path, {.chord = "0.005"});
  is_no_go(path, "entry is no arc", {.chord = "0.001"});
  is_no_go(path, "entry is no arc");
}

TEST(ThreadSteps, AHelixInPiecesIsGo) {
  for (const int pieces : {4, 16, 3600}) {
    is_go({.helix = [&](TraceText& t) {
      for (int i = 1; i <= pieces; ++i) {
        const double angle = -2 * std::numbers::pi * 4 * i / pieces;
        t.arc("G18", {{'z', 0}, {'x', 0}}, -1,
              {{'z', 17 * std::cos(angle)},
               {'x', 17 * std::sin(angle)},
               {'y', 15 - 20.0 * i / pieces}});
      }
    }});
  }
}

// In 5,000 pieces a step: no piece is an overrun (J-THR-01).
TEST(ThreadSteps, StepsInManyPiecesAreNoOverrun) {
  Path path;
  path.words = "J2 K30";
  path.run_out = [](TraceText& t) {
    // Radial: from (17, 0) by 2 at 30 degrees from the normal, clockwise.
    for (int i = 1; i <= 1500; ++i) {
      t.feed({{'z', 17 + 2 * std::cos(std::numbers::pi / 6) * i / 1500}, {'x', -1.0 * i / 1500}});
    }
  };
  path.helix = [](TraceText& t) {
    for (int i = 1; i <= 5000; ++i) {
      const double angle = -2 * std::numbers::pi * 4 * i / 5000;
      t.arc(
          "G18", {{'z', 0}, {'x', 0}}, -1,
          {{'z', 17 * std::cos(angle)}, {'x', 17 * std::sin(angle)}, {'y', 15 - 20.0 * i / 5000}});
    }
  };
  path.away = [](TraceText& t) { t.rapid({{'z', 20}}); };
  is_go(path);
}

TEST(ThreadSteps, TurnsAtTheBottomAreNoGo) {
  for (const int turns : {-1, -2, 1, 20, 50}) {
    for (const std::string_view words : {"J2 K0", "J0"}) {
      Path path;
      path.words = words;
      path.run_out = [&](TraceText& t) {
        t.arc("G18", {{'z', 0}, {'x', 0}}, turns, {{'z', 17}, {'x', 0}});
        if (words != "J0") t.feed({{'z', 19}});
      };
      is_no_go(path, words == "J0" ? "turns on at the bottom" : "turns round at the bottom");
    }
  }
}

TEST(ThreadSteps, ALeftHandThreadOnTheWayBackIsNoGo) {
  // Counterclockwise going up is a right-hand one again; clockwise going up crosses it.
  for (const int turns : {-4, 4}) {
    is_no_go({.way_back =
                  [&](TraceText& t) {
                    t.arc("G18", {{'z', 0}, {'x', 0}}, turns, {{'z', 19}, {'x', 0}, {'y', 15}});
                  }},
             "cuts on after its run-out");
    is_no_go({.words = "J0",
              .run_out = kNothing,
              .way_back =
                  [&](TraceText& t) {
                    t.arc("G18", {{'z', 0}, {'x', 0}}, turns, {{'z', 17}, {'x', 0}, {'y', 15}});
                  }},
             "J = 0 is no run-out");
  }
}

// J 0.2 is below the pass depth of 1: the rings at 17.2 cut the crests between 17 and 18.
TEST(ThreadSteps, RingsAtHalfHeightAreNoGo) {
  is_no_go({.words = "J0.2 K0",
            .run_out =
                [](TraceText& t) {
                  t.feed({{'z', 17.2}});
                },
            .way_back =
                [](TraceText& t) {
                  t.rapid({{'y', 5}});
                  t.arc("G18", {{'z', 0}, {'x', 0}}, -1, {{'z', 17.2}, {'x', 0}});
                  t.rapid({{'y', 15}});
                }},
           "turns on its way back");
}

TEST(ThreadSteps, AWayBackBesideTheDepthAxisIsNoGo) {
  is_no_go({.way_back =
                [](TraceText& t) {
                  t.rapid({{'z', 30}, {'y', 15}});
                }},
           "along the depth axis alone");
  is_no_go({.way_back =
                [](TraceText& t) {
                  t.rapid({{'y', 10}}).rapid({{'y', 5}}).rapid({{'y', 15}});
                }},
           "goes down again");
}

// With J below the pass depth the way back passes the crests: the text orders it.
TEST(ThreadSteps, AWayBackThroughTheCrestsIsGoWhereJIsSmall) {
  is_go({.words = "J0.2 K0",
         .run_out =
             [](TraceText& t) {
               t.feed({{'z', 17.2}});
             },
         .away =
             [](TraceText& t) {
               t.rapid({{'z', 18.2}});
             }});
  is_go({.words = "J0", .run_out = kNothing, .away = [](TraceText& t) { t.rapid({{'z', 18}}); }});
}

TEST(ThreadSteps, NoMoveToTheSafePositionIsNoGo) {
  is_no_go({.away = kNothing}, "safe position");
  is_no_go({.away = [](TraceText& t) { t.rapid({{'z', 19.9}}); }}, "safe position");
  // Along q.
  is_no_go({.away = [](TraceText& t) { t.rapid({{'x', 15}}); }}, "safe position");
}

TEST(ThreadSteps, ARunOutOfAnotherLengthOrSideIsNoGo) {
  const auto out_to = [](double z, double x) {
    return [=](TraceText& t) { t.feed({{'z', z}, {'x', x}}); };
  };
  const auto away_to = [](double z) { return [=](TraceText& t) { t.rapid({{'z', z}}); }; };
  is_no_go({.run_out = out_to(47, 0), .away = away_to(50)}, "another point");
  is_no_go({.run_out = out_to(18.5, 0)}, "another point");
  is_no_go({.run_out = kNothing}, "run-out is missing");
  is_no_go({.words = "J0"}, "run-out although J = 0");
  // K 30 clockwise is the side of -X: 17 + 2 cos 30 = 18.732051, X-1. To +X it is the other side.
  is_go({.words = "J2 K30", .run_out = out_to(18.732050808, -1)});
  is_no_go({.words = "J2 K30", .run_out = out_to(18.732050808, 1)}, "another point");
}

// J-THR-05. A half circle about Y-5 Z18 in the plane of Y and Z: it ends where J and K lead to.
TEST(ThreadSteps, ARunOutByAnArcInAnotherPlaneIsNoGo) {
  for (const int sense : {1, -1}) {
    is_no_go({.run_out =
                  [sense](TraceText& t) {
                    t.arc("G19", {{'y', -5}, {'z', 18}}, sense, {{'y', -5}, {'z', 19}});
                  }},
             "none of the run-outs");
  }
}

// With K 0 the groove leads up by nothing. At Z18 the tool is out of the material.
TEST(ThreadSteps, ARunOutMayRiseOutOfTheMaterial) {
  is_go({.run_out = [](TraceText& t) { t.feed({{'z', 18}}).feed({{'z', 19}, {'y', 3}}); }});
  is_no_go({.run_out = [](TraceText& t) { t.feed({{'z', 19}, {'y', 3}}); }}, "rises out of its");
  is_no_go({.run_out = [](TraceText& t) { t.feed({{'z', 20}, {'y', 3}}); }}, "run-out");
  is_no_go({.run_out = [](TraceText& t) { t.feed({{'z', 19}, {'y', 16}}); }}, "beyond the R plane");
  is_no_go({.run_out = [](TraceText& t) { t.feed({{'z', 19}, {'y', -6}}); }}, "below the bottom");
}

// The end 0.0098 to 0.011 mm beside the place that whole turns lead to: at a radius of 8 and a lead
// of 5 the height of the helix is off by about the tolerance there.
TEST(ThreadSteps, AHelixThatEndsBesideIsNoGo) {
  for (const double lead : {5.0, 10.0}) {
    for (int i = 0; i <= 60; ++i) {
      const double beside = 0.0092 + 0.00004 * i;
      for (const int sign : {-1, 1}) {
        const std::string program = "G0 X70 Z70 Y20\nG18\nG114 X0 Z0 V-20 R-5 I" +
                                    std::to_string(lead) + " E12 P1 D3 F900 J0\nG0 X70\n";
        TraceText t(1, 900);
        t.rapid({{'x', 35}, {'z', 70}, {'y', 20}}).block(3, 900);
        t.rapid({{'x', 0}, {'z', 0}}).rapid({{'y', 15}});
        t.arc("G18", {{'z', 4.5}, {'x', 0}}, -1, {{'z', 9}, {'x', 0}}).feed({{'z', 8}});
        const int turns = static_cast<int>(20 / lead) + (sign < 0 ? 1 : 0);
        t.arc("G18", {{'z', 0}, {'x', 0}}, -turns, {{'z', 8}, {'x', sign * beside}, {'y', -5}});
        t.rapid({{'y', 15}}).rapid({{'z', 9}}).rapid({{'y', 20}}).block(4, 900).rapid({{'x', 35}});
        const Verdict verdict = judge_trace(program, t.text());
        EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << beside << verdict.message;
      }
    }
  }
}

TEST(ThreadSteps, OneRunOutHoldsForAWholeProgram) {
  // K 30: the first pass leaves by the polar one, the second by the radial one.
  for (const bool same : {true, false}) {
    Thread thread;
    thread.mixed_run_outs = !same;
    const Verdict verdict = judge(thread);
    EXPECT_EQ(decision(verdict.kind), same ? Decision::go : Decision::no_go) << verdict.message;
    if (same) continue;
    EXPECT_NE(verdict.message.find("one holds"), std::string::npos) << verdict.message;
  }
}

// facts and readings: 19.5 and 19 from the axis at -30 degrees; in the bore 3 and 3.5.
TEST(ThreadSteps, ThePolarRunOutEndsWhereTheManualsWordsLead) {
  struct Want {
    std::string_view program;
    std::array<std::array<double, 2>, 2> ends;  // Z, and X from the centre
    double centre_x;
  };
  const std::array<Want, 2> wants = {
      Want{kExternal, {{{16.887495, -9.75}, {16.454483, -9.5}}}, 0},
      Want{kInternal, {{{72.598076, -1.5}, {73.031089, -1.75}}}, 35}};
  for (const Want& want : wants) {
    reference::Profile profile =
        std::get<reference::Profile>(reference::default_profile("gsk988ta"));
    const std::string program(want.program);
    ProgramInput input(program);
    reference::Expander expander(profile, input.lines, reference::OpenPaths::shown);
    std::size_t pass = 0;
    while (const reference::Item* item = expander.next()) {
      const auto* record = std::get_if<Record>(item);
      if (record == nullptr || reference::clause_name(record->clause) != "GSK-G114-11") continue;
      ASSERT_LT(pass, 2U);
      EXPECT_NEAR(estimate(record->to[Axis::z]), want.ends[pass][0], 5e-7);
      EXPECT_NEAR(estimate(record->to[Axis::x]) - want.centre_x, want.ends[pass][1], 5e-7);
      ++pass;
    }
    EXPECT_EQ(pass, 2U);
  }
}

}  // namespace
}  // namespace gonogo::oracle
