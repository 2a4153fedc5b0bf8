// SPDX-License-Identifier: GPL-3.0-or-later
//
// One program through a subject and the judge.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "oracle/differential/subject.hpp"
#include "oracle/judge/judge_session.hpp"

namespace gonogo::oracle {

// Runs the program and judges it as the subject declares. Nothing where the subject sends more
// than `most_records` and all of them agree so far: such a program costs more than it can show.
std::optional<oracle::Verdict> run_and_judge(oracle::Subject& subject,
                                             const reference::Profile& profile,
                                             std::string_view program, std::size_t most_records);

// The same without the judge and the reference: what the subject alone costs, and says at its end.
RunEnd run_alone(oracle::Subject& subject, const reference::Profile& profile,
                 std::string_view program, std::size_t most_records);

// Whether the reference's own path is NO-GO: where a reading and a rule contradict each other no
// path is right. The judge says so itself of run-outs that cut deeper than their pass; of anything
// else like it nothing is known.
bool contradicts_itself(const reference::Profile& profile, std::string_view program,
                        std::size_t most_records);

// The subject's records, a JSON line each; the first ten thousand.
std::string trace_text(oracle::Subject& subject, const reference::Profile& profile,
                       std::string_view program);
// The verdict, the program and how to see it again, for a failed run.
std::string failure_text(const oracle::Verdict& verdict, const reference::Profile& profile,
                         std::string_view program);
// The profile as --profile takes it from a JSON file.
std::string profile_text(const reference::Profile& profile);

}  // namespace gonogo::oracle
