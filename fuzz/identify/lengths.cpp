// SPDX-License-Identifier: GPL-3.0-or-later
//
// Readings that are lengths: any length may be followed, so the subject's own places say which ones
// to try. What explains every program that shows the reading is what the subject follows, if it is
// one length alone.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "fuzz/identify/identifier.hpp"

namespace gonogo::identify {

using oracle::Decision;
using reference::Axis;

namespace {

constexpr std::size_t kMostAsked = 6;     // programs for one length
constexpr std::size_t kMostLengths = 64;  // that one program gives
constexpr std::size_t kMostLooked = 40;   // that are looked at of a program

// Shorter texts first: a length that somebody chose has few digits.
struct ShorterFirst {
  bool operator()(const std::string& a, const std::string& b) const {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  }
};
using Lengths = std::set<std::string, ShorterFirst>;

// How far apart two places of one axis are.
void add_distance(const Record& a, const Record& b, Lengths& lengths) {
  for (const Axis axis : reference::kLinearAxes) {
    if (!a.axes.has(axis) || !b.axes.has(axis)) continue;
    const reference::Number distance = a.to[axis] - b.to[axis];
    if (distance.is_rational() && distance.sign() != 0) lengths.insert(abs(distance).text());
  }
}

// Longer than any of them: where it explains all, too, no program has room for the whole length.
std::string longer_than(const std::vector<std::string>& lengths) {
  reference::Number most = 0;
  for (const std::string& length : lengths) {
    most = max(most, reference::Number::parse(length).value());
  }
  return (most + 1'000).text();
}

}  // namespace

// The distances between what the subject gave for the program and what the default would give, and
// between the subject's own places.
std::vector<std::string> Identifier::lengths_shown(const Item& item, ReadingKey key) const {
  Lengths lengths;
  const std::vector<Record>& own = found_.runs[item.run.value()].outcome.records;
  const std::size_t count = std::min(own.size(), kMostLooked);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = i + 1; k < count; ++k) add_distance(own[i], own[k], lengths);
  }
  if (const auto other = run_reference(item.probe->profile, item.probe->program)) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < std::min(other->records.size(), kMostLooked); ++k) {
        if (own[i].block == other->records[k].block) {
          add_distance(own[i], other->records[k], lengths);
        }
      }
    }
  }
  std::erase_if(
      lengths, [&](const std::string& length) { return !admits(reference::reading(key), length); });
  std::vector<std::string> some(lengths.begin(), lengths.end());
  if (some.size() > kMostLengths) some.resize(kMostLengths);
  return some;
}

// Whether the length explains the run under any combination of the other readings.
bool Identifier::explains(const Item& item, ReadingKey key, const std::string& length) {
  const std::string before(base_.get(key));
  base_.set(key, length);
  const bool passes = !explaining(item, item.probe->by_reading).empty();
  base_.set(key, before);
  return passes;
}

// Programs that show the length and no other: those first that tell many lengths apart, of equal
// ones the shortest.
std::vector<Identifier::Item*> Identifier::showing(ReadingKey key) {
  std::vector<Item*> shows;
  for (Item& item : items_) {
    if (item.probe->lengths == std::set<ReadingKey>{key}) shows.push_back(&item);
  }
  std::ranges::sort(shows, {}, [](const Item* item) {
    return std::pair(-static_cast<int>(item->probe->by_length), item->probe->program.size());
  });
  return shows;
}

// Asks programs until one length alone explains all of them, or there are no more.
Identifier::LengthsLeft Identifier::narrow_length(ReadingKey key, std::vector<Item*>& asked) {
  // Where the reading is open, what `expand` shows.
  const auto& named = reference::reading(key).alternatives;
  std::vector<std::string> shown = {
      std::string(base_.is(key, "any") ? named.front() : base_.get(key))};
  LengthsLeft left;
  const auto explains_all = [&](const std::string& length) {
    return std::ranges::all_of(asked,
                               [&](const Item* item) { return explains(*item, key, length); });
  };
  for (Item* item : showing(key)) {
    unknown_lengths_.erase(key);
    const bool can = usable(*item);
    unknown_lengths_.insert(key);
    if (!can || asked.size() == kMostAsked || ask(*item) == nullptr) continue;
    asked.push_back(item);
    for (std::string& length : lengths_shown(*item, key)) {
      if (std::ranges::find(shown, length) == shown.end()) shown.push_back(std::move(length));
    }
    left = {};
    std::ranges::copy_if(shown, std::back_inserter(left.lengths), explains_all);
    left.any_longer = explains_all(longer_than(shown));
    if (left.is_one()) break;
  }
  return left;
}

void Identifier::find_lengths() {
  for (const ReadingKey key : kinds_.lengths) {
    unknown_lengths_.insert(key);
    std::vector<Item*> asked;
    const LengthsLeft& left = lengths_left_[key] = narrow_length(key, asked);
    if (!left.is_one()) continue;
    const std::string length = left.lengths.front();
    const std::string fallback(base_.get(key));
    base_.set(key, length);
    known_lengths_.insert(key);
    unknown_lengths_.erase(key);
    found_.runs[*asked.back()->run].learnt.push_back(
        fmt::format("{} is {} mm{}", reference::reading(key).name, length,
                    length == fallback ? "" : ", not " + fallback));
    for (Item* item : asked) {
      if (!strike(*item)) return;
    }
  }
}

}  // namespace gonogo::identify
