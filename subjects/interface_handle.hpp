// SPDX-License-Identifier: GPL-3.0-or-later
//
// The life of one handle of the C interface: create, run, reset, destroy, and the sink between.
#pragma once

#include <exception>
#include <functional>

#include "gonogo/subject.h"
#include "subjects/make_subject.hpp"

namespace gonogo::oracle {

// Takes a record as the subject made it. Returns false to stop the run; sets `fault` when the
// record breaks the interface, a sentence.
using RawSink = std::function<bool(const gonogo_record_v1& record, std::string& fault)>;

class InterfaceHandle {
 public:
  // The table must outlive the handle. Throws SubjectUnusable when it is not whole.
  explicit InterfaceHandle(const gonogo_subject_v1& subject);
  InterfaceHandle(const InterfaceHandle&) = delete;
  InterfaceHandle& operator=(const InterfaceHandle&) = delete;
  ~InterfaceHandle() { close(); }

  // What the subject says of itself, JSON. Throws SubjectUnusable.
  std::string description() const;

  // Another configuration, {"dialect":...,"profile":{...}}; the same one changes nothing.
  void configure(std::string configuration);

  // Makes the handle if there is none, or resets it after a run. Returns why it cannot be used.
  std::optional<RunEnd> prepare();

  // Prepares and runs. What the sink throws is thrown on, after the subject has returned.
  RunEnd run(std::string_view program, const RawSink& sink);

  void close();

 private:
  // What one call of the subject has sent so far. Nothing here throws through the subject.
  struct Call {
    const RawSink* sink = nullptr;
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

  static int take_record(void* context, const gonogo_record_v1* record) noexcept;
  static void take_alarm(void* context, const gonogo_alarm_v1* alarm) noexcept;
  static void take_note(void* context, int level, gonogo_text message) noexcept;

  void check_table() const;
  std::optional<RunEnd> create();
  RunEnd run_program(std::string_view program, const RawSink& sink);
  RunEnd read_answer(int answer);

  const gonogo_subject_v1& subject_;
  std::string configuration_;
  gonogo_sink_v1 sink_{};
  Call call_;
  void* handle_ = nullptr;
  bool open_ = false;
  bool used_ = false;  // since it was created or reset
};

}  // namespace gonogo::oracle
