// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/likely_cause.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "oracle/records/run_scope.hpp"

namespace gonogo::identify {
namespace {

constexpr std::size_t kShown = 3;  // ids, rivals

std::string first_of(const std::vector<std::string>& all, std::string_view between) {
  return fmt::format("{}", fmt::join(std::span(all).first(std::min(all.size(), kShown)), between));
}

// What the mistake of this name is in the program that departs first. Null: nothing.
const Variant* find(const Variants& variants, const std::string& name) {
  const auto found = std::ranges::find(variants, name, &Variant::name);
  return found == variants.end() ? nullptr : &*found;
}

void add_new(const std::vector<std::string>& ids, std::vector<std::string>& to) {
  std::ranges::copy_if(ids, std::back_inserter(to), [&](const std::string& id) {
    return std::ranges::find(to, id) == to.end();
  });
}

// The programs of another finding and the mistakes that may be what they depart by.
class Recognition {
 public:
  Recognition(oracle::Subject& subject, const FindingAsked& finding,
              const ExplanationOptions& options)
      : explainer_(subject, options), programs_(finding.departures), others_(finding.others) {
    while (departures_.empty() && !programs_.empty()) observe_next();
    if (!departures_.empty()) variants_ = variants_for(departures_.front());
  }

  // Counts the departures for the cause, if it or a rival of it is theirs.
  bool take(LikelyCause& cause, bool by_rival) {
    const Variant* const variant = by_rival ? rival_of(cause) : meant_by(cause.name);
    if (variant == nullptr) return false;
    const std::string dialect = departures_.front().profile.dialect;
    const bool is_new = !cause.dialects.contains(dialect);
    if (is_new && !keeps_passes(*variant)) return false;
    while (!programs_.empty()) observe_next();
    LikelyCause here;
    for (const Observation& seen : departures_) {
      (explainer_.explains(*variant, seen) ? here.explained : here.unexplained).push_back(seen.id);
    }
    if (!is_most(variant->is_misread, here.explained.size(), departures_.size())) return false;
    cause.name = variant->name;
    cause.add(here);
    if (is_new) cause.passes += passing_.size();
    cause.dialects.insert(dialect);
    std::erase_if(cause.rivals, [&](const std::string& rival) {
      const Variant* const other = find(variants_, rival);
      return rival == cause.name || other == nullptr || count(*other) < here.explained.size() ||
             (is_new && !keeps_passes(*other));
    });
    return true;
  }

 private:
  void observe_next() {
    std::optional<Observation> seen = explainer_.observe(programs_.front());
    programs_ = programs_.subspan(1);
    if (seen && seen->departs()) departures_.push_back(*std::move(seen));
  }

  // The mistake of this name, if it explains the first departure.
  const Variant* meant_by(const std::string& name) {
    const Variant* const variant = find(variants_, name);
    const bool is_its = variant != nullptr && explainer_.explains(*variant, departures_.front());
    return is_its ? variant : nullptr;
  }

  // The first rival that does; both explain all that was tried before.
  const Variant* rival_of(const LikelyCause& cause) {
    if (!cause.unexplained.empty()) return nullptr;
    for (const std::string& rival : cause.rivals) {
      if (const Variant* const variant = meant_by(rival)) return variant;
    }
    return nullptr;
  }

  std::size_t count(const Variant& variant) {
    return static_cast<std::size_t>(std::ranges::count_if(
        departures_, [&](const Observation& seen) { return explainer_.explains(variant, seen); }));
  }

  bool keeps_passes(const Variant& variant) {
    for (const ProgramAsked& other : std::exchange(others_, {})) {
      std::optional<Observation> seen = explainer_.observe(other);
      if (seen && !seen->departs()) passing_.push_back(*std::move(seen));
    }
    return std::ranges::all_of(
        passing_, [&](const Observation& seen) { return explainer_.explains(variant, seen); });
  }

  Explainer explainer_;
  std::span<const ProgramAsked> programs_;  // still to be run
  std::span<const ProgramAsked> others_;    // as well
  std::vector<Observation> passing_;        // of those
  std::vector<Observation> departures_;
  Variants variants_;  // of the first
};

}  // namespace

void LikelyCause::add(const LikelyCause& other) {
  add_new(other.explained, explained);
  add_new(other.unexplained, unexplained);
}

std::string LikelyCause::evidence() const {
  std::string text = fmt::format("It explains {} of {} departures that were tried",
                                 explained.size(), explained.size() + unexplained.size());
  if (unexplained.size() > kShown) {
    text += fmt::format(" (not: {} and {} more)", first_of(unexplained, ", "),
                        unexplained.size() - kShown);
  } else if (!unexplained.empty()) {
    text += fmt::format(" (not: {})", first_of(unexplained, ", "));
  }
  if (passes > 0) {
    text +=
        fmt::format(", and that {}", oracle::counted(passes, "program passes", "programs pass"));
  }
  if (rivals.empty()) return text + ".";
  return text + fmt::format(". As much is explained by: {}{}.", first_of(rivals, "; "),
                            rivals.size() > kShown ? "; and others" : "");
}

bool is_most(bool is_misread, std::size_t explained, std::size_t departures) {
  return is_misread ? 4 * explained >= 3 * departures : 2 * explained > departures;
}

LikelyCause* recognise(std::vector<LikelyCause>& named, oracle::Subject& subject,
                       const FindingAsked& finding, const ExplanationOptions& options) {
  Recognition recognition(subject, finding, options);
  for (const bool by_rival : {false, true}) {
    for (LikelyCause& cause : named) {
      if (recognition.take(cause, by_rival)) return &cause;
    }
  }
  return nullptr;
}

}  // namespace gonogo::identify
