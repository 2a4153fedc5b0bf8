// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether the reference with a mistake does what a subject did: the common part of attributions of
// one departure and of many.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/identify/variant.hpp"
#include "oracle/motion/tolerances.hpp"

namespace gonogo::identify {

// A program to be given to the subject, with its machine.
struct ProgramAsked {
  std::string id;
  std::string program;
  Profile profile;
};

// At most so many of them, spread evenly.
std::vector<ProgramAsked> spread(const std::vector<ProgramAsked>& all, std::size_t most);

// How, and how long, a subject is compared with mistakes.
struct ExplanationOptions {
  oracle::Grants grants;
  // For all trials of a departure; beyond it there is no answer. A subject that never ends a cycle
  // has thousands of records, and is compared with hundreds of mistakes.
  std::size_t most_records = std::numeric_limits<std::size_t>::max();
};

// How far a mistake explains an observation. Cut short: up to a block that the mistake makes the
// reference refuse, while the subject goes on.
enum class Fit : std::uint8_t { no, cut_short, full };

class Explainer {
 public:
  // Both outlive it.
  Explainer(oracle::Subject& subject, const ExplanationOptions& options)
      : subject_(subject), options_(options) {}

  // Runs the program on the subject. Nothing: no answer, or one that cannot be judged.
  // Throws SubjectUnusable.
  std::optional<Observation> observe(const ProgramAsked& asked);
  // Whether the judge says GO with the mistake in the reference's place; of a program to which it
  // makes no difference, whether that passes.
  Fit fit(const Variant& variant, const Observation& seen);
  bool explains(const Variant& variant, const Observation& seen) {
    return fit(variant, seen) == Fit::full;
  }
  // The bound holds from here on.
  void begin_anew() { spent_ = 0; }
  // Nothing more is tried: from here on no mistake explains anything.
  bool is_spent() const { return spent_ > options_.most_records; }

 private:
  oracle::Tolerances tolerances(const Profile& profile) const;
  Fit judge_trial(const ChangedRun& trial, const Observation& seen);

  oracle::Subject& subject_;
  const ExplanationOptions& options_;
  std::optional<Profile> configured_;
  Carried before_;
  std::size_t spent_ = 0;  // records, the subject's and the reference's
};

// Every mistake that can be what the observation departs by, the simplest first.
Variants variants_for(const Observation& departure);

}  // namespace gonogo::identify
