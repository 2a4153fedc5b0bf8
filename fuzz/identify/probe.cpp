// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/probe.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gonogo::identify {

using reference::ReadingChoice;

namespace {

constexpr std::size_t kMostLeaves = 64;
constexpr std::size_t kMostProbeRecords = 2'000;

// Leaves of the tree, with the readings that are split. Under "any" a reading that is split counts
// as its first alternative until it is asked for.
class Enumeration {
 public:
  Enumeration(const Profile& profile, std::string_view program,
              const std::vector<ReadingKey>& split)
      : profile_(profile), program_(program), split_(split) {}

  std::optional<Outcomes> run();

 private:
  // The first reading to be split that the run under the leaf asks for and the leaf does not say.
  std::optional<ReadingKey> next_split(const PartialAssignment& leaf,
                                       const Profile& assigned) const;
  bool add_leaf(PartialAssignment leaf, const Profile& assigned);

  const Profile& profile_;
  std::string_view program_;
  const std::vector<ReadingKey>& split_;
  Outcomes outcomes_;
  std::map<std::string, std::size_t> numbers_;  // outcome text -> its number
};

std::optional<ReadingKey> Enumeration::next_split(const PartialAssignment& leaf,
                                                  const Profile& assigned) const {
  for (const ReadingKey key : oracle::touched_by(assigned, program_)) {
    if (std::ranges::find(split_, key) == split_.end()) continue;
    if (std::ranges::find(leaf, key, &PartialAssignment::value_type::first) == leaf.end()) {
      return key;
    }
  }
  return std::nullopt;
}

bool Enumeration::add_leaf(PartialAssignment leaf, const Profile& assigned) {
  const auto outcome = run_reference(assigned, program_, kMostProbeRecords);
  if (!outcome || outcome->not_covered) return false;
  std::string text = outcome->text();
  // None of the named paths: an outcome of its own, which no record of the reference changes.
  for (const auto& [key, value] : leaf) {
    const Reading& reading = reference::reading(key);
    if (reading.by_properties && value == value_of_none(reading)) {
      text += fmt::format("any {}", reading.name);
    }
  }
  const auto [number, is_new] = numbers_.emplace(std::move(text), numbers_.size());
  std::ranges::sort(leaf);
  outcomes_.leaves.push_back({std::move(leaf), number->second});
  return true;
}

std::optional<Outcomes> Enumeration::run() {
  std::vector<PartialAssignment> open = {{}};
  while (!open.empty()) {
    if (open.size() + outcomes_.leaves.size() > kMostLeaves) return std::nullopt;
    const PartialAssignment leaf = std::move(open.back());
    open.pop_back();
    Profile assigned = profile_;
    set_values(assigned, leaf);
    const auto key = next_split(leaf, assigned);
    if (!key) {
      if (!add_leaf(leaf, assigned)) return std::nullopt;
      continue;
    }
    const Reading& reading = reference::reading(*key);
    const std::size_t values = reading.alternatives.size() + (reading.by_properties ? 1 : 0);
    for (std::size_t i = 0; i < values; ++i) {
      open.push_back(leaf);
      open.back().emplace_back(*key, static_cast<ReadingValue>(i));
    }
  }
  std::set<ReadingKey> keys;
  for (const Outcomes::Leaf& leaf : outcomes_.leaves) {
    for (const auto& [key, value] : leaf.readings) keys.insert(key);
  }
  outcomes_.keys.assign(keys.begin(), keys.end());
  outcomes_.different = numbers_.size();
  return std::move(outcomes_);
}

}  // namespace

ReadingValue value_of_none(const Reading& reading) {
  return static_cast<ReadingValue>(reading.alternatives.size());
}

std::string_view text_of(const Reading& reading, ReadingValue value) {
  return value < reading.alternatives.size() ? reading.alternatives[value] : "any";
}

void set_values(Profile& profile, const PartialAssignment& assignment) {
  for (const auto& [key, value] : assignment) {
    profile.readings.set(key, text_of(reference::reading(key), value));
  }
}

std::string Outcomes::signature() const {
  std::string text;
  for (const Leaf& leaf : leaves) {
    for (const auto& [key, value] : leaf.readings) {
      text += fmt::format("{}={} ", reference::index(key), value);
    }
    text += fmt::format(":{};", leaf.outcome);
  }
  return text;
}

ReadingKinds reading_kinds(std::string_view dialect) {
  ReadingKinds kinds;
  for (const Reading& reading : reference::readings()) {
    if (!reading.belongs_to(dialect)) continue;
    auto& kind = reading.is_length       ? kinds.lengths
                 : reading.by_properties ? kinds.properties
                                         : kinds.choices;
    kind.push_back(reading.key);
  }
  return kinds;
}

