// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stored outcome of one side on one program, so that it can be judged under each reading in
// turn.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/differential/subject.hpp"
#include "oracle/judge/judge_session.hpp"

namespace gonogo::identify {

using oracle::Record;
using reference::Profile;

struct KeptOutcome {
  std::vector<Record> records;
  oracle::RunEnd end;
  std::vector<reference::Alarm> admitted;  // of the reference: the admissible alarms
  bool not_covered = false;  // the reference says nothing of the program, or of the rest of it

  // Whether the program was expanded or ended with an alarm.
  bool answered() const {
    return end.kind == oracle::RunEnd::Kind::ok || end.kind == oracle::RunEnd::Kind::alarm;
  }
  // Equal texts are equal outcomes.
  std::string text() const;
};

inline constexpr std::size_t kMostRecords = 20'000;

// The subject has to be configured. Stops after kMostRecords: no program tried here needs them.
KeptOutcome run_subject(oracle::Subject& subject, std::string_view id, std::string_view program);
// The reference's outcome, as if it were a subject. Nothing: more than `most` records, or what it
// cannot decide.
std::optional<KeptOutcome> run_reference(const Profile& profile, std::string_view program,
                                         std::size_t most = kMostRecords);

oracle::Verdict judge_kept(const Profile& profile, std::string_view program,
                           const oracle::Tolerances& tolerances, const KeptOutcome& outcome);

}  // namespace gonogo::identify
