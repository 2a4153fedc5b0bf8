// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>
#include <iterator>

#include "run_subject.hpp"

namespace gonogo::oracle {
namespace {

std::unique_ptr<Subject> fake_pipe(const std::string& mode,
                                   const Limits& limits = patient_limits()) {
  auto subject = make_pipe_subject(std::string(FAKE_PIPE) + " " + mode, limits);
  subject->configure(gsk_profile());
  return subject;
}

RunEnd pipe_end(const std::string& mode) {
  return run(*fake_pipe(mode)).end;
}

RunEnd soon_end_of(const std::string& mode) {
  return run(*fake_pipe(mode, short_limits())).end;
}

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
  EXPECT_NE(end.message.find("gsk.g94.rewrite"), std::string::npos) << end.message;
}

TEST(PipeSubject, AReadingThatTheCertifierStatesNeedNotBeTold) {
  Limits limits = patient_limits();
  limits.stated.readings = {"gsk.g94.rewrite=" + other_rewriting()};
  auto subject = fake_pipe("told", limits);
  subject->configure(rewriting(other_rewriting()));
  const RunEnd end = run(*subject).end;
  EXPECT_EQ(end.kind, Kind::error);
  EXPECT_NE(end.message.find("\"profile\":{}"), std::string::npos) << end.message;
}

TEST(PipeSubject, AReadingThatItNamesIsTold) {
  auto subject = fake_pipe("told-one");
  subject->configure(rewriting(other_rewriting()));
  const RunEnd end = run(*subject).end;
  EXPECT_EQ(end.kind, Kind::error);
  EXPECT_NE(end.message.find("\"gsk.g94.rewrite\":\"" + other_rewriting()), std::string::npos)
      << end.message;
}

TEST(PipeSubject, AnAbortIsACrashNamedByItsSignal) {
  const RunEnd end = pipe_end("abort");
  EXPECT_EQ(end.kind, Kind::crash);
  EXPECT_NE(end.message.find("signal 6"), std::string::npos) << end.message;
}

TEST(PipeSubject, AnExitInARunIsACrashWhateverItsCode) {
  EXPECT_EQ(pipe_end("exit7").kind, Kind::crash);
  EXPECT_NE(pipe_end("exit7").message.find("exited with 7"), std::string::npos);
  EXPECT_EQ(pipe_end("exit0").kind, Kind::crash);
  EXPECT_EQ(pipe_end("half-exit").kind, Kind::crash);
  EXPECT_EQ(pipe_end("dies-in-configure").kind, Kind::crash);
}

TEST(PipeSubject, AnAbortWhereItIsToldToStopIsACrash) {
  auto subject = fake_pipe("aborts-at-stop");
  EXPECT_EQ(run(*subject).end.kind, Kind::ok);
  const std::optional<RunEnd> end = subject->finish();
  ASSERT_TRUE(end.has_value());
  EXPECT_EQ(end->kind, Kind::crash);
  EXPECT_NE(end->message.find("signal 6 (Aborted) when it was told to stop"), std::string::npos)
      << end->message;
  auto good = fake_pipe("good");
  EXPECT_EQ(run(*good).end.kind, Kind::ok);
  EXPECT_FALSE(good->finish().has_value());
}

TEST(PipeSubject, IsStartedAgainAfterACrash) {
  auto subject = fake_pipe("second-aborts");
  EXPECT_EQ(run(*subject).end.kind, Kind::ok);
  EXPECT_EQ(run(*subject).end.kind, Kind::crash);
  EXPECT_EQ(run(*subject).end.kind, Kind::ok);
}

TEST(PipeSubject, ADeathBetweenTwoRunsIsACrashOfTheSecond) {
  auto subject = fake_pipe("exits-between");
  EXPECT_EQ(run(*subject).end.kind, Kind::ok);
  usleep(50'000);
  EXPECT_EQ(run(*subject).end.kind, Kind::crash);
  EXPECT_EQ(run(*subject).end.kind, Kind::ok);
}

TEST(PipeSubject, AHangIsATimeoutNearTheLimit) {
  auto subject = fake_pipe("hang", short_limits());
  const auto begin = std::chrono::steady_clock::now();
  const RunEnd end = run(*subject).end;
  const auto spent = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(end.kind, Kind::timeout);
  EXPECT_GE(end.microseconds, 290'000);
  EXPECT_LT(spent, std::chrono::seconds(10));
}

TEST(PipeSubject, AHangThatIgnoresSignalsIsKilled) {
  EXPECT_EQ(soon_end_of("hang-deaf").kind, Kind::timeout);
}

TEST(PipeSubject, AHangInConfigureIsATimeout) {
  Limits limits = patient_limits();
  limits.start = std::chrono::milliseconds(1000);
  EXPECT_EQ(run(*fake_pipe("hangs-in-configure", limits)).end.kind, Kind::timeout);
}

TEST(PipeSubject, AGrandchildThatHoldsThePipesHidesNoDeath) {
  const RunEnd end = pipe_end("die-with-grandchild");
  EXPECT_EQ(end.kind, Kind::crash);
  EXPECT_NE(end.message.find("exited with 9"), std::string::npos) << end.message;
  EXPECT_EQ(soon_end_of("hang-with-grandchild").kind, Kind::timeout);
}

TEST(PipeSubject, TheSinkStopsAFloodOfRecords) {
  auto subject = fake_pipe("flood");
  const Ran ran = run(*subject, "G0 X1\n", 5000);
  EXPECT_EQ(ran.end.kind, Kind::stopped);
  EXPECT_EQ(ran.records.size(), 5000u);
}

TEST(PipeSubject, AFloodOfEmptyPartsIsATimeout) {
  EXPECT_EQ(soon_end_of("flood-empty").kind, Kind::timeout);
}

TEST(PipeSubject, PartsDoNotProlongTheTime) {
  EXPECT_EQ(soon_end_of("slow-parts").kind, Kind::timeout);
}

TEST(PipeSubject, TheTimeOfTheSinkIsNotTheSubjects) {
  Limits limits = patient_limits();
  limits.run = std::chrono::milliseconds(3000);
  auto subject = fake_pipe("parts", limits);
  std::size_t records = 0;
  const RunEnd end = subject->run("slow.sink", "G0\n", [&](const reference::Record&) {
    if (++records % 10 == 0) usleep(400'000);  // 4 s in all; the limit is 3 s
    return true;
  });
  EXPECT_EQ(end.kind, Kind::ok) << end.message;
  EXPECT_EQ(records, 101u);
  EXPECT_LT(end.microseconds, 3'900'000);
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
  EXPECT_NE(pipe_end("duplicate-key").message.find("\"s\""), std::string::npos);
}

TEST(PipeSubject, HalfALineAndThenNothingIsATimeout) {
  EXPECT_EQ(soon_end_of("half-stall").kind, Kind::timeout);
}

TEST(PipeSubject, ALateAnswerIsNeverTakenForTheNext) {
  const auto mark =
      std::filesystem::temp_directory_path() / ("gonogo-late-" + std::to_string(getpid()));
  setenv("FAKE_MARK", mark.c_str(), 1);
  Limits limits = short_limits();
  limits.environment = {"FAKE_MARK"};
  auto subject = fake_pipe("late-first", limits);
  EXPECT_EQ(run(*subject).end.kind, Kind::timeout);
  usleep(500'000);  // by now the first answer would have come
  const Ran second = run(*subject);
  std::filesystem::remove(mark);
  EXPECT_EQ(second.end.kind, Kind::ok) << second.end.message;
  ASSERT_EQ(second.records.size(), 1u);
  EXPECT_EQ(second.records[0].seconds, Number(1));  // first run of a fresh process
}

TEST(PipeSubject, ALineAboveTheLimitIsProtocolAndIsNotKept) {
  Limits limits = patient_limits();
  limits.run = std::chrono::milliseconds(20'000);
  const RunEnd end = run(*fake_pipe("long-line", limits)).end;  // 100 MiB, limit 64 MiB
  EXPECT_EQ(end.kind, Kind::protocol);
  EXPECT_NE(end.message.find("67108864"), std::string::npos) << end.message;
}

TEST(PipeSubject, StderrIsKeptAndNoVerdict) {
  const RunEnd end = pipe_end("noise");
  EXPECT_EQ(end.kind, Kind::ok);
  EXPECT_EQ(end.notes, "tool \xEF\xBF\xBD\xEF\xBF\xBD is worn\n");
}

TEST(PipeSubject, BytesGoAsBase64ToThoseThatTakeThem) {
  auto subject = fake_pipe("echo");
  const std::string message = run(*subject, "(\xB5\xB6)\n").end.message;  // 28 B5 B6 29 0A
  EXPECT_NE(message.find(R"("program":{"base64":"KLW2KQo="})"), std::string::npos) << message;
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
  EXPECT_NE(message.find(R"("program":"G0\u0009\"X\\1\"\u000d\n%\u0001\n")"), std::string::npos)
      << message;
}

TEST(PipeSubject, EatingMemoryIsToldApartFromACrash) {
  Limits limits = patient_limits();
  limits.run = std::chrono::milliseconds(20'000);
  limits.memory_bytes = std::size_t{256} << 20;
  EXPECT_EQ(run(*fake_pipe("eat-memory", limits)).end.kind, Kind::out_of_memory);
}

TEST(PipeSubject, RenewGivesAFreshProcess) {
  auto subject = fake_pipe("leak");
  EXPECT_EQ(run(*subject).records.at(0).seconds, Number(1));
  EXPECT_EQ(run(*subject).records.at(0).seconds, Number(2));
  subject->renew();
  EXPECT_EQ(run(*subject).records.at(0).seconds, Number(1));
}

TEST(PipeSubject, IsGivenUpAfterTheRestartsInARow) {
  Limits limits = patient_limits();
  limits.restarts = 2;
  auto subject = fake_pipe("abort", limits);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NE(run(*subject).end.message.find("signal 6"), std::string::npos);
  }
  const RunEnd end = run(*subject).end;
  EXPECT_EQ(end.kind, Kind::crash);
  EXPECT_NE(end.message.find("given up after 2 restarts"), std::string::npos) << end.message;
}

TEST(PipeSubject, RenewedItIsNoLongerGivenUp) {
  Limits limits = patient_limits();
  limits.restarts = 1;
  auto subject = fake_pipe("abort", limits);
  for (int i = 0; i < 3; ++i) run(*subject);
  EXPECT_TRUE(run(*subject).end.given_up);
  subject->renew();
  EXPECT_NE(run(*subject).end.message.find("signal 6"), std::string::npos);
}

// Programs that stand together and that it dies of are no reason to give it up.
TEST(PipeSubject, IsNotGivenUpWhileItRunsAProgramThatDoesNothing) {
  Limits limits = patient_limits();
  limits.restarts = 1;
  auto subject = fake_pipe("aborts-on-demand", limits);
  for (int i = 0; i < 6; ++i) {
    EXPECT_NE(run(*subject, "(ABORT)").end.message.find("signal 6"), std::string::npos) << i;
  }
  EXPECT_EQ(run(*subject).end.kind, Kind::ok);
}

TEST(PipeSubject, AnAnswerBetweenTwoCrashesBeginsTheCountAgain) {
  Limits limits = patient_limits();
  limits.restarts = 1;
  auto subject = fake_pipe("second-aborts", limits);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(run(*subject).end.kind, Kind::ok);
    EXPECT_NE(run(*subject).end.message.find("signal 6"), std::string::npos);
  }
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
    EXPECT_NE(std::string(error.what()).find("licence expired"), std::string::npos);
  }
}

TEST(PipeSubject, WhatTheSinkThrowsComesThrough) {
  auto subject = fake_pipe("parts");
  EXPECT_THROW(subject->run("x", "G0\n",
                            [](const reference::Record&) -> bool { throw std::logic_error("x"); }),
               std::logic_error);
  EXPECT_EQ(run(*subject).records.size(), 101u);
}

TEST(PipeSubject, NoProcessOutlivesItsSubject) {
  auto subject = fake_pipe("pid");
  const int pid = std::stoi(run(*subject).end.message);
  EXPECT_TRUE(is_alive(pid));
  subject.reset();
  EXPECT_FALSE(is_alive(pid));
}

TEST(PipeSubject, TwoHundredRestartsLeaveNeitherZombiesNorDescriptors) {
  const std::size_t before = open_descriptors();
  {
    Limits limits = patient_limits();
    limits.restarts = 1000;
    auto crashing = fake_pipe("abort", limits);
    for (int i = 0; i < 200; ++i) ASSERT_EQ(run(*crashing).end.kind, Kind::crash);
    EXPECT_FALSE(has_children());
    EXPECT_EQ(open_descriptors(), before);
  }
  EXPECT_EQ(open_descriptors(), before);
  EXPECT_FALSE(has_children());
}

}  // namespace
}  // namespace gonogo::oracle
