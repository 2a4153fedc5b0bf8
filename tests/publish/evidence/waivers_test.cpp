// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-RUN-13: what a known failure of the run makes of a line is held against the line.
#include "publish/evidence/verify_waivers.hpp"

#include <gtest/gtest.h>

namespace gonogo::oracle::evidence {
namespace {

const KnownFailure kAlarm = {"ngc.arc.000001", VerdictKind::fail_alarm_spurious, {}, {}, "a bug",
                             std::nullopt};
const KnownFailure kFlaky = {"ngc.arc.000001", VerdictKind::fail_geometry, {}, {}, "a race",
                             Flaky{1, 3}};

// Of the case ngc.arc.000001, with what follows its verdict.
std::string fault(const KnownFailure& entry, const std::string& verdict,
                  const std::string& rest = "") {
  const Json line =
      Json::parse(R"({"id":"ngc.arc.000001","dialect":"rs274","cycle":"arc","verdict":")" +
                  verdict + "\"" + rest + "}");
  return RunWaivers({entry}).fault(line, case_row(line), true);
}

TEST(Waivers, APassThatIsKnownToFailIsUnexpected) {
  EXPECT_NE(fault(kAlarm, "pass-exact").find("it passes, and a known failure"), std::string::npos);
  EXPECT_EQ(fault(kAlarm, "xpass",
                  R"(,"message":"Known to fail with fail.alarm-spurious (a bug), but it passes.")"),
            "");
  EXPECT_NE(fault(kAlarm, "xpass", R"(,"message":"It is mended.")"), "");
  // What fails now and then may pass, and an entry is of its own cases alone.
  EXPECT_EQ(fault(kFlaky, "pass-exact"), "");
  KnownFailure other = kAlarm;
  other.cases = "ngc.arc.000002";
  EXPECT_EQ(fault(other, "pass-exact"), "");
  EXPECT_NE(fault(other, "xpass"), "");
}

TEST(Waivers, AKnownFailureIsWhatItsEntrySays) {
  const std::string departure = R"(,"departure":"fail.alarm-spurious","got":"E302")";
  const std::string known = R"(,"known":"a bug")";
  EXPECT_EQ(fault(kAlarm, "xfail", departure + known), "");
  EXPECT_NE(fault(kAlarm, "xfail", departure + R"(,"known":"by design")"), "");
  KnownFailure otherwise = kAlarm;
  otherwise.got = "E999";
  EXPECT_NE(fault(otherwise, "xfail", departure + known), "");
  otherwise.got = "E302";
  EXPECT_EQ(fault(otherwise, "xfail", departure + known), "");
  otherwise.deviation = "1";
  EXPECT_NE(fault(otherwise, "xfail", departure + known), "");
}

TEST(Waivers, AFailureThatIsKnownIsNoNoGo) {
  EXPECT_NE(fault(kAlarm, "fail.alarm-spurious"), "");
  EXPECT_EQ(fault(kAlarm, "fail.geometry"), "");
  EXPECT_EQ(fault(kFlaky, "fail.geometry"), "");
  EXPECT_NE(fault(kAlarm, "fail.geometry", R"(,"known":"a bug")"), "");
}

// The readings of the run say whether it contradicts the other cases.
TEST(Waivers, APassThatIsKnownToContradictOthersIsLeftToTheReadings) {
  KnownFailure contradicts = kAlarm;
  contradicts.verdict = VerdictKind::fail_reading;
  const std::string readings =
      R"(,"readings":{"open":["k"],"explaining":["k=a"],"verdict":"pass-exact")";
  EXPECT_EQ(fault(contradicts, "xpass", readings + R"(,"known":"a bug"})"), "");
  EXPECT_NE(fault(contradicts, "pass-exact", readings + "}"), "");
  EXPECT_NE(fault(kAlarm, "pass-exact", readings + "}"), "");
  KnownFailure other = contradicts;
  other.cases = "ngc.arc.000002";
  EXPECT_NE(fault(other, "xfail", readings + R"(,"known":"a bug"})"), "");
}

// "1 of 3": it takes three runs to say so, and one trace is kept.
TEST(Waivers, WhatFailsNowAndThenIsProvenByNoTrace) {
  const auto rests = [](const KnownFailure& entry, const std::string& departure,
                        const std::string& reason) {
    return RunWaivers({entry}).rests_on_runs(case_row(
        Json::parse(R"({"id":"ngc.arc.000001","dialect":"rs274","cycle":"arc","verdict":"xfail",)"
                    R"("departure":")" +
                    departure + R"(","known":")" + reason + "\"}")));
  };
  EXPECT_TRUE(rests(kFlaky, "fail.geometry", "a race"));
  EXPECT_FALSE(rests(kAlarm, "fail.alarm-spurious", "a bug"));
}

TEST(Waivers, AMessageMaySayThatMoreRunsFailedThanAnEntryAllows) {
  const Json line = Json::parse(
      R"({"id":"ngc.arc.000001","dialect":"rs274","cycle":"arc","verdict":"fail.geometry"})");
  EXPECT_EQ(RunWaivers({kFlaky}).additions(case_row(line)),
            (std::vector<std::string>{
                " 2 of 3 runs failed so; it is known to fail in at most 1 of them (a race).",
                " 3 of 3 runs failed so; it is known to fail in at most 1 of them (a race)."}));
  EXPECT_TRUE(RunWaivers({kAlarm}).additions(case_row(line)).empty());
}

}  // namespace
}  // namespace gonogo::oracle::evidence
