// SPDX-License-Identifier: GPL-3.0-or-later
//
// G114 to G117 derived by hand from the manual, against the vectors. The path that is shown: a
// semicircle to rho_0 on +p, straight in to the radius r_n of the pass, the helix, the run-out, up
// to the R plane, along p to rho_0 + J (external) or rho_0 - J (internal).
//
// A polar run-out ends at the radius e = r_n + J or r_n - J, K further round. Its arc touches the
// helix: with a = e cos K - r_n its centre lies w = (r_n^2 + e^2 - 2 r_n e cos K) / (2 a) beyond
// the helix's end, seen from the thread's centre; it turns as the thread where a < 0.
#include <gtest/gtest.h>

#include "derived.hpp"

namespace gonogo::testing {
namespace {

// rho_0 = 15 + 3 = 18, r_n = 17.5 and 17; V-20 from the R plane: Y15 to Y-5, four turns.
const Lines kExternalStart = {"1 rapid x35 y20 z70", "3 rapid x0 z0", "3 rapid y15",
                              "3 arc G18 -1 cx0 cz9 x0 z18 f900"};
const Lines kExternalFirst = {"3 feed z17.5 f900", "3 arc G18 -4 cx0 cz0 x0 y-5 z17.5 f900"};
const Lines kExternalSecond = {"3 feed z17 f900", "3 arc G18 -4 cx0 cz0 x0 y-5 z17 f900"};

TEST(DerivedG114, TheExampleOfTheManualWithoutItsRunOut) {
  const Lines want = kExternalStart + kExternalFirst + Lines{"3 rapid y15", "3 rapid z18"} +
                     kExternalSecond +
                     Lines{"3 rapid y15", "3 rapid z18", "3 rapid y20", "end x0 y20 z18 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.000005"), want);
}

TEST(DerivedG114, TheExampleOfTheManual) {
  // J2 K30. e = 19.5: ends at Z 19.5 cos 30 = 9.75 sqrt 3, X -9.75. a = 9.75 sqrt 3 - 17.5,
  // w = (686.5 - 341.25 sqrt 3) / (2 a) = -(16257.5 + 5772 sqrt 3) / 337.
  // e = 19: Z 9.5 sqrt 3, X -9.5; w = (650 - 323 sqrt 3) / (19 sqrt 3 - 34)
  //       = -(3689 + 1368 sqrt 3) / 73. Safe: Z20.
  const Lines want =
      kExternalStart + kExternalFirst +
      Lines{"3 arc G18 -1 cx0 cz-10360/337 - 5772/337*sqrt(3) x-9.75 z9.75*sqrt(3) f900",
            "3 rapid y15", "3 rapid z20", "3 arc G18 -1 cx-4.875 cz19 x0 z18 f900"} +
      kExternalSecond +
      Lines{"3 arc G18 -1 cx0 cz-2448/73 - 1368/73*sqrt(3) x-9.5 z9.5*sqrt(3) f900", "3 rapid y15",
            "3 rapid z20", "3 rapid y20", "end x-9.5 y20 z20 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.000001"), want);
  EXPECT_EQ(records_of("gsk.g114.reading.000009"), want);
}

TEST(DerivedG114, TheExampleWithARadialRunOut) {
  // 2 long, 30 degrees from +Z towards the feed at the helix's end, which is -X.
  const Lines want = kExternalStart + kExternalFirst +
                     Lines{"3 feed x-1 z17.5 + sqrt(3) f900", "3 rapid y15", "3 rapid z20",
                           "3 arc G18 -1 cx-0.5 cz19 x0 z18 f900"} +
                     kExternalSecond +
                     Lines{"3 feed x-1 z17 + sqrt(3) f900", "3 rapid y15", "3 rapid z20",
                           "3 rapid y20", "end x-1 y20 z20 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.reading.000018"), want);
}

TEST(DerivedG114, TheExampleWithATangentRunOut) {
  // 2 long, 30 degrees from -X towards +Z.
  const Lines want = kExternalStart + kExternalFirst +
                     Lines{"3 feed x-sqrt(3) z18.5 f900", "3 rapid y15", "3 rapid z20",
                           "3 arc G18 -1 cx-0.5*sqrt(3) cz19 x0 z18 f900"} +
                     kExternalSecond +
                     Lines{"3 feed x-sqrt(3) z18 f900", "3 rapid y15", "3 rapid z20", "3 rapid y20",
                           "end x-sqrt(3) y20 z20 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.reading.000024"), want);
}

