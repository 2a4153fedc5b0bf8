// SPDX-License-Identifier: GPL-3.0-or-later
#include "identify/attribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "identify/same_path.hpp"

namespace gonogo::identify {

using oracle::Decision;

namespace {

constexpr std::size_t kMostBytes = 4'000;
constexpr std::size_t kMostPartial = 10;

class Attributor {
 public:
  Attributor(oracle::Subject& subject, const AttributionOptions& options)
      : subject_(subject), options_(options) {}

  // Gives the program to the subject; and tries on it what explains everything so far.
  void observe(const ProgramAsked& asked);
  // What explains the programs that have been observed.
  void find_causes();
  bool has_causes() const { return !causes_.empty(); }
  // Nothing more is tried.
  bool is_spent() const { return spent_ > options_.most_records; }
  Attribution finish();
  const std::vector<Observation>& programs() const { return found_.programs; }

 private:
  struct Explanation {
    Variant variant;
    Cause cause;
  };

  oracle::JudgeTerms terms(const Profile& profile) const {
    oracle::JudgeTerms terms = make_terms(
        subject_.info(), profile, {options_.tolerance, options_.chord, options_.feed_resolution});
    terms.strict = true;  // what it follows, not what a text states
    return terms;
  }
  bool judge_trial(const Trial& trial) const;
  bool explains(const Variant& variant, const Observation& seen) const;
  // Counts the program for the cause. False: it is not explained.
  bool count(const Variant& variant, const Observation& seen, Cause& cause) const;
  void try_variant(const Variant& variant);
  void try_causes(const Observation& seen);

