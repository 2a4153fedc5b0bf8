// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same arc in all the forms that say it exactly. On circles of a radius of 5k about a centre
// there are twelve places that decimals name, and CR=, AP= RP=, AR=, CIP and CT can all lead from
// one to another without a root being left.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fmt/format.h>

#include <cstdlib>

#include "sie_program.hpp"
#include "tests/reference/path_trace.hpp"

namespace gonogo::reference::testing::sie {
namespace {

using Pair = std::array<std::int64_t, 2>;

// Counterclockwise, from the first axis on.
constexpr std::array<Pair, 12> kSpokes = {{{5, 0},
                                           {4, 3},
                                           {3, 4},
                                           {0, 5},
                                           {-3, 4},
                                           {-4, 3},
                                           {-5, 0},
                                           {-4, -3},
                                           {-3, -4},
                                           {0, -5},
                                           {3, -4},
                                           {4, -3}}};
constexpr std::array<std::string_view, 3> kEnds[] = {
    {"X", "Y", "Z"}, {"Z", "X", "Y"}, {"Y", "Z", "X"}};
constexpr std::array<std::string_view, 2> kCentres[] = {{"I", "J"}, {"K", "I"}, {"J", "K"}};

std::string word(std::string_view name, std::int64_t thousandths) {
  return fmt::format("{}={} ", name, decimal(thousandths));
}

// An arc from one of the places to another.
struct Arc {
  std::size_t plane = 0;  // 0: G17
  Pair centre = {0, 0};
  std::int64_t k = 1;
  int from = 0;
  int to = 0;
  int sense = 1;

