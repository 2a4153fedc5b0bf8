// SPDX-License-Identifier: GPL-3.0-or-later
//
// What came back from a machine as sampled axis positions. It is no trace of records, so it brings
// its own judge; the session asks it under every combination of readings.
#pragma once

#include <string>
#include <string_view>

#include "oracle/motion/tolerances.hpp"
#include "oracle/records/verdict.hpp"
#include "oracle/steps/program_input.hpp"

namespace gonogo::oracle {

// The notes of such a run begin with this: the results have no trace of records, and the file that
// the notes name is needed to judge again.
inline constexpr std::string_view kSampledNote = "Sampled axis positions: ";

struct SampledVerdict {
  Verdict verdict;
  std::size_t progress = 0;  // how many motions of the reference were followed
  std::uint64_t block = 0;   // of a departure, where blocks run in the order of their lines
  // The open readings of this verdict, where `expand` shows others: "k=v, k=v".
  std::string told_under = {};
};

class SampledOutcome {
 public:
  SampledOutcome() = default;
  SampledOutcome(const SampledOutcome&) = delete;
  SampledOutcome& operator=(const SampledOutcome&) = delete;
  virtual ~SampledOutcome() = default;
  // `profile` says every reading that counts; `end` is how the run ended.
  virtual SampledVerdict judge(const reference::Profile& profile, const ProgramText& program,
                               const Tolerances& tolerances, const RunEnd& end) const = 0;
};

}  // namespace gonogo::oracle