  oracle::Subject& subject_;
  const AttributionOptions& options_;
  std::optional<Profile> configured_;
  Carried before_;
  std::vector<Explanation> causes_;  // that explain everything so far
  mutable std::size_t spent_ = 0;    // records, the subject's and the reference's
  Attribution found_;
};

void Attributor::observe(const ProgramAsked& asked) {
  if (!configured_ || *configured_ != asked.profile) {
    configured_ = asked.profile;
    subject_.configure(asked.profile);
    before_ = {};
  }
  Observation seen{asked.id, asked.program, asked.profile, {}, {}, 0, before_};
  seen.outcome = run_subject(subject_, asked.id, asked.program);
  before_.take(asked.profile, asked.program, seen.outcome);
  if (!seen.outcome.answered()) return;
  seen.verdict = judge_outcome(asked.profile, asked.program, terms(asked.profile),
                               seen.outcome.records, seen.outcome.end)
                     .verdict;
  if (decision(seen.verdict.kind) == Decision::undecided) return;
  if (seen.departs()) ++found_.departures;
  if (const auto shown = run_reference(asked.profile, asked.program)) {
    seen.alarm = shown->end.alarm.block;
  }
  found_.programs.push_back(std::move(seen));
  try_causes(found_.programs.back());
}

// The lines of `changed` before the line of this number, and those of `original` from it on.
std::string spliced(std::string_view changed, std::string_view original, std::uint64_t line,
                    const Profile& profile) {
  const ProgramText before(profile, changed);
  const ProgramText after(profile, original);
  if (before.blocks.size() != after.blocks.size()) return std::string(changed);
  std::string text;
  for (std::size_t i = 0; i < before.blocks.size(); ++i) {
    text += program::line_text((i + 1 < line ? before : after).blocks[i]);
  }
  return text;
}

bool Attributor::judge_trial(const Trial& trial) const {
  spent_ += trial.outcome.records.size();
  if (is_spent()) return false;
  const oracle::JudgeTerms on = terms(trial.profile);
  if (trial.model) {
    return same_path(*trial.model, trial.outcome, trial.profile.initial.at, on);
  }
  // One that would put out far more than the subject did need not be followed to its end.
  const std::size_t most = 1'000 + 20 * trial.outcome.records.size();
  const auto shown = run_reference(trial.profile, trial.program, most);
  spent_ += shown ? shown->records.size() : most;
  if (!shown) return false;
  const oracle::SessionVerdict said =
      judge_outcome(trial.profile, trial.program, on, trial.outcome.records, trial.outcome.end);
  return decision(said.verdict.kind) == Decision::go;
}

bool Attributor::explains(const Variant& variant, const Observation& seen) const {
  auto trial = variant.apply(seen);
  if (!trial) return !seen.departs();
  if (judge_trial(*trial)) return true;
  // Rules may be checked on the words as they are written, whatever is made of them afterwards.
  if (seen.alarm == 0 || trial->model || trial->program == seen.program) return false;
  trial->program = spliced(trial->program, seen.program, seen.alarm, seen.profile);
  return judge_trial(*trial);
}

bool Attributor::count(const Variant& variant, const Observation& seen, Cause& cause) const {
  if (!explains(variant, seen)) return false;
  ++(seen.departs() ? cause.departures : cause.passes);
  return true;
}

void Attributor::try_variant(const Variant& variant) {
  ++found_.tried;
  Cause cause{variant.name, 0, 0};
  for (const Observation& seen : found_.programs) {
    if (seen.departs()) count(variant, seen, cause);
  }
  if (cause.departures == 0) return;
  for (const Observation& seen : found_.programs) {
    if (!seen.departs()) count(variant, seen, cause);
  }
  const bool complete = cause.departures == found_.departures && cause.passes == found_.passes();
  if (complete) {
    causes_.push_back({variant, std::move(cause)});
  } else {
    found_.partial.push_back(std::move(cause));
  }
}

void Attributor::try_causes(const Observation& seen) {
  std::erase_if(causes_, [&](Explanation& one) {
    if (count(one.variant, seen, one.cause)) return false;
    found_.partial.push_back(one.cause);
    return true;
  });
}

void Attributor::find_causes() {
  const auto departure =
      std::ranges::find_if(found_.programs, [](const auto& seen) { return seen.departs(); });
  if (departure == found_.programs.end()) return;
  Variants variants;
  add_machine_variants(*departure, variants);
  add_record_variants(*departure, variants);
  add_word_variants(*departure, variants);
  add_code_variants(*departure, variants);
  add_modal_variants(*departure, variants);
  add_model_variants(*departure, variants);
  for (const Variant& variant : variants) {
    if (is_spent()) return;
    try_variant(variant);
  }
}

Attribution Attributor::finish() {
  if (is_spent()) {
    found_.given_up = true;
    found_.partial.clear();
    return std::move(found_);
  }
  for (const Explanation& one : causes_) found_.complete.push_back(one.cause);
  std::ranges::sort(found_.partial, [](const Cause& a, const Cause& b) {
    const auto rank = [](const Cause& cause) {
      return (cause.departures + 1) * (cause.passes + 1);
    };
    return std::tuple(rank(b), a.name) < std::tuple(rank(a), b.name);
  });
  if (found_.partial.size() > kMostPartial) found_.partial.resize(kMostPartial);
  return std::move(found_);
}

// The codes of motion of a program; what is in force where it departs, if that is known.
Motions codes_that_matter(const Observation& seen) {
  const ProgramText program(seen.profile, seen.program);
  const std::string_view there = program.code_at(seen.verdict.block);
  if (!there.empty()) return {std::string(there)};
  Motions motions;
  for (const TextBlock& block : program.blocks) {
    if (block.modes.code() != nullptr) motions.emplace(block.modes.code_name());
  }
  return motions;
}

// As many as wanted, spread evenly.
void spread(const std::vector<ProgramAsked>& from, std::size_t wanted,
            std::vector<ProgramAsked>& out) {
  const std::size_t count = std::min(wanted, from.size());
  for (std::size_t i = 0; i < count; ++i) out.push_back(from[i * from.size() / count]);
}

// Programs of the corpus, those with a code that matters first.
struct Programs {
  std::vector<ProgramAsked> first;
  std::vector<ProgramAsked> then;
};

Programs programs_like(const oracle::Corpus& corpus, const Observation& seen,
                       const AttributionOptions& options) {
  const Motions codes = codes_that_matter(seen);
  std::vector<ProgramAsked> alike;
  std::vector<ProgramAsked> others;
  oracle::CaseReader reader(corpus, oracle::Detail::to_run);
  while (const auto test = reader.next()) {
    if (test->dialect != seen.profile.dialect || test->id == seen.id) continue;
    if (test->program.size() > kMostBytes) continue;
    const ProgramText program(test->profile, test->program);
    const bool like = std::ranges::any_of(program.blocks, [&](const TextBlock& block) {
      return codes.contains(block.modes.code_name());
    });
    (like ? alike : others).push_back({test->id, test->program, test->profile});
  }
  Programs programs;
  spread(alike, options.alike, programs.first);
  spread(others, options.others, programs.first);
  spread(alike, options.more * 3 / 4, programs.then);
  spread(others, options.more / 4, programs.then);
  return programs;
}

}  // namespace

Attribution attribute(oracle::Subject& subject, const oracle::Corpus& corpus,
                      const ProgramAsked& asked, const AttributionOptions& options) {
  Attributor attributor(subject, options);
  attributor.observe(asked);
  Observation seed{asked.id, asked.program, asked.profile, {}, {}, 0, {}};
  if (!attributor.programs().empty()) seed = attributor.programs().front();
  const Programs programs = programs_like(corpus, seed, options);
  for (const ProgramAsked& other : programs.first) attributor.observe(other);
  // What is left over from program to program shows the second time only.
  attributor.observe(asked);
  attributor.find_causes();
  for (const ProgramAsked& other : programs.then) {
    if (!attributor.has_causes() || attributor.is_spent()) break;
    attributor.observe(other);
  }
  return attributor.finish();
}

namespace {

void append_cause(const Attribution& all, const Cause& cause, std::string& out) {
  out += fmt::format("  {}: explains {} of {} departures", cause.name, cause.departures,
                     all.departures);
  if (cause.passes == all.passes()) {
    out += fmt::format(", and that {} programs pass\n", all.passes());
  } else {
    out += fmt::format("; {} of {} programs that pass would not\n", all.passes() - cause.passes,
                       all.passes());
  }
}

}  // namespace

std::string attribution_text(const Attribution& all) {
  std::string out = fmt::format("{} programs, {} of them depart; {} mistakes tried\n",
                                all.programs.size(), all.departures, all.tried);
  for (const Observation& seen : all.programs) {
    if (!seen.departs()) continue;
    out += fmt::format("  {}: {}, line {}\n", seen.id, name(seen.verdict.kind), seen.verdict.block);
  }
  if (all.departures == 0) return out + "Nothing departs: there is no cause to name.\n";
  if (!all.complete.empty()) {
    out += "The subject does what the reference does when\n";
    for (const Cause& cause : all.complete) append_cause(all, cause, out);
    return out;
  }
  out += "No one mistake that was tried explains everything.\n";
  if (!all.partial.empty()) out += "Some of it is explained when\n";
  for (const Cause& cause : all.partial) append_cause(all, cause, out);
  return out;
}

}  // namespace gonogo::identify