TEST(DerivedG114, TheInternalExampleOfTheManual) {
  // rho_0 = 7.5 - 3 = 4.5, r_n = 5 and 5.5 about Z70 X35; Y25 to Y5. J2 K30:
  // e = 3: X 35 - 1.5, Z 70 + 1.5 sqrt 3; r + w = (160 + 48 sqrt 3) / 73.
  // e = 3.5: X 35 - 1.75, Z 70 + 1.75 sqrt 3; r + w = (792 + 252 sqrt 3) / 337. Safe: Z72.5.
  const Lines want = {"1 rapid x35 y30 z70",
                      "3 rapid x35 z70",
                      "3 rapid y25",
                      "3 arc G18 -1 cx35 cz72.25 x35 z74.5 f900",
                      "3 feed z75 f900",
                      "3 arc G18 -4 cx35 cz70 x35 y5 z75 f900",
                      "3 arc G18 -1 cx35 cz5270/73 + 48/73*sqrt(3) x33.5 z70 + 1.5*sqrt(3) f900",
                      "3 rapid y25",
                      "3 rapid z72.5",
                      "3 arc G18 -1 cx34.25 cz73.5 x35 z74.5 f900",
                      "3 feed z75.5 f900",
                      "3 arc G18 -4 cx35 cz70 x35 y5 z75.5 f900",
                      ("3 arc G18 -1 cx35 cz24382/337 + 252/337*sqrt(3) x33.25 z70 + 1.75*sqrt(3) "
                       "f900"),
                      "3 rapid y25",
                      "3 rapid z72.5",
                      "3 rapid y30",
                      "end x33.25 y30 z72.5 a0 c0"};
  EXPECT_EQ(records_of("gsk.g116.000001"), want);
}

TEST(DerivedG114, TheInternalExampleWithoutItsRunOut) {
  const Lines want = {"1 rapid x35 y30 z70", "3 rapid x35 z70",
                      "3 rapid y25",         "3 arc G18 -1 cx35 cz72.25 x35 z74.5 f900",
                      "3 feed z75 f900",     "3 arc G18 -4 cx35 cz70 x35 y5 z75 f900",
                      "3 rapid y25",         "3 rapid z74.5",
                      "3 feed z75.5 f900",   "3 arc G18 -4 cx35 cz70 x35 y5 z75.5 f900",
                      "3 rapid y25",         "3 rapid z74.5",
                      "3 rapid y30",         "end x35 y30 z74.5 a0 c0"};
  EXPECT_EQ(records_of("gsk.g116.000005"), want);
}

// The threads "X20 Y10 E24 D3" in G17: rho_0 = 12 + 3 = 15 about X10 Y10.
Lines entry(const std::string& r_plane, const std::string& sense = "-1") {
  return {"1 rapid x20 y30 z10", "2 rapid x10 y10", "2 rapid z" + r_plane,
          "2 arc G17 " + sense + " cx17.5 cy10 x25 y10 f200"};
}
// W-4 R-1 I2: two turns from 9 to 5.
Lines whole_pass(const std::string& x) {
  return {"2 feed x" + x + " f200", "2 arc G17 -2 cx10 cy10 x" + x + " y10 z5 f200"};
}
const Lines kBack = {"2 rapid z9", "2 rapid x25"};

TEST(DerivedG114, ALastPassOfOneIncrement) {
  const Lines want = entry("9") + whole_pass("24.001") + kBack + whole_pass("24") + kBack +
                     Lines{"2 rapid z10", "end x25 y10 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.000049"), want);
}

TEST(DerivedG114, TenPassesOfATenth) {
  Lines want = entry("9");
  for (const char* x :
       {"24.9", "24.8", "24.7", "24.6", "24.5", "24.4", "24.3", "24.2", "24.1", "24"}) {
    want = want + whole_pass(x) + kBack;
  }
  EXPECT_EQ(records_of("gsk.g114.000054"), (want + Lines{"2 rapid z10", "end x25 y10 z10 a0 c0"}));
}

