// SPDX-License-Identifier: GPL-3.0-or-later
#include "identify/attribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace gonogo::identify {

namespace {

constexpr std::size_t kMostBytes = 4'000;
constexpr std::size_t kMostPartial = 10;

class Attributor {
 public:
  Attributor(oracle::Subject& subject, const AttributionOptions& options)
      : explainer_(subject, options) {}

  // Gives the program to the subject; and tries on it what explains everything so far.
  void observe(const ProgramAsked& asked);
  // What explains the programs that have been observed.
  void find_causes();
  bool has_causes() const { return !causes_.empty(); }
  bool is_spent() const { return explainer_.is_spent(); }
  Attribution finish();
  const std::vector<Observation>& programs() const { return found_.programs; }

 private:
  struct Explanation {
    Variant variant;
    Cause cause;
  };

  // Counts the program for the cause. False: it is not explained.
  bool count(const Variant& variant, const Observation& seen, Cause& cause);
  void try_variant(const Variant& variant);
  void try_causes(const Observation& seen);

  Explainer explainer_;
  std::vector<Explanation> causes_;  // that explain everything so far
  Attribution found_;
};

void Attributor::observe(const ProgramAsked& asked) {
  std::optional<Observation> seen = explainer_.observe(asked);
  if (!seen) return;
  if (seen->departs()) ++found_.departures;
  found_.programs.push_back(*std::move(seen));
  try_causes(found_.programs.back());
}

bool Attributor::count(const Variant& variant, const Observation& seen, Cause& cause) {
  if (!explainer_.explains(variant, seen)) return false;
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
  const Variants variants = variants_for(*departure);
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
