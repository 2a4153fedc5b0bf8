// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/interface_handle.hpp"

#include <fmt/format.h>

#include "oracle/records/text.hpp"
#include "subjects/interface_record.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::size_t kMostCallNotes = 16384;

// Calls the subject; an exception that escapes it becomes a sentence.
template <class Function>
std::optional<std::string> escaped(Function&& function) noexcept {
  try {
    function();
    return std::nullopt;
  } catch (const std::exception& error) {
    return fmt::format("An exception left the subject: {}", visible(error.what()));
  } catch (...) {
    return "An exception left the subject.";
  }
}

}  // namespace

int InterfaceHandle::take_record(void* context, const gonogo_record_v1* record) noexcept {
  Call& call = *static_cast<Call*>(context);
  try {
    if (call.asked_to_stop()) return 1;
    if (record == nullptr || call.sink == nullptr) {
      call.note_fault(record == nullptr ? "A record is a null pointer."
                                        : "A record came outside a run.");
      return 1;
    }
    if (call.alarms != 0) call.note_fault("A record came after the alarm.");
    if (!call.fault.empty()) return 1;
    std::string fault;
    const bool go_on = (*call.sink)(*record, fault);
    if (!fault.empty()) {
      call.note_fault(std::move(fault));
      return 1;
    }
    call.stopped = !go_on;
    return go_on ? 0 : 1;
  } catch (...) {
    call.thrown = std::current_exception();
    return 1;
  }
}

void InterfaceHandle::take_alarm(void* context, const gonogo_alarm_v1* alarm) noexcept {
  Call& call = *static_cast<Call*>(context);
  ++call.alarms;
  if (call.sink == nullptr) return call.note_fault("An alarm came outside a run.");
  if (alarm == nullptr) return call.note_fault("An alarm is a null pointer.");
  if (call.alarms > 1) return call.note_fault("A second alarm came.");
  auto converted = convert_alarm(*alarm);
  if (auto* fault = std::get_if<TraceFault>(&converted)) return call.note_fault(fault->message);
  call.alarm = std::get<SubjectAlarm>(std::move(converted));
}

void InterfaceHandle::take_note(void* context, int, gonogo_text message) noexcept {
  Call& call = *static_cast<Call*>(context);
  call.note = excerpt(view(message), 1000);
  if (call.notes.size() < kMostCallNotes) call.notes += call.note + "\n";
}

InterfaceHandle::InterfaceHandle(const gonogo_subject_v1& subject) : subject_(subject) {
  check_table();
  sink_.struct_size = sizeof sink_;
  sink_.context = &call_;
  sink_.record = take_record;
  sink_.alarm = take_alarm;
  sink_.note = take_note;
}