TEST(DerivedG114, AQuarterOfATurnOverTwo) {
  // 2 1/4 turns clockwise from +p end at -q: Y 10 - 14. A third turn has begun: rot -3.
  const Lines want =
      entry("10") + Lines{"2 feed x24 f200", "2 arc G17 -3 cx10 cy10 x10 y-4 z5.5 f200",
                          "2 rapid z10",     "2 rapid x25",
                          "2 rapid z10",     "end x25 y-4 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.000075"), want);
}

TEST(DerivedG114, AQuarterOfATurnCounterclockwise) {
  // Passes at 14.4 and 14, which end at +q; from there back to +p about the middle of the chord.
  const Lines want = entry("10", "1") + Lines{"2 feed x24.4 f200",
                                              "2 arc G17 3 cx10 cy10 x10 y24.4 z5.5 f200",
                                              "2 rapid z10",
                                              "2 rapid x25",
                                              "2 arc G17 1 cx25 cy17.2 x25 y10 f200",
                                              "2 feed x24 f200",
                                              "2 arc G17 3 cx10 cy10 x10 y24 z5.5 f200",
                                              "2 rapid z10",
                                              "2 rapid x25",
                                              "2 rapid z10",
                                              "end x25 y24 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.000076"), want);
}

TEST(DerivedG114, AThirdOfATurn) {
  // 120 degrees clockwise at radius 14: X 10 - 7, Y 10 - 7 sqrt 3.
  const Lines want =
      entry("10") + Lines{"2 feed x24 f200", "2 arc G17 -1 cx10 cy10 x3 y10 - 7*sqrt(3) z9 f200",
                          "2 rapid z10",     "2 rapid x25",
                          "2 rapid z10",     "end x25 y10 - 7*sqrt(3) z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.000079"), want);
}

TEST(DerivedG114, Upward) {
  // The sense is the commanded one, whichever way the thread goes: 10 to 14.5.
  const Lines want =
      entry("10") + Lines{"2 feed x24 f200", "2 arc G17 -3 cx10 cy10 x10 y-4 z14.5 f200",
                          "2 rapid z10",     "2 rapid x25",
                          "2 rapid z10",     "end x25 y-4 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.000098"), want);
}

// P1 Q0.5 J2: e = 16.5 and 16 on r = 14.5 and 14; safe at X27.
const Lines kSafe = {"2 rapid z9", "2 rapid x27"};

TEST(DerivedG114, KZeroLeavesByASemicircle) {
  // a = J, w = 1: outwards, against the sense of the thread.
  const Lines want = entry("9") + whole_pass("24.5") +
                     Lines{"2 arc G17 1 cx25.5 cy10 x26.5 y10 f200"} + kSafe +
                     Lines{"2 arc G17 -1 cx26 cy10 x25 y10 f200"} + whole_pass("24") +
                     Lines{"2 arc G17 1 cx25 cy10 x26 y10 f200"} + kSafe +
                     Lines{"2 rapid z10", "end x27 y10 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.000106"), want);
}

TEST(DerivedG114, KNinety) {
  // a = -r. w = -482.5/29: centre 10 + 14.5 - 482.5/29 = 228/29; w = -452/28: centre 55/7.
  const Lines want = entry("9") + whole_pass("24.5") +
                     Lines{"2 arc G17 -1 cx228/29 cy10 x10 y-6.5 f200"} + kSafe +
                     Lines{"2 arc G17 -1 cx26 cy1.75 x25 y10 f200"} + whole_pass("24") +
                     Lines{"2 arc G17 -1 cx55/7 cy10 x10 y-6 f200"} + kSafe +
                     Lines{"2 rapid z10", "end x27 y-6 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.000112"), want);
}

TEST(DerivedG114, K180) {
  // Half round: a = -(r + e), w = -(r + e)/2 = -15.5 and -15, both about X9.
  const Lines want = entry("9") + whole_pass("24.5") +
                     Lines{"2 arc G17 -1 cx9 cy10 x-6.5 y10 f200"} + kSafe +
                     Lines{"2 arc G17 -1 cx26 cy10 x25 y10 f200"} + whole_pass("24") +
                     Lines{"2 arc G17 -1 cx9 cy10 x-6 y10 f200"} + kSafe +
                     Lines{"2 rapid z10", "end x27 y10 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.000114"), want);
}

