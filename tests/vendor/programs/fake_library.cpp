// SPDX-License-Identifier: GPL-3.0-or-later
//
// A library that misbehaves: VARIANT says how it presents itself, the program says what a run does.
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "gonogo/subject.h"

// What VARIANT may be.
#define WELL 0
#define WITHOUT_ENTRY 1
#define WITHOUT_INTERFACE 2
#define OLDER_TABLE 3
#define NULL_FUNCTION 4
#define BAD_DESCRIPTION 5
#define CRASH_AT_LOAD 6
#define HANG_AT_DESCRIBE 7
#define OTHER_ABI 8
#define LOUD 9

namespace {

struct Handle {
  const gonogo_sink_v1* sink;
  int runs = 0;
};

gonogo_text text_of(const char* text) {
  return {text, std::strlen(text)};
}

gonogo_number number(double value) {
  return {GONOGO_NUMBER_BINARY64, value, {}};
}
gonogo_number number(const char* value) {
  return {GONOGO_NUMBER_TEXT, 0, text_of(value)};
}

gonogo_record_v1 record_of(unsigned kind) {
  gonogo_record_v1 record{};
  record.struct_size = sizeof record;
  record.kind = kind;
  record.block = 1;
  return record;
}

int give(const Handle& handle, const gonogo_record_v1& record) {
  return handle.sink->record(handle.sink->context, &record);
}

int note(const gonogo_sink_v1& sink, int answer, const char* text) {
  sink.note(sink.context, GONOGO_NOTE_ERROR, text_of(text));
  return answer;
}

// Every kind of record, every form of number.
int all_kinds(const Handle& handle) {
  auto rapid = record_of(GONOGO_RAPID);
  rapid.to[GONOGO_X] = number(0.1);
  rapid.to[GONOGO_Z] = number(-3.0);
  auto feed = record_of(GONOGO_FEED);
  feed.to[GONOGO_Y] = number("1/3");
  feed.f = number("0x1.8p1");
  feed.feed_mode = GONOGO_FEED_PER_REVOLUTION;
  auto arc = record_of(GONOGO_ARC);
  arc.plane = 18;
  arc.centre[0] = number(1.0);
  arc.centre[1] = number(2.0);
  arc.rot = -2;
  arc.f = number(5e-324);
  arc.to[GONOGO_X] = number("1e-3");
  arc.to[GONOGO_Z] = number(1e300);
  auto arc3 = record_of(GONOGO_ARC3);
  for (int axis : {GONOGO_X, GONOGO_Y, GONOGO_Z}) {
    arc3.via[axis] = number(axis + 0.5);
    arc3.to[axis] = number(axis + 10.0);
  }
  arc3.f = number(100.0);
  auto thread = record_of(GONOGO_THREAD);
  thread.to[GONOGO_Z] = number(-20.0);
  thread.lead = number("1.5");
  thread.start = number(0.0);
  auto dwell = record_of(GONOGO_DWELL);
  dwell.seconds = number("2.5");
  auto m = record_of(GONOGO_M);
  m.m = 35;
  auto end = record_of(GONOGO_END);
  for (auto& axis : end.to) axis = number(-0.0);
  for (const auto& record : {rapid, feed, arc, arc3, thread, dwell, m, end}) {
    if (give(handle, record) != 0) return GONOGO_STOPPED;
  }
  return GONOGO_OK;
}

int many(const Handle& handle, int count) {
  auto record = record_of(GONOGO_RAPID);
  for (int i = 0; i < count; ++i) {
    record.to[GONOGO_X] = number(i + 0.5);
    if (give(handle, record) != 0) return GONOGO_STOPPED;
  }
  return GONOGO_OK;
}

int alarm(const Handle& handle, int times) {
  const gonogo_alarm_v1 told = {sizeof told, 7, text_of("E\"61\""), text_of("value-sign"), 'Q'};
  for (int i = 0; i < times; ++i) handle.sink->alarm(handle.sink->context, &told);
  return GONOGO_ALARM;
}

[[noreturn]] void eat_memory() {
  constexpr std::size_t kPiece = std::size_t{8} << 20;
  std::vector<char*> pieces;
  while (pieces.size() < 200) {
    pieces.push_back(static_cast<char*>(std::malloc(kPiece)));
    std::memset(pieces.back(), 1, kPiece);
    usleep(2000);
  }
  while (true) pause();
}

int misbehave(const Handle& handle, const std::string& what) {
  if (what == "crash") std::raise(SIGSEGV);
  if (what == "exit") std::exit(0);
  if (what == "throw") throw std::runtime_error("boom");
  if (what == "memory") eat_memory();
  if (what == "two-alarms") return alarm(handle, 2);
  if (what == "answer") return 12;
  if (what == "nan") {
    auto record = record_of(GONOGO_DWELL);
    record.seconds = number(std::nan(""));
    give(handle, record);
  }
  if (what == "kind") give(handle, record_of(99));
  if (what == "number") {
    auto record = record_of(GONOGO_DWELL);
    record.seconds = number("1,5");
    give(handle, record);
  }
  while (what == "hang") pause();
  return GONOGO_OK;
}

int run(void* made, gonogo_text program) {
  Handle& handle = *static_cast<Handle*>(made);
  const std::string what(program.data, program.size);
  ++handle.runs;
  if (what == "kinds") return all_kinds(handle);
  if (what == "many") return many(handle, 100'000);
  if (what == "alarm") return alarm(handle, 1);
  if (what == "skip") return note(*handle.sink, GONOGO_UNSUPPORTED, "g116");
  if (what == "skip-nothing") return GONOGO_UNSUPPORTED;
  if (what == "error") return note(*handle.sink, GONOGO_ERROR, "no tool table");
  if (what == "runs") return many(handle, handle.runs);
  if (what == "\xff\xfe") return many(handle, 2);
  if (what == "print") {
    std::printf("{\"seq\":1,\"outcome\":\"ok\"}\n");
    [[maybe_unused]] const auto count = write(STDOUT_FILENO, "written\n", 8);
    return std::getchar() == EOF ? many(handle, 1) : GONOGO_ERROR;
  }
  return misbehave(handle, what);
}

gonogo_text describe() {
#if VARIANT == BAD_DESCRIPTION
  return text_of("{\"protocol\":1}");
#elif VARIANT == HANG_AT_DESCRIBE
  while (true) pause();
#elif VARIANT == LOUD
  std::puts("the library says good morning");
#endif
  return text_of(
      "{\"protocol\":1,\n \"subject\":{\"name\":\"fake \\\"library\\\"\",\"version\":\"1\"},\n"
      " \"dialects\":{\"gsk988ta\":[\"basic\"]}, \"max_in_flight\":1,\n"
      " \"features\":[\"blocks\",\"bytes\"], \"numeric\":{\"kind\":\"binary64\"}}\n");
}

int create(gonogo_text configuration, const gonogo_sink_v1* sink, void** handle) {
  const std::string text(configuration.data, configuration.size);
  if (text.find("\"hnc21t\"") != std::string::npos)
    return note(*sink, GONOGO_UNSUPPORTED, "No HNC.");
  if (text.find("\"rs274\"") != std::string::npos) return note(*sink, GONOGO_ERROR, "No licence.");
  *handle = new Handle{sink};
  return GONOGO_OK;
}

int reset(void* handle) {
  static_cast<Handle*>(handle)->runs = 0;
  return GONOGO_OK;
}

void destroy(void* handle) {
  delete static_cast<Handle*>(handle);
}

#if VARIANT == CRASH_AT_LOAD
const int kCrash = std::raise(SIGABRT);
#endif

}  // namespace

#if VARIANT == WITHOUT_ENTRY
#define ENTRY gonogo_get_another
#else
#define ENTRY gonogo_get_subject
#endif
extern "C" const gonogo_subject_v1* ENTRY(uint32_t abi) {
  static gonogo_subject_v1 subject = {
      GONOGO_SUBJECT_ABI, sizeof(gonogo_subject_v1), describe, create, run, reset, destroy};
#if VARIANT == OLDER_TABLE
  subject.struct_size = 16;
#elif VARIANT == NULL_FUNCTION
  subject.reset = nullptr;
#elif VARIANT == OTHER_ABI
  subject.abi = 2;
#elif VARIANT == WITHOUT_INTERFACE
  abi = 0;
#endif
  return abi >= GONOGO_SUBJECT_ABI ? &subject : nullptr;
}
