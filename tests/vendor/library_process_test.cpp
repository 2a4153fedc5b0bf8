// SPDX-License-Identifier: GPL-3.0-or-later
//
// A library under the gauge, in the process of its own that `gonogo host` gives it.
#include "libraries.hpp"

namespace gonogo::oracle {
namespace {

using reference::Axis;
using reference::Number;
using reference::RecordKind;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(LibraryProcess, DescribesItselfWithTheWindowOfTheHost) {
  const auto subject = subject_of("WELL");
  EXPECT_EQ(subject->info().name, "fake \"library\"");
  EXPECT_EQ(subject->info().max_in_flight, 64);
  EXPECT_EQ(subject->info().numeric_kind, "binary64");
  EXPECT_TRUE(subject->info().declares("gsk988ta", "basic"));
}

TEST(LibraryProcess, EveryKindOfRecordComesThrough) {
  const auto subject = subject_of("WELL");
  const Ran ran = run(*subject, "kinds");
  ASSERT_EQ(ran.end.kind, Kind::ok) << ran.end.message;
  ASSERT_EQ(ran.records.size(), 8u);
  const std::vector<RecordKind> expected = {
      RecordKind::rapid,  RecordKind::feed,  RecordKind::arc, RecordKind::arc3,
      RecordKind::thread, RecordKind::dwell, RecordKind::m,   RecordKind::end};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(ran.records[i].kind, expected[i]);
    EXPECT_EQ(ran.records[i].block, 1u);
  }
  EXPECT_EQ(ran.records[1].feed_mode, reference::FeedMode::per_revolution);
  EXPECT_EQ(ran.records[2].plane, reference::Plane::g18);
  EXPECT_EQ(ran.records[2].rot, -2);
  EXPECT_EQ(ran.records[6].m, 35);
}

TEST(LibraryProcess, NumbersArriveExactly) {
  const auto subject = subject_of("WELL");
  const Ran ran = run(*subject, "kinds");
  ASSERT_EQ(ran.records.size(), 8u) << ran.end.message;
  // The double next to 0.1 is 0x1.999999999999ap-4, by IEEE 754; denorm_min is 2^-1074.
  EXPECT_EQ(ran.records[0].to[Axis::x], Number::parse("0x1.999999999999ap-4"));
  EXPECT_NE(ran.records[0].to[Axis::x], Number::parse("0.1"));
  EXPECT_EQ(ran.records[0].to[Axis::z], Number(-3));
  EXPECT_EQ(ran.records[1].to[Axis::y], Number(1) / Number(3));
  EXPECT_EQ(ran.records[1].feed, Number(3));
  EXPECT_EQ(ran.records[2].feed, Number::binary(1, -1074));
  EXPECT_EQ(ran.records[2].centre[1], Number(2));
  EXPECT_EQ(ran.records[2].to[Axis::x], Number(1) / Number(1000));
  EXPECT_EQ(ran.records[3].via[Axis::z], Number(5) / Number(2));
  EXPECT_EQ(ran.records[4].lead, Number(3) / Number(2));
  EXPECT_EQ(ran.records[5].seconds, Number(5) / Number(2));
  EXPECT_EQ(ran.records[7].to[Axis::c], Number(0));
}

TEST(LibraryProcess, ALongRunComesInParts) {
  const auto subject = subject_of("WELL");
  const Ran ran = run(*subject, "many");
  EXPECT_EQ(ran.end.kind, Kind::ok) << ran.end.message;
  ASSERT_EQ(ran.records.size(), 100'000u);
  EXPECT_EQ(ran.records.back().to[Axis::x], Number(199'999) / Number(2));
}

TEST(LibraryProcess, TheSinkStopsALongRunAndTheNextIsWhole) {
  const auto subject = subject_of("WELL");
  const Ran ran = run(*subject, "many", 10);
  EXPECT_EQ(ran.end.kind, Kind::stopped) << ran.end.message;
  EXPECT_EQ(ran.records.size(), 10u);
  EXPECT_EQ(run(*subject, "kinds").records.size(), 8u);
}

TEST(LibraryProcess, AlarmSkipAndErrorAreTold) {
  const auto subject = subject_of("WELL");
  const Ran alarm = run(*subject, "alarm");
  EXPECT_EQ(alarm.end.kind, Kind::alarm) << alarm.end.message;
  EXPECT_EQ(alarm.end.alarm.native, "E\"61\"");
  EXPECT_EQ(alarm.end.alarm.alarm_class, "value-sign");
  EXPECT_EQ(alarm.end.alarm.block, 7u);
  EXPECT_EQ(alarm.end.alarm.word.text(), "Q");
  const Ran skip = run(*subject, "skip");
  EXPECT_EQ(skip.end.kind, Kind::skip);
  EXPECT_EQ(skip.end.feature, "g116");
  const Ran error = run(*subject, "error");
  EXPECT_EQ(error.end.kind, Kind::error);
  EXPECT_TRUE(contains(error.end.message, "no tool table")) << error.end.message;
}

TEST(LibraryProcess, NotesAreOfTheirRunWhenOthersAreSentAhead) {
  const auto subject = subject_of("WELL");
  const auto take = [](const reference::Record&) { return true; };
  const std::vector<std::string> programs = {"kinds", "skip", "kinds", "error", "alarm"};
  for (const std::string& program : programs) subject->announce(program, program);
  std::vector<std::string> notes;
  for (const std::string& program : programs) {
    notes.push_back(subject->run(program, program, take).notes);
  }
  EXPECT_EQ(notes, (std::vector<std::string>{"", "g116\n", "", "no tool table\n", ""}));
}

TEST(LibraryProcess, EveryRunStartsFromReset) {
  const auto subject = subject_of("WELL");
  EXPECT_EQ(run(*subject, "runs").records.size(), 1u);
  EXPECT_EQ(run(*subject, "runs").records.size(), 1u);
}

TEST(LibraryProcess, BytesReachTheLibraryAsTheyAre) {
  const auto subject = subject_of("WELL");
  const Ran ran = run(*subject, "\xff\xfe");
  EXPECT_EQ(ran.end.kind, Kind::ok) << ran.end.message;
  EXPECT_EQ(ran.records.size(), 2u);
}

TEST(LibraryProcess, WhatTheLibraryPrintsIsKeptForTheReportAndDisturbsNothing) {
  const auto subject = subject_of("LOUD");
  const Ran ran = run(*subject, "print");
  EXPECT_EQ(ran.end.kind, Kind::ok) << ran.end.message;
  EXPECT_EQ(ran.records.size(), 1u);
  EXPECT_EQ(run(*subject, "kinds").records.size(), 8u);
}

TEST(LibraryProcess, EveryWayToEndTheProcessIsACrashThatNamesTheLibrary) {
  const auto subject = subject_of("WELL");
  for (const char* way : {"crash", "exit", "throw"}) {
    const Ran ran = run(*subject, way);
    EXPECT_EQ(ran.end.kind, Kind::crash) << way << ": " << ran.end.message;
    EXPECT_TRUE(contains(ran.end.message, "library_WELL.so")) << ran.end.message;
    EXPECT_EQ(run(*subject, "kinds").end.kind, Kind::ok) << "after " << way;
  }
}

TEST(LibraryProcess, AnExceptionThatEscapesIsNamed) {
  const auto subject = subject_of("WELL");
  const Ran ran = run(*subject, "throw");
  EXPECT_TRUE(contains(ran.end.notes, "boom")) << ran.end.notes;
}

TEST(LibraryProcess, AHangIsATimeout) {
  Limits limits = patient_limits();
  limits.run = std::chrono::milliseconds(300);
  const auto subject = subject_of("WELL", limits);
  const Ran ran = run(*subject, "hang");
  EXPECT_EQ(ran.end.kind, Kind::timeout) << ran.end.message;
  EXPECT_TRUE(contains(ran.end.message, "library_WELL.so")) << ran.end.message;
}

TEST(LibraryProcess, MemoryIsLimited) {
  Limits limits = patient_limits();
  limits.memory_bytes = std::size_t{300} << 20;
  const auto subject = subject_of("WELL", limits);
  EXPECT_EQ(run(*subject, "memory").end.kind, Kind::out_of_memory);
}

TEST(LibraryProcess, WhatBreaksTheInterfaceIsProtocol) {
  const auto subject = subject_of("WELL");
  for (const char* fault : {"two-alarms", "answer", "nan", "kind", "number", "skip-nothing"}) {
    const Ran ran = run(*subject, fault);
    EXPECT_EQ(ran.end.kind, Kind::protocol) << fault << ": " << ran.end.message;
    EXPECT_TRUE(contains(ran.end.message, "library_WELL.so")) << ran.end.message;
  }
}

TEST(LibraryProcess, ARefusedConfigurationIsToldByTheRuns) {
  const auto subject = subject_of("WELL", patient_limits(), "hnc21t");
  const Ran ran = run(*subject, "kinds");
  EXPECT_EQ(ran.end.kind, Kind::refused);
  EXPECT_EQ(ran.end.message, "No HNC.");
}

TEST(LibraryProcess, AConfigurationThatFailsIsNoRefusal) {
  const auto subject = subject_of("WELL", patient_limits(), "rs274");
  const Ran ran = run(*subject, "kinds");
  EXPECT_EQ(ran.end.kind, Kind::error);
  EXPECT_TRUE(contains(ran.end.message, "No licence.")) << ran.end.message;
}

}  // namespace
}  // namespace gonogo::oracle
