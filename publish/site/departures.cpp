// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/site/departures.hpp"

#include <algorithm>
#include <tuple>

namespace gonogo::oracle::site {
namespace {

// Subjects may break down in another way each time; what is beyond so many is counted as one.
constexpr std::size_t kMostDepartures = 2'000;

// A program that is not kept is no example while there is another; equal ones: the first run's.
auto size_of(const Departure::Example& example) {
  return std::tuple(example.blocks == 0, example.blocks, example.bytes,
                    std::string_view(example.id), example.run);
}

bool is_departure(const CaseHead& line, VerdictKind kind) {
  if (kind == VerdictKind::oracle_gap) return !line.expected;
  return kind == VerdictKind::oracle_error || departs(outcome_of(kind));
}

Finding::Key key_of(const CaseHead& line, VerdictKind kind) {
  if (kind == VerdictKind::xfail) kind = verdict_kind(line.departure).value_or(kind);
  return {gravity(kind), kind, line.dialect, line.clause,
          departed_about(kind, line.want, line.got, line.message)};
}

}  // namespace

std::string Departure::text() const {
  Finding finding;
  finding.shown = key;
  return finding.text();
}

void Departures::add(const CaseHead& line, VerdictKind kind, std::size_t run) {
  if (!is_departure(line, kind)) return;
  Finding::Key key = key_of(line, kind);
  if (departures_.size() >= kMostDepartures && !departures_.contains(key)) {
    key.dialect = key.clause = "";
    key.what = "of further kinds";
  }
  Departure& departure = departures_[key];
  departure.key = key;
  std::string& last = last_[key];
  if (last != line.id) ++departure.cases;
  last = line.id;
  departure.cycles.insert(line.cycle);
  Departure::Share& share = departure.shares[run];
  if (share.cases++ == 0) share.first = line.id;
  if (kind == VerdictKind::xfail) ++share.known;
  const Departure::Example example{line.id, line.message.empty() ? line.known : line.message,
                                   line.program_blocks, line.program_bytes, run};
  if (departure.smallest.id.empty() || size_of(example) < size_of(departure.smallest)) {
    departure.smallest = example;
  }
}

std::vector<const Departure*> Departures::list() const {
  std::vector<const Departure*> all;
  for (const auto& [key, departure] : departures_) all.push_back(&departure);
  std::ranges::sort(all, [](const Departure* a, const Departure* b) {
    const auto rank = [](const Departure& one) {
      return std::tuple(-static_cast<std::int64_t>(one.shares.size()), one.key.gravity,
                        -static_cast<std::int64_t>(one.cases), std::cref(one.key));
    };
    const auto [a1, a2, a3, a4] = rank(*a);
    const auto [b1, b2, b3, b4] = rank(*b);
    return std::tie(a1, a2, a3, a4.get()) < std::tie(b1, b2, b3, b4.get());
  });
  return all;
}

}  // namespace gonogo::oracle::site
