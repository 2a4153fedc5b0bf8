// SPDX-License-Identifier: GPL-3.0-or-later
//
// A subject behind the C interface, in this process.
#include <fmt/format.h>

#include <chrono>
#include <exception>

#include "gonogo/subject.h"
#include "oracle/subject.hpp"
#include "oracle/subjects/configuration.hpp"
#include "oracle/subjects/interface_record.hpp"
#include "oracle/subjects/start_reply.hpp"
#include "oracle/subjects/text.hpp"

namespace gonogo::oracle {
namespace {

using reference::Record;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostNotes = 16384;

// What one call of the subject has told so far. Nothing here throws through the subject.
struct Call {
  const RecordSink* sink = nullptr;
  bool stopped = false;
  int alarms = 0;
  SubjectAlarm alarm;
  std::string fault;
  std::string note;           // the last
  std::string notes;          // all, cut
  std::exception_ptr thrown;  // by the sink

  bool asked_to_stop() const { return stopped || !fault.empty() || thrown; }
  void note_fault(std::string message) {
    if (fault.empty()) fault = std::move(message);
  }
};

int take_record(void* context, const gonogo_record_v1* record) noexcept {
  Call& call = *static_cast<Call*>(context);
  try {
    if (call.asked_to_stop()) return 1;
    if (record == nullptr || call.sink == nullptr) {
      call.note_fault(record == nullptr ? "A record is a null pointer."
                                        : "A record came outside a run.");
      return 1;
    }
    if (call.alarms != 0) call.note_fault("A record came after the alarm.");
    auto converted = convert_record(*record);
    if (auto* fault = std::get_if<TraceFault>(&converted)) call.note_fault(fault->message);
    if (!call.fault.empty()) return 1;
    call.stopped = !(*call.sink)(std::get<Record>(converted));
    return call.stopped ? 1 : 0;
  } catch (...) {
    call.thrown = std::current_exception();
    return 1;
  }
}

void take_alarm(void* context, const gonogo_alarm_v1* alarm) noexcept {
  Call& call = *static_cast<Call*>(context);
  ++call.alarms;
  if (alarm == nullptr) return call.note_fault("An alarm is a null pointer.");
  if (call.alarms > 1) return call.note_fault("A second alarm came.");
  auto converted = convert_alarm(*alarm);
  if (auto* fault = std::get_if<TraceFault>(&converted)) return call.note_fault(fault->message);
  call.alarm = std::get<SubjectAlarm>(std::move(converted));
}

void take_note(void* context, int, gonogo_text message) noexcept {
  Call& call = *static_cast<Call*>(context);
  call.note = excerpt(view(message), 1000);
  if (call.notes.size() < kMostNotes) call.notes += call.note + "\n";
}

// Calls the subject; an exception that escapes it becomes a sentence.
template <class Function>
std::optional<std::string> escaped(Function&& function) noexcept {
  try {
    function();
    return std::nullopt;
  } catch (const std::exception& error) {
    return fmt::format("An exception left the subject: {}", readable(error.what()));
  } catch (...) {
    return "An exception left the subject.";
  }
}

RunEnd end_of(RunEnd::Kind kind, std::string message) {
  RunEnd end;
  end.kind = kind;
  end.message = std::move(message);
  return end;
}

class InterfaceSubject : public Subject {
 public:
  explicit InterfaceSubject(const gonogo_subject_v1& subject) : subject_(subject) {
    check_table();
    read_description();
    sink_.struct_size = sizeof sink_;
    sink_.context = &call_;
    sink_.record = take_record;
    sink_.alarm = take_alarm;
    sink_.note = take_note;
  }
  InterfaceSubject(const InterfaceSubject&) = delete;
  InterfaceSubject& operator=(const InterfaceSubject&) = delete;
  ~InterfaceSubject() override { close(); }

  const SubjectInfo& info() const override { return info_; }

  void configure(const reference::Profile& profile) override {
    std::string configuration = "{" + configuration_members(profile) + "}";
    if (configuration == configuration_) return;  // the handle is used on, as a controller would be
    close();
    configuration_ = std::move(configuration);
  }

  RunEnd run(std::string_view, std::string_view program, const RecordSink& sink) override {
    call_ = Call();
    const auto begin = Clock::now();
    RunEnd end = run_program(program, sink);
    end.microseconds =
        std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - begin).count();
    end.notes = std::move(call_.notes);
    call_.sink = nullptr;
    // The sink is the oracle's: what it throws is not the subject's doing.
    if (call_.thrown) std::rethrow_exception(std::exchange(call_.thrown, nullptr));
    return end;
  }

  void renew() override { close(); }

 private:
  void check_table() const {
    if (subject_.abi != GONOGO_SUBJECT_ABI) {
      throw SubjectUnusable(fmt::format(
          "The subject has version {} of the C interface; build it with the header of version {}.",
          subject_.abi, GONOGO_SUBJECT_ABI));
    }
    if (subject_.struct_size < sizeof subject_) {
      throw SubjectUnusable(
          fmt::format("gonogo_subject_v1 has struct_size {}; set it to sizeof(gonogo_subject_v1), "
                      "{} bytes.",
                      subject_.struct_size, sizeof subject_));
    }
    if (!subject_.describe || !subject_.create || !subject_.run || !subject_.reset ||
        !subject_.destroy) {
      throw SubjectUnusable("A function of gonogo_subject_v1 is null; all five are needed.");
    }
  }

