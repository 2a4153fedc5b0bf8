// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_subject.hpp"
#include "tests/has.hpp"

namespace gonogo::oracle {
namespace {

TEST(PipeSubject, TellsWhatTheStartReplySays) {
  auto subject = fake_pipe("good");
  EXPECT_EQ(subject->info().name, "fake");
  EXPECT_EQ(subject->info().version, "1.0");
  EXPECT_TRUE(subject->info().declares("gsk988ta", "g94"));
  EXPECT_FALSE(subject->info().declares("gsk988ta", "g110"));
  EXPECT_FALSE(subject->info().declares("hnc21t", "g94"));
  EXPECT_EQ(subject->info().resolution, Number::parse("0.001"));
  EXPECT_EQ(subject->info().max_in_flight, 1);
}

TEST(PipeSubject, GivesTheRecordsOfAGoodReply) {
  auto subject = fake_pipe("good");
  const Ran ran = run(*subject);
  EXPECT_EQ(ran.end.kind, Kind::ok) << ran.end.message;
  ASSERT_EQ(ran.records.size(), 1u);
  EXPECT_EQ(ran.records[0].to[reference::Axis::x], Number::parse("3/2"));
}

TEST(PipeSubject, KeepsOneProcessForManyRuns) {
  auto subject = fake_pipe("pid");
  const std::string first = run(*subject).end.message;
  EXPECT_EQ(run(*subject).end.message, first);
}

TEST(PipeSubject, GivesTheAlarmAndTheRecordsBeforeIt) {
  auto subject = fake_pipe("alarm");
  const Ran ran = run(*subject);
  EXPECT_EQ(ran.end.kind, Kind::alarm);
  EXPECT_EQ(ran.end.alarm.native, "PS0061");
  EXPECT_EQ(ran.end.alarm.alarm_class, "value-sign");
  EXPECT_EQ(ran.end.alarm.block, 3u);
  EXPECT_EQ(ran.end.alarm.word, 'Q');
  EXPECT_EQ(ran.records.size(), 1u);
}

TEST(PipeSubject, ASkipNamesItsFeature) {
  const RunEnd end = pipe_end("skip");
  EXPECT_EQ(end.kind, Kind::skip);
  EXPECT_EQ(end.feature, "g116");
}

// J-RUN-05: also where the sink has seen enough before.
TEST(PipeSubject, ASkipIsOneWhateverRecordsCameBefore) {
  for (const char* mode : {"skip-beside-records", "skip-behind-parts"}) {
    for (const std::size_t most : {1U, 1000U}) {
      auto subject = fake_pipe(mode);
      const RunEnd end = run(*subject, "G0 X1\n", most).end;
      EXPECT_EQ(end.kind, Kind::skip) << mode << ": " << end.message;
      EXPECT_EQ(end.feature, "g116");
    }
  }
}

// 101 records in as many parts.
TEST(PipeSubject, ARunThatTheSinkStopsInItsPartsLeavesTheNextWhole) {
  auto subject = fake_pipe("parts");
  const Ran ran = run(*subject, "G0 X1\n", 5);
  EXPECT_EQ(ran.end.kind, Kind::stopped);
  EXPECT_EQ(ran.records.size(), 5U);
  EXPECT_EQ(run(*subject).records.size(), 101U);
}

TEST(PipeSubject, AnErrorIsNotACrash) {
  EXPECT_EQ(pipe_end("error").kind, Kind::error);
}

TEST(PipeSubject, EveryRunOfARefusedProfileTellsTheRefusal) {
  auto subject = fake_pipe("refuses");
  EXPECT_EQ(run(*subject).end.kind, Kind::refused);
  const RunEnd second = run(*subject).end;
  EXPECT_EQ(second.kind, Kind::refused);
  EXPECT_EQ(second.message, "no readings here");
}

// A machine with this value of the reading gsk.g94.rewrite.
reference::Profile rewriting(std::string_view value) {
  reference::Profile profile = gsk_profile();
  profile.readings.set(reference::find_reading("gsk.g94.rewrite")->key, value);
  return profile;
}

std::string other_rewriting() {
  return std::string(reference::find_reading("gsk.g94.rewrite")->alternatives.back());
}

TEST(PipeSubject, AReadingThatItDoesNotKnowIsNotToldAndNotAsked) {
  auto subject = fake_pipe("told");
  subject->configure(rewriting(other_rewriting()));
  const RunEnd end = run(*subject).end;
  EXPECT_EQ(end.kind, Kind::refused);
  EXPECT_TRUE(has(end.message, "gsk.g94.rewrite"));
}

TEST(PipeSubject, AReadingThatTheCertifierStatesNeedNotBeTold) {
  Limits limits = patient_limits();
  limits.stated.readings = {"gsk.g94.rewrite=" + other_rewriting()};
  auto subject = fake_pipe("told", limits);
  subject->configure(rewriting(other_rewriting()));
  const RunEnd end = run(*subject).end;
  EXPECT_EQ(end.kind, Kind::error);
  EXPECT_TRUE(has(end.message, "\"profile\":{}"));
}

TEST(PipeSubject, AReadingThatItNamesIsTold) {
  auto subject = fake_pipe("told-one");
  subject->configure(rewriting(other_rewriting()));
  const RunEnd end = run(*subject).end;
  EXPECT_EQ(end.kind, Kind::error);
  EXPECT_TRUE(has(end.message, "\"gsk.g94.rewrite\":\"" + other_rewriting()));
}

TEST(PipeSubject, TheSinkStopsAFloodOfRecords) {
  auto subject = fake_pipe("flood");
  const Ran ran = run(*subject, "G0 X1\n", 5000);
  EXPECT_EQ(ran.end.kind, Kind::stopped);
  EXPECT_EQ(ran.records.size(), 5000u);
}

TEST(PipeSubject, AReplyMayComeInManyParts) {
  auto subject = fake_pipe("parts");
  EXPECT_EQ(run(*subject).records.size(), 101u);
  EXPECT_EQ(run(*subject).end.kind, Kind::ok);
}

TEST(PipeSubject, WhatIsNotTheProtocolIsNamedSo) {
  for (const char* mode : {"garbage", "wrong-seq", "duplicate-key", "bare-number", "two-replies"}) {
    const RunEnd end = pipe_end(mode);
    EXPECT_EQ(end.kind, Kind::protocol) << mode << ": " << end.message;
    EXPECT_FALSE(end.message.empty()) << mode;
  }
}

TEST(PipeSubject, TheDuplicateKeyIsNamed) {
  EXPECT_TRUE(has(pipe_end("duplicate-key").message, "\"s\""));
}

TEST(PipeSubject, ALineAboveTheLimitIsProtocolAndIsNotKept) {
  const RunEnd end = run(*fake_pipe("long-line", run_limits(20'000))).end;  // 100 MiB, limit 64 MiB
  EXPECT_EQ(end.kind, Kind::protocol);
  EXPECT_TRUE(has(end.message, "67108864"));
}

TEST(PipeSubject, StderrIsKeptAndNoVerdict) {
  const RunEnd end = pipe_end("noise");
  EXPECT_EQ(end.kind, Kind::ok);
  EXPECT_EQ(end.notes, "tool \xEF\xBF\xBD\xEF\xBF\xBD is worn\n");
}

TEST(PipeSubject, BytesGoAsBase64ToThoseThatTakeThem) {
  auto subject = fake_pipe("echo");
  const std::string message = run(*subject, "(\xB5\xB6)\n").end.message;  // 28 B5 B6 29 0A
  EXPECT_TRUE(has(message, R"("program":{"base64":"KLW2KQo="})"));
}

TEST(PipeSubject, BytesAreSkippedForTheOthers) {
  auto subject = fake_pipe("good");
  const RunEnd end = run(*subject, "(\xB5)\n").end;
  EXPECT_EQ(end.kind, Kind::skip);
  EXPECT_EQ(end.feature, "bytes");
}

TEST(PipeSubject, AProgramArrivesWholeWhateverItHolds) {
  auto subject = fake_pipe("echo");
  const std::string message = run(*subject, "G0\t\"X\\1\"\r\n%\x01\n").end.message;
  EXPECT_TRUE(has(message, R"("program":"G0\u0009\"X\\1\"\u000d\n%\u0001\n")"));
}

TEST(PipeSubject, RenewGivesAFreshProcess) {
  auto subject = fake_pipe("leak");
  EXPECT_EQ(run(*subject).records.at(0).seconds, Number(1));
  EXPECT_EQ(run(*subject).records.at(0).seconds, Number(2));
  subject->renew();
  EXPECT_EQ(run(*subject).records.at(0).seconds, Number(1));
}

TEST(PipeSubject, OneThatCannotStartIsUnusableAndSaysWhy) {
  Limits limits = patient_limits();
  limits.start = std::chrono::milliseconds(500);
  for (const char* mode : {"never-starts", "protocol2", "start-garbage", "talks-first"}) {
    EXPECT_THROW(fake_pipe(mode, limits), SubjectUnusable) << mode;
  }
  EXPECT_THROW(make_pipe_subject("/no/such/program", limits), SubjectUnusable);
  try {
    fake_pipe("dies-at-start");
    FAIL() << "it was taken for usable";
  } catch (const SubjectUnusable& error) {
    EXPECT_TRUE(has(error.what(), "licence expired"));
  }
}

TEST(PipeSubject, WhatTheSinkThrowsComesThrough) {
  auto subject = fake_pipe("parts");
  EXPECT_THROW(subject->run("x", "G0\n",
                            [](const reference::Record&) -> bool { throw std::logic_error("x"); }),
               std::logic_error);
  EXPECT_EQ(run(*subject).records.size(), 101u);
}

}  // namespace
}  // namespace gonogo::oracle
