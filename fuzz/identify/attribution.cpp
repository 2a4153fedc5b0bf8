// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/attribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <string_view>

namespace gonogo::identify {

namespace {

constexpr std::size_t kAlike = 32;   // programs with the code that departs
constexpr std::size_t kOthers = 12;  // and without it
constexpr std::size_t kMore = 400;   // on which the explanations of all these are tried too
constexpr std::size_t kMostBytes = 4'000;
constexpr std::size_t kMostPartial = 10;
constexpr std::size_t kTriedFirst = 8;  // departures: who explains none of them, explains few
constexpr std::size_t kMostTried = 12;  // mistakes on further programs, except equals

class Attributor {
 public:
  Attributor(oracle::Subject& subject, const ExplanationOptions& options)
      : explainer_(subject, options) {}

  // Gives the program to the subject; and tries on it what explains everything so far.
  void observe(const ProgramAsked& asked);
  // What explains the programs that have been observed, or some of them and every pass.
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
  std::vector<Explanation> causes_;  // that no pass contradicts so far
  Attribution found_;
};

void Attributor::observe(const ProgramAsked& asked) {
  std::optional<Observation> seen = explainer_.observe(asked);
  if (!seen) return;
  // What comes a second time counts where it shows something else.
  const bool is_known = std::ranges::any_of(found_.programs, [&](const Observation& one) {
    return one.id == seen->id && one.departs() == seen->departs();
  });
  if (is_known) return;
  if (seen->departs()) ++found_.departures;
  found_.programs.push_back(*std::move(seen));
  try_causes(found_.programs.back());
}

bool Attributor::count(const Variant& variant, const Observation& seen, Cause& cause) {
  const Fit fit = explainer_.fit(variant, seen);
  if (fit == Fit::no) return false;
  ++(!seen.departs() ? cause.passes : fit == Fit::full ? cause.departures : cause.cut_short);
  if (seen.departs() && fit == Fit::full) cause.explained.push_back(seen.id);
  return true;
}

void Attributor::try_variant(const Variant& variant) {
  ++found_.tried;
  Cause cause{variant.name, 0, 0, 0, variant.opposite, variant.is_misread, found_.tried};
  cause.is_by_path = variant.apply != nullptr;
  std::size_t tried = 0;
  for (const Observation& seen : found_.programs) {
    if (seen.departs() && ++tried > kTriedFirst && cause.departures == 0) return;
    if (seen.departs()) count(variant, seen, cause);
  }
  if (cause.departures == 0) return;
  for (const Observation& seen : found_.programs) {
    if (!seen.departs()) count(variant, seen, cause);
  }
  if (cause.passes == found_.passes()) {
    causes_.push_back({variant, std::move(cause)});
  } else {
    found_.partial.push_back(std::move(cause));
  }
}

// A departure may have another cause; a pass that would be none may not.
void Attributor::try_causes(const Observation& seen) {
  std::erase_if(causes_, [&](Explanation& one) {
    if (count(one.variant, seen, one.cause) || seen.departs()) return false;
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
  // The simplest first among equals; the hopeless are not tried any further.
  std::vector<std::size_t> explained;
  for (const Explanation& one : causes_) explained.push_back(one.cause.departures);
  std::ranges::sort(explained, std::greater());
  if (explained.size() <= kMostTried) return;
  std::erase_if(causes_, [least = explained[kMostTried - 1]](const Explanation& one) {
    return one.cause.departures < least;
  });
}

Attribution Attributor::finish() {
  if (is_spent()) {
    found_.given_up = true;
    found_.partial.clear();
    return std::move(found_);
  }
  for (const Explanation& one : causes_) {
    const Cause& cause = one.cause;
    const bool is_complete = cause.departures + cause.cut_short == found_.departures &&
                             2 * cause.cut_short < found_.departures;
    (is_complete ? found_.complete : found_.partial).push_back(cause);
  }
  std::ranges::sort(found_.partial, [](const Cause& a, const Cause& b) {
    const auto rank = [](const Cause& cause) {
      return (cause.departures + 1) * (cause.passes + 1);
    };
    return std::tuple(rank(b), a.place) < std::tuple(rank(a), b.place);
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

// Programs of the corpus, those with a code that matters first.
struct Programs {
  std::vector<ProgramAsked> first;
  std::vector<ProgramAsked> then;
};

// Programs with what the subject does not declare tell no mistake.
Programs programs_like(const oracle::Corpus& corpus, const Observation& seen,
                       const oracle::SubjectInfo& info) {
  const Motions codes = codes_that_matter(seen);
  std::vector<ProgramAsked> alike;
  std::vector<ProgramAsked> others;
  oracle::CaseReader reader(corpus, oracle::Detail::to_run, {seen.profile.dialect});
  while (const auto test = reader.next()) {
    if (test->id == seen.id || test->program.size() > kMostBytes) continue;
    const bool is_declared = info.dialects.empty() ||
                             std::ranges::all_of(test->features, [&](const std::string& feature) {
                               return info.declares(test->dialect, feature);
                             });
    if (!is_declared) continue;
    const ProgramText program(test->profile, test->program);
    const bool like = std::ranges::any_of(program.blocks, [&](const TextBlock& block) {
      return codes.contains(block.modes.code_name());
    });
    (like ? alike : others).push_back({test->id, test->program, test->profile});
  }
  Programs programs{spread(alike, kAlike), spread(alike, kMore * 3 / 4)};
  std::ranges::move(spread(others, kOthers), std::back_inserter(programs.first));
  std::ranges::move(spread(others, kMore / 4), std::back_inserter(programs.then));
  return programs;
}

}  // namespace

Attribution attribute(oracle::Subject& subject, const oracle::Corpus& corpus,
                      const ProgramAsked& asked, const ExplanationOptions& options) {
  Attributor attributor(subject, options);
  attributor.observe(asked);
  Observation seed{asked.id, asked.program, asked.profile, {}, {}, 0, {}, {}};
  if (!attributor.programs().empty()) seed = attributor.programs().front();
  const Programs programs = programs_like(corpus, seed, subject.info());
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

// Whether a mistake and its opposite are among them: then neither is what the departures show.
bool contradict(const std::vector<Cause>& equal) {
  return std::ranges::any_of(equal, [&](const Cause& cause) {
    return !cause.opposite.empty() &&
           std::ranges::find(equal, cause.opposite, &Cause::name) != equal.end();
  });
}

bool is_likely(const Cause& cause, const Attribution& all) {
  constexpr std::size_t kChance = 1;  // departures for which some word misread always serves
  if (cause.is_misread && cause.departures <= kChance) return false;
  return is_most(cause.is_misread, cause.departures, all.departures);
}

// The departures that the cause does not explain in full.
std::vector<std::string> left_over(const Attribution& all, const Cause& cause) {
  std::vector<std::string> ids;
  for (const Observation& seen : all.programs) {
    const bool is_explained = std::ranges::find(cause.explained, seen.id) != cause.explained.end();
    if (seen.departs() && !is_explained) ids.push_back(seen.id);
  }
  return ids;
}

}  // namespace

LikelyCause likely_cause(const Attribution& all) {
  constexpr std::size_t kFew = 3;  // departures that tell few mistakes apart
  std::vector<Cause> equal;
  std::ranges::copy_if(all.complete, std::back_inserter(equal),
                       [&](const Cause& cause) { return is_likely(cause, all); });
  const bool is_whole = !equal.empty();
  for (const Cause& cause : all.partial) {
    if (is_whole || cause.passes != all.passes() || !is_likely(cause, all)) continue;
    if (equal.empty() || cause.departures == equal.front().departures) equal.push_back(cause);
  }
  if (equal.empty() || (equal.size() > kFew && all.departures < kFew)) return {};
  if (contradict(equal)) return {};
  // What does all that the subject does says more than that a rule is not checked.
  if (!equal.front().is_by_path) {
    const auto followed = std::ranges::find_if(
        equal, [](const Cause& cause) { return cause.is_by_path && !cause.is_misread; });
    if (followed != equal.end()) std::rotate(equal.begin(), followed, followed + 1);
  }
  const Cause& first = equal.front();
  LikelyCause likely{first.name, first.explained, left_over(all, first), first.passes, {}};
  for (const Observation& seen : all.programs) likely.dialects.insert(seen.profile.dialect);
  for (std::size_t i = 1; i < equal.size(); ++i) likely.rivals.push_back(equal[i].name);
  return likely;
}

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
