// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers that must be whole: P of an arc, M functions, G codes times ten (NGC-COM-01, NGC-ARC-05).
#include <gtest/gtest.h>

#include "ngc_expanding.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

Profile nist() {
  return ngc({{"ngc.whole", "nist"}});
}
Profile by_linuxcnc() {
  return ngc({{"ngc.whole", "linuxcnc"}});
}

Profile by_grbl() {
  return ngc({{"ngc.whole", "grbl"}});
}

// How an arc with this P ends: an alarm, or its turns.
std::string turns(const std::string& p, const Profile& profile = ngc()) {
  const std::string last = path("F9\nG2 X2 I1 P" + p, profile).back();
  if (!last.starts_with("arc")) return last;
  return last.substr(last.find("rot"), last.find(" f") - last.find("rot"));
}
std::string code(const std::string& g, const Profile& profile = ngc()) {
  return path("F9\nG" + g + " X1", profile).back();
}
std::string function(const std::string& m, const Profile& profile = ngc()) {
  return lines("M" + m, profile).back();
}

constexpr const char* kNotWhole = "alarm b2 not-an-integer";
constexpr const char* kUndefined = "alarm b2 undefined-code";

TEST(NgcWhole, ByDefaultIsExactlyWhole) {
  EXPECT_EQ(turns("3.000"), "rot-3");
  EXPECT_EQ(turns("2.9999"), kNotWhole);
  EXPECT_EQ(turns("3.00000000000000000001"), kNotWhole);
  EXPECT_EQ(turns("-0.0001"), "alarm b2 value-sign not-an-integer");
  EXPECT_EQ(code("1.0"), "feed x1 f9");
  EXPECT_EQ(code("1.00001"), kUndefined);
  EXPECT_EQ(function("8.0"), "m8");
  EXPECT_EQ(function("8.00001"), "alarm b1 not-an-integer");
}

// NISTIR 6556, 3.3.2.1: "close enough if it is within 0.0001 of an integer".
TEST(NgcWhole, OfNistTurnsAndFunctionsMayBeATenThousandthOff) {
  for (const char* three : {"2.9999", "3.0001", "3.00009999999999999999", "2.99995"}) {
    EXPECT_EQ(turns(three, nist()), "rot-3") << three;
    EXPECT_EQ(function(three, nist()), "m3") << three;
  }
  for (const char* other : {"2.9998999", "3.0001001", "3.00010000000000000001", "3.001", "3.5"}) {
    EXPECT_EQ(turns(other, nist()), kNotWhole) << other;
    EXPECT_EQ(function(other, nist()), "alarm b1 not-an-integer") << other;
  }
}

// The same: "G codes multiplied by ten", so that the code itself may be 0.00001 off.
TEST(NgcWhole, OfNistTenTimesACodeMayBeATenThousandthOff) {
  EXPECT_EQ(code("1.00001", nist()), "feed x1 f9");
  EXPECT_EQ(code("0.99999", nist()), "feed x1 f9");
  EXPECT_EQ(code("-0.00001", nist()), "rapid x1");
  EXPECT_EQ(code("1.000010000000001", nist()), kUndefined);
  EXPECT_EQ(code("0.9999899", nist()), kUndefined);
  EXPECT_EQ(code("1.0001", nist()), kUndefined);
  EXPECT_EQ(path("G0 X1\nG90.10001 G2 X3 I2 J0 F9", nist()).back(), "arc x3 y0 c2,0 rot-1 f9");
  EXPECT_EQ(code("41.09999", nist()), "not-covered b2 G41.1");
  EXPECT_EQ(code("6.00001", nist()), kUndefined);
}

// As measured of LinuxCNC 2.9: P within 0.001, ten times a G code too, M within 0.0001.
TEST(NgcWhole, OfLinuxcncItIsAThousandthButForFunctions) {
  EXPECT_EQ(turns("2.999", by_linuxcnc()), "rot-3");
  EXPECT_EQ(turns("3.001", by_linuxcnc()), "rot-3");
  EXPECT_EQ(turns("2.9989999", by_linuxcnc()), kNotWhole);
  EXPECT_EQ(turns("3.0010001", by_linuxcnc()), kNotWhole);
  EXPECT_EQ(code("1.0001", by_linuxcnc()), "feed x1 f9");
  EXPECT_EQ(code("0.9999", by_linuxcnc()), "feed x1 f9");
  EXPECT_EQ(code("1.0001001", by_linuxcnc()), kUndefined);
  EXPECT_EQ(function("7.9999", by_linuxcnc()), "m8");
  EXPECT_EQ(function("8.0001001", by_linuxcnc()), "alarm b1 not-an-integer");
}

