// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-PROP-07: no trace that is right in another way is NO-GO, advised against or left undecided.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <variant>

#include "alternative.hpp"
#include "bench.hpp"

namespace gonogo::mutations {
namespace {

using oracle::Decision;

constexpr std::size_t kMostExamples = 30;

struct Count {
  long accepted = 0;
  std::map<std::string, long> rejected;  // by what the judge says
};

constexpr double kDomain = 10'000;  // mm: no machine's axes are longer

// J-PATH-06: of an arc that the tolerance all but swallows, or that has whole turns and hardly a
// height, rounding decides which turn is meant.
bool hangs_on_rounding(const Stroke& stroke, double tolerance) {
  if (!stroke.is_round) return false;
  const double least = 4 * tolerance;
  if (std::min(stroke.from_radius, stroke.to_radius) < least) return true;
  if (std::abs(stroke.sweep) < std::numbers::pi) return false;
  return std::ranges::any_of(std::array{0, 1, 2}, [&](int axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double height = std::abs(stroke.to[i] - stroke.from[i]);
    return stroke.u[i] == 0 && stroke.v[i] == 0 && height > 0 && height < least;
  });
}

// Whether two layers of a pocket in a row are no farther apart than the tolerance: docs/relation.md
// has what the judge makes of them.
bool has_thin_layers(const Specimen& specimen) {
  const reference::PocketLevel* above = nullptr;
  for (const reference::Item& item : specimen.items) {
    const auto* const level = std::get_if<reference::PocketLevel>(&item);
    if (level == nullptr) continue;
    const bool is_of_pocket = above != nullptr && above->block == level->block;
    if (is_of_pocket && abs(above->depth - level->depth) <= specimen.tolerances.tolerance) {
      return true;
    }
    above = level;
  }
  return false;
}

// J-PROP-07: what no alternative is held against.
bool is_outside(const Attempt& attempt) {
  const double tolerance = value_of(attempt.tolerances.tolerance);
  if (has_thin_layers(attempt.specimen)) return true;
  const std::vector<Stroke> strokes = attempt.specimen.strokes(attempt.specimen.right);
  return std::ranges::any_of(strokes, [&](const Stroke& stroke) {
    const bool is_far = std::ranges::any_of(std::array<std::size_t, 3>{0, 1, 2}, [&](auto axis) {
      return std::abs(stroke.to[axis]) > kDomain;
    });
    return is_far || hangs_on_rounding(stroke, tolerance);
  });
}

// J-THR-09: without block numbers it may not be told where a thread ends, nor with a tolerance as
// large as it is deep where a pass does.
bool is_untold_thread(std::string_view name, const Specimen& specimen,
                      const oracle::Verdict& said) {
  const bool is_thread = std::ranges::any_of(specimen.items, [](const reference::Item& item) {
    return std::holds_alternative<reference::ThreadMilling>(item);
  });
  return (name == "no-blocks" || name == "looser-tolerance") && is_thread &&
         said.kind == oracle::VerdictKind::oracle_gap;
}

class Alternatives {
 public:
  explicit Alternatives(Chance& chance) : chance_(chance) {}

  void try_all(const Specimen& specimen) {
    for (std::size_t i = 0; i < all_.size(); ++i) {
      Attempt attempt(specimen, chance_);
      if (!all_[i].apply(attempt)) continue;
      judge(all_[i].name, attempt);
    }
    // Two at once: an open part first, for it takes the right trace as it stands.
    Attempt attempt(specimen, chance_);
    const Alternative& one = chance_.one_of(all_);
    if (!one.apply(attempt)) return;
    const std::vector<Alternative> wordings = wording_alternatives();
    const Alternative& other = chance_.one_of(wordings);
    if (other.name == one.name || one.name == "looser-tolerance") return;
    // What is rounded coarsely first is no finer value rounded.
    if (one.name.starts_with("rounded") && other.name.starts_with("rounded")) return;
    if (other.apply(attempt))
      judge("two-at-once", attempt, std::string(one.name) + " + " + std::string(other.name));
  }

  long accepted() const {
    long count = 0;
    for (const auto& [name, one] : counts_) count += one.accepted;
    return count;
  }

