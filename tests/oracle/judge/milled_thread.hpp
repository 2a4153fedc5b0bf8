// SPDX-License-Identifier: GPL-3.0-or-later
//
// The threads of the manual's own examples as somebody may mill them. G18: p = Z, q = X, d = Y;
// clockwise goes from +Z to -X. G114: centre Z0 X0, R plane Y15, bottom Y-5, lead 5: four turns;
// rho_0 = 15 + 3 = 18, two passes at 17.5 and 17, J 2, K 30. G116: centre Z70 X35, R plane Y25,
// bottom Y5; rho_0 = 7.5 - 3 = 4.5, passes at 5 and 5.5.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "judging.hpp"

namespace gonogo::oracle {

inline constexpr std::string_view kExternal =
    "G0 X70 Z70 Y20\nG18\nG114 X0 Z0 V-20 R-5 I5 J2 K30 E30 P1 Q0.5 D3 F900\nG0 X70\n";
inline constexpr std::string_view kInternal =
    "G0 X70 Z70 Y30\nG18\nG116 X70 Z70 V-20 R-5 I5 J2 K30 E15 P1 Q0.5 D3 F900\nG0 X80\n";

// One thread as somebody may mill it; the members are what the tests change.
struct Thread {
  bool external = true;
  double centre_z = 0;
  double centre_x = 0;
  double initial = 20;
  double r_plane = 15;
  std::vector<double> radii = {17.5, 17};

  double start_degrees = 0;  // of the helices, counterclockwise from +Z
  int sense = -1;
  double lead = 5;
  double bottom = -5;
  double turns = 4;
  int pieces = 1;
  double feed = 900;
  double run_out_radius = 2;    // J, to the free side
  double run_out_degrees = 30;  // K
  enum class RunOut { arc, three_chords, line, radial, tangent, none } run_out = RunOut::arc;
  enum class Return { to_r_plane, to_initial, none, tilted } way_back = Return::to_r_plane;
  double start_radius = 18;  // rho_0
  double safe = 20;          // along p from the centre
  bool near_side = false;    // of the axis, where the run-out ended
  enum class Entry { semicircle, two_arcs, chords, flat_arc, none } entry = Entry::semicircle;
  bool infeed_by_arc = false;
  bool mixed_run_outs = false;  // the passes behind the first leave radially
  int decimals = 9;

  struct Point {
    double z;
    double x;
  };
  Point at(double radius, double degrees) const {
    const double angle = degrees * std::numbers::pi / 180;
    return {centre_z + radius * std::cos(angle), centre_x + radius * std::sin(angle)};
  }

  // Turns clockwise about the middle of the chord, or about a point to the side of it.
  void enter(TraceText& trace, Point from) const {
    const Point to = at(start_radius, start_degrees);
    const double z = (from.z + to.z) / 2;
    const double x = (from.x + to.x) / 2;
    switch (entry) {
      case Entry::semicircle:
        trace.arc("G18", {{'z', z}, {'x', x}}, sense, {{'z', to.z}, {'x', to.x}});
        break;
      case Entry::flat_arc:  // its centre lies as far beside the chord as the chord is long
        trace.arc("G18", {{'z', z + (to.x - from.x)}, {'x', x - (to.z - from.z)}}, -1,
                  {{'z', to.z}, {'x', to.x}});
        break;
      case Entry::two_arcs:
        trace.arc("G18", {{'z', z}, {'x', x}}, -1, {{'z', z - (to.x - x)}, {'x', x + (to.z - z)}});
        trace.arc("G18", {{'z', z}, {'x', x}}, -1, {{'z', to.z}, {'x', to.x}});
        break;
      case Entry::chords:
        for (int i = 1; i <= 100; ++i) {
          const double turn = -std::numbers::pi * i / 100;
          const double cosine = std::cos(turn);
          const double sine = std::sin(turn);
          trace.feed({{'z', z + (from.z - z) * cosine - (from.x - x) * sine},
                      {'x', x + (from.z - z) * sine + (from.x - x) * cosine}});
        }
        break;
      case Entry::none:
        break;
    }
  }

  void infeed(TraceText& trace, double radius) const {
    const Point start = at(radius, start_degrees);
    if (!infeed_by_arc) {
      trace.feed({{'z', start.z}, {'x', start.x}});
      return;
    }
    const Point from = at(start_radius, start_degrees);
    trace.arc("G18", {{'z', (from.z + start.z) / 2}, {'x', (from.x + start.x) / 2}},
              external ? -sense : sense, {{'z', start.z}, {'x', start.x}});
  }

  void helix(TraceText& trace, double radius) const {
    for (int i = 1; i <= pieces; ++i) {
      const double part = turns * i / pieces;
      const Point to = at(radius, start_degrees + sense * part * 360);
      const double down = part * lead * (bottom < r_plane ? -1 : 1);
      const int whole = static_cast<int>(std::ceil(turns / pieces - 1e-9));
      trace.arc("G18", {{'z', centre_z}, {'x', centre_x}}, sense * whole,
                {{'z', to.z}, {'x', to.x}, {'y', r_plane + down}});
    }
  }

