// SPDX-License-Identifier: GPL-3.0-or-later
//
// Subjects that crash, hang or take too much, and what becomes of them.
#include <filesystem>

#include "run_subject.hpp"
#include "tests/has.hpp"

namespace gonogo::oracle {
namespace {

Limits restarted(int restarts) {
  Limits limits = patient_limits();
  limits.restarts = restarts;
  return limits;
}

RunEnd soon_end_of(const std::string& mode) {
  return run(*fake_pipe(mode, run_limits(300))).end;
}

TEST(PipeSubject, AnAbortIsACrashNamedByItsSignal) {
  const RunEnd end = pipe_end("abort");
  EXPECT_EQ(end.kind, Kind::crash);
  EXPECT_TRUE(has(end.message, "signal 6"));
}

TEST(PipeSubject, AnExitInARunIsACrashWhateverItsCode) {
  EXPECT_EQ(pipe_end("exit7").kind, Kind::crash);
  EXPECT_TRUE(has(pipe_end("exit7").message, "exited with 7"));
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
  EXPECT_TRUE(has(end->message, "signal 6 (Aborted) when it was told to stop"));
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
  auto subject = fake_pipe("hang", run_limits(300));
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
  EXPECT_TRUE(has(end.message, "exited with 9"));
  EXPECT_EQ(soon_end_of("hang-with-grandchild").kind, Kind::timeout);
}

TEST(PipeSubject, AFloodOfEmptyPartsIsATimeout) {
  EXPECT_EQ(soon_end_of("flood-empty").kind, Kind::timeout);
}

TEST(PipeSubject, PartsDoNotProlongTheTime) {
  EXPECT_EQ(soon_end_of("slow-parts").kind, Kind::timeout);
}

TEST(PipeSubject, TheTimeOfTheSinkIsNotTheSubjects) {
  auto subject = fake_pipe("parts", run_limits(3000));
  std::size_t records = 0;
  const RunEnd end = subject->run("slow.sink", "G0\n", [&](const reference::Record&) {
    if (++records % 10 == 0) usleep(400'000);  // 4 s in all; the limit is 3 s
    return true;
  });
  EXPECT_EQ(end.kind, Kind::ok) << end.message;
  EXPECT_EQ(records, 101u);
  EXPECT_LT(end.microseconds, 3'900'000);
}

TEST(PipeSubject, HalfALineAndThenNothingIsATimeout) {
  EXPECT_EQ(soon_end_of("half-stall").kind, Kind::timeout);
}

TEST(PipeSubject, ALateAnswerIsNeverTakenForTheNext) {
  const auto mark =
      std::filesystem::temp_directory_path() / ("gonogo-late-" + std::to_string(getpid()));
  setenv("FAKE_MARK", mark.c_str(), 1);
  Limits limits = run_limits(300);
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

TEST(PipeSubject, EatingMemoryIsToldApartFromACrash) {
  Limits limits = run_limits(20'000);
  limits.memory_bytes = std::size_t{256} << 20;
  EXPECT_EQ(run(*fake_pipe("eat-memory", limits)).end.kind, Kind::out_of_memory);
}

TEST(PipeSubject, IsGivenUpAfterTheRestartsInARow) {
  auto subject = fake_pipe("abort", restarted(2));
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(has(run(*subject).end.message, "signal 6"));
  }
  const RunEnd end = run(*subject).end;
  EXPECT_EQ(end.kind, Kind::crash);
  EXPECT_TRUE(has(end.message, "given up after 2 restarts"));
}

TEST(PipeSubject, RenewedItIsNoLongerGivenUp) {
  auto subject = fake_pipe("abort", restarted(1));
  for (int i = 0; i < 3; ++i) run(*subject);
  EXPECT_TRUE(run(*subject).end.given_up);
  subject->renew();
  EXPECT_TRUE(has(run(*subject).end.message, "signal 6"));
}

// Programs that stand together and that it dies of are no reason to give it up.
TEST(PipeSubject, IsNotGivenUpWhileItRunsAProgramThatDoesNothing) {
  auto subject = fake_pipe("aborts-on-demand", restarted(1));
  for (int i = 0; i < 6; ++i) {
    EXPECT_TRUE(has(run(*subject, "(ABORT)").end.message, "signal 6")) << i;
  }
  EXPECT_EQ(run(*subject).end.kind, Kind::ok);
}

TEST(PipeSubject, AnAnswerBetweenTwoCrashesBeginsTheCountAgain) {
  auto subject = fake_pipe("second-aborts", restarted(1));
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(run(*subject).end.kind, Kind::ok);
    EXPECT_TRUE(has(run(*subject).end.message, "signal 6"));
  }
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
    auto crashing = fake_pipe("abort", restarted(1000));
    for (int i = 0; i < 200; ++i) ASSERT_EQ(run(*crashing).end.kind, Kind::crash);
    EXPECT_FALSE(has_children());
    EXPECT_EQ(open_descriptors(), before);
  }
  EXPECT_EQ(open_descriptors(), before);
  EXPECT_FALSE(has_children());
}

}  // namespace
}  // namespace gonogo::oracle