  long tried() const {
    long count = 0;
    for (const auto& [name, one] : counts_) {
      count += one.accepted;
      for (const auto& [why, times] : one.rejected) count += times;
    }
    return count;
  }

  long rejected() const { return tried() - accepted() - too_close(); }

  // R9: the estimate of an angle does not tell. It rejects nothing, but decides nothing.
  long too_close() const { return too_close_; }

  // Traces of enclosures, and how many of them nothing could be said of.
  long enclosed() const { return enclosed_; }
  long enclosed_gaps() const { return enclosed_gaps_; }

  void print() const {
    for (const auto& [name, one] : counts_) {
      fmt::print("{:32} {:7} accepted\n", name, one.accepted);
      for (const auto& [why, times] : one.rejected) fmt::print("    {:5} x {}\n", times, why);
    }
    std::map<std::string, int> seen;
    std::size_t printed = 0;
    for (const auto& [key, text] : examples_) {
      if (++printed <= kMostExamples) fmt::print("\n--- {}\n{}", key, text.second);
    }
  }

 private:
  void judge(std::string_view name, const Attempt& attempt, std::string what = {}) {
    if (is_outside(attempt)) return;
    const oracle::Verdict verdict =
        judge_outcome(attempt.profile, attempt.specimen.program, attempt.tolerances,
                      attempt.trace.records, attempt.trace.end)
            .verdict;
    if (is_untold_thread(name, attempt.specimen, verdict)) return;
    if (name == "as-enclosures" || what.find("as-enclosures") != std::string::npos) {
      ++enclosed_;
      // An open path asks for more than its ends, and what it asks may depend on an enclosure's
      // width.
      if (verdict.gap == oracle::GapReason::comparison) {
        ++enclosed_gaps_;
        return;
      }
    }
    Count& count = counts_[std::string(name)];
    if (decision(verdict.kind) == Decision::go) {
      ++count.accepted;
      return;
    }
    const std::string why = fmt::format("{}: {}", oracle::name(verdict.kind), verdict.message);
    ++count.rejected[why];
    if (verdict.gap == oracle::GapReason::comparison) ++too_close_;
    // The smallest of its kind.
    const std::size_t size = attempt.trace.records.size();
    auto& example = examples_[fmt::format("{}{}{}: {}", name, what.empty() ? "" : " ", what, why)];
    if (!example.second.empty() && example.first <= size) return;
    example = {size,
               fmt::format("{}\n{}{}\n{}", attempt.specimen.id, attempt.specimen.program,
                           reference::profile_json(attempt.profile), trace_text(attempt.trace))};
  }

  Chance& chance_;
  std::vector<Alternative> all_ = all_alternatives();
  std::map<std::string, Count> counts_;
  long too_close_ = 0;
  long enclosed_ = 0;
  long enclosed_gaps_ = 0;
  std::map<std::string, std::pair<std::size_t, std::string>> examples_;
};

TEST(Alternatives, NoneThatIsRightIsRejected) {
  const long wanted = trial_count(20'000);
  Chance chance(trial_seed());
  const RawCases cases = cases_of_corpus(GONOGO_SOURCE_DIR "/corpus");
  Alternatives alternatives(chance);
  while (alternatives.tried() < wanted) {
    for (const auto& [group, raws] : cases) {
      const RawCase& raw = chance.one_of(raws);
      const auto specimen = make_specimen(raw, chance.one_of(raw.assignments), kMostRecords);
      if (specimen == nullptr) continue;
      const auto verdict = judge_outcome(specimen->profile, specimen->program, specimen->tolerances,
                                         specimen->right.records, specimen->right.end);
      if (decision(verdict.verdict.kind) != Decision::go) continue;
      alternatives.try_all(*specimen);
    }
  }
  alternatives.print();
  EXPECT_EQ(alternatives.rejected(), 0) << "of " << alternatives.tried();
  EXPECT_LT(alternatives.enclosed_gaps() * 5, alternatives.enclosed());
  EXPECT_LE(alternatives.too_close() * 10'000, alternatives.tried());
}

}  // namespace
}  // namespace gonogo::mutations
