// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/likely_cause.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

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
  Recognition(oracle::Subject& subject, std::span<const ProgramAsked> programs,
              const ExplanationOptions& options)
      : explainer_(subject, options) {
    for (const ProgramAsked& program : programs) {
      std::optional<Observation> seen = explainer_.observe(program);
      if (seen && seen->departs()) departures_.push_back(*std::move(seen));
    }
    if (!departures_.empty()) variants_ = variants_for(departures_.front());
  }

  // Counts the departures for the cause, if it is theirs.
  bool take(LikelyCause& cause) {
    const Variant* const variant = find(variants_, cause.name);
    if (variant == nullptr || !explainer_.explains(*variant, departures_.front())) return false;
    LikelyCause here;
    for (const Observation& seen : departures_) {
      (explainer_.explains(*variant, seen) ? here.explained : here.unexplained).push_back(seen.id);
    }
    if (!is_most(variant->is_misread, here.explained.size(), departures_.size())) return false;
    cause.add(here);
    std::erase_if(cause.rivals, [&](const std::string& rival) {
      return count(find(variants_, rival)) < here.explained.size();
    });
    return true;
  }

 private:
  std::size_t count(const Variant* variant) {
    if (variant == nullptr) return 0;
    return static_cast<std::size_t>(std::ranges::count_if(
        departures_, [&](const Observation& seen) { return explainer_.explains(*variant, seen); }));
  }

  Explainer explainer_;
  std::vector<Observation> departures_;
  Variants variants_;
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
                       std::span<const ProgramAsked> programs, const ExplanationOptions& options) {
  Recognition recognition(subject, programs, options);
  const auto found =
      std::ranges::find_if(named, [&](LikelyCause& cause) { return recognition.take(cause); });
  return found == named.end() ? nullptr : &*found;
}

}  // namespace gonogo::identify
