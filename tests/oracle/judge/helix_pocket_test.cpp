// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge of helical pockets on the manual's example: G112 X70 Z70 Y20 I8 L5 D4. G18: p = Z, q =
// X; centre Z70 X35, R plane Y30 (no R word), bottom Y20, helix of 5 turns at I - D = 4, clockwise.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::string_view kHelixPocket =
    "G00 X70 Z70 Y30\nG18\nG112 X70 Z70 Y20 I8 L5 D4 F200\nG00 X80\n";

struct Pocket {
  double degrees = 0;  // side of the entry, counterclockwise from +Z
  int sense = -1;
  double radius = 4;
  double bottom = 20;
  int turns = 5;
  int pieces = 1;        // of the helix
  int entry_pieces = 1;  // and of the semicircles
  double entry_radius = 2;
  double exit_degrees = 0;  // how far from the helix's end the exit begins
  double feed = 200;
  bool flat = false;
  bool exit = true;

  void arc(TraceText& text, double z, double x, double radius_of_arc, double from, double by,
           int parts) const {
    for (int i = 1; i <= parts; ++i) {
      const double angle = (from + sense * by * i / parts) * std::numbers::pi / 180;
      text.arc(
          "G18", {{'z', z}, {'x', x}}, sense,
          {{'z', z + radius_of_arc * std::cos(angle)}, {'x', x + radius_of_arc * std::sin(angle)}});
    }
  }

  std::string text() const {
    const double angle = degrees * std::numbers::pi / 180;
    const double z = 70 + radius * std::cos(angle);
    const double x = 35 + radius * std::sin(angle);
    TraceText text(1, feed);
    text.rapid({{'x', 35}, {'y', 30}, {'z', 70}}).block(3, feed);
    arc(text, 70 + entry_radius * std::cos(angle), 35 + entry_radius * std::sin(angle),
        entry_radius, degrees + 180, 180, entry_pieces);
    for (int i = 1; i <= pieces; ++i) {
      text.arc("G18", {{'z', 70}, {'x', 35}}, sense * turns / pieces,
               {{'z', z}, {'x', x}, {'y', 30 + (bottom - 30) * i / pieces}});
    }
    if (flat) text.arc("G18", {{'z', 70}, {'x', 35}}, sense, {{'z', z}, {'x', x}});
    if (exit_degrees != 0) arc(text, 70, 35, radius, degrees, exit_degrees, 1);
    if (exit) {
      const double out = degrees + sense * exit_degrees;
      const double to = out * std::numbers::pi / 180;
      arc(text, 70 + radius / 2 * std::cos(to), 35 + radius / 2 * std::sin(to), radius / 2, out,
          180, entry_pieces);
    }
    text.rapid({{'y', 30}});
    return text.block(4, feed).rapid({{'x', 40}}).text();
  }
};

Verdict judge_pocket(const Pocket& pocket, const Judging& judging = {}) {
  return judge_trace(kHelixPocket, pocket.text(), judging);
}

void expect_pocket_go(const Pocket& pocket, const Judging& judging = {}) {
  const Verdict verdict = judge_pocket(pocket, judging);
  EXPECT_EQ(decision(verdict.kind), Decision::go)
      << verdict.message << "\nwant " << verdict.want << "\ngot " << verdict.got;
}

void expect_pocket_no_go(const Pocket& pocket, std::string_view clause,
                         const Judging& judging = {}) {
  const Verdict verdict = judge_pocket(pocket, judging);
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_EQ(reference::clause_name(verdict.clause), clause) << verdict.message;
  EXPECT_FALSE(verdict.witness.empty());
  EXPECT_EQ(verdict.block, 3U);
}

TEST(HelixPocketJudge, AnyEntrySideIsGo) {
  for (double degrees : {0.0, 90.0, 180.0, 33.0, 211.7}) {
    Pocket pocket;
    pocket.degrees = degrees;
    expect_pocket_go(pocket);
  }
}

TEST(HelixPocketJudge, ANamedSideIsGoOnlyThere) {
  expect_pocket_go({}, {.reading = "gsk.helix.entry-side=+p"});
  Pocket pocket;
  pocket.degrees = 90;
  EXPECT_EQ(decision(judge_pocket(pocket, {.reading = "gsk.helix.entry-side=+p"}).kind),
            Decision::no_go);
}

TEST(HelixPocketJudge, ArcsInPartsAreTheSameArcs) {
  // 100 parts of the semicircle: the last but one ends 0.06 from its end, and still within the
  // tolerance of the circle of the helix.
  for (int parts : {2, 7, 100}) {
    Pocket pocket;
    pocket.degrees = 33;
    pocket.pieces = 5;
    pocket.entry_pieces = parts;
    expect_pocket_go(pocket);
  }
}

TEST(HelixPocketJudge, AnEntryOfAnotherRadiusIsNoGo) {
  Pocket pocket;
  pocket.entry_radius = 1.9;
  expect_pocket_no_go(pocket, "GSK-G112-04");
}

TEST(HelixPocketJudge, AMissingEntryIsNoGo) {
  std::string text = Pocket{}.text();
  const std::size_t entry = text.find("{\"k\":\"arc\"");
  text.replace(entry, text.find('\n', entry) - entry,
               R"({"k":"feed","b":3,"to":{"z":"74"},"f":"200"})");
  const Verdict verdict = judge_trace(kHelixPocket, text);
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry);
  EXPECT_EQ(reference::clause_name(verdict.clause), "GSK-G112-04");
}

TEST(HelixPocketJudge, TheOppositeSenseIsNoGo) {
  Pocket pocket;
  pocket.sense = 1;
  expect_pocket_no_go(pocket, "GSK-G112-04");
}

