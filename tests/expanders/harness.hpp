// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "gonogo/subject.h"

namespace gonogo::expanders::testing {

/// What a run gave, as text. A record is one line without its block, in this form:
///   rapid x=1 z=2 | feed x=1 f=200 | arc18 c=50,50 rot=-1 x=50 z=53 f=800 |
///   arc3 via=1,2,3 x=4 y=5 z=6 f=9 | thread z=-9 lead=2 start=0 | dwell 0.5 | m 3 |
///   end x=0 y=0 z=0 a=0 c=0            (`/rev` follows f in mm per revolution)
struct Outcome {
  int create = GONOGO_OK;
  int answer = GONOGO_ERROR;
  std::vector<std::string> records;
  std::vector<std::size_t> blocks;  // of the records
  std::string alarm;                // class
  std::string native;
  std::size_t alarm_block = 0;
  char alarm_word = 0;
  std::size_t alarms = 0;
  std::string note;

  /// The records but the closing `end`, a line each.
  std::string motions() const;
  /// The same with their blocks, and the alarm.
  std::string trace() const;
  /// Everything, for comparing two outcomes.
  std::string all() const;
};

/// A subject in use, with a sink that collects.
class Session {
 public:
  /// `profile` is the JSON of the profile, `maker` a name of the registry or `sinumerik802s`.
  explicit Session(std::string_view profile = "{}", std::string_view fault = {},
                   std::string_view maker = "gsk");
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Stops after `most` records.
  Outcome run(std::string_view program, std::size_t most = 100'000);
  int reset() { return subject_->reset(handle_); }
  /// For `create`, or of the last run.
  const Outcome& outcome() const { return outcome_; }

 private:
  static int take_record(void* context, const gonogo_record_v1* record);
  static void take_alarm(void* context, const gonogo_alarm_v1* alarm);
  static void take_note(void* context, int level, gonogo_text message);

  const gonogo_subject_v1* subject_;
  gonogo_sink_v1 sink_{};
  void* handle_ = nullptr;
  std::size_t most_ = 0;
  Outcome outcome_;
};

/// One program in a session of its own.
Outcome run(std::string_view program, std::string_view profile = "{}", std::string_view fault = {});

/// The profile under which X words are radii.
inline constexpr const char* kRadiusProfile = R"({"x_diameter":false})";

/// One program under that profile with one reading.
Outcome run_with_reading(const std::string& reading, const std::string& value,
                         std::string_view program);

/// The same with the expander of hnc21t.
Outcome run_hnc(std::string_view program, std::string_view profile = "{}",
                std::string_view fault = {});

/// The same with the expander of rs274; unless the profile says otherwise, a text need not end the
/// program.
Outcome run_ngc(std::string_view program, std::string_view profile = "{}",
                std::string_view fault = {});

/// The same with the expander of sinumerik840d.
Outcome run_sinumerik(std::string_view program, std::string_view profile = "{}",
                      std::string_view fault = {});

/// The same as sinumerik802s.
Outcome run_sinumerik802s(std::string_view program, std::string_view profile = "{}",
                          std::string_view fault = {});

/// `lines` with a line end after each.
std::string joined(const std::vector<std::string>& lines);

/// The records between the first one and the `end`.
std::string after_first(const Outcome& outcome);

/// "-1.500"
std::string millimetres(long thousandths);

/// How far the numbers of records, which are rounded to 1e-9 mm, may be off, mm.
inline constexpr double kNear = 1e-8;

}  // namespace gonogo::expanders::testing
