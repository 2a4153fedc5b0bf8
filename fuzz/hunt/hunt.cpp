// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/hunt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "fuzz/hunt/coverage.hpp"
#include "fuzz/hunt/profile_parts.hpp"
#include "fuzz/program/features.hpp"
#include "fuzz/program/mutator/mutate.hpp"
#include "oracle/differential/differential.hpp"
#include "oracle/differential/domain.hpp"
#include "oracle/records/finding.hpp"

namespace gonogo::hunt {

using oracle::Decision;
using oracle::Verdict;
using oracle::VerdictKind;

namespace {

bool is_finding(const Verdict& verdict) {
  return decision(verdict.kind) == Decision::no_go || verdict.kind == VerdictKind::oracle_error;
}

bool is_of(const std::optional<Verdict>& verdict, const generate::GeneratedProgram& program,
           const Signature& signature) {
  return verdict && is_finding(*verdict) && signature_of(*verdict, program) == signature;
}

// D-DOM-01 to D-DOM-08. A crash, a hang, a broken protocol is one wherever it happens.
bool counts_by(const HuntOptions& options, const Verdict& verdict,
               const generate::GeneratedProgram& program) {
  if (options.everywhere || !oracle::is_other_answer(verdict.kind)) return true;
  return oracle::outside_domain(program.profile, program.text, kMostCostInHunt).empty();
}

}  // namespace

HuntCount& HuntCount::operator+=(const HuntCount& other) {
  for (const auto& [name, count] : kHuntCounts) this->*count += other.*count;
  return *this;
}

void add_features(FeatureCounts& sum, const FeatureCounts& more) {
  for (const auto& [feature, count] : more) {
    FeatureCount& into = sum[feature];
    into.judged += count.judged;
    into.skipped += count.skipped;
    into.no_go += count.no_go;
  }
}

Hunt::Hunt(SubjectMaker maker, TrialOptions trial, HuntOptions options)
    : trial_(std::move(maker), std::move(trial)),
      options_(std::move(options)),
      generator_(generate::generator_of(options_.dialect)),
      dice_(options_.seed),
      supported_(trial_.info(), options_.dialect),
      known_(options_.known) {}

std::optional<Specimen> Hunt::next_fitted() {
  constexpr int kMostDrawn = 50;
  if (!due_.empty()) {
    Specimen specimen{std::move(due_.front()), {}};
    due_.pop_front();
    return specimen;
  }
  for (int drawn = 0; drawn < kMostDrawn; ++drawn) {
    Specimen specimen = next();
    auto program = supported_.fitted(specimen.program);
    if (!program) continue;
    specimen.program = *std::move(program);
    options_.put_in(specimen.program.profile);  // a single block has a machine of its own
    return specimen;
  }
  return std::nullopt;
}

// Generated programs at first and now and then, else mutants of those that showed something.
Specimen Hunt::next() {
  constexpr std::size_t kGeneratedFirst = 64;
  Specimen specimen;
  if (siblings_ > 0) {
    specimen = mutant();
  } else if (!options_.guided || count_.programs <= kGeneratedFirst || pool_.empty() ||
             dice_.below(8) < 3) {
    specimen = fresh();
  } else if (dice_.one_in(2)) {
    const Specimen& picked = pool_.pick(dice_);
    specimen.bytes = program::mutate_bytes(dice_, picked.bytes, pool_.pick(dice_).bytes);
    generate::Choices choices{std::span<const std::uint8_t>(specimen.bytes)};
    specimen.program = generator_.generate(choices, options_.settings, nullptr);
  } else {
    // Some of one parent in a row: what a program leaves behind shows in the next one only if the
    // machine stays the same.
    constexpr std::size_t kSiblings = 4;
    parent_ = pool_.pick(dice_);
    siblings_ = kSiblings;
    specimen = mutant();
  }
  options_.put_in(specimen.program.profile);
  return specimen;
}

Specimen Hunt::fresh() {
  constexpr std::size_t kBytes = 512;
  Specimen specimen;
  specimen.bytes.resize(kBytes);
  for (std::uint8_t& byte : specimen.bytes) byte = dice_.byte();
  generate::Choices choices{std::span<const std::uint8_t>(specimen.bytes)};
  specimen.program = generator_.generate(choices, options_.settings, nullptr);
  return specimen;
}

Specimen Hunt::mutant() {
  --siblings_;
  Specimen specimen{parent_.program, {}};
  const generate::GeneratedProgram& other = pool_.pick(dice_).program;
  specimen.program.text = program::mutate_text(dice_, parent_.program.text, other.text);
  if (dice_.one_in(4)) mutate_profile(dice_, specimen.program.profile, other.profile);
  return specimen;
}

void Hunt::offer(const generate::GeneratedProgram& program) {
  const auto coverage = coverage_of(program, kMostCostInHunt);
  if (options_.guided && coverage) pool_.offer({program, {}}, *coverage);
}

std::optional<Finding> Hunt::step() {
  ++count_.programs;
  const std::optional<Specimen> fitted = next_fitted();
  if (!fitted) {
    ++count_.skipped;
    return std::nullopt;
  }
  const Specimen& specimen = *fitted;
  auto coverage = coverage_of(specimen.program, kMostCostInHunt);
  if (!coverage) {
    ++count_.too_long;
    return std::nullopt;
  }
  const std::optional<Verdict> verdict = trial_.run(specimen.program);
  if (verdict && verdict->kind == VerdictKind::skip) {
    supported_.skipped(specimen.program);
  } else {
    supported_.ran(specimen.program);
    // A fine step clears an area of few levels in thousands of motions.
    coverage->cost += trial_.records();
    // Mutants of what is skipped are skipped.
    if (options_.guided) pool_.offer(specimen, *coverage);
  }
  if (!verdict) {
    ++count_.too_long;
    return std::nullopt;
  }
  const Decision decided = decision(verdict->kind);
  const bool is_judged = decided == Decision::go || decided == Decision::no_go;
  if (is_judged && trial_.moved()) ++count_.moved;
  if (is_finding(*verdict)) {
    ++count_.judged;
    const std::size_t before = count_.no_go++;
    std::optional<Finding> finding = examine(*verdict, specimen.program);
    count_features(*verdict, specimen.program, count_.no_go > before);
    return finding;
  }
  count_features(*verdict, specimen.program, false);
  if (verdict->kind == VerdictKind::skip) {
    ++count_.skipped;
  } else if (decided == Decision::undecided) {
    ++count_.gaps;
  } else {
    ++count_.judged;
  }
  return std::nullopt;
}

void Hunt::count_features(const Verdict& verdict, const generate::GeneratedProgram& program,
                          bool is_no_go) {
  const Decision decided = decision(verdict.kind);
  const bool is_skipped = verdict.kind == VerdictKind::skip;
  const bool is_judged = decided == Decision::go || is_finding(verdict);
  if (!is_skipped && !is_judged) return;
  for (const std::string& feature : program::features_needed({program.profile, program.text})) {
    FeatureCount& count = features_[feature];
    ++(is_skipped ? count.skipped : count.judged);
    if (is_no_go) ++count.no_go;
  }
}

// A finding of a new signature is run again alone in a fresh process.
std::optional<Finding> Hunt::examine(const Verdict& verdict,
                                     const generate::GeneratedProgram& program) {
  Finding finding{signature_of(verdict, program), verdict, {{}, program}, count_.programs};
  ++seen_[finding.signature];
  if (known_.contains(finding.signature)) return std::nullopt;
  if (oracle::contradicts_itself(program.profile, program.text, kMostCostInHunt)) {
    --count_.no_go;
    ++count_.gaps;
    return std::nullopt;
  }
  if (!counts_by(options_, verdict, program)) {
    --count_.no_go;
    ++count_.outside;
    return std::nullopt;
  }
  known_.insert(finding.signature);
  const std::optional<Verdict> alone = trial_.run_alone(finding.reproducer);
  if (is_of(alone, program, finding.signature)) return finding;
  if (!alone || !is_finding(*alone)) {
    known_.erase(finding.signature);  // another program may show it for good
    return trial_.keeps_state() ? leak(program) : flicker(program);
  }
  finding.verdict = *alone;
  finding.signature = signature_of(*alone, program);
  if (!known_.insert(finding.signature).second) return std::nullopt;
  return finding;
}

// Alone the program is GO: the subject keeps something of the programs that ran before.
std::optional<Finding> Hunt::leak(const generate::GeneratedProgram& program) {
  Finding finding;
  finding.reproducer = {trial_.history(), program};
  finding.program = count_.programs;
  const std::optional<Verdict> after = trial_.run_alone(finding.reproducer);
  if (!after || !is_finding(*after)) return flicker(program);
  finding.verdict = *after;
  finding.verdict.message =
      "Alone the program is GO, after other programs it is not: " + after->message;
  finding.verdict.kind = VerdictKind::state_leak;
  finding.signature = signature_of(finding.verdict, program);
  if (!known_.insert(finding.signature).second) return std::nullopt;
  return finding;
}

// Neither alone nor after the same programs: how often, as far as that can be seen.
std::optional<Finding> Hunt::flicker(const generate::GeneratedProgram& program) {
  constexpr std::size_t kMostRuns = 300;
  constexpr std::chrono::seconds kMostTime{5};
  Finding finding;
  finding.reproducer.program = program;
  finding.program = count_.programs;
  finding.signature = {options_.dialect, VerdictKind::state_leak, {}, "flicker", {}};
  if (!known_.insert(finding.signature).second) return std::nullopt;
  const auto begin = std::chrono::steady_clock::now();
  std::size_t runs = 0;
  std::size_t others = 0;
  while (runs < kMostRuns && std::chrono::steady_clock::now() - begin < kMostTime) {
    const std::optional<Verdict> verdict = trial_.run_alone(finding.reproducer);
    ++runs;
    if (!verdict || !is_finding(*verdict)) continue;
    ++others;
    finding.verdict = *verdict;
  }
  finding.verdict.kind = VerdictKind::state_leak;
  finding.verdict.message = fmt::format(
      "The answer flickers: the program was not GO, and of {} runs of it alone {} were not.", runs,
      others);
  return finding;
}

void Hunt::reduce(Finding& finding, const ReduceLimits& limits, const StillShows& also) {
  const StillShows inside = [&](const Reproducer& reproducer) {
    return options_.is_in(reproducer) && counts_by(options_, finding.verdict, reproducer.program) &&
           (also == nullptr || also(reproducer));
  };
  reduce_finding(trial_, finding, limits, inside);
}

bool is_news(const HuntOptions& options, const Verdict& verdict,
             const generate::GeneratedProgram& program) {
  return is_finding(verdict) && !options.known.contains(signature_of(verdict, program)) &&
         !oracle::contradicts_itself(program.profile, program.text, kMostCostInHunt) &&
         counts_by(options, verdict, program);
}

std::optional<Finding> finding_of(Trial& trial, const generate::GeneratedProgram& program,
                                  Verdict& verdict) {
  const std::optional<Verdict> answer = trial.run_alone({{}, program});
  if (!answer) {
    verdict = oracle::gap_verdict(oracle::GapReason::cap_records,
                                  "The program has too many records to be reduced.");
    return std::nullopt;
  }
  verdict = *answer;
  if (!is_finding(verdict)) return std::nullopt;
  return Finding{signature_of(verdict, program), verdict, {{}, program}};
}

namespace {

// Whether a reproducer shows the finding still. State that leaks needs a fresh process each time;
// all else is tried in the process that runs, and confirmed in a fresh one at the end.
bool shows(Trial& trial, const Finding& finding, const Reproducer& reproducer) {
  if (finding.signature.kind != VerdictKind::state_leak) {
    return is_of(trial.run(reproducer.program), reproducer.program, finding.signature);
  }
  const std::optional<Verdict> after = trial.run_alone(reproducer);
  if (!after || !is_finding(*after)) return false;
  Verdict leak = *after;
  leak.kind = VerdictKind::state_leak;
  if (signature_of(leak, reproducer.program) != finding.signature) return false;
  const std::optional<Verdict> alone = trial.run_alone({{}, reproducer.program});
  return alone && !is_finding(*alone);
}

bool shows_alone(Trial& trial, const Finding& finding, const Reproducer& reproducer) {
  if (finding.signature.kind == VerdictKind::state_leak) return shows(trial, finding, reproducer);
  return is_of(trial.run_alone(reproducer), reproducer.program, finding.signature);
}

}  // namespace

void reduce_finding(Trial& trial, Finding& finding, const ReduceLimits& limits,
                    const StillShows& also) {
  const bool is_leak = finding.signature.kind == VerdictKind::state_leak;
  if (is_leak && finding.reproducer.before.empty()) return;
  // A program that hangs costs its whole time limit each time: a part of it will do.
  const std::chrono::milliseconds limit = trial.run_limit();
  const bool hangs = finding.signature.kind == VerdictKind::timeout;
  if (hangs) trial.set_run_limit(std::max(limit / 8, std::chrono::milliseconds(50)));
  Reduced reduced = reduce(
      finding.reproducer,
      [&](const Reproducer& reproducer) {
        return shows(trial, finding, reproducer) && (also == nullptr || also(reproducer));
      },
      limits);
  if (hangs) trial.set_run_limit(limit);
  finding.reduce_runs = reduced.runs;
  if (!shows_alone(trial, finding, reduced.reproducer)) return;
  finding.reproducer = std::move(reduced.reproducer);
  finding.is_reduced = reduced.finished;
  if (is_leak) return;
  const JudgedRun judged = trial.examine(finding.reproducer);
  if (is_finding(judged.verdict)) finding.verdict = judged.verdict;
}

}  // namespace gonogo::hunt
