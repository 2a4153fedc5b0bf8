// SPDX-License-Identifier: GPL-3.0-or-later
// Pockets of LCYC75 that are each other turned, moved, mirrored or written in other parameters.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fmt/format.h>

#include <cstdlib>

#include "makers.hpp"

namespace gonogo::expanders::testing {
namespace {

using oracle::Verdict;
using reference::testing::any_between;

// In thousandths. The tool has a radius of 2.
struct Pocket {
  Vector centre{};  // along the axes of the plane; the third is nothing
  std::int64_t length = 0;
  std::int64_t width = 0;
  std::int64_t corner = 0;
  std::int64_t allowance = 0;
  std::int64_t left = 0;  // R125
  int sense = 2;
  int type = 1;
};

// Wider and longer than the tool, so that its border goes round something.
Pocket some_pocket() {
  Pocket pocket;
  pocket.centre = {any_between(-40'000, 40'000), any_between(-40'000, 40'000), 0};
  pocket.allowance = any_between(0, 1) * 300;
  pocket.length = 4'800 + 2 * any_between(0, 4'000);
  pocket.width = 4'800 + 2 * any_between(0, 4'000);
  pocket.corner = any_between(0, std::min(pocket.length, pocket.width) / 2);
  pocket.left = any_between(0, 1) * 250;
  pocket.sense = static_cast<int>(any_between(2, 3));
  pocket.type = static_cast<int>(any_between(1, 2));
  return pocket;
}

// A hole is drilled before; what is above the centre is in the frame.
std::string cycles(const Pocket& pocket, std::int64_t zero) {
  return fmt::format(
      "R101={} R102=1 R103={} R104={} R105=0.5\nLCYC82\nR116={} R117={} R118={} R119={} R120={}\n"
      "R121=2 R122=20 R123=30 R124={} R125={} R126={} R127={}\nLCYC75\n",
      decimal(5'000 + zero), decimal(zero), decimal(zero - 3'000), decimal(pocket.centre[0]),
      decimal(pocket.centre[1]), decimal(pocket.length), decimal(pocket.width),
      decimal(pocket.corner), decimal(pocket.allowance), decimal(pocket.left), pocket.sense,
      pocket.type);
}
std::string head(reference::Plane plane) {
  return fmt::format("G{} G90 F60 S300 M3 T2\n", reference::plane_code(plane));
}
std::string program_of(const Pocket& pocket, reference::Plane plane = reference::Plane::g17) {
  return head(plane) + "\n\n" + cycles(pocket, 0);
}

// In base coordinates, where the rotation is by quarters.
Pocket worked_out(Pocket pocket, const Turn& turn) {
  pocket.centre = turn.point(pocket.centre);
  if (turn.cosine == 0) std::swap(pocket.length, pocket.width);
  return pocket;
}

void expect_go(const Verdict& verdict) {
  RC_LOG() << name(verdict.kind) << " " << verdict.message;
  RC_ASSERT(oracle::decision(verdict.kind) == oracle::Decision::go);
}

RC_GTEST_PROP(SinumerikPocketRelations, ATurnedFrameTurnsTheCycles, ()) {
  const Turn turn = some_turn(false);
  const Pocket pocket = some_pocket();
  const std::string framed = head(turn.plane) + turn.frame() + cycles(pocket, 0);
  const reference::Profile there = machine_at(turn.xyz(turn.shift));
  const reference::Profile here = machine_at({});
  RC_LOG() << framed;
  for (const Maker make : makers()) {
    Steps want = make(program_of(pocket, turn.plane), here).steps(here);
    for (Step& step : want) {
      step.to = turn.place(step.to);
      step.record.centre = turn.centre(step.record.centre);
    }
    const Made got = make(framed, there);
    RC_ASSERT(got.alarm.empty());
    expect_near(got.steps(there), want, Number::decimal(false, 1, 8), 0);
  }
}

// Frames against coordinates derived: by quarters, length and width change places.
RC_GTEST_PROP(SinumerikPocketRelations, APocketInAFrameIsThePocketWorkedOut, ()) {
  const Turn turn = some_turn(true);
  const Pocket pocket = some_pocket();
  const reference::Profile profile = machine_at(turn.xyz(turn.shift));
  const Pocket base = worked_out(pocket, turn);
  const std::string framed = head(turn.plane) + turn.frame() + cycles(pocket, 0);
  const std::string plain = head(turn.plane) + "\n\n" + cycles(base, turn.shift[2]);
  RC_LOG() << framed << plain;
  for (const Maker make : makers()) {
    expect_go(judged(plain, profile, make(framed, profile).records));
    expect_go(judged(framed, profile, make(plain, profile).records));
  }
}