// As grbl's parser has it: trunc(value), and round(100 * what is behind the point).
TEST(NgcWhole, GrblCutsAtThePointAndRoundsToHundredths) {
  EXPECT_EQ(code("1.004999999999999999", by_grbl()), "feed x1 f9");
  EXPECT_EQ(code("1.005", by_grbl()), kUndefined);
  EXPECT_EQ(code("0.99999", by_grbl()), kUndefined);
  EXPECT_EQ(code("-0.0049", by_grbl()), "rapid x1");
  EXPECT_EQ(code("41.095", by_grbl()), "not-covered b2 G41.1");
  EXPECT_EQ(code("41.1049", by_grbl()), "not-covered b2 G41.1");
  EXPECT_EQ(code("41.0949", by_grbl()), kUndefined);
  EXPECT_EQ(code("41.105", by_grbl()), kUndefined);
  EXPECT_EQ(function("8.0049", by_grbl()), "m8");
  EXPECT_EQ(function("8.005", by_grbl()), "alarm b1 not-an-integer");
  EXPECT_EQ(function("7.99999", by_grbl()), "alarm b1 not-an-integer");
  EXPECT_EQ(turns("3.0001", by_grbl()), kNotWhole);
}

TEST(NgcWhole, WhatCountsAsWholeIsThatNumberEverywhere) {
  EXPECT_EQ(turns("0.0001", nist()), "alarm b2 value-sign");
  EXPECT_EQ(turns("-0.0001", nist()), "alarm b2 value-sign");
  EXPECT_EQ(turns("-2.9999", nist()), "alarm b2 value-sign");
  EXPECT_EQ(ending_of("F9\nG81 Z-1 R0 L-0.00001", nist()), "alarm b2 value-out-of-range");
  EXPECT_EQ(ending_of("G17 G18.00001", nist()), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("M3 M4.0001", nist()), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("M10.0001", nist()), "alarm b1 undefined-code");
  EXPECT_EQ(ending_of("M19.0001", nist()), "not-covered b1 M19");
  EXPECT_EQ(lines("M1.9999\nM3", nist()), Lines{"m2"});
  // P belongs to M62, an output, and is no number of turns.
  EXPECT_EQ(path("F9\nG2 X2 I1 M62.0001 P0.5", nist()).back(), "arc x2 y0 c1,0 rot-1 f9");
}

TEST(NgcWhole, TooManyTurnsAreOutOfRange) {
  EXPECT_EQ(turns("2147483647"), "rot-2147483647");
  EXPECT_EQ(turns("2147483648"), "alarm b2 value-out-of-range");
  EXPECT_EQ(turns("100000000000000000000"), "alarm b2 value-out-of-range");
}

TEST(NgcWhole, TheReadingIsAskedForOnlyWhereItMatters) {
  const Lines asked = {"ngc.whole"};
  EXPECT_EQ(touched("F9\nG2 X2 I1 P3\nG3 X4 I1 P2.5"), Lines{});
  EXPECT_EQ(touched("F9\nG2 X2 I1 P3.0011"), Lines{});
  EXPECT_EQ(touched("F9\nG2 X2 I1 P3.001"), asked);
  EXPECT_EQ(touched("M3.005"), Lines{});
  EXPECT_EQ(touched("M3.0049"), asked);
  EXPECT_EQ(touched("M2.9998"), Lines{});
  EXPECT_EQ(touched("M2.9999"), asked);
  EXPECT_EQ(touched("G1.005"), Lines{});
  EXPECT_EQ(touched("G1.0049"), asked);
  EXPECT_EQ(touched("G6.0001"), Lines{});
  EXPECT_EQ(touched("G6"), Lines{});
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
