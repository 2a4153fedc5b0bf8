// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs that are sent ahead of the replies.
#include "run_subject.hpp"
#include "tests/has.hpp"

namespace gonogo::oracle {
namespace {

std::unique_ptr<Subject> windowed(const std::string& mode, int window,
                                  const Limits& limits = patient_limits()) {
  auto subject = make_pipe_subject(
      "FAKE_WINDOW=" + std::to_string(window) + " " + std::string(FAKE_PIPE) + " " + mode, limits);
  subject->configure(gsk_profile());
  return subject;
}

std::string id_of(int i) {
  return "case." + std::to_string(i);
}

void announce(Subject& subject, int count, const std::string& program = "G0 X1\n") {
  for (int i = 0; i < count; ++i) subject.announce(id_of(i), program);
}

RunEnd run_case(Subject& subject, int i, Number* seconds = nullptr,
                const std::string& program = "G0 X1\n") {
  return subject.run(id_of(i), program, [&](const reference::Record& record) {
    if (seconds != nullptr) *seconds = record.seconds;
    return true;
  });
}

TEST(PipeWindow, ProgramsAreSentBeforeTheRepliesHaveCome) {
  auto subject = windowed("by-four", 4);
  EXPECT_EQ(subject->info().max_in_flight, 4);
  announce(*subject, 4);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(run_case(*subject, i).kind, Kind::ok) << i;
}

TEST(PipeWindow, NoMoreAreSentThanTheSubjectTakes) {
  auto subject = windowed("by-four", 3, run_limits(1500));
  announce(*subject, 4);
  EXPECT_EQ(run_case(*subject, 0).kind, Kind::timeout);
}

TEST(PipeWindow, WithoutAnAnnouncementOneIsSentAtATime) {
  auto subject = windowed("by-four", 4, run_limits(1500));
  EXPECT_EQ(run_case(*subject, 0).kind, Kind::timeout);
}

TEST(PipeWindow, RepliesOutOfOrderAreProtocol) {
  auto subject = windowed("by-four-swapped", 4);
  announce(*subject, 4);
  const RunEnd end = run_case(*subject, 0);
  EXPECT_EQ(end.kind, Kind::protocol);
  EXPECT_TRUE(has(end.message, "\"seq\":2"));
}

// Five programs, of which the third says what it wants.
void announce_five(Subject& subject, const std::string& third) {
  for (int i = 0; i < 5; ++i) subject.announce(id_of(i), i == 2 ? third : "G0 X1\n");
}
RunEnd run_of_five(Subject& subject, int i, const std::string& third, Number* seconds = nullptr) {
  return run_case(subject, i, seconds, i == 2 ? third : "G0 X1\n");
}

// The dwell of each reply counts the runs of its process.
TEST(PipeWindow, ACrashIsThatOfTheProgramWhoseReplyWasDueAndTheOthersAreSentAgain) {
  for (const std::string third : {"(ABORT)", "(HANG)"}) {
    const bool hangs = third == "(HANG)";
    auto subject = windowed(hangs ? "hangs-on-demand" : "aborts-on-demand", 64, run_limits(1500));
    announce_five(*subject, third);
    Number seconds;
    EXPECT_EQ(run_of_five(*subject, 0, third).kind, Kind::ok);
    EXPECT_EQ(run_of_five(*subject, 1, third).kind, Kind::ok);
    const RunEnd crash = run_of_five(*subject, 2, third);
    EXPECT_EQ(crash.kind, hangs ? Kind::timeout : Kind::crash);
    EXPECT_TRUE(has(crash.message, "case.2"));
    EXPECT_EQ(run_of_five(*subject, 3, third, &seconds).kind, Kind::ok);
    EXPECT_EQ(seconds, Number(1));
    EXPECT_EQ(run_of_five(*subject, 4, third, &seconds).kind, Kind::ok);
    EXPECT_EQ(seconds, Number(2));
  }
}

// The replies to the two before it are lost with it.
TEST(PipeWindow, ACrashIsNotThatOfAProgramThatWasUnderWayBesideIt) {
  const std::string third = "(ABORT)";
  auto subject = windowed("batches", 64);
  announce_five(*subject, third);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(run_of_five(*subject, i, third).kind, i == 2 ? Kind::crash : Kind::ok) << i;
  }
}

TEST(PipeWindow, ACrashThatNoProgramBringsAboutAloneIsToldOfTheLastThatWasUnderWay) {
  auto subject = windowed("aborts-with-more-to-do", 64);
  announce(*subject, 3);
  EXPECT_EQ(run_case(*subject, 0).kind, Kind::ok);
  EXPECT_EQ(run_case(*subject, 1).kind, Kind::ok);
  const RunEnd last = run_case(*subject, 2);
  EXPECT_EQ(last.kind, Kind::crash);
  EXPECT_TRUE(has(last.message, "signal 6"));
  EXPECT_TRUE(has(last.message, "others under way"));
}

// The third of five runs of one process or two: whichever it is, it is told once.
TEST(PipeWindow, ACrashOfWhatCameBeforeIsToldOnce) {
  auto subject = windowed("third-aborts", 64);
  announce(*subject, 5);
  int crashes = 0;
  for (int i = 0; i < 5; ++i) crashes += run_case(*subject, i).kind == Kind::crash ? 1 : 0;
  EXPECT_EQ(crashes, 1);
}

// 16 programs of 120 ms each; the limit of a case is 1.5 s.
TEST(PipeWindow, TheTimeOfACaseBeginsWithTheReplyBeforeIt) {
  auto subject = windowed("slow", 16, run_limits(1500));
  announce(*subject, 16);
  for (int i = 0; i < 16; ++i) EXPECT_EQ(run_case(*subject, i).kind, Kind::ok) << i;
}

// 64 programs of 1 MiB and replies of 1 MiB: neither fits into a pipe.
TEST(PipeWindow, LongProgramsAndLongRepliesDoNotBlockEachOther) {
  auto subject = windowed("long-replies", 64);
  const std::string program(std::size_t{1} << 20, ';');
  announce(*subject, 64, program);
  for (int i = 0; i < 64; ++i) {
    EXPECT_EQ(run_case(*subject, i, nullptr, program).kind, Kind::error) << i;
  }
}

TEST(PipeWindow, WhatWasNotAnnouncedIsRunAllTheSame) {
  auto subject = windowed("leak", 8);
  announce(*subject, 4);
  Number seconds;
  EXPECT_EQ(run_case(*subject, 0).kind, Kind::ok);
  EXPECT_EQ(run_case(*subject, 7, &seconds).kind, Kind::ok);
  EXPECT_EQ(seconds, Number(1));  // in a process that the announced ones did not reach
}

TEST(PipeWindow, AnotherConfigurationForgetsWhatWasAnnounced) {
  auto subject = windowed("leak", 8);
  announce(*subject, 4);
  EXPECT_EQ(run_case(*subject, 0).kind, Kind::ok);
  reference::Profile other = gsk_profile();
  other.block_skip = true;
  subject->configure(other);
  Number seconds;
  EXPECT_EQ(run_case(*subject, 1, &seconds).kind, Kind::ok);
  EXPECT_EQ(seconds, Number(1));
}

}  // namespace
}  // namespace gonogo::oracle
