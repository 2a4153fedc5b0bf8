// SPDX-License-Identifier: GPL-3.0-or-later
// How near to a whole number is near enough, by each reading of ngc.whole.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

constexpr const char* kExactly = R"({"readings":{"ngc.whole":"exact"}})";
constexpr const char* kByNist = R"({"readings":{"ngc.whole":"nist"}})";
constexpr const char* kByLinuxcnc = R"({"readings":{"ngc.whole":"linuxcnc"}})";

std::string whole_alarm(const std::string& block, const char* profile) {
  return run_ngc("F9\n" + block + "\n", profile).alarm;
}
std::string turns_alarm(const std::string& p, const char* profile) {
  return whole_alarm("G2 X2 I1 P" + p, profile);
}

TEST(NgcWhole, ExactlyWholeIsWholeToTheLastDigit) {
  for (const char* profile : {"{}", kExactly}) {
    EXPECT_EQ(turns_alarm("3.0000", profile), "");
    EXPECT_EQ(turns_alarm("3.00000000001", profile), "not-an-integer");
    EXPECT_EQ(turns_alarm("0.00000000001", profile), "not-an-integer");
    EXPECT_EQ(turns_alarm("2.9999", profile), "not-an-integer");
    EXPECT_EQ(whole_alarm("M3.0001", profile), "not-an-integer");
    EXPECT_EQ(whole_alarm("G1.00001 X1", profile), "undefined-code");
  }
}

// NISTIR 6556, 3.3.2.1: within 0.0001 of an integer; of G codes, multiplied by ten.
TEST(NgcWhole, NistAllowsATenThousandth) {
  for (const char* p : {"3.0001", "2.9999", "3.00009999999999", "2.99990000000001", "0.9999"}) {
    EXPECT_EQ(turns_alarm(p, kByNist), "") << p;
    EXPECT_EQ(whole_alarm(std::string("M") + p, kByNist), "") << p;
  }
  for (const char* p : {"3.000100001", "2.999899999", "3.00010000000001", "2.99989999999999"}) {
    EXPECT_EQ(turns_alarm(p, kByNist), "not-an-integer") << p;
    EXPECT_EQ(whole_alarm(std::string("M") + p, kByNist), "not-an-integer") << p;
  }
  for (const char* g : {"1.00001", "0.99999", "-0.00001", "90.10001", "90.09999"}) {
    EXPECT_EQ(whole_alarm(std::string("G") + g, kByNist), "") << g;
  }
  for (const char* g : {"1.000010001", "0.9999899", "-0.0000101", "90.10002", "90.09998"}) {
    EXPECT_EQ(whole_alarm(std::string("G") + g, kByNist), "undefined-code") << g;
  }
}

// As measured: 0.001 for P and for G codes multiplied by ten.
TEST(NgcWhole, LinuxcncAllowsAThousandthButForFunctions) {
  EXPECT_EQ(turns_alarm("3.001", kByLinuxcnc), "");
  EXPECT_EQ(turns_alarm("2.999", kByLinuxcnc), "");
  EXPECT_EQ(turns_alarm("3.0010001", kByLinuxcnc), "not-an-integer");
  EXPECT_EQ(whole_alarm("G1.0001", kByLinuxcnc), "");
  EXPECT_EQ(whole_alarm("G90.0999", kByLinuxcnc), "");
  EXPECT_EQ(whole_alarm("G1.0001001", kByLinuxcnc), "undefined-code");
  EXPECT_EQ(whole_alarm("M3.0001", kByLinuxcnc), "");
  EXPECT_EQ(whole_alarm("M3.0002", kByLinuxcnc), "not-an-integer");
}

// grbl's parser: trunc(value), and round(100 * what is behind the point).
TEST(NgcWhole, GrblCutsAtThePointAndRoundsToHundredths) {
  constexpr const char* kByGrbl = R"({"readings":{"ngc.whole":"grbl"}})";
  for (const char* g : {"1.0049", "1.00499999999", "90.1049", "90.095", "-0.0049"}) {
    EXPECT_EQ(whole_alarm(std::string("G") + g, kByGrbl), "") << g;
  }
  for (const char* g :
       {"1.005", "0.99999", "0.99999999999", "90.105", "90.0949", "90.09499999999"}) {
    EXPECT_EQ(whole_alarm(std::string("G") + g, kByGrbl), "undefined-code") << g;
  }
  EXPECT_EQ(whole_alarm("M3.0049", kByGrbl), "");
  EXPECT_EQ(whole_alarm("M3.005", kByGrbl), "not-an-integer");
  EXPECT_EQ(whole_alarm("M2.99999999999", kByGrbl), "not-an-integer");
  EXPECT_EQ(turns_alarm("3.0001", kByGrbl), "not-an-integer");
}

TEST(NgcWhole, WhatIsNearlyWholeIsTakenAsTheWhole) {
  EXPECT_EQ(run_ngc("G2 X2 I1 P2.9999 F9\n", kByNist).motions(),
            "arc17 c=1,0 rot=-3 x=2 y=0 f=9\n");
  EXPECT_EQ(run_ngc("G0.99999 X1 F9 M7.9999\n", kByNist).trace(), "1 m 8\n1 feed x=1 f=9\n");
  EXPECT_EQ(run_ngc("M1.9999\nG0 X1\n", kByNist).trace(), "1 m 2\n");
  EXPECT_EQ(turns_alarm("0.0001", kByNist), "value-sign");
  EXPECT_EQ(turns_alarm("-0.0001", kByNist), "value-sign");
  EXPECT_EQ(whole_alarm("M3 M4.0001", kByNist), "duplicate-word");
  EXPECT_EQ(run_ngc("G59.30001\n", kByNist).note, "G59.3 is not implemented.");
  EXPECT_EQ(run_ngc("M98.0001\n", kByNist).note, "M98 is not implemented.");
}

}  // namespace
}  // namespace gonogo::expanders::testing
