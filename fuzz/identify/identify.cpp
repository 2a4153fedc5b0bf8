// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/identify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fuzz/identify/identifier.hpp"

namespace gonogo::identify {

using oracle::Decision;
using oracle::RunEnd;
using oracle::VerdictKind;

namespace {

// Rows of readings that are looked at together. A program that ties more of them together waits
// until there are fewer.
constexpr std::size_t kMostRows = 4'096;
// Outcomes that are compared with each other by the judge.
constexpr std::size_t kMostCompared = 8;
// That are run for one identification, skipped ones too.
constexpr std::size_t kMostPrograms = 300;
// No information to speak of.
constexpr double kNothing = 1e-9;

std::string values_text(const Reading& reading, const std::vector<ReadingValue>& values) {
  std::vector<std::string_view> texts;
  for (const ReadingValue value : values) texts.push_back(text_of(reading, value));
  return fmt::format("{}", fmt::join(texts, " or "));
}

}  // namespace

Identifier::Identifier(oracle::Subject& subject, const ProbePool& pool,
                       const oracle::Grants& grants)
    : subject_(subject), pool_(pool), grants_(grants), kinds_(reading_kinds(pool.dialect)) {
  for (const Probe& probe : pool.probes) {
    Item& item = items_.emplace_back();
    item.probe = &probe;
    for (const Outcomes::Leaf& leaf : probe.by_reading.leaves) item.outcome.push_back(leaf.outcome);
  }
  choices_ = all_choices();
  for (const ReadingKey key : kinds_.properties) {
    properties_.add(key, reference::reading(key).alternatives.size() + 1);
  }
}

Candidates Identifier::all_choices() const {
  Candidates all;
  for (const ReadingKey key : kinds_.choices) {
    all.add(key, reference::reading(key).alternatives.size());
  }
  return all;
}

bool Identifier::usable(const Item& item) const {
  if (item.used || (item.probe->named_paths && !paths_found_)) return false;
  for (const std::string& feature : item.probe->features) {
    if (skipped_features_.contains(feature)) return false;
    if (!subject_.info().declares(pool_.dialect, feature)) return false;
  }
  return std::ranges::none_of(item.probe->lengths,
                              [&](ReadingKey key) { return unknown_lengths_.contains(key); });
}

ProbeRun* Identifier::ask(Item& item) {
  item.used = true;
  if (!item.run) {
    if (found_.runs.size() >= kMostPrograms) return nullptr;
    if (!configured_ || *configured_ != item.probe->profile) {
      configured_ = item.probe->profile;
      subject_.configure(*configured_);
    }
    item.run = found_.runs.size();
    found_.runs.push_back(
        {item.probe, run_subject(subject_, item.probe->id, item.probe->program), {}});
    const RunEnd& end = found_.runs.back().outcome.end;
    if (end.kind == RunEnd::Kind::skip && item.probe->features.contains(end.feature)) {
      skipped_features_.insert(end.feature);
    }
  }
  ProbeRun& run = found_.runs[*item.run];
  return run.outcome.answered() ? &run : nullptr;
}

oracle::Verdict Identifier::judge(const Item& item, const PartialAssignment& readings) const {
  const ProbeRun& run = found_.runs[item.run.value()];
  Profile profile = item.probe->profile;
  profile.readings = base_;
  set_values(profile, readings);
  oracle::Tolerances tolerances = make_tolerances(subject_.info(), profile, grants_);
  tolerances.strict = true;  // what it follows, not what a text states
  return judge_kept(profile, item.probe->program, tolerances, run.outcome);
}

std::vector<PartialAssignment> Identifier::explaining(const Item& item,
                                                      const Outcomes& outcomes) const {
  std::vector<PartialAssignment> left;
  for (const Outcomes::Leaf& leaf : outcomes.leaves) {
    const VerdictKind kind = judge(item, leaf.readings).kind;
    // What cannot be decided, or an alarm whose class is not known, rules nothing out.
    if (decision(kind) != Decision::no_go || kind == VerdictKind::unmapped_alarm) {
      left.push_back(leaf.readings);
    }
  }
  return left;
}

// How much the outcome of the program would say, in bits: the entropy of the parts into which its
// outcomes divide what is left.
double Identifier::information(const Item& item) const {
  const Outcomes& outcomes = item.probe->by_reading;
  if (outcomes.different < 2) return 0;
  const auto group = choices_.joined(outcomes.keys, kMostRows);
  if (!group) return 0;
  std::map<std::size_t, std::size_t> parts;
  for (const auto& row : group->rows) {
    for (std::size_t i = 0; i < outcomes.leaves.size(); ++i) {
      if (!group->agrees(row, outcomes.leaves[i].readings)) continue;
      ++parts[item.outcome[i]];
      break;
    }
  }
  double bits = 0;
  for (const auto& [outcome, rows] : parts) {
    const double part = static_cast<double>(rows) / static_cast<double>(group->rows.size());
    bits -= part * std::log2(part);
  }
  return bits;
}

// Outcomes whose texts differ may be one for the judge, by less than the tolerance or because it
// admits both. Each outcome is judged under the readings of the others.
void Identifier::check_outcomes(Item& item) {
  item.checked = true;
  const Probe& probe = *item.probe;
  if (probe.by_reading.different > kMostCompared) return;
  std::map<std::size_t, std::pair<Profile, KeptOutcome>> shown;  // one leaf of each outcome
  for (const Outcomes::Leaf& leaf : probe.by_reading.leaves) {
    if (shown.contains(leaf.outcome)) continue;
    Profile profile = probe.profile;
    profile.readings = base_;
    set_values(profile, leaf.readings);
    auto outcome = run_reference(profile, probe.program);
    if (!outcome) return;
    shown.emplace(leaf.outcome, std::pair{std::move(profile), std::move(*outcome)});
  }
  oracle::Tolerances tolerances = make_tolerances(subject_.info(), probe.profile, grants_);
  tolerances.strict = true;
  const auto passes = [&](const auto& outcome, const auto& under) {
    const oracle::Verdict verdict =
        judge_kept(under.second.first, probe.program, tolerances, outcome.second.second);
    return decision(verdict.kind) != Decision::no_go;
  };
  for (auto a = shown.begin(); a != shown.end(); ++a) {
    for (auto b = std::next(a); b != shown.end(); ++b) {
      if (!passes(*a, *b) || !passes(*b, *a)) continue;
      for (std::size_t i = 0; i < item.outcome.size(); ++i) {
        if (probe.by_reading.leaves[i].outcome == b->first) item.outcome[i] = a->first;
      }
    }
  }
}

Identifier::Item* Identifier::best_item() {
  while (true) {
    Item* best = nullptr;
    double most = kNothing;
    for (Item& item : items_) {
      if (!usable(item)) continue;
      const double bits = information(item);
      const bool shorter =
          best != nullptr && item.probe->program.size() < best->probe->program.size();
      if (bits > most + kNothing || (bits > most - kNothing && shorter)) {
        best = &item;
        most = bits;
      }
    }
    if (best == nullptr || best->checked) return best;
    check_outcomes(*best);
  }
}

// Keeps of the candidates what explains the run. False: nothing does.
bool Identifier::strike(Item& item) {
  const Outcomes& outcomes = item.probe->by_reading;
  std::vector<PartialAssignment> left = explaining(item, outcomes);
  if (left.empty()) {
    found_.aside.push_back(*item.run);
    return true;
  }
  ProbeRun& run = found_.runs[*item.run];
  std::map<ReadingKey, std::vector<ReadingValue>> before;
  for (const ReadingKey key : outcomes.keys) before[key] = choices_.values(key);
  if (!choices_.joined(outcomes.keys, kMostRows)) return true;  // later, when fewer are left
  const bool consistent = choices_.keep(outcomes.keys, left, kMostRows);
  if (!consistent) {
    note_contradiction(*item.run, outcomes.keys, left);
    return false;
  }
  for (const auto& [key, values] : before) {
    const std::vector<ReadingValue> now = choices_.values(key);
    if (now.size() == values.size()) continue;
    const Reading& reading = reference::reading(key);
    std::vector<ReadingValue> struck;
    std::ranges::set_difference(values, now, std::back_inserter(struck));
    run.learnt.push_back(fmt::format("{} is {}, not {}", reading.name, values_text(reading, now),
                                     values_text(reading, struck)));
  }
  constraints_.push_back({*item.run, outcomes.keys, std::move(left)});
  return true;
}

// The two runs that contradict each other, or, where it takes more, as few as do.
void Identifier::note_contradiction(std::size_t run, const std::vector<ReadingKey>& keys,
                                    const std::vector<PartialAssignment>& left) {
  found_.contradiction = {run};
  constexpr std::size_t kMany = kMostRows * 16;
  const auto possible = [&](std::span<const Constraint* const> those) {
    Candidates candidates = all_choices();
    for (const Constraint* one : those) {
      if (!candidates.joined(one->keys, kMany)) return true;
      if (!candidates.keep(one->keys, one->left, kMany)) return false;
    }
    return true;
  };
  const Constraint last{run, keys, left};
  std::vector<const Constraint*> those = {&last};
  for (const Constraint& earlier : constraints_) {
    const std::array<const Constraint*, 2> pair = {&earlier, &last};
    if (possible(pair)) continue;
    found_.contradiction.push_back(earlier.run);
    return;
  }
  for (const Constraint& earlier : constraints_) those.push_back(&earlier);
  for (std::size_t i = those.size(); i-- > 1;) {
    std::vector<const Constraint*> fewer = those;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (!possible(fewer)) those = std::move(fewer);
  }
  for (std::size_t i = 1; i < those.size(); ++i) found_.contradiction.push_back(those[i]->run);
}

void Identifier::find_choices() {
  while (Item* item = best_item()) {
    if (ask(*item) != nullptr && !strike(*item)) return;
  }
}

// Judges all runs once more: under the properties that have been found, outcomes can be
// distinguished that were one before.
void Identifier::judge_runs_again() {
  found_.aside.clear();
  for (Item& item : items_) {
    item.checked = false;
    for (std::size_t i = 0; i < item.outcome.size(); ++i) {
      item.outcome[i] = item.probe->by_reading.leaves[i].outcome;
    }
    if (!item.run || !found_.runs[*item.run].outcome.answered()) continue;
    if (!strike(item)) return;
  }
}

// One of the values that look the same is as good as another.
void Identifier::count_coordinates() {
  for (const Item& item : items_) {
    if (!item.run || !found_.runs[*item.run].outcome.answered()) continue;
    Profile profile = item.probe->profile;
    profile.readings = base_;
    for (const ReadingFound& one : found_.readings) {
      if (!one.values.empty()) profile.readings.set(one.key, one.values.front());
    }
    const oracle::Tolerances tolerances = make_tolerances(subject_.info(), profile, grants_);
    const oracle::Verdict verdict =
        judge_kept(profile, item.probe->program, tolerances, found_.runs[*item.run].outcome);
    if (verdict.coordinates) found_.coordinates.add(*verdict.coordinates);
  }
}

Identification Identifier::run() {
  found_.bits = choices_.bits() + properties_.bits();
  find_lengths();
  find_choices();
  if (found_.contradiction.empty()) {
    find_properties();
    fix_properties();
    paths_found_ = true;
    judge_runs_again();
    if (found_.contradiction.empty()) find_choices();
  }
  found_.readings = findings();
  if (found_.contradiction.empty()) count_coordinates();
  return std::move(found_);
}

Identification identify_readings(oracle::Subject& subject, const ProbePool& pool,
                                 const oracle::Grants& grants) {
  return Identifier(subject, pool, grants).run();
}

}  // namespace gonogo::identify
