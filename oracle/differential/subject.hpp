// SPDX-License-Identifier: GPL-3.0-or-later
//
// A subject: the implementation under the gauge, in whichever way it is connected.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string_view>

#include "oracle/records/subject_outcome.hpp"

namespace gonogo::oracle {

class Subject {
 public:
  virtual ~Subject() = default;
  virtual const SubjectInfo& info() const = 0;
  // Before the first run, and whenever the profile changes. The runs report a refusal.
  virtual void configure(const reference::Profile& profile) = 0;
  // What will be run next under this configuration, in order: the next run first. A hint for a
  // subject that takes programs ahead; `id` and `program` are copied.
  virtual void announce(std::string_view id, std::string_view program) {
    static_cast<void>(id);
    static_cast<void>(program);
  }
  // Runs one program. Never throws for what the subject does.
  virtual RunEnd run(std::string_view id, std::string_view program, const RecordSink& sink) = 0;
  // Makes the next run start in a fresh process (or handle).
  virtual void renew() = 0;
  // Behind the last run: ends what stands behind the subject. How it broke down in that; nothing:
  // it did not, or nothing stands there.
  virtual std::optional<RunEnd> finish() { return std::nullopt; }
  // Another time limit for the next runs.
  virtual void set_run_limit(std::chrono::milliseconds limit) { static_cast<void>(limit); }
  // Whether a run in a fresh process can differ from one in a used one.
  virtual bool keeps_state() const { return true; }
};

}  // namespace gonogo::oracle
