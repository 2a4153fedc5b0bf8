// SPDX-License-Identifier: GPL-3.0-or-later
// The C interface: life of a handle, streaming, stopping, bad use.
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "expanders/registry.hpp"
#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

TEST(Registry, KnowsItsNames) {
  EXPECT_NE(find("gsk"), nullptr);
  EXPECT_NE(find("gsk", "taper-sign"), nullptr);
  EXPECT_EQ(find("gsk", "no-such-fault"), nullptr);
  EXPECT_NE(find("hnc"), nullptr);
  EXPECT_NE(find("hnc", "g80-taper-sign"), nullptr);
  EXPECT_EQ(find("hnc", "taper-sign"), nullptr);
  EXPECT_NE(find("ngc"), nullptr);
  EXPECT_NE(find("ngc", "helix-flat"), nullptr);
  EXPECT_EQ(find("acme"), nullptr);
  EXPECT_TRUE(faults("acme").empty());
  EXPECT_EQ(names().size(), 4u);
}

TEST(Subject, DescribesItself) {
  const gonogo_subject_v1* subject = find("gsk");
  EXPECT_EQ(subject->abi, GONOGO_SUBJECT_ABI);
  EXPECT_EQ(subject->struct_size, sizeof(gonogo_subject_v1));
  const gonogo_text text = subject->describe();
  const auto json = nlohmann::json::parse(text.data, text.data + text.size);
  EXPECT_EQ(json["protocol"], 1);
  const std::vector<std::string> features = {"basic", "arc",  "g90",  "g92", "g94",
                                             "g110",  "g112", "g114", "g116"};
  EXPECT_EQ(json["dialects"]["gsk988ta"], features);
  EXPECT_EQ(json["numeric"]["resolution"], "0.001");
}

TEST(Subject, EveryRunStartsFromPowerOn) {
  Session session;
  const Outcome first = session.run("G20 G17 G99 G1 X5 F3\nG94 X1 Y2 R1\n");
  session.run("G110 I9 L1 Q1 D2\n");
  session.run("G999\n");
  EXPECT_EQ(session.run("G20 G17 G99 G1 X5 F3\nG94 X1 Y2 R1\n").all(), first.all());
  EXPECT_EQ(session.run("X8\nG1 X4\n").alarm, "feed-missing");
}

TEST(Subject, ResetGivesThePowerOnState) {
  Session session;
  session.run("G1 X5 F100\n");
  EXPECT_EQ(session.reset(), GONOGO_OK);
  EXPECT_EQ(session.run("X8\n").all(), run("X8\n").all());
}

TEST(Subject, HandlesDoNotShareState) {
  Session radius(R"({"x_diameter":false})");
  Session diameter;
  radius.run("G20 G1 X1 F1\n");
  EXPECT_EQ(diameter.run("G0 X10\n").motions(), "rapid x=5\n");
  EXPECT_EQ(radius.run("G0 X10\n").motions(), "rapid x=10\n");
}

TEST(Subject, StopsAtOnceWhenTheSinkSaysSo) {
  for (std::size_t most = 1; most <= 5; ++most) {
    const Outcome outcome = Session().run("G0 X2\nG94 X1 Z-1 F9\n", most);
    EXPECT_EQ(outcome.answer, GONOGO_STOPPED);
    EXPECT_EQ(outcome.records.size(), most);
  }
}

TEST(Subject, EndlessWorkStreams) {
  // 999,999,999 layers; a full buffer of them would not fit in memory.
  const Outcome outcome = Session().run("G110 X0 Z0 Y-999999 I3 L3 Q0.001 D2 F9\n", 50'000);
  EXPECT_EQ(outcome.answer, GONOGO_STOPPED);
  EXPECT_EQ(outcome.records.size(), 50'000u);
  // Layer k is at -k/1000 and takes 6 records but the first, which needs no rapid to re-enter.
  EXPECT_EQ(outcome.records[0], "feed y=-0.001 f=9");
  EXPECT_EQ(outcome.records[5], "rapid y=-0.001");
  EXPECT_EQ(outcome.records[6], "feed y=-0.002 f=9");
}

TEST(Subject, RefusesWrongUse) {
  const gonogo_subject_v1* subject = find("gsk");
  void* handle = nullptr;
  gonogo_sink_v1 sink{};
  sink.struct_size = sizeof sink;
  EXPECT_EQ(subject->create({"{}", 2}, nullptr, &handle), GONOGO_ERROR);
  EXPECT_EQ(subject->create({"{}", 2}, &sink, &handle), GONOGO_ERROR);
  sink.record = [](void*, const gonogo_record_v1*) { return 0; };
  EXPECT_EQ(subject->create({"{", 1}, &sink, &handle), GONOGO_ERROR);
  EXPECT_EQ(subject->create({"[1]", 3}, &sink, &handle), GONOGO_ERROR);
  EXPECT_EQ(subject->run(nullptr, {"", 0}), GONOGO_ERROR);
  EXPECT_EQ(handle, nullptr);
  subject->destroy(nullptr);
}

TEST(Subject, AlarmAndNoteMayBeLeftOut) {
  const gonogo_subject_v1* subject = find("gsk");
  gonogo_sink_v1 sink{};
  sink.struct_size = sizeof sink;
  sink.record = [](void*, const gonogo_record_v1*) { return 0; };
  void* handle = nullptr;
  const char* text = R"({"dialect":"gsk988ta"})";
  ASSERT_EQ(subject->create({text, std::strlen(text)}, &sink, &handle), GONOGO_OK);
  EXPECT_EQ(subject->run(handle, {"G999", 4}), GONOGO_ALARM);
  EXPECT_EQ(subject->run(handle, {"G71", 3}), GONOGO_UNSUPPORTED);
  subject->destroy(handle);
}

TEST(Subject, RefusesAnotherDialect) {
  const gonogo_subject_v1* subject = find("gsk");
  gonogo_sink_v1 sink{};
  sink.struct_size = sizeof sink;
  sink.record = [](void*, const gonogo_record_v1*) { return 0; };
  void* handle = nullptr;
  const char* text = R"({"dialect":"hnc21t","profile":{}})";
  EXPECT_EQ(subject->create({text, std::strlen(text)}, &sink, &handle), GONOGO_UNSUPPORTED);
}

}  // namespace
}  // namespace gonogo::expanders::testing
