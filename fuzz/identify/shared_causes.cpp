// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/shared_causes.hpp"

#include <algorithm>
#include <optional>

namespace gonogo::identify {
namespace {

constexpr std::size_t kMostDeparting = 40;  // other programs that mistakes are told apart by

class Sharing {
 public:
  Sharing(oracle::Subject& subject, const ExplanationOptions& options)
      : explainer_(subject, options) {}

  void add_symptoms(std::span<const ProgramAsked> symptoms);
  void add_others(std::span<const ProgramAsked> others);
  SharedCauses find();

 private:
  struct Symptom {
    std::size_t number = 0;
    Observation seen;
  };
  // A mistake and the symptoms in `open_` that it explains.
  struct Candidate {
    const Variant* variant = nullptr;
    std::vector<std::size_t> explained;
  };
  // Those that explain the first symptom that is open, the one that explains most first.
  std::vector<Candidate> candidates(const Variants& variants);
  bool keeps_passes(const Variant& variant);
  // Those of the ones which explain most symptoms that explain most other departures, the simplest
  // first; none: also where they explain a single symptom and nothing else.
  std::vector<const Candidate*> best_of(const std::vector<Candidate>& all);
  SharedCause cause_of(const std::vector<const Candidate*>& best);
  // Takes the symptoms of the first open one's cause away, or that symptom alone.
  void close_first();

  Explainer explainer_;
  std::vector<Symptom> open_;
  std::vector<Symptom> closed_;
  std::vector<Observation> passing_;
  std::vector<Observation> departing_;  // other programs: what a smallest one shows alike
  SharedCauses found_;
};

void Sharing::add_symptoms(std::span<const ProgramAsked> symptoms) {
  for (std::size_t i = 0; i < symptoms.size(); ++i) {
    std::optional<Observation> seen = explainer_.observe(symptoms[i]);
    if (seen && seen->departs()) open_.push_back({i, *std::move(seen)});
  }
}

void Sharing::add_others(std::span<const ProgramAsked> others) {
  for (const ProgramAsked& other : others) {
    std::optional<Observation> seen = explainer_.observe(other);
    if (!seen) continue;
    if (!seen->departs()) {
      passing_.push_back(*std::move(seen));
    } else if (departing_.size() < kMostDeparting) {
      departing_.push_back(*std::move(seen));
    }
  }
  found_.passes = passing_.size();
}

std::vector<Sharing::Candidate> Sharing::candidates(const Variants& variants) {
  std::vector<Candidate> all;
  for (const Variant& variant : variants) {
    if (explainer_.is_spent()) break;
    ++found_.tried;
    if (!explainer_.explains(variant, open_.front().seen)) continue;
    Candidate candidate{&variant, {0}};
    for (std::size_t i = 1; i < open_.size(); ++i) {
      if (explainer_.explains(variant, open_[i].seen)) candidate.explained.push_back(i);
    }
    all.push_back(std::move(candidate));
  }
  // Among equal ones the mistake that was tried first.
  std::ranges::sort(all, {}, [&](const Candidate& candidate) {
    return std::pair(open_.size() - candidate.explained.size(),
                     candidate.variant - variants.data());
  });
  return all;
}

bool Sharing::keeps_passes(const Variant& variant) {
  return std::ranges::all_of(
      passing_, [&](const Observation& seen) { return explainer_.explains(variant, seen); });
}

// A smallest program may show too little: where every H is 1, "one too few" does as "ignored". What
// explains that one alone, and none of the other programs that depart, is a coincidence.
std::vector<const Sharing::Candidate*> Sharing::best_of(const std::vector<Candidate>& all) {
  std::vector<const Candidate*> best;
  std::ptrdiff_t most = -1;
  for (const Candidate& candidate : all) {
    if (!best.empty() && candidate.explained.size() < best.front()->explained.size()) break;
    if (!keeps_passes(*candidate.variant)) continue;
    const std::ptrdiff_t explained = std::ranges::count_if(
        departing_,
        [&](const Observation& seen) { return explainer_.explains(*candidate.variant, seen); });
    if (explainer_.is_spent()) break;
    if (explained > most) best.clear();
    if (explained >= most) best.push_back(&candidate);
    most = std::max(most, explained);
  }
  const bool is_alone = !best.empty() && best.front()->explained.size() == 1 && most == 0;
  if (is_alone && !departing_.empty()) best.clear();
  return best;
}

// A symptom that another cause has may be explained by this one as well.
SharedCause Sharing::cause_of(const std::vector<const Candidate*>& best) {
  const Candidate& first = *best.front();
  SharedCause cause;
  cause.name = first.variant->name;
  cause.passes = passing_.size();
  for (const std::size_t i : first.explained) cause.symptoms.push_back(open_[i].number);
  for (const std::vector<Symptom>* symptoms : {&open_, &closed_}) {
    for (const Symptom& symptom : *symptoms) {
      const bool is_explained = explainer_.explains(*first.variant, symptom.seen);
      (is_explained ? cause.explained : cause.unexplained).push_back(symptom.seen.id);
    }
  }
  for (std::size_t i = 1; i < best.size(); ++i) cause.rivals.push_back(best[i]->variant->name);
  return cause;
}

void Sharing::close_first() {
  explainer_.begin_anew();  // one that is too long leaves the others their chance
  std::vector<std::size_t> closed = {0};
  const Variants variants = variants_for(open_.front().seen);
  const std::vector<Candidate> all = candidates(variants);
  const std::vector<const Candidate*> best = best_of(all);
  if (!best.empty()) {
    closed = best.front()->explained;
    found_.causes.push_back(cause_of(best));
  }
  for (auto i = closed.rbegin(); i != closed.rend(); ++i) {
    const auto place = open_.begin() + static_cast<std::ptrdiff_t>(*i);
    closed_.push_back(std::move(*place));
    open_.erase(place);
  }
}

SharedCauses Sharing::find() {
  while (!open_.empty()) {
    close_first();
    found_.given_up = found_.given_up || explainer_.is_spent();
  }
  return std::move(found_);
}

}  // namespace

SharedCauses find_shared_causes(oracle::Subject& subject, std::span<const ProgramAsked> symptoms,
                                std::span<const ProgramAsked> others,
                                const ExplanationOptions& options) {
  Sharing sharing(subject, options);
  sharing.add_symptoms(symptoms);
  sharing.add_others(others);
  return sharing.find();
}

std::string known_cause(oracle::Subject& subject, const ProgramAsked& symptom,
                        const std::set<std::string>& names, const ExplanationOptions& options) {
  Explainer explainer(subject, options);
  const std::optional<Observation> seen = explainer.observe(symptom);
  if (!seen || !seen->departs()) return {};
  for (const Variant& variant : variants_for(*seen)) {
    if (names.contains(variant.name) && explainer.explains(variant, *seen)) return variant.name;
  }
  return {};
}

}  // namespace gonogo::identify
