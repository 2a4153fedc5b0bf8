// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/signature.hpp"

#include <gtest/gtest.h>

#include "hunting.hpp"

namespace gonogo::hunt::testing {
namespace {

Signature signature(const char* fault, const char* program) {
  Trial trial(builtin("gsk", fault), {});
  oracle::Verdict verdict;
  const auto finding = finding_of(trial, gsk(program), verdict);
  return finding ? finding->signature : Signature{};
}

TEST(Signature, OtherNumbersAreTheSameDefect) {
  EXPECT_EQ(signature("taper-sign", "G00 X100 Z5\nG94 X50 Z-10 R-2 F100\n"),
            signature("taper-sign", "G00 X90 Z7\n\nG94 X30 Z-20.5 R-3 F250\n"));
}

TEST(Signature, AnotherCodeIsAnotherDefect) {
  EXPECT_NE(signature("inch-feed", "G20 G00 X1 Z1\nG01 X2 F1\n"),
            signature("inch-feed", "G20 G00 X1 Z1\nG94 X0 Z0 F1\n"));
}

TEST(Signature, AnotherKindOfVerdictIsAnotherDefect) {
  EXPECT_EQ(
      signature("tool-equality-accepted", "G18 G0 X0 Z0 Y50\nG110 X0 Z0 Y20 R-5 I5 L3 Q50 D5 F1\n")
          .kind,
      oracle::VerdictKind::fail_alarm_missing);
  EXPECT_EQ(signature("gouge", "G18 G0 X0 Z0 Y50\nG110 X0 Z0 Y20 R-5 I9 L3 Q50 D5 F1\n").kind,
            oracle::VerdictKind::fail_region);
}

// G94 goes at rapid to B = C + R = Z-12; with the fault to Z-8, which lies on the way, and cuts on.
TEST(Signature, NamesClauseRecordsAndCode) {
  EXPECT_EQ(signature("taper-sign", "G00 X100 Z5\nG94 X50 Z-10 R-2 F100\n").text(),
            "fail.geometry GSK-G94-02 rapid/rapid Z in G94");
}

oracle::Verdict departure(const char* want, const char* got) {
  oracle::Verdict verdict;
  verdict.kind = oracle::VerdictKind::fail_geometry;
  verdict.want = want;
  verdict.got = got;
  return verdict;
}

// A mistake along one axis does not stand for one along another.
TEST(Signature, NamesTheFirstAxisAlongWhichMotionsOfOneKindEndApart) {
  const auto what = [](const char* want, const char* got) {
    return signature_of(departure(want, got), gsk("G0\n")).what;
  };
  const char* const want = R"({"k":"rapid","to":{"y":"25.4","z":"1"}})";
  EXPECT_EQ(what(want, R"({"k":"rapid","to":{"x":"0","y":"50.8","z":"1"}})"), "rapid/rapid Y");
  EXPECT_EQ(what(want, R"({"k":"rapid","to":{"y":"0","z":"2"}})"), "rapid/rapid Y");
  EXPECT_EQ(what(want, R"({"k":"rapid","to":{"y":"25.4","z":"2"}})"), "rapid/rapid Z");
  EXPECT_EQ(what(want, R"({"k":"rapid","to":{"x":"3"}})"), "rapid/rapid");
  EXPECT_EQ(what(want, R"({"k":"feed","to":{"y":"0"}})"), "rapid/feed");
}

// G4 stands beside a cycle that goes on: the cycle is what moves.
TEST(Signature, NamesTheMotionBesideADwell) {
  oracle::Verdict verdict = departure("", "");
  verdict.block = 2;
  generate::GeneratedProgram program{{}, "G81 X1 Z-1 R1 F100\nG4 P1 X2\nG4 P1\n"};
  program.profile.dialect = "rs274";
  EXPECT_EQ(signature_of(verdict, program).code, "G81");
  verdict.block = 3;
  EXPECT_EQ(signature_of(verdict, program).code, "G4");
}

TEST(Signature, SaysThatTheSubjectIsStillInAnEarlierBlock) {
  const char* const want = R"({"k":"rapid","b":5,"to":{"x":"0"}})";
  const Signature behind =
      signature_of(departure(want, R"({"k":"feed","b":4,"to":{"x":"0"}})"), gsk("G0\n"));
  EXPECT_EQ(behind.what, "rapid/feed of an earlier block");
  EXPECT_TRUE(behind.is_surplus());
  const Signature there =
      signature_of(departure(want, R"({"k":"feed","b":5,"to":{"x":"0"}})"), gsk("G0\n"));
  EXPECT_EQ(there.what, "rapid/feed");
  EXPECT_FALSE(there.is_surplus());
  const Signature ahead =
      signature_of(departure(want, R"({"k":"feed","b":10,"to":{"x":"0"}})"), gsk("G0\n"));
  EXPECT_FALSE(ahead.is_surplus());
}

TEST(Signature, AnAlarmIsNoMotionOfAnEarlierBlock) {
  const Signature signature = signature_of(
      departure(R"({"k":"rapid","b":5})", R"({"k":"alarm","b":4,"class":"syntax"})"), gsk("G0\n"));
  EXPECT_EQ(signature.what, "rapid/syntax");
  EXPECT_FALSE(signature.is_surplus());
}

TEST(Signature, AnAlarmThatIsNotDueIsKnownByItsClass) {
  Signature signature;
  signature.kind = oracle::VerdictKind::fail_alarm_class;
  signature.what = "alarm/missing-word";
  EXPECT_EQ(signature.undue_alarm(), "missing-word");
  signature.kind = oracle::VerdictKind::fail_alarm_missing;
  EXPECT_EQ(signature.undue_alarm(), "");
}

TEST(Signature, HashesAreEightDigits) {
  const std::string hash = signature("taper-sign", "G00 X100 Z5\nG94 X50 Z-10 R-2 F100\n").hash();
  EXPECT_EQ(hash.size(), 8U);
  EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST(Signature, WhatBrokeDownIsNamedWithoutItsNumbers) {
  oracle::Verdict first;
  first.kind = oracle::VerdictKind::crash;
  first.message = "The subject exited with 134 in `run` 17.";
  oracle::Verdict second = first;
  second.message = "The subject exited with 9 in `run` 4.";
  EXPECT_EQ(signature_of(first, gsk("G0\n")), signature_of(second, gsk("G1 X1\n")));
}

}  // namespace
}  // namespace gonogo::hunt::testing