  // Returns where it ends.
  Point leave(TraceText& trace, double radius) const {
    const double end_degrees = start_degrees + sense * turns * 360;
    const Point from = at(radius, end_degrees);
    const double side = external ? 1 : -1;
    const double k = run_out_degrees;
    const double normal = external ? end_degrees : end_degrees + 180;
    auto straight = [&](double degrees) {
      const double angle = degrees * std::numbers::pi / 180;
      return Point{from.z + run_out_radius * std::cos(angle),
                   from.x + run_out_radius * std::sin(angle)};
    };
    const double turn = external ? sense : -sense;  // from the normal toward the feed
    Point to = at(radius + side * run_out_radius, end_degrees + sense * k);
    switch (run_out) {
      case RunOut::none:
        return from;
      case RunOut::line:
        break;
      case RunOut::radial:
        to = straight(normal + turn * k);
        break;
      case RunOut::tangent:
        to = straight(normal + turn * (90 - k));
        break;
      case RunOut::arc:
      case RunOut::three_chords: {
        const double end = radius + side * run_out_radius;
        const double cosine = std::cos(k * std::numbers::pi / 180);
        const double a = end * cosine - radius;
        const double w = (radius * radius + end * end - 2 * radius * end * cosine) / (2 * a);
        const Point middle = at(radius + w, end_degrees);
        if (run_out == RunOut::three_chords) {
          const double begin = std::atan2(from.x - middle.x, from.z - middle.z);
          const double turn_by = std::remainder(
              std::atan2(to.x - middle.x, to.z - middle.z) - begin, 2 * std::numbers::pi);
          for (int i = 1; i <= 3; ++i) {
            const double angle = begin + turn_by * i / 3;
            trace.feed({{'z', middle.z + std::abs(w) * std::cos(angle)},
                        {'x', middle.x + std::abs(w) * std::sin(angle)}});
          }
          return to;
        }
        trace.arc("G18", {{'z', middle.z}, {'x', middle.x}}, a < 0 ? sense : -sense,
                  {{'z', to.z}, {'x', to.x}});
        return to;
      }
    }
    trace.feed({{'z', to.z}, {'x', to.x}});
    return to;
  }

  std::string text() const {
    TraceText trace(1, feed);
    trace.decimals(decimals);
    trace.rapid({{'x', 35}, {'z', 70}, {'y', initial}});
    trace.block(3, feed);
    if (centre_z != 70) trace.rapid({{'x', centre_x}, {'z', centre_z}});
    trace.rapid({{'y', r_plane}});
    Point from = {centre_z, centre_x};
    for (double radius : radii) {
      enter(trace, from);
      infeed(trace, radius);
      helix(trace, radius);
      Thread pass = *this;
      if (mixed_run_outs && radius != radii.front()) pass.run_out = RunOut::radial;
      from = pass.leave(trace, radius);
      if (way_back == Return::none) continue;
      from.z = centre_z + (near_side && from.z < centre_z ? -safe : safe);
      if (way_back == Return::tilted) {
        trace.rapid({{'z', from.z}, {'y', r_plane}});
        continue;
      }
      const bool high = way_back == Return::to_initial && radius == radii.back();
      trace.rapid({{'y', high ? initial : r_plane}});
      if (!high) trace.rapid({{'z', from.z}});
    }
    if (way_back != Return::to_initial) trace.rapid({{'y', initial}});
    trace.block(4, feed).rapid({{'x', centre_z == 70 ? 40.0 : 35.0}});
    return trace.text();
  }
};

inline Thread internal() {
  Thread thread;
  thread.external = false;
  thread.centre_z = 70;
  thread.centre_x = 35;
  thread.initial = 30;
  thread.r_plane = 25;
  thread.bottom = 5;
  thread.radii = {5, 5.5};
  thread.start_radius = 4.5;
  thread.safe = 2.5;
  return thread;
}

inline Verdict judge(const Thread& thread, const Judging& judging = {}) {
  return judge_trace(thread.external ? kExternal : kInternal, thread.text(), judging);
}

inline void expect_go(const Thread& thread, const Judging& judging = {}) {
  const Verdict verdict = judge(thread, judging);
  EXPECT_EQ(decision(verdict.kind), Decision::go)
      << name(verdict.kind) << " " << verdict.message << "\nwant " << verdict.want << "\ngot "
      << verdict.got << "\nwitness " << verdict.witness;
}

// `says`: a part of the message, which names the defect.
inline void expect_no_go(const Thread& thread, std::string_view clause, std::string_view says,
                         const Judging& judging = {}) {
  const Verdict verdict = judge(thread, judging);
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_EQ(reference::clause_name(verdict.clause), clause) << verdict.message;
  EXPECT_NE(verdict.message.find(says), std::string::npos) << verdict.message;
  EXPECT_FALSE(verdict.witness.empty());
  EXPECT_EQ(verdict.block, 3U);
}

}  // namespace gonogo::oracle
