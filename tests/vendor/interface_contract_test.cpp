// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contract of the C interface on the gauge's side: sizes, callbacks outside a run, life of a
// handle.
#include <cstring>

#include "libraries.hpp"
#include "subjects/interface_handle.hpp"
#include "subjects/interface_record.hpp"

namespace gonogo::oracle {
namespace {

// A subject that does what the test says and keeps count.
struct Fake {
  std::function<int(const gonogo_sink_v1&)> on_create = [](auto&) { return GONOGO_OK; };
  std::function<int(const gonogo_sink_v1&)> on_run = [](auto&) { return GONOGO_OK; };
  std::function<int(const gonogo_sink_v1&)> on_reset = [](auto&) { return GONOGO_OK; };
  const gonogo_sink_v1* sink = nullptr;
  int created = 0;
  int resets = 0;
  int destroyed = 0;
};
Fake fake;

gonogo_subject_v1 table() {
  gonogo_subject_v1 made{};
  made.abi = GONOGO_SUBJECT_ABI;
  made.struct_size = sizeof made;
  made.describe = [] { return gonogo_text{"{}", 2}; };
  made.create = [](gonogo_text, const gonogo_sink_v1* sink, void** handle) {
    ++fake.created;
    fake.sink = sink;
    *handle = &fake;
    return fake.on_create(*sink);
  };
  made.run = [](void*, gonogo_text) { return fake.on_run(*fake.sink); };
  made.reset = [](void*) {
    ++fake.resets;
    return fake.on_reset(*fake.sink);
  };
  made.destroy = [](void*) { ++fake.destroyed; };
  return made;
}

gonogo_record_v1 dwell() {
  static const std::string one = "1";
  gonogo_record_v1 made{};
  made.struct_size = sizeof made;
  made.kind = GONOGO_DWELL;
  made.seconds = {GONOGO_NUMBER_TEXT, 0, {one.data(), one.size()}};
  return made;
}

int send_record(const gonogo_sink_v1& sink) {
  const gonogo_record_v1 made = dwell();
  sink.record(sink.context, &made);
  return GONOGO_OK;
}

class InterfaceContract : public ::testing::Test {
 protected:
  void SetUp() override {
    fake = Fake();
    handle_.configure("{}");
  }
  RunEnd run() {
    return handle_.run("G0", [](const gonogo_record_v1&, std::string&) { return true; });
  }
  const gonogo_subject_v1 table_ = table();
  InterfaceHandle handle_{table_};
};

TEST_F(InterfaceContract, ANewerTableIsUsedAsFarAsItIsKnown) {
  gonogo_subject_v1 newer = table();
  newer.struct_size = sizeof newer + 64;
  InterfaceHandle handle(newer);
  handle.configure("{}");
  EXPECT_EQ(handle.run("G0", [](auto&, auto&) { return true; }).kind, Kind::ok);
}

TEST_F(InterfaceContract, ANewerRecordIsReadAsFarAsItIsKnown) {
  gonogo_record_v1 newer = dwell();
  newer.struct_size = sizeof newer + 64;
  EXPECT_FALSE(form_fault(newer));
  newer.struct_size = sizeof newer - 1;
  EXPECT_TRUE(form_fault(newer));
}

TEST_F(InterfaceContract, TheSinkSaysItsSize) {
  run();
  EXPECT_EQ(fake.sink->struct_size, sizeof(gonogo_sink_v1));
}

TEST_F(InterfaceContract, ARecordWhileTheHandleIsMadeBreaksIt) {
  fake.on_create = send_record;
  EXPECT_EQ(run().kind, Kind::protocol);
  EXPECT_EQ(fake.destroyed, 1);  // what was made is destroyed
}

TEST_F(InterfaceContract, ARecordInResetBreaksIt) {
  run();
  fake.on_reset = send_record;
  EXPECT_EQ(run().kind, Kind::protocol);
  EXPECT_EQ(fake.destroyed, 1);
}

TEST_F(InterfaceContract, AnAlarmOutsideARunBreaksIt) {
  fake.on_create = [](const gonogo_sink_v1& sink) {
    const gonogo_alarm_v1 alarm = {sizeof alarm, 1, {"1", 1}, {}, 0};
    sink.alarm(sink.context, &alarm);
    return GONOGO_OK;
  };
  EXPECT_EQ(run().kind, Kind::protocol);
}

TEST_F(InterfaceContract, NullPointersBreakIt) {
  fake.on_run = [](const gonogo_sink_v1& sink) {
    sink.record(sink.context, nullptr);
    return GONOGO_OK;
  };
  EXPECT_EQ(run().kind, Kind::protocol);
  fake.on_run = [](const gonogo_sink_v1& sink) {
    sink.alarm(sink.context, nullptr);
    return GONOGO_ALARM;
  };
  EXPECT_EQ(run().kind, Kind::protocol);
}

TEST_F(InterfaceContract, ARecordThatComesAfterTheSinkSaidStopIsNotTaken) {
  int taken = 0;
  fake.on_run = [](const gonogo_sink_v1& sink) {
    for (int i = 0; i < 5; ++i) send_record(sink);
    return GONOGO_OK;
  };
  const RunEnd end =
      handle_.run("G0", [&](const gonogo_record_v1&, std::string&) { return ++taken < 2; });
  EXPECT_EQ(end.kind, Kind::stopped);
  EXPECT_EQ(taken, 2);
}

TEST_F(InterfaceContract, AHandleIsMadeOnceAndResetBetweenRuns) {
  EXPECT_FALSE(handle_.prepare());
  run();
  run();
  EXPECT_EQ(fake.created, 1);
  EXPECT_EQ(fake.resets, 1);
  handle_.close();
  EXPECT_EQ(fake.destroyed, 1);
}

TEST_F(InterfaceContract, AResetThatFailsEndsTheHandleAndTheNextRunHasAnother) {
  run();
  fake.on_reset = [](auto&) { return GONOGO_ERROR; };
  EXPECT_EQ(run().kind, Kind::error);
  EXPECT_EQ(run().kind, Kind::ok);
  EXPECT_EQ(fake.created, 2);
  EXPECT_EQ(fake.destroyed, 1);
}

TEST_F(InterfaceContract, AFailedCreateIsNotDestroyed) {
  fake.on_create = [](auto&) { return GONOGO_ERROR; };
  EXPECT_EQ(run().kind, Kind::error);
  handle_.close();
  EXPECT_EQ(fake.destroyed, 0);
}

TEST_F(InterfaceContract, ASkipNamesTheFeature) {
  fake.on_run = [](auto&) { return GONOGO_UNSUPPORTED; };
  EXPECT_EQ(run().kind, Kind::protocol);
}

// A table that lacks one function, for each of the five.
TEST(InterfaceTable, EveryFunctionIsNeeded) {
  const auto refused = [](auto&& change) {
    gonogo_subject_v1 made = table();
    change(made);
    EXPECT_THROW(InterfaceHandle{made}, SubjectUnusable);
  };
  refused([](gonogo_subject_v1& t) { t.describe = nullptr; });
  refused([](gonogo_subject_v1& t) { t.create = nullptr; });
  refused([](gonogo_subject_v1& t) { t.run = nullptr; });
  refused([](gonogo_subject_v1& t) { t.reset = nullptr; });
  refused([](gonogo_subject_v1& t) { t.destroy = nullptr; });
  refused([](gonogo_subject_v1& t) { t.struct_size -= 1; });
  refused([](gonogo_subject_v1& t) { t.abi = 0; });
}

// Through the pipe and back: what the JSON of a record says is what the record says.
TEST(InterfaceJson, ARecordReadBackIsTheSame) {
  gonogo_record_v1 arc{};
  arc.struct_size = sizeof arc;
  arc.kind = GONOGO_ARC;
  arc.block = 12;
  arc.plane = 19;
  arc.rot = 3;
  arc.f = {GONOGO_NUMBER_BINARY64, 1e-7, {}};
  arc.centre[0] = {GONOGO_NUMBER_BINARY64, -0.3, {}};
  arc.centre[1] = {GONOGO_NUMBER_BINARY64, 9007199254740993.0, {}};
  arc.to[GONOGO_Y] = {GONOGO_NUMBER_BINARY64, 12345678.5, {}};
  arc.to[GONOGO_Z] = {GONOGO_NUMBER_TEXT, 0, {"-7/3", 4}};
  std::string json;
  append_json(arc, json);
  const auto direct = std::get<reference::Record>(convert_record(arc));
  const auto read = TraceReader().read(json);
  ASSERT_TRUE(std::holds_alternative<reference::Record>(read))
      << json << std::get<TraceFault>(read).message;
  const auto& back = std::get<reference::Record>(read);
  EXPECT_EQ(back.to[reference::Axis::y], direct.to[reference::Axis::y]);
  EXPECT_EQ(back.to[reference::Axis::z], direct.to[reference::Axis::z]);
  EXPECT_EQ(back.centre[0], direct.centre[0]);
  EXPECT_EQ(back.centre[1], direct.centre[1]);
  EXPECT_EQ(back.feed, direct.feed);
  EXPECT_EQ(back.rot, direct.rot);
  EXPECT_EQ(back.plane, direct.plane);
  EXPECT_EQ(back.block, direct.block);
}

}  // namespace
}  // namespace gonogo::oracle
