// SPDX-License-Identifier: GPL-3.0-or-later
#include "gonogo/subject.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "run_subject.hpp"
#include "tests/has.hpp"

namespace gonogo::oracle {
namespace {

// A subject whose run is what the test says.
struct Fake {
  std::function<int(const gonogo_sink_v1&)> run;
  std::function<int(const gonogo_sink_v1&)> create = [](auto&) { return GONOGO_OK; };
  std::string description = R"({"protocol":1,"subject":{"name":"fake","version":"1"}})";
  int reset_answer = GONOGO_OK;
  gonogo_sink_v1 sink{};
  std::string configuration;
  std::string program;
  int created = 0;
  int resets = 0;
  int destroyed = 0;
};
Fake fake_interface;

gonogo_text text(const std::string& from) {
  return {from.data(), from.size()};
}

gonogo_text describe() {
  return text(fake_interface.description);
}
int create(gonogo_text configuration, const gonogo_sink_v1* sink, void** handle) {
  fake_interface.configuration.assign(configuration.data, configuration.size);
  fake_interface.sink = *sink;
  *handle = &fake_interface;
  ++fake_interface.created;
  return fake_interface.create(*sink);
}
int run_fake(void*, gonogo_text program) {
  fake_interface.program.assign(program.data, program.size);
  return fake_interface.run(fake_interface.sink);
}
int reset(void*) {
  ++fake_interface.resets;
  return fake_interface.reset_answer;
}
void destroy(void*) {
  ++fake_interface.destroyed;
}

gonogo_subject_v1 table() {
  return {
      GONOGO_SUBJECT_ABI, sizeof(gonogo_subject_v1), describe, create, run_fake, reset, destroy};
}

gonogo_number number(const std::string& from) {
  return {GONOGO_NUMBER_TEXT, 0, text(from)};
}
gonogo_number number(double value) {
  return {GONOGO_NUMBER_BINARY64, value, {}};
}

gonogo_record_v1 record(std::uint32_t kind) {
  gonogo_record_v1 made{};
  made.struct_size = sizeof made;
  made.kind = kind;
  made.block = 4;
  return made;
}

const std::string kOne = "1";
const std::string kBad = "1,5";

class InterfaceSubject : public ::testing::Test {
 protected:
  void SetUp() override { fake_interface = Fake(); }

  Ran run_with(std::function<int(const gonogo_sink_v1&)> action, std::size_t most = 1000) {
    fake_interface.run = std::move(action);
    if (!subject_) {
      subject_ = make_interface_subject(table_);
      subject_->configure(gsk_profile());
    }
    return run(*subject_, "G0 X1\n", most);
  }
  // Sends one record and ends well.
  Ran send(const gonogo_record_v1& made) {
    return run_with([&](auto& sink) {
      sink.record(sink.context, &made);
      return GONOGO_OK;
    });
  }

