// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/trial.hpp"

#include <gtest/gtest.h>

#include "hunting.hpp"

namespace gonogo::hunt::testing {
namespace {

using oracle::VerdictKind;

// A subject of a given end.
class Scripted : public oracle::Subject {
 public:
  explicit Scripted(oracle::RunEnd end) : end_(std::move(end)) {
    info_.everything = true;
    info_.features = {"blocks"};
  }
  const oracle::SubjectInfo& info() const override { return info_; }
  void configure(const reference::Profile&) override {}
  oracle::RunEnd run(std::string_view, std::string_view, const oracle::RecordSink&) override {
    return end_;
  }
  void renew() override {}

 private:
  oracle::SubjectInfo info_;
  oracle::RunEnd end_;
};

SubjectMaker scripted(oracle::RunEnd::Kind kind, std::size_t& made) {
  return [kind, &made] {
    ++made;
    return std::make_unique<Scripted>(oracle::RunEnd::of(kind, ""));
  };
}

TEST(Trial, TheFaultFreeExpanderIsGo) {
  Trial trial(builtin("gsk"), {});
  EXPECT_EQ(trial.run(gsk(kTaper))->kind, VerdictKind::pass_exact);
}

TEST(Trial, AFaultIsNoGo) {
  Trial trial(builtin("gsk", "taper-sign"), {});
  EXPECT_EQ(trial.run(gsk(kTaper))->kind, VerdictKind::fail_geometry);
}

TEST(Trial, ABlindJudgeSaysGo) {
  TrialOptions options;
  options.blind = true;
  Trial trial(builtin("gsk", "taper-sign"), options);
  EXPECT_EQ(trial.run(gsk(kTaper))->kind, VerdictKind::pass_exact);
}

TEST(Trial, MoreRecordsThanAllowedAreTooLong) {
  TrialOptions options;
  options.most_records = 2;
  Trial trial(builtin("gsk"), options);
  EXPECT_FALSE(trial.run(gsk(kTaper)));
}

TEST(Trial, ASubjectThatBreaksDownIsMadeAgain) {
  std::size_t made = 0;
  Trial trial(scripted(oracle::RunEnd::Kind::crash, made), {});
  for (int i = 0; i < 20; ++i) EXPECT_EQ(trial.run(gsk(kTaper))->kind, VerdictKind::crash);
  EXPECT_EQ(made, 21U);
}

TEST(Trial, ASubjectThatCannotBeMadeAgainEndsIt) {
  std::size_t made = 0;
  const SubjectMaker make = scripted(oracle::RunEnd::Kind::crash, made);
  Trial trial(
      [&]() -> std::unique_ptr<oracle::Subject> {
        if (made > 0) throw oracle::SubjectUnusable("It is gone.");
        return make();
      },
      {});
  EXPECT_THROW(trial.run(gsk(kTaper)), oracle::SubjectUnusable);
}

TEST(Trial, AnAlarmMapGivesTheClass) {
  oracle::RunEnd end;
  end.kind = oracle::RunEnd::Kind::alarm;
  end.alarm.native = "PS0061";
  end.alarm.block = 1;
  const SubjectMaker make = [end] { return std::make_unique<Scripted>(end); };
  Trial unmapped(make, {});
  EXPECT_EQ(unmapped.run(gsk("G00 @\n"))->kind, VerdictKind::unmapped_alarm);
  TrialOptions options;
  options.alarm_map = std::make_shared<const oracle::AlarmMap>(
      std::vector<oracle::AlarmMap::Entry>{{"PS0061", "syntax"}});
  Trial mapped(make, options);
  EXPECT_EQ(mapped.run(gsk("G00 @\n"))->kind, VerdictKind::pass_exact);
}

// With the fault F of the program before is in force: the second program cuts, and must alarm.
TEST(Trial, WhatRanBeforeCountsOnlyWhereItIsAsked) {
  Trial trial(builtin("gsk", "feed-survives-reset"), {});
  const generate::GeneratedProgram feed = gsk("G01 X1 F100\n");
  const generate::GeneratedProgram none = gsk("G01 X1\n");
  EXPECT_EQ(trial.run_alone({{}, none})->kind, VerdictKind::pass_exact);
  EXPECT_EQ(trial.run_alone({{feed}, none})->kind, VerdictKind::fail_alarm_missing);
}

}  // namespace
}  // namespace gonogo::hunt::testing