  Pair spoke(int i) const {
    const Pair& unit = kSpokes[static_cast<std::size_t>(i)];
    return {unit[0] * k, unit[1] * k};
  }
  Pair place(int i) const { return {centre[0] + spoke(i)[0], centre[1] + spoke(i)[1]}; }
  // 0: a full circle.
  int steps() const { return ((to - from) * sense + 12) % 12; }
  // The sign of the angle of the arc, 1 for more than half a turn.
  int beyond_half() const {
    const Pair a = spoke(from);
    const Pair b = spoke(to);
    const std::int64_t cross = (a[0] * b[1] - a[1] * b[0]) * sense;
    return cross < 0 ? 1 : cross > 0 ? -1 : 0;
  }
  // The angle in thousandths of a degree where the arc is of quarters, else 0.
  std::int64_t quarters() const {
    const Pair a = spoke(from);
    const Pair b = spoke(to);
    if (a[0] * b[0] + a[1] * b[1] == 0) return beyond_half() > 0 ? 270'000 : 90'000;
    return a[0] == -b[0] && a[1] == -b[1] ? 180'000 : 0;
  }
  std::string code() const { return sense > 0 ? "G3 " : "G2 "; }
  std::string end() const {
    return word(kEnds[plane][0], place(to)[0]) + word(kEnds[plane][1], place(to)[1]);
  }
  std::string offsets() const {
    return word(kCentres[plane][0], -spoke(from)[0]) + word(kCentres[plane][1], -spoke(from)[1]);
  }
  std::string by_centre() const { return code() + end() + offsets(); }
};

Arc any_arc(bool full_circle = false) {
  Arc arc;
  arc.plane = static_cast<std::size_t>(any_between(0, 2));
  arc.centre = {any_between(-50'000, 50'000), any_between(-50'000, 50'000)};
  arc.k = any_between(1, 9'000);
  arc.from = static_cast<int>(any_between(0, 11));
  arc.to = static_cast<int>((arc.from + any_between(full_circle ? 0 : 1, 11)) % 12);
  arc.sense = any_between(0, 1) == 1 ? 1 : -1;
  return arc;
}

// The arc after a line to its start, and a tangent arc after it.
PathTrace look(const Arc& arc, const std::string& form, const std::string& pole = {},
               const std::string& plane_in_force = {}) {
  const Pair start = arc.place(arc.from);
  const std::string go = "G0 " + word(kEnds[arc.plane][0], start[0]) +
                         word(kEnds[arc.plane][1], start[1]) + word(kEnds[arc.plane][2], 7'000) +
                         "F200\n";
  const std::string plane =
      plane_in_force.empty() ? fmt::format("G{}", 17 + arc.plane) : plane_in_force;
  const std::string text = plane + " G90\n" + go + pole + "\n" + form + "\n" +
                           fmt::format("G{}\n", 17 + arc.plane) + "CT " +
                           word(kEnds[arc.plane][0], 61'000) + word(kEnds[arc.plane][1], 47'123);
  RC_LOG() << text;
  const Profile profile = std::get<Profile>(default_profile("sinumerik840d"));
  return without_clauses(path_trace(text, profile));
}

// Without what is between the line to the start and the tangent arc.
PathTrace after_arc(PathTrace trace) {
  RC_ASSERT(trace.size() >= 3U);
  trace.erase(trace.begin() + 1);
  return trace;
}

RC_GTEST_PROP(SieArcForms, ACentreIsAnIncrementOrAPlace, ()) {
  const Arc arc = any_arc(true);
  const std::string ac =
      fmt::format("{}{}{}=AC({}) {}=AC({})", arc.code(), arc.end(), kCentres[arc.plane][0],
                  decimal(arc.centre[0]), kCentres[arc.plane][1], decimal(arc.centre[1]));
  RC_ASSERT(look(arc, ac) == look(arc, arc.by_centre()));
}

RC_GTEST_PROP(SieArcForms, ACircleNeedsNoEndPoint, ()) {
  Arc arc = any_arc();
  arc.to = arc.from;
  RC_ASSERT(look(arc, arc.code() + arc.offsets()) == look(arc, arc.by_centre()));
}

RC_GTEST_PROP(SieArcForms, ARadiusIsACentre, ()) {
  const Arc arc = any_arc();
  const int sign = arc.beyond_half() != 0 ? -arc.beyond_half() : any_between(0, 1) == 1 ? 1 : -1;
  const std::string cr = arc.code() + arc.end() + word("CR", std::int64_t{sign} * 5 * arc.k);
  RC_ASSERT(look(arc, cr) == look(arc, arc.by_centre()));
}

RC_GTEST_PROP(SieArcForms, APoleIsACentre, ()) {
  Arc arc = any_arc(true);
  arc.to = static_cast<int>(any_between(0, 3)) * 3;
  const std::string pole =
      "G111 " + word(kEnds[arc.plane][0], arc.centre[0]) + word(kEnds[arc.plane][1], arc.centre[1]);
  const std::int64_t turn = any_between(0, 1) == 1 && arc.to != 0 ? -360'000 : 0;
  const std::string polar =
      arc.code() + word("AP", std::int64_t{arc.to} * 30'000 + turn) + word("RP", 5 * arc.k);
  RC_ASSERT(look(arc, polar, pole) == look(arc, arc.by_centre(), pole));
}

RC_GTEST_PROP(SieArcForms, AnAngleOfQuartersIsAnEndPointOrACentre, ()) {
  Arc arc = any_arc();
  arc.to = (arc.from + 3 * static_cast<int>(any_between(1, 3))) % 12;
  const std::int64_t angle = arc.quarters();
  RC_ASSERT(angle != 0);
  const PathTrace want = look(arc, arc.by_centre());
  RC_ASSERT(look(arc, arc.code() + arc.offsets() + word("AR", angle)) == want);
  RC_ASSERT(look(arc, arc.code() + arc.end() + word("AR", angle)) == want);
}

RC_GTEST_PROP(SieArcForms, TheAxesOfTheEndPointAreAPlane, ()) {
  const Arc arc = any_arc(true);
  const std::string other =
      fmt::format("G{}", 17 + (arc.plane + std::size_t(any_between(1, 2))) % 3);
  RC_ASSERT(look(arc, arc.by_centre(), "", other) == look(arc, arc.by_centre()));
}

// A tangent arc goes on from both alike, and the record of CIP is on the circle.
RC_GTEST_PROP(SieArcForms, ThreePointsAreAnArc, ()) {
  const Arc arc = any_arc();
  RC_PRE(arc.steps() > 1);
  const int via =
      (arc.from + arc.sense * static_cast<int>(any_between(1, arc.steps() - 1)) + 12) % 12;
  const std::string_view names[] = {"I1", "J1", "K1"};
  std::array<std::string_view, 2> via_names;
  for (std::size_t i = 0; i < 2; ++i) {
    via_names[i] = names[static_cast<std::size_t>(kEnds[arc.plane][i][0] - 'X')];
  }
  const std::string cip = "CIP " + arc.end() + word(via_names[0], arc.place(via)[0]) +
                          word(via_names[1], arc.place(via)[1]);
  const PathTrace got = look(arc, cip);
  const PathTrace want = look(arc, arc.by_centre());
  RC_ASSERT(after_arc(got) == after_arc(want));
  RC_ASSERT(got[1].record == RecordKind::arc3);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto axis = static_cast<std::size_t>(kEnds[arc.plane][i][0] - 'X');
    RC_ASSERT(got[1].to[axis] == want[1].to[axis]);
    RC_ASSERT(got[1].via[axis] * 1'000 == Number(arc.place(via)[i]));
  }
}

// A line along the tangent ahead of the start.
RC_GTEST_PROP(SieArcForms, ATangentAndAnEndPointAreAnArc, ()) {
  const Arc arc = any_arc();
  const Pair spoke = arc.spoke(arc.from);
  const std::int64_t times = any_between(1, 3);
  const Pair ahead = {times * arc.sense * spoke[1], -times * arc.sense * spoke[0]};
  const Pair start = arc.place(arc.from);
  const auto go = [&](const Pair& to) {
    return "G1 " + word(kEnds[arc.plane][0], to[0]) + word(kEnds[arc.plane][1], to[1]) + "\n";
  };
  const std::string line = go({start[0] + ahead[0], start[1] + ahead[1]}) + go(start);
  RC_ASSERT(look(arc, "CT " + arc.end(), line) == look(arc, arc.by_centre(), line));
}

// Exactly half a turn, with the third axis and whole turns ahead of it.
RC_GTEST_PROP(SieArcForms, AHelixHasTheFormsOfItsArc, ()) {
  const Arc arc = any_arc();
  const std::string helix = word(kEnds[arc.plane][2], any_between(-30'000, 30'000)) +
                            fmt::format("TURN={}", any_between(0, 5));
  const int sign = arc.beyond_half() > 0 ? -1 : 1;
  const PathTrace want = look(arc, arc.by_centre() + helix);
  RC_ASSERT(look(arc, arc.code() + arc.end() + word("CR", std::int64_t{sign} * 5 * arc.k) +
                          helix) == want);
  const std::string pole =
      "G111 " + word(kEnds[arc.plane][0], arc.centre[0]) + word(kEnds[arc.plane][1], arc.centre[1]);
  if (arc.to % 3 != 0) return;
  RC_ASSERT(
      look(arc,
           arc.code() + word("AP", std::int64_t{arc.to} * 30'000) + word("RP", 5 * arc.k) + helix,
           pole) == look(arc, arc.by_centre() + helix, pole));
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