std::optional<Probe> with_named_paths(const Probe& probe) {
  if (probe.by_property.different < 2) return std::nullopt;
  const ReadingKinds kinds = reading_kinds(probe.profile.dialect);
  Profile named = probe.profile;
  for (const ReadingKey key : kinds.properties) {
    named.readings.set(key, reference::reading(key).alternatives.front());
  }
  auto outcomes = Enumeration(named, probe.program, kinds.choices).run();
  if (!outcomes) return std::nullopt;
  const bool more = std::ranges::any_of(outcomes->keys, [&](ReadingKey key) {
    return outcomes->tells_apart(key) && !probe.by_reading.tells_apart(key);
  });
  if (!more) return std::nullopt;
  Probe with = probe;
  with.by_reading = std::move(*outcomes);
  with.by_property = {};
  with.named_paths = true;
  return with;
}

namespace {

// How many different outcomes the program has under the default, short, middling and endless
// lengths.
std::size_t outcomes_by_length(const Probe& probe, ReadingKey key) {
  Profile profile = probe.profile;
  std::set<std::string> texts;
  for (const std::string_view length : {"", "0.125", "1", "3", "1000"}) {
    if (!length.empty()) profile.readings.set(key, length);
    const auto outcome = run_reference(profile, probe.program, kMostProbeRecords);
    if (outcome) texts.insert(outcome->text());
  }
  return texts.size();
}

}  // namespace

std::optional<Probe> make_probe(std::string id, std::string program, Profile profile) {
  const ReadingKinds kinds = reading_kinds(profile.dialect);
  profile.readings = ReadingChoice();
  const std::vector<ReadingKey> touched = oracle::touched_by(profile, program);
  Probe probe{std::move(id), std::move(program), std::move(profile), {}, {}, {}, {}};
  if (touched.empty()) return std::nullopt;
  auto by_reading = Enumeration(probe.profile, probe.program, kinds.choices).run();
  if (!by_reading) return std::nullopt;
  probe.by_reading = std::move(*by_reading);
  for (const ReadingKey key : touched) {
    if (std::ranges::find(kinds.lengths, key) == kinds.lengths.end()) continue;
    const std::size_t outcomes = outcomes_by_length(probe, key);
    if (outcomes > 1) probe.lengths.insert(key);
    probe.by_length = std::max(probe.by_length, outcomes);
  }
  const bool has_property = std::ranges::any_of(touched, [&](ReadingKey key) {
    return std::ranges::find(kinds.properties, key) != kinds.properties.end();
  });
  if (has_property) {
    auto by_property = Enumeration(probe.profile, probe.program, kinds.properties).run();
    if (by_property) probe.by_property = std::move(*by_property);
  }
  if (probe.by_reading.different < 2 && probe.by_property.different < 2 && probe.lengths.empty()) {
    return std::nullopt;
  }
  return probe;
}

namespace {

bool has_value(const Outcomes::Leaf& leaf, ReadingKey key, ReadingValue value) {
  return std::ranges::find(leaf.readings, std::pair(key, value)) != leaf.readings.end();
}

// The one reading in which the leaves differ; nothing: none, or more than one.
std::optional<ReadingKey> only_difference(const Outcomes::Leaf& a, const Outcomes::Leaf& b) {
  const auto differs = [&](const auto& entry) {
    const auto other =
        std::ranges::find(b.readings, entry.first, &PartialAssignment::value_type::first);
    return other != b.readings.end() && other->second != entry.second;
  };
  if (std::ranges::count_if(a.readings, differs) != 1) return std::nullopt;
  return std::ranges::find_if(a.readings, differs)->first;
}

}  // namespace

bool Outcomes::tells_apart(ReadingKey key) const {
  if (different < 2) return false;
  const Reading& reading = reference::reading(key);
  // Two named paths have to differ; a single one differs from all others that there may be.
  const bool named_only = reading.by_properties && reading.alternatives.size() > 1;
  for (const Leaf& a : leaves) {
    if (named_only && has_value(a, key, value_of_none(reading))) continue;
    for (const Leaf& b : leaves) {
      if (a.outcome == b.outcome || only_difference(a, b) != key) continue;
      if (!named_only || !has_value(b, key, value_of_none(reading))) return true;
    }
  }
  return false;
}

bool ProbePool::shows(ReadingKey key) const {
  return std::ranges::any_of(probes, [&](const Probe& probe) {
    const bool by_properties = reference::reading(key).by_properties;
    return (by_properties ? probe.by_property : probe.by_reading).tells_apart(key);
  });
}

}  // namespace gonogo::identify