  void read_description() {
    std::string text;
    if (auto thrown = escaped([&] { text = view(subject_.describe()); })) {
      throw SubjectUnusable(*thrown);
    }
    JsonDocument document;
    auto parsed = document.parse(text);
    if (auto* object = std::get_if<simdjson::dom::object>(&parsed)) {
      auto reply = read_start_reply(*object);
      if (auto* info = std::get_if<SubjectInfo>(&reply)) {
        info_ = std::move(*info);
        return;
      }
      parsed = std::get<JsonFault>(reply);
    }
    throw SubjectUnusable("The subject's description cannot be used: " +
                          std::get<JsonFault>(parsed).message);
  }

  void close() {
    if (!open_) return;
    open_ = false;
    call_.sink = nullptr;
    escaped([&] { subject_.destroy(handle_); });
    handle_ = nullptr;
  }

  // A handle in the state after `create`, or why there is none.
  std::optional<RunEnd> prepare() {
    if (configuration_.empty()) {
      return end_of(RunEnd::Kind::error, "The subject has not been configured.");
    }
    if (open_) {
      int answer = GONOGO_OK;
      auto thrown = escaped([&] { answer = subject_.reset(handle_); });
      if (!thrown && answer == GONOGO_OK) return std::nullopt;
      close();
      if (thrown) return end_of(RunEnd::Kind::crash, *thrown);
      return end_of(RunEnd::Kind::error,
                    fmt::format("`reset` answered {}. {}", answer, call_.note));
    }
    return create();
  }

  std::optional<RunEnd> create() {
    int answer = GONOGO_ERROR;
    auto thrown = escaped([&] {
      answer = subject_.create({configuration_.data(), configuration_.size()}, &sink_, &handle_);
    });
    if (thrown) return end_of(RunEnd::Kind::crash, *thrown);
    if (!call_.fault.empty()) return end_of(RunEnd::Kind::protocol, call_.fault);
    switch (answer) {
      case GONOGO_OK:
        open_ = true;
        return std::nullopt;
      case GONOGO_UNSUPPORTED:
        return end_of(RunEnd::Kind::refused, call_.note.empty()
                                                 ? "The subject does not say which key it refuses."
                                                 : call_.note);
      case GONOGO_ERROR:
        return end_of(RunEnd::Kind::error, "`create` failed. " + call_.note);
      default:
        return end_of(RunEnd::Kind::protocol,
                      fmt::format("`create` answered {}, which is none of its answers.", answer));
    }
  }

  RunEnd run_program(std::string_view program, const RecordSink& sink) {
    if (auto failed = prepare()) return *std::move(failed);
    call_.note.clear();
    call_.sink = &sink;
    int answer = GONOGO_ERROR;
    auto thrown = escaped([&] {
      answer = subject_.run(handle_, {program.data(), program.size()});
    });
    if (thrown) {
      close();
      return end_of(RunEnd::Kind::crash, *thrown);
    }
    if (!call_.fault.empty()) return end_of(RunEnd::Kind::protocol, call_.fault);
    if (call_.stopped) return end_of(RunEnd::Kind::stopped, "The run was stopped.");
    return read_answer(answer);
  }

  RunEnd read_answer(int answer) {
    if ((answer == GONOGO_ALARM) != (call_.alarms == 1)) {
      return end_of(RunEnd::Kind::protocol,
                    answer == GONOGO_ALARM
                        ? "`run` answered that there was an alarm, and none came."
                        : fmt::format("An alarm came, and `run` answered {}.", answer));
    }
    RunEnd end = end_of(RunEnd::Kind::ok, call_.note);
    switch (answer) {
      case GONOGO_OK:
        return end_of(RunEnd::Kind::ok, {});
      case GONOGO_ALARM:
        end.kind = RunEnd::Kind::alarm;
        end.alarm = std::move(call_.alarm);
        return end;
      case GONOGO_UNSUPPORTED:
        end.kind = RunEnd::Kind::skip;
        end.feature = call_.note;
        return end;
      case GONOGO_ERROR:
        end.kind = RunEnd::Kind::error;
        return end;
      default:
        return end_of(
            RunEnd::Kind::protocol,
            answer == GONOGO_STOPPED
                ? "`run` answered that it was stopped, and nobody had asked for it."
                : fmt::format("`run` answered {}, which is none of its answers.", answer));
    }
  }

  const gonogo_subject_v1& subject_;
  SubjectInfo info_;
  std::string configuration_;
  gonogo_sink_v1 sink_{};
  Call call_;
  void* handle_ = nullptr;
  bool open_ = false;
};

}  // namespace

std::unique_ptr<Subject> make_interface_subject(const gonogo_subject_v1& subject) {
  return std::make_unique<InterfaceSubject>(subject);
}

}  // namespace gonogo::oracle
