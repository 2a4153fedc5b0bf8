// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-PKT-06: a level goes round the middle of its pocket as commanded, in any pieces. I16
// L3 D4 clockwise: E has radius 12, rings at 3, 6, 9, 12, tolerance 0.001.
#include <cmath>
#include <numbers>

#include "oracle/region/arc.hpp"
#include "tests/oracle/region/expectations.hpp"

namespace gonogo::oracle::region {
namespace {

// A rational point of the unit circle near the angle: of half the tangent t it is
// ((1 - t^2), 2 t) / (1 + t^2).
PlanePoint unit_at(double angle) {
  const Number t = Number::millionths(std::llround(std::tan(angle / 2) * 1e6));
  const Number below = Number(1) + t * t;
  return {(Number(1) - t * t) / below, Number(2) * t / below};
}

PlanePoint times(const PlanePoint& point, const Number& factor) {
  return {point.p * factor, point.q * factor};
}

// The middle of a chord lies on the ray on which all centres of arcs over it lie: `centre` is how
// many times as far from the middle of the ring.
struct Pieces {
  int count = 260;
  Number centre = 70;
  bool clockwise = false;
};

// A ring in arcs that each turn clockwise, after a link straight out. With the centre outside they
// bulge to the middle, and the way round is the other one.
void ring_in_arcs(Job& job, const Number& radius, const Pieces& pieces) {
  const auto place = [&](int k) {
    const double part = (k % pieces.count + 0.5) / pieces.count;
    return times(unit_at((pieces.clockwise ? -1 : 1) * std::numbers::pi * (2 * part - 1)), radius);
  };
  line_to(job, place(0));
  for (int k = 1; k <= pieces.count; ++k) {
    const PlanePoint middle = times(place(k - 1) + place(k), Number(1) / Number(2));
    arc_to(job, place(k), times(middle, pieces.centre), -1);
  }
}

Job rings_in_arcs(const Pieces& pieces) {
  Job job{i16_l3_d4(), {}};
  for (const int radius : {3, 6, 9, 12}) ring_in_arcs(job, radius, pieces);
  return job;
}

TEST(Winding, CounterclockwiseInClockwiseArcsBreaksSense) {
  for (const int count : {3, 8, 60}) {
    for (const int centre : {3, 70}) {
      EXPECT_TRUE(breaks(Rule::sense, rings_in_arcs({count, centre}))) << count << " " << centre;
    }
  }
  EXPECT_TRUE(breaks(Rule::sense, rings_in_arcs({})));
}

TEST(Winding, OneRingOfManyTheOtherWayBreaksSense) {
  for (const int wrong : {3, 6, 9, 12}) {
    Job job{i16_l3_d4(), {}};
    for (const int radius : {3, 6, 9, 12}) {
      if (radius == wrong) {
        ring_in_arcs(job, radius, {60, 10});
      } else {
        circle(job, radius, {1, 0});
      }
    }
    EXPECT_TRUE(breaks(Rule::sense, job)) << wrong;
  }
}

// Over a chord of 12 / 260 of a turn, 0.29, an arc of radius 6 rises 0.0018 above it, one of 12
// 0.0009: the ring in arcs stays within the tolerance.
TEST(Winding, ClockwiseInClockwiseArcsIsGo) {
  for (const std::string_view centre : {"0.5", "0"}) {
    const LevelVerdict verdict = judge(rings_in_arcs({260, mm(centre), true}));
    EXPECT_EQ(verdict.kind, LevelVerdict::Kind::go) << centre << verdict.gap;
  }
}

// 3.1 mm further for each turn, the other way round, in arcs over a sixtieth of a turn.
TEST(Winding, ASpiralTheOtherWayBreaksSense) {
  Job job{i16_l3_d4(), {}};
  for (int k = 1; k <= 120; ++k) {
    const Number radius = mm("3.1") * Number(k) / Number(60) + Number(1);
    const double angle = 2 * std::numbers::pi * ((k % 60 + 0.5) / 60 - 0.5);
    const PlanePoint from = job.motions.empty() ? PlanePoint{} : job.motions.back().to;
    const PlanePoint to = times(unit_at(angle), radius);
    const PlanePoint middle = times(from + to, Number(1) / Number(2));
    const PlanePoint aside{to.q - from.q, from.p - to.p};  // right of the chord
    k == 1 ? line_to(job, to) : arc_to(job, to, middle + times(aside, 20), -1);
  }
  EXPECT_TRUE(breaks(Rule::sense, job));
}

// Straight, with a small clockwise circle at each corner: what clears is the circles alone.
TEST(Winding, ChordsWithSmallArcsBetweenBreakSense) {
  for (const std::string_view chord : {"0", "0.002"}) {
    Job job{i16_l3_d4(), {}};
    job.level.chord = mm(chord);
    for (const int radius : {3, 6, 9, 12}) {
      for (int k = 0; k <= 260; ++k) {
        const PlanePoint place =
            times(unit_at(std::numbers::pi * ((k % 260 + 0.5) / 130 - 1)), Number(radius));
        line_to(job, place);
        arc_to(job, place, times(place, mm("0.999")), -1);
      }
    }
    EXPECT_TRUE(breaks(Rule::sense, job)) << chord;
  }
}

// From ring to ring in a bow of radius 1.5, which first leads back by asin(1.5 / 4.5), 19 degrees.
TEST(Winding, BowsFromRingToRingAreGo) {
  Job job = concentric(i16_l3_d4(), {3});
  for (const int radius : {6, 9, 12}) {
    const Number outer = radius;
    arc_to(job, {outer, 0}, {outer - mm("1.5"), 0}, -1);
    arc_to(job, {outer, 0}, {}, -1);
  }
  EXPECT_TRUE(is_go(job));
}

// Half a ring, and straight back across the middle: half a turn forth, at most half a turn back.
TEST(Winding, HalfRingsOneWayAreGo) {
  Job job{i16_l3_d4(), {}};
  for (const int side : {1, -1}) {
    for (const int radius : {3, 6, 9, 12}) {
      line_to(job, {side * radius, mm("0.0005")});
      line_to(job, {side * radius, 0});
      arc_to(job, {-side * radius, 0}, {}, -1);
    }
  }
  EXPECT_TRUE(is_go(job));
}

// Sixths of a ring, each as commanded, one after the other the other way round.
TEST(Winding, SectorsInTheOtherOrderAreGo) {
  Job job{i16_l3_d4(), {}};
  for (const int radius : {2, 4, 6, 9, 12}) {
    for (int k = 0; k < 6; ++k) {
      const auto place = [&](double sixths) {
        return times(unit_at(std::numbers::pi * (sixths + 0.3) / 3), Number(radius));
      };
      line_to(job, place(k - 3));
      arc_to(job, place(k - 4), {}, -1);
    }
  }
  EXPECT_TRUE(is_go(job));
}

// Half of the last ring: too little for a turn, but it runs along the border.
TEST(Winding, HalfOfTheLastRingTheOtherWayBreaksSense) {
  Job job = concentric(i16_l3_d4(), {3, 6, 9, 12});
  Job back{i16_l3_d4(), {}};
  ring_in_arcs(back, 12, {260, 70});
  back.motions.resize(131);
  for (const LevelMotion& motion : back.motions) {
    motion.is_arc ? arc_to(job, motion.to, motion.centre, -1) : line_to(job, motion.to);
  }
  EXPECT_TRUE(breaks(Rule::sense, job));
}

}  // namespace
}  // namespace gonogo::oracle::region
