// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hunt for programs on which a subject departs from the reference. The coverage of the
// reference guides it, so that it works on black boxes. Programs and findings follow from the seed
// alone.
#pragma once

#include <array>
#include <deque>
#include <map>
#include <set>
#include <utility>

#include "fuzz/hunt/pool.hpp"
#include "fuzz/hunt/profile_parts.hpp"
#include "fuzz/hunt/reduce.hpp"
#include "fuzz/hunt/signature.hpp"
#include "fuzz/hunt/supported_features.hpp"
#include "fuzz/hunt/trial.hpp"

namespace gonogo::hunt {

// Of one program, as of coverage_of(). What costs more is not judged.
inline constexpr std::size_t kMostCostInHunt = 3'000;

struct HuntOptions : GivenMachine {
  std::string dialect;
  std::uint64_t seed = 1;
  bool guided = true;                    // false: generated programs only
  generate::GeneratorSettings settings;  // of the programs that are generated
  // What a subject does on a program outside of docs/domain.md is no finding, except what ends it.
  bool everywhere = false;
  std::set<Signature> known;  // not reported again
};

struct Finding {
  Signature signature;
  oracle::Verdict verdict;
  Reproducer reproducer;
  std::size_t program = 0;      // of the hunt, from 1
  std::size_t reduce_runs = 0;  // that the reduction took
  bool is_reduced = false;      // nothing smaller shows the same
};

// What became of the programs so far.
struct HuntCount {
  std::size_t programs = 0;
  std::size_t judged = 0;    // GO or NO-GO
  std::size_t moved = 0;     // of those judged, with a motion of the subject's
  std::size_t skipped = 0;   // by the subject, or for what it does not declare
  std::size_t gaps = 0;      // the gauge cannot say
  std::size_t outside = 0;   // departures outside of the domain
  std::size_t too_long = 0;  // more records than they can be worth
  std::size_t no_go = 0;     // those of known signatures among them

  HuntCount& operator+=(const HuntCount& other);
};
// Each of them with its name in files.
inline constexpr std::array<std::pair<const char*, std::size_t HuntCount::*>, 8> kHuntCounts = {
    {{"programs", &HuntCount::programs},
     {"judged", &HuntCount::judged},
     {"moved", &HuntCount::moved},
     {"skipped", &HuntCount::skipped},
     {"gaps", &HuntCount::gaps},
     {"outside", &HuntCount::outside},
     {"too_long", &HuntCount::too_long},
     {"no_go", &HuntCount::no_go}}};

// What became of the programs that need a feature of the dialect.
struct FeatureCount {
  std::size_t judged = 0;
  std::size_t skipped = 0;
  std::size_t no_go = 0;
};
using FeatureCounts = std::map<std::string, FeatureCount>;
void add_features(FeatureCounts& sum, const FeatureCounts& more);

class Hunt {
 public:
  // REQUIRES: the dialect has a generator. Throws oracle::SubjectUnusable.
  Hunt(SubjectMaker maker, TrialOptions trial, HuntOptions options);

  // Tries one more program. A finding is one of a signature that none before had. Throws
  // oracle::SubjectUnusable where the subject cannot be started again.
  std::optional<Finding> step();
  // Reduces its reproducer, and says again what the judge says of it then. What `also` is given
  // holds of the result too.
  void reduce(Finding& finding, const ReduceLimits& limits, const StillShows& also = nullptr);

  // From an earlier hunt: a program that showed something new, and a known signature.
  void offer(const generate::GeneratedProgram& program);
  void know(const Signature& signature) { known_.insert(signature); }
  // The program is tried before all that is drawn.
  void try_next(generate::GeneratedProgram program) { due_.push_back(std::move(program)); }
  // How many programs showed each signature, before they were run again alone.
  const std::map<Signature, std::size_t>& seen() const { return seen_; }

  const HuntCount& count() const { return count_; }
  // By the vocabulary of `gonogo spec --features`; a program counts for each that it needs.
  const FeatureCounts& features() const { return features_; }
  const Pool& pool() const { return pool_; }
  const SupportedFeatures& supported() const { return supported_; }
  Trial& trial() { return trial_; }

 private:
  // One that the subject may run, as far as that is known; nothing: none of many was.
  std::optional<Specimen> next_fitted();
  Specimen next();
  Specimen fresh();
  Specimen mutant();
  void count_features(const oracle::Verdict& verdict, const generate::GeneratedProgram& program,
                      bool is_no_go);
  std::optional<Finding> examine(const oracle::Verdict& verdict,
                                 const generate::GeneratedProgram& program);
  std::optional<Finding> leak(const generate::GeneratedProgram& program);
  std::optional<Finding> flicker(const generate::GeneratedProgram& program);

  Trial trial_;
  HuntOptions options_;
  const generate::Generator& generator_;
  program::Dice dice_;
  Pool pool_;
  SupportedFeatures supported_;
  Specimen parent_;                             // of the text mutants that are due
  std::size_t siblings_ = 0;                    // how many of them
  std::deque<generate::GeneratedProgram> due_;  // before all that is drawn
  std::set<Signature> known_;
  std::map<Signature, std::size_t> seen_;
  HuntCount count_;
  FeatureCounts features_;
};

// Whether the verdict is a finding to report: by these options, and because the reference does
// not contradict itself on the program.
bool is_news(const HuntOptions& options, const oracle::Verdict& verdict,
             const generate::GeneratedProgram& program);

// The same for one given program: nothing where the subject is GO on it (`verdict` says what it
// is).
std::optional<Finding> finding_of(Trial& trial, const generate::GeneratedProgram& program,
                                  oracle::Verdict& verdict);
void reduce_finding(Trial& trial, Finding& finding, const ReduceLimits& limits,
                    const StillShows& also = nullptr);

}  // namespace gonogo::hunt