TEST(DerivedG114, JAndKFromTheParameters) {
  // 5921 = 2, 5920 = 90, passes at 14.4 and 14: w = -476.32/28.8, centre 283/36; then as above.
  const Lines want = entry("9") + whole_pass("24.4") +
                     Lines{"2 arc G17 -1 cx283/36 cy10 x10 y-6.4 f200"} + kSafe +
                     Lines{"2 arc G17 -1 cx26 cy1.8 x25 y10 f200"} + whole_pass("24") +
                     Lines{"2 arc G17 -1 cx55/7 cy10 x10 y-6 f200"} + kSafe +
                     Lines{"2 rapid z10", "end x27 y-6 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.reading.000036"), want);
}

TEST(DerivedG114, InternalKNinety) {
  // E20: rho_0 = 7, r = 7.5 and 8, e = 5.5 and 6. w = -86.5/15: centre 176/15; w = -6.25.
  const Lines want = {"1 rapid x20 y30 z10",
                      "2 rapid x10 y10",
                      "2 rapid z9",
                      "2 arc G17 -1 cx13.5 cy10 x17 y10 f200",
                      "2 feed x17.5 f200",
                      "2 arc G17 -2 cx10 cy10 x17.5 y10 z5 f200",
                      "2 arc G17 -1 cx176/15 cy10 x10 y4.5 f200",
                      "2 rapid z9",
                      "2 rapid x15",
                      "2 arc G17 -1 cx16 cy7.25 x17 y10 f200",
                      "2 feed x18 f200",
                      "2 arc G17 -2 cx10 cy10 x18 y10 z5 f200",
                      "2 arc G17 -1 cx11.75 cy10 x10 y4 f200",
                      "2 rapid z9",
                      "2 rapid x15",
                      "2 rapid z10",
                      "end x15 y4 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g116.000072"), want);
}

TEST(DerivedG114, InInch) {
  // R plane 0.4 in, bottom -0.1 in: 0.5 in, five turns. rho_0 = 0.5 in, r = 0.47 and 0.45 in.
  const Lines back = {"2 rapid z10.16", "2 rapid x25.4"};
  const Lines want =
      Lines{"1 rapid x25.4 y25.4 z12.7",
            "2 rapid x12.7 y12.7",
            "2 rapid z10.16",
            "2 arc G17 -1 cx19.05 cy12.7 x25.4 y12.7 f254",
            "2 feed x24.638 f254",
            "2 arc G17 -5 cx12.7 cy12.7 x24.638 y12.7 z-2.54 f254"} +
      back + Lines{"2 feed x24.13 f254", "2 arc G17 -5 cx12.7 cy12.7 x24.13 y12.7 z-2.54 f254"} +
      back + Lines{"2 rapid z12.7", "end x25.4 y12.7 z12.7 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.000180"), want);
}

TEST(DerivedG114, WithoutDepthNothingIsCut) {
  const Lines want = {"1 rapid x20 y30 z10", "2 rapid x10 y10", "2 rapid z5", "2 rapid z10",
                      "end x10 y10 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.000176"), want);
}

TEST(DerivedG114, IncrementsCountFromWhereTheThreadEnds) {
  // P1 Q0.6: 14.4 and 14; the tool stands at X25 Y10. U10 is 5, V20: the next centre is X30 Y30.
  const Lines want = entry("9") + whole_pass("24.4") + kBack + whole_pass("24") + kBack +
                     Lines{"2 rapid z10",     "3 rapid x30 y30",
                           "3 rapid z10",     "3 arc G17 -1 cx37.5 cy30 x45 y30 f200",
                           "3 feed x44 f200", "3 arc G17 -2 cx30 cy30 x44 y30 z6 f200",
                           "3 rapid z10",     "3 rapid x45",
                           "3 rapid z10",     "end x45 y30 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g114.000215"), want);
}

}  // namespace
}  // namespace gonogo::testing