// About its own centre a round pocket has no direction.
RC_GTEST_PROP(SinumerikPocketRelations, ACircleTurnedIsTheSameCircle, ()) {
  Pocket circle = some_pocket();
  circle.width = circle.length;
  circle.corner = circle.length / 2;
  Turn turn;
  turn.shift = circle.centre;
  turn.degrees = decimal(any_between(-360'000, 360'000));
  Pocket in_frame = circle;
  in_frame.centre = {};
  const reference::Profile profile = machine_at(turn.shift);
  const std::string framed = head(turn.plane) + turn.frame() + cycles(in_frame, 0);
  RC_LOG() << framed;
  for (const Maker make : makers()) {
    expect_go(judged(program_of(circle), profile, make(framed, profile).records));
  }
}

// Along the axis of the width, about the pocket's own middle.
std::vector<reference::Record> mirrored(std::vector<reference::Record> records,
                                        const Pocket& pocket) {
  const Number twice = Number(2 * pocket.centre[1]) / 1'000;
  for (reference::Record& record : records) {
    Number& y = record.to[reference::Axis::y];
    if (record.axes.has(reference::Axis::y)) y = twice - y;
    record.centre[1] = twice - record.centre[1];
    record.rot = -record.rot;
  }
  return records;
}

// R126 = 3 asks for the mirror image of what R126 = 2 asks for, not for the same path.
RC_GTEST_PROP(SinumerikPocketRelations, TheMirrorImageHasTheOtherDirection, ()) {
  Pocket pocket = some_pocket();
  const reference::Profile profile = machine_at(pocket.centre);
  for (const Maker make : makers()) {
    pocket.sense = 2;
    const std::vector<reference::Record> clockwise = make(program_of(pocket), profile).records;
    expect_go(judged(program_of(pocket), profile, clockwise));
    pocket.sense = 3;
    expect_go(judged(program_of(pocket), profile, mirrored(clockwise, pocket)));
    const Verdict same = judged(program_of(pocket), profile, clockwise);
    RC_LOG() << name(same.kind) << " " << same.message;
    RC_ASSERT(same.kind == oracle::VerdictKind::fail_region);
  }
}

// A corner radius as large as fits makes a slot, or a circle; a larger one is clamped to it.
RC_GTEST_PROP(SinumerikPocketRelations, ASlotIsAPocketWithCornersOfHalfItsWidth, ()) {
  Pocket slot = some_pocket();
  slot.corner = std::min(slot.length, slot.width) / 2;
  Pocket larger = slot;
  larger.corner += any_between(1, 20'000);
  const reference::Profile profile = machine_at({});
  for (const Maker make : makers()) {
    const Made made = make(program_of(slot), profile);
    RC_ASSERT(made.alarm.empty());
    expect_go(judged(program_of(slot), profile, made.records));
    expect_go(judged(program_of(larger), profile, made.records));
    expect_near(make(program_of(larger), profile).steps(profile), made.steps(profile), Number(0),
                0);
  }
}

// What a slot has that a pocket with smaller corners has not: the judge sees the difference where
// the tool does.
RC_GTEST_PROP(SinumerikPocketRelations, ASlotDoesNotClearTheCornersOfAPocket, ()) {
  Pocket slot = some_pocket();
  slot.type = 1;
  slot.corner = std::min(slot.length, slot.width) / 2;
  Pocket square = slot;
  square.corner = 0;
  const reference::Profile profile = machine_at({});
  for (const Maker make : makers()) {
    const Verdict too_little =
        judged(program_of(square), profile, make(program_of(slot), profile).records);
    RC_ASSERT(too_little.kind == oracle::VerdictKind::fail_region);
    const Verdict too_much =
        judged(program_of(slot), profile, make(program_of(square), profile).records);
    RC_ASSERT(too_much.kind == oracle::VerdictKind::fail_region);
  }
}

}  // namespace
}  // namespace gonogo::expanders::testing
