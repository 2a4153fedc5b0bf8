// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>

#include "run_subject.hpp"
#include "tests/has.hpp"

namespace gonogo::oracle {
namespace {

std::unique_ptr<Subject> fake_oneshot(const std::string& mode,
                                      const Limits& limits = patient_limits()) {
  auto subject = make_oneshot_subject(std::string(FAKE_ONESHOT) + " " + mode, limits);
  subject->configure(gsk_profile());
  return subject;
}

RunEnd oneshot_end(const std::string& mode) {
  return run(*fake_oneshot(mode)).end;
}

TEST(OneshotSubject, ExitZeroIsExpanded) {
  auto subject = fake_oneshot("good");
  const Ran ran = run(*subject);
  EXPECT_EQ(ran.end.kind, Kind::ok) << ran.end.message;
  ASSERT_EQ(ran.records.size(), 1u);
  EXPECT_EQ(ran.records[0].to[reference::Axis::z], Number(11) / Number(3));
  EXPECT_FALSE(subject->keeps_state());
}

TEST(OneshotSubject, ExitOneIsTheAlarmOfTheLastLine) {
  auto subject = fake_oneshot("alarm");
  const Ran ran = run(*subject);
  EXPECT_EQ(ran.end.kind, Kind::alarm);
  EXPECT_EQ(ran.end.alarm.alarm_class, "syntax");
  EXPECT_EQ(ran.end.alarm.block, 2u);
  EXPECT_EQ(ran.records.size(), 1u);
}

TEST(OneshotSubject, AlarmAndExitCodeMustAgree) {
  EXPECT_EQ(oneshot_end("alarm-exit0").kind, Kind::protocol);
  EXPECT_EQ(oneshot_end("exit1").kind, Kind::protocol);
  EXPECT_EQ(oneshot_end("after-alarm").kind, Kind::protocol);
}

TEST(OneshotSubject, ExitThreeIsASkipWithItsReason) {
  const RunEnd end = oneshot_end("exit3");
  EXPECT_EQ(end.kind, Kind::skip);
  EXPECT_EQ(end.message, "no G116 here");
}

// J-RUN-05: also where the sink has seen enough before. What ends otherwise stays stopped.
TEST(OneshotSubject, ExitThreeIsASkipWhateverRecordsCameBefore) {
  for (const std::size_t most : {1U, 2U, 1000U}) {
    auto subject = fake_oneshot("exit3-behind-records");
    const Ran ran = run(*subject, "G0\n", most);
    EXPECT_EQ(ran.end.kind, Kind::skip) << ran.end.message;
    EXPECT_EQ(ran.records.size(), std::min<std::size_t>(most, 3));
  }
  auto subject = fake_oneshot("exit2-behind-records");
  EXPECT_EQ(run(*subject, "G0\n", 1).end.kind, Kind::stopped);
}

TEST(OneshotSubject, AnyOtherEndIsACrashAndNoRejection) {
  EXPECT_EQ(oneshot_end("exit2").kind, Kind::crash);
  EXPECT_EQ(oneshot_end("abort").kind, Kind::crash);
}

TEST(OneshotSubject, OutputThatIsNoTraceIsProtocol) {
  EXPECT_EQ(oneshot_end("garbage").kind, Kind::protocol);
  EXPECT_EQ(oneshot_end("cut").kind, Kind::protocol);
}

TEST(OneshotSubject, TheLastLineMayLackItsEnd) {
  auto subject = fake_oneshot("no-newline");
  EXPECT_EQ(run(*subject).records.size(), 1u);
}

TEST(OneshotSubject, AHangIsATimeout) {
  EXPECT_EQ(run(*fake_oneshot("hang", run_limits(300))).end.kind, Kind::timeout);
}

TEST(OneshotSubject, TheSinkStopsAFlood) {
  auto subject = fake_oneshot("flood");
  const Ran ran = run(*subject, "G0\n", 3000);
  EXPECT_EQ(ran.end.kind, Kind::stopped);
  EXPECT_EQ(ran.records.size(), 3000u);
}

TEST(OneshotSubject, AGrandchildThatHoldsThePipesDelaysNothing) {
  const RunEnd end = oneshot_end("grandchild");
  EXPECT_EQ(end.kind, Kind::ok) << end.message;
  EXPECT_LT(end.microseconds, 10'000'000);
}

TEST(OneshotSubject, MegabytesGoInAndComeOutAtTheSameTime) {
  auto subject = fake_oneshot("echo-size");
  const std::string program(3'000'000, ' ');
  const Ran ran = run(*subject, program, 10'000);
  EXPECT_EQ(ran.end.kind, Kind::ok) << ran.end.message;
  ASSERT_EQ(ran.records.size(), 5001u);
  EXPECT_EQ(ran.records.back().m, 3'000'000);
}

TEST(OneshotSubject, TheProfileIsAFileOfThisUserThatGoesAway) {
  auto subject = fake_oneshot("show 'a b'");
  const std::string notes = run(*subject).end.notes;
  EXPECT_TRUE(has(notes, "dialect=gsk988ta mode=600 profile={"));
  const std::size_t at = notes.find("path=") + 5;
  const std::filesystem::path path = notes.substr(at, notes.find('\n', at) - at);
  EXPECT_TRUE(std::filesystem::exists(path)) << path;
  subject.reset();
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_FALSE(std::filesystem::exists(path.parent_path()));
}

// Its name is another one each time, and the message is in the hash of the results.
TEST(OneshotSubject, TheFolderOfTheProfileIsNotInTheMessage) {
  const RunEnd first = oneshot_end("show-unsupported");
  EXPECT_EQ(first.kind, Kind::skip);
  EXPECT_TRUE(has(first.message, "path=profile.json"));
  EXPECT_EQ(first.message, oneshot_end("show-unsupported").message);
}

TEST(OneshotSubject, WithoutADescriptionEverythingIsDeclared) {
  auto subject = fake_oneshot("good");
  EXPECT_TRUE(subject->info().declares("sinumerik840d", "cycle83"));
  EXPECT_EQ(subject->info().name, std::string(FAKE_ONESHOT) + " good");
}

TEST(OneshotSubject, ADescriptionCounts) {
  auto subject = fake_oneshot("described");
  EXPECT_EQ(subject->info().name, "shot");
  EXPECT_TRUE(subject->info().declares("rs274", "g81"));
  EXPECT_FALSE(subject->info().declares("gsk988ta", "g94"));
}

// A machine of inches; nobody said that the subject's is one.
reference::Profile inch_machine() {
  reference::Profile profile = gsk_profile();
  profile.units = reference::Units::inch;
  return profile;
}

TEST(OneshotSubject, OneThatLeavesTheProfileUnreadIsNotRunForAnotherMachine) {
  auto subject = fake_oneshot("good");
  EXPECT_EQ(run(*subject).end.kind, Kind::ok);
  subject->configure(inch_machine());
  const RunEnd end = run(*subject).end;
  EXPECT_EQ(end.kind, Kind::refused);
  EXPECT_TRUE(has(end.message, "does not read --profile"));
  subject->configure(gsk_profile());
  EXPECT_EQ(run(*subject).end.kind, Kind::ok);
}

TEST(OneshotSubject, OneThatReadsTheProfileIsRunForEveryMachine) {
  auto subject = fake_oneshot("reads");
  subject->configure(inch_machine());
  EXPECT_EQ(run(*subject).end.kind, Kind::ok);
}

TEST(OneshotSubject, TheMachineThatTheCertifierStatesIsItsOwn) {
  Limits limits = patient_limits();
  limits.stated.profile = inch_machine();
  auto subject = fake_oneshot("good", limits);
  EXPECT_EQ(run(*subject).end.kind, Kind::refused);  // of millimetres
  subject->configure(inch_machine());
  EXPECT_EQ(run(*subject).end.kind, Kind::ok);
}

TEST(OneshotSubject, ABadDescriptionOrCommandIsUnusable) {
  EXPECT_THROW(fake_oneshot("described-badly"), SubjectUnusable);
  EXPECT_THROW(make_oneshot_subject("/no/such/program", run_limits(300)), SubjectUnusable);
}

TEST(OneshotSubject, ManyRunsLeaveNothingBehind) {
  auto subject = fake_oneshot("abort");
  const std::size_t before = open_descriptors();
  for (int i = 0; i < 200; ++i) ASSERT_EQ(run(*subject).end.kind, Kind::crash);
  EXPECT_EQ(open_descriptors(), before);
  EXPECT_FALSE(has_children());
}

}  // namespace
}  // namespace gonogo::oracle
