// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-CMP-09: pass-exact is said of a path that was compared from beginning to end. What the manual
// leaves open is pass-properties, with the number of motions that only properties bound.
#include <gtest/gtest.h>

#include "judging.hpp"
#include "own_outcome.hpp"

namespace gonogo::oracle {
namespace {

void expect_properties(const Verdict& verdict, std::size_t motions) {
  EXPECT_EQ(verdict.kind, VerdictKind::pass_properties) << verdict.message;
  EXPECT_EQ(verdict.property_motions, motions);
}

TEST(PropertyVerdict, APathThatIsComparedIsExact) {
  const Verdict verdict =
      judge_own("G00 X130 Z5\nG94 X100 Z-28 R-15 F100\nX80\n", profile_of("gsk988ta"));
  EXPECT_EQ(verdict.kind, VerdictKind::pass_exact) << verdict.message;
  EXPECT_EQ(verdict.property_motions, 0U);
}

// Four rings about Z50 X25, each a straight cut out to it and a circle. The plunge and the ways to
// and from the pocket are compared.
TEST(PropertyVerdict, TheMotionsOfALevelAreCounted) {
  TraceText trace(1, 800);
  trace.rapid({{'x', 35}, {'y', 50}, {'z', 70}}).block(2, 800);
  trace.rapid({{'x', 25}, {'z', 50}}).rapid({{'y', 45}}).feed({{'y', 40}});
  for (const int radius : {3, 6, 9, 12}) {
    const double z = 50 + radius;
    trace.feed({{'z', z}}).arc("G18", {{'x', 25}, {'z', 50}}, -1, {{'x', 25}, {'z', z}});
  }
  trace.rapid({{'y', 45}}).rapid({{'x', 25}, {'z', 50}}).rapid({{'y', 50}});
  expect_properties(
      judge_trace("G18 G0 X70 Z70 Y50\nG110 X50 Z50 Y40 R-5 I16 L3 Q5 P1 D4 F800\n", trace.text()),
      8);
}

// In by a semicircle, five turns down, out by a semicircle.
TEST(PropertyVerdict, TheMotionsOfAHelicalPocketAreCounted) {
  TraceText trace(1, 200);
  trace.rapid({{'x', 35}, {'y', 30}, {'z', 70}}).block(3, 200);
  trace.arc("G18", {{'z', 72}, {'x', 35}}, -1, {{'z', 74}, {'x', 35}});
  trace.arc("G18", {{'z', 70}, {'x', 35}}, -5, {{'z', 74}, {'x', 35}, {'y', 20}});
  trace.arc("G18", {{'z', 72}, {'x', 35}}, -1, {{'z', 70}, {'x', 35}});
  trace.rapid({{'y', 30}});
  trace.block(4, 0).rapid({{'x', 40}});
  expect_properties(
      judge_trace("G00 X70 Z70 Y30\nG18\nG112 X70 Z70 Y20 I8 L5 D4 F200\nG00 X80\n", trace.text()),
      3);
}

// A centre 0.9 of a micrometre off is within the tolerance of a path that was never compared.
TEST(PropertyVerdict, AThreadWhoseCentreIsOffIsNoExactPath) {
  constexpr std::string_view kThread =
      "G0 X70 Z70 Y20\nG18\nG114 X0 Z0 V-20 R-5 I5 J2 K30 E30 P1 Q0.5 D3 F900\nG0 X70\n";
  const reference::Profile profile = profile_of("gsk988ta");
  const Tolerances tolerances = exact_terms(profile);
  OwnOutcome own = own_outcome(kThread, profile);
  const Verdict shown = judge_outcome(profile, kThread, tolerances, own.records, own.end).verdict;
  EXPECT_EQ(shown.kind, VerdictKind::pass_properties) << shown.message;
  EXPECT_GT(shown.property_motions, 0U);
  std::size_t helices = 0;
  for (Record& record : own.records) {
    if (record.kind != RecordKind::arc || !record.axes.has(Axis::y)) continue;
    record.centre[0] += Number::millionths(900);
    ++helices;
  }
  EXPECT_EQ(helices, 2U);
  const Verdict off = judge_outcome(profile, kThread, tolerances, own.records, own.end).verdict;
  EXPECT_EQ(off.kind, VerdictKind::pass_properties) << off.message;
  EXPECT_EQ(off.property_motions, shown.property_motions);
}

}  // namespace
}  // namespace gonogo::oracle
