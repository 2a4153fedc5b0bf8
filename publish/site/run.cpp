// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/site/run.hpp"

#include <algorithm>
#include <numeric>
#include <string_view>

namespace gonogo::oracle::site {
namespace {

constexpr std::size_t kSlowest = 10;

// The end of the class of times that these microseconds belong to.
std::uint64_t class_end(std::uint64_t microseconds) {
  std::uint64_t end = 1;
  while (end <= microseconds) end += std::max<std::uint64_t>(1, end / 12);
  return end;
}

struct OutcomeNames {
  std::string_view title;
  std::string_view key;
};
constexpr std::array<OutcomeNames, kOutcomes> kNames = {{{"GO", "go"},
                                                         {"known to depart", "known"},
                                                         {"NO-GO", "no-go"},
                                                         {"undecided", "undecided"},
                                                         {"advice", "advice"},
                                                         {"skipped", "skip"}}};

}  // namespace

std::string_view title(Outcome outcome) {
  return kNames[static_cast<std::size_t>(outcome)].title;
}

std::string_view key(Outcome outcome) {
  return kNames[static_cast<std::size_t>(outcome)].key;
}

Outcome outcome_of(VerdictKind kind) {
  if (kind == VerdictKind::xfail) return Outcome::known;
  if (kind == VerdictKind::skip) return Outcome::skip;
  if (kind == VerdictKind::advice) return Outcome::advice;
  switch (decision(kind)) {
    case Decision::go:
      return Outcome::go;
    case Decision::no_go:
      return Outcome::no_go;
    default:
      return Outcome::undecided;
  }
}

std::uint64_t Counts::cases() const {
  return std::accumulate(of.begin(), of.end(), std::uint64_t{0});
}

bool CycleKey::operator<(const CycleKey& other) const {
  const NaturalOrder before;
  if (dialect != other.dialect) return before(dialect, other.dialect);
  return before(cycle, other.cycle);
}

void Speed::add(const std::string& id, std::uint64_t microseconds) {
  if (microseconds == 0) return;
  ++cases_;
  total_ += microseconds;
  ++classes_[class_end(microseconds)];
  if (slowest_.size() == kSlowest && microseconds <= slowest_.back().microseconds) return;
  // Among equally slow ones the first: lines come in the order of their ids.
  const auto place = std::ranges::find_if(
      slowest_, [&](const Slow& slow) { return slow.microseconds < microseconds; });
  slowest_.insert(place, {microseconds, id});
  if (slowest_.size() > kSlowest) slowest_.pop_back();
}

double Speed::rate() const {
  return total_ == 0 ? 0 : static_cast<double>(cases_) * 1e6 / static_cast<double>(total_);
}

std::uint64_t Speed::below(unsigned percent) const {
  std::uint64_t so_far = 0;
  for (const auto& [end, cases] : classes_) {
    so_far += cases;
    if (so_far * 100 >= cases_ * percent) return end;
  }
  return 0;
}

std::string folder_stem(std::string_view title) {
  constexpr std::size_t kLongest = 60;
  std::string stem;
  for (const char c : title.substr(0, kLongest)) {
    const bool upper = c >= 'A' && c <= 'Z';
    const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || upper;
    if (kept) {
      stem += upper ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (!stem.empty() && stem.back() != '-') {
      stem += c == '.' && stem.back() != '.' ? '.' : '-';
    }
  }
  while (!stem.empty() && (stem.back() == '-' || stem.back() == '.')) stem.pop_back();
  return stem.empty() ? "run" : stem;
}

Counts Run::of_cycle(const CycleKey& cycle) const {
  const auto found = cycles.find(cycle);
  return found == cycles.end() ? Counts{} : found->second;
}

void Run::add(const CaseHead& line, Outcome outcome) {
  dialects.insert(line.dialect);
  counts.add(outcome);
  cycles[{line.dialect, line.cycle}].add(outcome);
  if (outcome != Outcome::skip) speed.add(line.id, line.microseconds);
  if (outcome == Outcome::known) {
    Reason& reason = reasons[line.known];
    ++reason.cases;
    reason.verdicts.insert(line.departure.empty() ? line.verdict : line.departure);
  }
  if (outcome == Outcome::skip || outcome == Outcome::advice) return;
  for (const std::string& clause : line.clauses) {
    ClauseCounts& here = clauses[clause];
    if (outcome == Outcome::go) {
      ++here.passed;
    } else if (outcome == Outcome::undecided) {
      ++here.undecided;
    } else if (line.clause != clause) {
      ++here.elsewhere;
    }
  }
  // A case may depart at a clause that it is not there to test.
  if (departs(outcome) && !line.clause.empty()) ++clauses[line.clause].departed;
}

}  // namespace gonogo::oracle::site
