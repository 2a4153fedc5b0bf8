// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "capture/sampled_judge.hpp"
#include "oracle/judge/sampled_outcome.hpp"

namespace gonogo::oracle {

// A file of samples as the outcome of a run: read anew, sample by sample, each time it is judged.
class CapturedSamples : public SampledOutcome {
 public:
  CapturedSamples(std::string path, SampledTolerances sampled);
  SampledVerdict judge(const reference::Profile& profile, const ProgramText& program,
                       const Tolerances& tolerances, const RunEnd& end) const override;

 private:
  class Judging;
  std::string path_;
  SampledTolerances sampled_;
};

// Reads the whole file once, so that it is known to be good: how the run ended, and in `sampled`
// how the times are written. Throws SampleFault.
RunEnd check_samples(const std::string& path, SampledTolerances& sampled);

}  // namespace gonogo::oracle