TEST(HelixPocketJudge, AnotherNumberOfTurnsIsNoGo) {
  Pocket pocket;
  pocket.turns = 4;
  expect_pocket_no_go(pocket, "GSK-G112-05");
}

// In place of the helix's or a semicircle's own, in one record: of -5 and -1.
TEST(HelixPocketJudge, TurnsWithoutEndAreNoGo) {
  for (const std::string_view rot : {"\"rot\":-5", "\"rot\":-1"}) {
    for (const bool first : {true, false}) {
      for (const std::string_view turns : {"\"rot\":-1000000000", "\"rot\":-2"}) {
        std::string text = Pocket{}.text();
        text.replace(first ? text.find(rot) : text.rfind(rot), rot.size(), turns);
        EXPECT_EQ(judge_trace(kHelixPocket, text).kind, VerdictKind::fail_geometry) << text;
      }
    }
  }
}

// A cut aside or up from a place of the path, and back.
Decision with_excursion_at(int place, double aside, double up) {
  TraceText text(1, 200);
  int here = 0;
  const auto from = [&](double z, double y) {
    if (here++ != place) return;
    text.feed({{'z', z + aside}, {'y', y + up}}).feed({{'z', z}, {'y', y}});
  };
  text.rapid({{'x', 35}, {'y', 30}, {'z', 70}}).block(3, 200);
  from(70, 30);
  text.arc("G18", {{'x', 35}, {'z', 72}}, -1, {{'x', 35}, {'z', 74}});
  from(74, 30);
  text.arc("G18", {{'x', 35}, {'z', 70}}, -3, {{'x', 35}, {'z', 66}, {'y', 25}});
  from(66, 25);
  text.arc("G18", {{'x', 35}, {'z', 70}}, -3, {{'x', 35}, {'z', 74}, {'y', 20}});
  from(74, 20);
  text.arc("G18", {{'x', 35}, {'z', 72}}, -1, {{'x', 35}, {'z', 70}});
  from(70, 20);
  text.rapid({{'y', 30}}).block(4, 200).rapid({{'x', 40}});
  return decision(judge_trace(kHelixPocket, text.text()).kind);
}

TEST(HelixPocketJudge, AnExcursionAtAnyHeightIsNoGo) {
  constexpr int kPlaces = 5;
  EXPECT_EQ(with_excursion_at(kPlaces, 0, 0), Decision::go);
  for (int place = 0; place < kPlaces; ++place) {
    for (const double far : {0.01, -1.0, 5'000.0}) {
      EXPECT_EQ(with_excursion_at(place, far, 0), Decision::no_go) << place << " " << far;
      EXPECT_EQ(with_excursion_at(place, 0, far), Decision::no_go) << place << " " << far;
    }
  }
}

TEST(HelixPocketJudge, AnotherDepthIsNoGo) {
  Pocket pocket;
  pocket.bottom = 20.01;
  EXPECT_EQ(decision(judge_pocket(pocket).kind), Decision::no_go);
}

TEST(HelixPocketJudge, AnExitElsewhereIsNoGo) {
  Pocket pocket;
  pocket.exit_degrees = 30;
  expect_pocket_no_go(pocket, "GSK-G112-06");
}

// R8. By hand, about X15.5 Y-5: at the bottom 0.002 outwards and back, twice the tolerance.
TEST(HelixPocketJudge, ACutAsideAtTheEndOfTheHelixIsNoGo) {
  const auto trace = [](bool aside) {
    TraceText text(1, 300);
    text.rapid({{'x', 8}, {'y', 6}, {'z', 20}}).block(2, 300).rapid({{'x', 15.5}, {'y', -5}});
    text.arc("G17", {{'x', 16.5}, {'y', -5}}, 1, {{'x', 17.5}, {'y', -5}});
    text.arc("G17", {{'x', 15.5}, {'y', -5}}, 1, {{'x', 17.5}, {'y', -5}, {'z', 15.5}});
    if (aside) text.feed({{'x', 17.502}}).feed({{'x', 17.5}});
    text.arc("G17", {{'x', 16.5}, {'y', -5}}, 1, {{'x', 15.5}, {'y', -5}});
    return text.rapid({{'z', 20}}).text();
  };
  constexpr std::string_view kUpright = "G17 G00 X16 Y6 Z20\nG113 X31 Y-5 Z15.5 I6 L1 D4 F300\n";
  EXPECT_EQ(decision(judge_trace(kUpright, trace(false)).kind), Decision::go);
  EXPECT_EQ(judge_trace(kUpright, trace(true)).kind, VerdictKind::fail_geometry);
}

TEST(HelixPocketJudge, AMissingExitIsNoGo) {
  Pocket pocket;
  pocket.exit = false;
  expect_pocket_no_go(pocket, "GSK-G112-06");
}

TEST(HelixPocketJudge, AWrongFeedIsAFeedFailure) {
  Pocket pocket;
  pocket.feed = 201;
  EXPECT_EQ(judge_pocket(pocket).kind, VerdictKind::fail_feed);
}

TEST(HelixPocketJudge, TheFlatCircleIsDueUnderItsReadingAlone) {
  Pocket pocket;
  pocket.flat = true;
  pocket.degrees = 45;
  expect_pocket_go(pocket, {.reading = "gsk.helix.flat=on"});
  expect_pocket_no_go(pocket, "GSK-G112-06");
  pocket.flat = false;
  expect_pocket_no_go(pocket, "GSK-G112-05", {.reading = "gsk.helix.flat=on"});
}

}  // namespace
}  // namespace gonogo::oracle
