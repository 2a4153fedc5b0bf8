// SPDX-License-Identifier: GPL-3.0-or-later
// A path programmed in a frame of sinumerik802s, and the same path with its coordinates derived
// by hand: in the reference and in the expander.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "makers.hpp"

namespace gonogo::expanders::testing {
namespace {

using reference::testing::any_between;

// Lengths that a fifth of is a thousandth.
std::int64_t length() {
  return 5 * any_between(-20'000, 20'000);
}

struct Path {
  std::vector<Vector> to;
  std::vector<std::string> codes;          // before the end's words
  std::vector<std::vector<Vector>> extra;  // centre from the start, or intermediate point
};

// From (0, 0, 0), along the axes of the plane.
Path some_path() {
  Path path;
  Vector at{};
  for (std::int64_t steps = any_between(1, 6); steps > 0; --steps) {
    Vector to = {length(), length(), length()};
    std::vector<Vector> extra;
    std::string code = any_between(0, 1) == 1 ? "G0" : "G1";
    const std::int64_t kind = any_between(0, 4);
    const char* sense = any_between(0, 1) == 1 ? "G2" : "G3";
    if (kind == 2) {  // a quarter, a half, or three, in either sense
      std::array<std::int64_t, 2> spoke = {5 * any_between(1, 9'000), length()};
      extra.push_back({-spoke[0], -spoke[1], 0});
      const std::array<std::int64_t, 2> centre = {at[0] - spoke[0], at[1] - spoke[1]};
      for (std::int64_t quarters = any_between(1, 3); quarters > 0; --quarters) {
        spoke = {-spoke[1], spoke[0]};
      }
      to = {centre[0] + spoke[0], centre[1] + spoke[1], any_between(0, 1) == 1 ? length() : at[2]};
      code = std::string(sense) + " TURN=1";
    } else if (kind == 3) {
      // At least half the chord, which is shorter than the sum of its parts.
      const Vector way = to - at;
      const std::int64_t radius = std::abs(way[0]) + std::abs(way[1]) + 1 + any_between(0, 9'000);
      code = std::string(sense) + " TURN=0 CR=" + (any_between(0, 1) == 1 ? "" : "-") +
             decimal(radius);
    } else if (kind == 4) {
      extra.push_back({length(), length(), length()});
      code = "CIP";
    }
    path.to.push_back(to);
    path.codes.push_back(code);
    path.extra.push_back(extra);
    at = to;
  }
  return path;
}

// As it stands in the frame, or derived.
std::string written(const Path& path, const Turn& turn, bool worked_out) {
  std::string text;
  for (std::size_t i = 0; i < path.to.size(); ++i) {
    text += path.codes[i] + words(turn, worked_out ? turn.point(path.to[i]) : path.to[i]);
    for (const Vector& v : path.extra[i]) {
      const bool via = path.codes[i] == "CIP";
      const Vector mine = !worked_out ? v : via ? turn.point(v) : turn.turned(v);
      const std::string all = words(turn, mine, "IJK", via ? "1=" : "");
      // A centre has no word along the third axis, the last one.
      text += via ? all : all.substr(0, all.rfind(' '));
    }
    text += "\n";
  }
  return text;
}

std::string head(const Turn& turn) {
  return "G" + std::to_string(reference::plane_code(turn.plane)) + " G90 F60\n";
}

// In the frame as `frame` sets it, in kFrameBlocks blocks, and without one.
void compare(const Path& path, const Turn& turn, const std::string& frame,
             std::pair<const char*, const char*> reading = {"sie.g158", "absolute"}) {
  reference::Profile profile = machine_at(turn.xyz(turn.shift));
  RC_ASSERT(!set_reading(profile, reading.first, reading.second));
  const std::string framed = head(turn) + frame + written(path, turn, false);
  const std::string worked_out = head(turn) + written(path, turn, true);
  RC_LOG() << framed << worked_out;
  for (const Maker make : makers()) {
    const bool exactly = turn.is_exact() && make == &reference_makes;
    const Made got = make(framed, profile);
    const Made want = make(worked_out, profile);
    RC_PRE(want.alarm.empty());  // three points in a line
    RC_ASSERT(got.alarm.empty());
    // Centres far off are as good as their arcs.
    expect_near(got.steps(profile), want.steps(profile),
                exactly ? Number(0) : Number::decimal(false, 1, 8), kFrameBlocks);
  }
}

RC_GTEST_PROP(SinumerikFrameRelations, APathInAFrameIsThePathWorkedOut, ()) {
  const Turn turn = some_turn(false);
  compare(some_path(), turn, turn.frame());
}

// G259 adds to what G259 turned, about the zero that G158 put.
RC_GTEST_PROP(SinumerikFrameRelations, RotationsAdd, ()) {
  Turn turn = some_turn(true);
  const Path path = some_path();
  turn.shift = {};
  const std::int64_t part = any_between(-360, 360);
  const std::int64_t whole = std::stoll(turn.degrees);
  compare(path, turn,
          "G259 RPL=" + std::to_string(part) +
              "\nG259 RPL=" + std::to_string((whole - part) % 360) + "\n");
}

// Translations add under that reading; the rotation alone is replaced under the other one.
RC_GTEST_PROP(SinumerikFrameRelations, WhatTheReadingsAddAndReplace, ()) {
  Turn turn = some_turn(false);
  const Path path = some_path();
  compare(path, turn, "G158" + words(turn, turn.shift) + "\nG258 RPL=" + turn.degrees + "\n",
          {"sie.g258", "rotation-only"});
  const Vector part = reference::testing::any_shift();
  turn.degrees = "0";
  turn.cosine = turn.over = 1;
  turn.sine = 0;
  compare(path, turn, "G158" + words(turn, part) + "\nG158" + words(turn, turn.shift - part) + "\n",
          {"sie.g158", "additive"});
}

// By default a translation replaces all that was before it.
RC_GTEST_PROP(SinumerikFrameRelations, ATranslationReplaces, ()) {
  Turn turn;
  turn.plane = static_cast<reference::Plane>(any_between(0, 2));
  turn.shift = reference::testing::any_shift();
  const Path path = some_path();
  const std::string last = "G158" + words(turn, turn.shift) + "\n";
  compare(path, turn, "G158" + words(turn, reference::testing::any_shift()) + "\n" + last);
  compare(path, turn, "G259 RPL=33.5\n" + last);
}

// The tool stays, and so does what is not named.
RC_GTEST_PROP(SinumerikFrameRelations, AFrameSetAndClearedIsNone, ()) {
  const Turn turn = some_turn(false);
  const Path path = some_path();
  const std::string text = written(path, turn, false);
  const reference::Profile profile = machine_at({});
  for (const Maker make : makers()) {
    const Made got = make(head(turn) + turn.frame() + "G158\n" + text, profile);
    const Made want = make(head(turn) + "\n\n\n" + text, profile);
    RC_PRE(want.alarm.empty());
    RC_ASSERT(got.alarm.empty());
    expect_near(got.steps(profile), want.steps(profile), Number::decimal(false, 1, 8), 0);
  }
}

}  // namespace
}  // namespace gonogo::expanders::testing