void InterfaceHandle::check_table() const {
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

std::string InterfaceHandle::description() const {
  std::string text;
  if (auto thrown = escaped([&] { text = view(subject_.describe()); })) {
    throw SubjectUnusable(*thrown);
  }
  return text;
}

void InterfaceHandle::configure(std::string configuration) {
  if (configuration == configuration_) return;  // the handle is used on, as a controller would be
  close();
  configuration_ = std::move(configuration);
}

void InterfaceHandle::close() {
  if (!open_) return;
  open_ = false;
  call_.sink = nullptr;
  escaped([&] { subject_.destroy(handle_); });
  handle_ = nullptr;
}

std::optional<RunEnd> InterfaceHandle::prepare() {
  call_ = Call();
  if (configuration_.empty()) {
    return RunEnd::of(RunEnd::Kind::error, "The subject has not been configured.");
  }
  if (!open_) return create();
  if (!used_) return std::nullopt;
  int answer = GONOGO_OK;
  auto thrown = escaped([&] { answer = subject_.reset(handle_); });
  used_ = false;
  if (!thrown && call_.fault.empty() && answer == GONOGO_OK) return std::nullopt;
  close();
  if (thrown) return RunEnd::of(RunEnd::Kind::crash, *thrown);
  if (!call_.fault.empty()) return RunEnd::of(RunEnd::Kind::protocol, call_.fault);
  return RunEnd::of(RunEnd::Kind::error,
                    fmt::format("`reset` answered {}. {}", answer, call_.note));
}

std::optional<RunEnd> InterfaceHandle::create() {
  int answer = GONOGO_ERROR;
  auto thrown = escaped([&] {
    answer = subject_.create({configuration_.data(), configuration_.size()}, &sink_, &handle_);
  });
  open_ = !thrown && answer == GONOGO_OK;
  used_ = false;
  if (thrown) return RunEnd::of(RunEnd::Kind::crash, *thrown);
  if (!call_.fault.empty()) {
    close();
    return RunEnd::of(RunEnd::Kind::protocol, call_.fault);
  }
  switch (answer) {
    case GONOGO_OK:
      return std::nullopt;
    case GONOGO_UNSUPPORTED:
      return RunEnd::of(
          RunEnd::Kind::refused,
          call_.note.empty() ? "The subject does not say which key it refuses." : call_.note);
    case GONOGO_ERROR:
      return RunEnd::of(RunEnd::Kind::error, "`create` failed. " + call_.note);
    default:
      return RunEnd::of(RunEnd::Kind::protocol,
                        fmt::format("`create` answered {}, which is none of its answers.", answer));
  }
}

RunEnd InterfaceHandle::run(std::string_view program, const RawSink& sink) {
  RunEnd end = run_program(program, sink);
  end.notes = std::move(call_.notes);
  call_.sink = nullptr;
  // The sink is the oracle's: what it throws is not the subject's doing.
  if (call_.thrown) std::rethrow_exception(std::exchange(call_.thrown, nullptr));
  return end;
}

RunEnd InterfaceHandle::run_program(std::string_view program, const RawSink& sink) {
  if (auto failed = prepare()) return *std::move(failed);
  call_.note.clear();
  call_.sink = &sink;
  used_ = true;
  int answer = GONOGO_ERROR;
  auto thrown = escaped([&] { answer = subject_.run(handle_, {program.data(), program.size()}); });
  if (thrown) {
    close();
    return RunEnd::of(RunEnd::Kind::crash, *thrown);
  }
  if (!call_.fault.empty()) return RunEnd::of(RunEnd::Kind::protocol, call_.fault);
  if (call_.stopped) return RunEnd::of(RunEnd::Kind::stopped, "The run was stopped.");
  return read_answer(answer);
}

RunEnd InterfaceHandle::read_answer(int answer) {
  if ((answer == GONOGO_ALARM) != (call_.alarms == 1)) {
    return RunEnd::of(RunEnd::Kind::protocol,
                      answer == GONOGO_ALARM
                          ? "`run` answered that there was an alarm, and none came."
                          : fmt::format("An alarm came, and `run` answered {}.", answer));
  }
  RunEnd end = RunEnd::of(RunEnd::Kind::ok, call_.note);
  switch (answer) {
    case GONOGO_OK:
      return RunEnd::of(RunEnd::Kind::ok, {});
    case GONOGO_ALARM:
      end.kind = RunEnd::Kind::alarm;
      end.alarm = std::move(call_.alarm);
      return end;
    case GONOGO_UNSUPPORTED:
      if (call_.note.empty()) {
        return RunEnd::of(RunEnd::Kind::protocol,
                          "`run` answered that a feature is not supported, and no note names it.");
      }
      end.kind = RunEnd::Kind::skip;
      end.feature = call_.note;
      return end;
    case GONOGO_ERROR:
      end.kind = RunEnd::Kind::error;
      return end;
    default:
      return RunEnd::of(
          RunEnd::Kind::protocol,
          answer == GONOGO_STOPPED
              ? "`run` answered that it was stopped, and nobody had asked for it."
              : fmt::format("`run` answered {}, which is none of its answers.", answer));
  }
}

}  // namespace gonogo::oracle
