// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reference as a subject: what it shows of a program, in the form in which a subject answers.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "oracle/judge/judge_session.hpp"

namespace gonogo::oracle {

struct ReferenceRun {
  enum class Ending : std::uint8_t {
    told,         // `end` says how
    not_covered,  // the reference says nothing of the program, or of the rest of it
    too_long,     // more records than asked for
    undecided,    // 4,096 bits do not decide
  };
  Ending ending = Ending::told;
  std::vector<reference::Record> records;
  oracle::RunEnd end;                    // the alarm is the first of `alarms`
  std::vector<reference::Alarm> alarms;  // all that are admissible
  bool is_told() const { return ending == Ending::told; }
};

// Paths that are open come out as they are shown.
ReferenceRun run_reference(const reference::Profile& profile, std::string_view program,
                           std::size_t most_records);

// The verdict on such a run. REQUIRES: run.is_told().
oracle::Verdict judge_reference(const reference::Profile& profile, std::string_view program,
                                const ReferenceRun& run);

}  // namespace gonogo::oracle