  const gonogo_subject_v1 table_ = table();
  std::unique_ptr<Subject> subject_;
};

TEST_F(InterfaceSubject, TextIsTheNumberThatItSays) {
  auto made = record(GONOGO_DWELL);
  const std::string third = "1/3";
  made.seconds = number(third);
  const Ran ran = send(made);
  EXPECT_EQ(ran.end.kind, Kind::ok) << ran.end.message;
  ASSERT_EQ(ran.records.size(), 1u);
  EXPECT_EQ(ran.records[0].seconds, Number(1) / Number(3));
  EXPECT_EQ(ran.records[0].block, 4u);
}

TEST_F(InterfaceSubject, ADoubleIsItsExactValue) {
  auto made = record(GONOGO_RAPID);
  made.to[GONOGO_X] = number(0.1);  // 0x1.999999999999ap-4, by IEEE 754
  made.to[GONOGO_Y] = number(-0.0);
  made.to[GONOGO_Z] = number(std::numeric_limits<double>::denorm_min());  // 2^-1074
  made.to[GONOGO_A] = number(-std::numeric_limits<double>::max());
  const Ran ran = send(made);
  ASSERT_EQ(ran.records.size(), 1u) << ran.end.message;
  const auto& to = ran.records[0].to;
  EXPECT_EQ(to[reference::Axis::x], Number::parse("0x1.999999999999ap-4"));
  EXPECT_NE(to[reference::Axis::x], Number::parse("0.1"));
  EXPECT_EQ(to[reference::Axis::y], Number(0));
  EXPECT_EQ(to[reference::Axis::z], Number::binary(1, -1074));
  EXPECT_EQ(to[reference::Axis::a], -Number::binary((std::int64_t{1} << 53) - 1, 971));
  EXPECT_FALSE(ran.records[0].axes.has(reference::Axis::c));
}

TEST_F(InterfaceSubject, WhatIsNoNumberIsProtocol) {
  auto made = record(GONOGO_DWELL);
  for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    made.seconds = number(bad);
    EXPECT_EQ(send(made).end.kind, Kind::protocol);
  }
  made.seconds = number(kBad);
  EXPECT_EQ(send(made).end.kind, Kind::protocol);
  made.seconds = {7, 0, {}};
  EXPECT_EQ(send(made).end.kind, Kind::protocol);
  made.seconds = {};
  EXPECT_EQ(send(made).end.kind, Kind::protocol);
}

TEST_F(InterfaceSubject, AnArcIsRead) {
  auto made = record(GONOGO_ARC);
  made.plane = 18;
  made.centre[0] = number(1.0);
  made.centre[1] = number(2.0);
  made.rot = -1;
  made.f = number(100.0);
  made.feed_mode = GONOGO_FEED_PER_REVOLUTION;
  made.to[GONOGO_X] = number(3.0);
  made.to[GONOGO_Z] = number(4.0);
  const Ran ran = send(made);
  ASSERT_EQ(ran.records.size(), 1u) << ran.end.message;
  EXPECT_EQ(ran.records[0].plane, reference::Plane::g18);
  EXPECT_EQ(ran.records[0].centre[0], Number(1));
  EXPECT_EQ(ran.records[0].feed_mode, reference::FeedMode::per_revolution);
  made.to[GONOGO_Z] = {};
  EXPECT_EQ(send(made).end.kind, Kind::protocol);
}

TEST_F(InterfaceSubject, NothingIsIgnoredSilently) {
  auto made = record(GONOGO_RAPID);
  made.f = number(kOne);
  EXPECT_EQ(send(made).end.kind, Kind::protocol);
  made = record(GONOGO_M);
  made.rot = 1;
  EXPECT_EQ(send(made).end.kind, Kind::protocol);
  EXPECT_EQ(send(record(99)).end.kind, Kind::protocol);
  made = record(GONOGO_M);
  made.struct_size -= 8;
  EXPECT_EQ(send(made).end.kind, Kind::protocol);
}

TEST_F(InterfaceSubject, AnAlarmIsReported) {
  const std::string native = "61";
  const std::string klass = "value-sign";
  const Ran ran = run_with([&](auto& sink) {
    gonogo_alarm_v1 alarm{sizeof(gonogo_alarm_v1), 3, text(native), text(klass), 'Q'};
    sink.alarm(sink.context, &alarm);
    return GONOGO_ALARM;
  });
  EXPECT_EQ(ran.end.kind, Kind::alarm) << ran.end.message;
  EXPECT_EQ(ran.end.alarm.alarm_class, "value-sign");
  EXPECT_EQ(ran.end.alarm.block, 3u);
}

TEST_F(InterfaceSubject, AlarmAndAnswerMustAgree) {
  const std::string klass = "syntax";
  gonogo_alarm_v1 alarm{sizeof(gonogo_alarm_v1), 3, {}, text(klass), 0};
  auto with = [&](int alarms, int answer) {
    return run_with([&, alarms, answer](auto& sink) {
             for (int i = 0; i < alarms; ++i) sink.alarm(sink.context, &alarm);
             return answer;
           })
        .end.kind;
  };
  EXPECT_EQ(with(1, GONOGO_ALARM), Kind::alarm);
  EXPECT_EQ(with(1, GONOGO_OK), Kind::protocol);
  EXPECT_EQ(with(0, GONOGO_ALARM), Kind::protocol);
  EXPECT_EQ(with(2, GONOGO_ALARM), Kind::protocol);
  EXPECT_EQ(with(0, GONOGO_STOPPED), Kind::protocol);
  EXPECT_EQ(with(0, 12), Kind::protocol);
}

TEST_F(InterfaceSubject, ASkipAndAnErrorGiveTheNote) {
  const std::string feature = "g116";
  auto answer = [&](int value) {
    return run_with([&, value](auto& sink) {
             sink.note(sink.context, GONOGO_NOTE_ERROR, text(feature));
             return value;
           })
        .end;
  };
  EXPECT_EQ(answer(GONOGO_UNSUPPORTED).kind, Kind::skip);
  EXPECT_EQ(answer(GONOGO_UNSUPPORTED).feature, "g116");
  EXPECT_EQ(answer(GONOGO_ERROR).kind, Kind::error);
  EXPECT_EQ(answer(GONOGO_ERROR).notes, "g116\n");
}

TEST_F(InterfaceSubject, TheSinkStopsTheRun) {
  auto made = record(GONOGO_DWELL);
  made.seconds = number(kOne);
  int sent = 0;
  const Ran ran = run_with(
      [&](auto& sink) {
        while (sink.record(sink.context, &made) == 0) ++sent;
        return GONOGO_STOPPED;
      },
      10);
  EXPECT_EQ(ran.end.kind, Kind::stopped);
  EXPECT_EQ(ran.records.size(), 10u);
  EXPECT_EQ(sent, 9);
}

TEST_F(InterfaceSubject, AnEscapingExceptionIsACrashAndTheHandleIsNotUsedAgain) {
  const Ran ran = run_with([](auto&) -> int { throw std::runtime_error("boom"); });
  EXPECT_EQ(ran.end.kind, Kind::crash);
  EXPECT_TRUE(has(ran.end.message, "boom"));
  EXPECT_EQ(fake_interface.destroyed, 1);
  EXPECT_EQ(run_with([](auto&) { return GONOGO_OK; }).end.kind, Kind::ok);
  EXPECT_EQ(fake_interface.created, 2);
}

TEST_F(InterfaceSubject, WhatTheSinkThrowsCrossesTheBorderBehindTheSubject) {
  auto made = record(GONOGO_DWELL);
  made.seconds = number(kOne);
  bool returned = false;
  fake_interface.run = [&](const gonogo_sink_v1& sink) {
    const int answer = sink.record(sink.context, &made);
    returned = true;
    return answer == 0 ? GONOGO_OK : GONOGO_STOPPED;
  };
  const auto own = make_interface_subject(table_);
  own->configure(gsk_profile());
  EXPECT_THROW(own->run("x", "G0\n",
                        [](const reference::Record&) -> bool { throw std::logic_error("judge"); }),
               std::logic_error);
  EXPECT_TRUE(returned);
}

TEST_F(InterfaceSubject, IsResetBetweenRunsAndRenewedOnRequest) {
  auto well = [](auto&) { return GONOGO_OK; };
  run_with(well);
  EXPECT_EQ(fake_interface.resets, 0);
  run_with(well);
  EXPECT_EQ(fake_interface.resets, 1);
  EXPECT_EQ(fake_interface.created, 1);
  subject_->renew();
  run_with(well);
  EXPECT_EQ(fake_interface.created, 2);
  EXPECT_EQ(fake_interface.resets, 1);
  subject_.reset();
  EXPECT_EQ(fake_interface.destroyed, 2);
}

TEST_F(InterfaceSubject, GetsTheConfigurationOfTheProtocol) {
  run_with([](auto&) { return GONOGO_OK; });
  EXPECT_EQ(fake_interface.configuration.find(R"({"dialect":"gsk988ta","profile":{)"), 0u)
      << fake_interface.configuration;
  EXPECT_EQ(fake_interface.program, "G0 X1\n");
}

TEST_F(InterfaceSubject, AReadingThatTheCertifierStatesNeedNotBeTold) {
  reference::Profile profile = gsk_profile();
  ASSERT_FALSE(set_reading(profile, "gsk.decimals", "nearest"));
  fake_interface.run = [](auto&) { return GONOGO_OK; };
  subject_ = make_interface_subject(table_);
  subject_->configure(profile);
  EXPECT_EQ(run(*subject_, "G0 X1\n", 1000).end.kind, Kind::refused);
  subject_ = make_interface_subject(table_, {std::nullopt, {"gsk.decimals=nearest"}});
  subject_->configure(profile);
  EXPECT_EQ(run(*subject_, "G0 X1\n", 1000).end.kind, Kind::ok);
  EXPECT_FALSE(has(fake_interface.configuration, "gsk.decimals"));
}

TEST_F(InterfaceSubject, ARefusalToBeCreatedIsTold) {
  const std::string why = "no readings";
  fake_interface.create = [&](const gonogo_sink_v1& sink) {
    sink.note(sink.context, GONOGO_NOTE_ERROR, text(why));
    return GONOGO_UNSUPPORTED;
  };
  const Ran ran = run_with([](auto&) { return GONOGO_OK; });
  EXPECT_EQ(ran.end.kind, Kind::refused);
  EXPECT_EQ(ran.end.message, "no readings");
}

TEST_F(InterfaceSubject, ATableThatDoesNotFitIsUnusable) {
  auto other = table();
  other.abi = 2;
  EXPECT_THROW(make_interface_subject(other), SubjectUnusable);
  other = table();
  other.struct_size = 16;
  EXPECT_THROW(make_interface_subject(other), SubjectUnusable);
  other = table();
  other.run = nullptr;
  EXPECT_THROW(make_interface_subject(other), SubjectUnusable);
  fake_interface.description = R"({"protocol":3})";
  EXPECT_THROW(make_interface_subject(table_), SubjectUnusable);
}

}  // namespace
}  // namespace gonogo::oracle
