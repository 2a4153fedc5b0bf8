// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/steps/watched_reference.hpp"

#include <algorithm>

#include "oracle/steps/different_assignments.hpp"

namespace gonogo::oracle {

using reference::Expander;
using reference::Item;
using reference::OpenPaths;
using reference::Profile;
using reference::ReadingKey;

// A run under one other alternative than the run that it stands beside.
struct WatchedReference::Other {
  Other(const Profile& other, const ProgramText& program, Parted its, const Other* its_neighbour)
      : what(its),
        root(its_neighbour == nullptr ? its : its_neighbour->root),
        neighbour(its_neighbour),
        profile(with_reading(other, its.key, its.value)),
        input(program),
        expander(profile, input.lines, OpenPaths::judged) {}
  bool has(ReadingKey key) const {
    return what.key == key || (neighbour != nullptr && neighbour->has(key));
  }
  const Parted what;
  const Parted root;             // of the one beside the run itself that this comes of
  const Other* const neighbour;  // null: the run itself
  const Profile profile;
  ProgramInput input;
  Expander expander;
  std::size_t items = 0;
  std::vector<ReadingKey> known;  // as of the run itself
};

WatchedReference::WatchedReference(const Profile& profile, const ProgramText& program,
                                   const AssignmentSet* watched, Forking forking)
    : profile_(profile),
      program_(program),
      watched_(watched),
      forking_(forking),
      input_(program),
      expander_(profile, input_.lines, OpenPaths::judged) {}

WatchedReference::~WatchedReference() = default;

const Item* WatchedReference::next() {
  const Item* item = expander_.next();
  if (watched_ == nullptr) return item;
  watch_asked();
  ++items_;
  const std::size_t parted = parted_.size();
  // Some of them put new ones behind.
  for (std::size_t i = 0; i < others_.size(); ++i) {
    Other& other = *others_[i];
    if (is_parted(other)) continue;
    if (agrees(other, item)) {
      watch_asked_beside(other);
    } else {
      parted_.push_back(other.root);
    }
  }
  if (parted_.size() != parted) {
    std::erase_if(others_, [&](const auto& other) { return is_parted(*other); });
  }
  return item;
}

bool WatchedReference::is_parted(const Other& other) const {
  return std::ranges::find(parted_, other.root) != parted_.end();
}

void WatchedReference::take_turn(Turn turn) {
  if (watched_ == nullptr) return;
  for (const auto& other : others_) {
    turn.stands_at ? other->expander.stand_at(*turn.stands_at) : other->expander.go_past_end();
  }
  turns_.push_back(std::move(turn));
}

void WatchedReference::stand_at(const reference::Position& position) {
  expander_.stand_at(position);
  take_turn({items_, position});
}

void WatchedReference::go_past_end() {
  expander_.go_past_end();
  take_turn({items_, std::nullopt});
}

void WatchedReference::stop_watching() {
  watched_ = nullptr;
  others_.clear();
  turns_.clear();
  parted_.clear();
}

// The readings that it has asked for since.
void WatchedReference::watch_asked() {
  for (const ReadingKey key : watched_->openable()) {
    if (!expander_.readings().touched(key)) continue;
    if (std::ranges::find(known_, key) != known_.end()) continue;
    known_.push_back(key);
    const auto values = watched_->values(key);
    for (std::size_t i = 1; i < values.size(); ++i) {
      if (forking_ == Forking::when_asked) {
        parted_.push_back({key, values[i]});
        continue;
      }
      add_other(profile_, {key, values[i]}, nullptr, items_);
    }
  }
}

// What only one beside it asks for makes no difference where that one says the same for each
// answer.
void WatchedReference::watch_asked_beside(Other& other) {
  const reference::ReadingsInUse& asked = other.expander.readings();
  const reference::ReadingsInUse& before =
      other.neighbour == nullptr ? expander_.readings() : other.neighbour->expander.readings();
  for (const ReadingKey key : watched_->openable()) {
    if (!asked.touched(key) || before.touched(key) || other.has(key)) continue;
    if (std::ranges::find(other.known, key) != other.known.end()) continue;
    other.known.push_back(key);
    const auto values = watched_->values(key);
    for (std::size_t i = 1; i < values.size(); ++i) {
      add_other(other.profile, {key, values[i]}, &other, items_ - 1);
    }
  }
}

// At where the run was before its last item, which is behind so many. What was said so far hung on
// no reading that had been asked for.
void WatchedReference::add_other(const Profile& beside, Parted what, const Other* neighbour,
                                 std::size_t items) {
  Other& other = *others_.emplace_back(std::make_unique<Other>(beside, program_, what, neighbour));
  auto turn = turns_.begin();
  const auto take_turns = [&] {
    for (; turn != turns_.end() && turn->items == other.items; ++turn) {
      turn->stands_at ? other.expander.stand_at(*turn->stands_at) : other.expander.go_past_end();
    }
  };
  for (take_turns(); other.items < items; take_turns()) {
    other.expander.next();
    ++other.items;
  }
}

// Whether the other run's next item is the same. It is not where that cannot be decided: a judge of
// its own comes to the same place.
bool WatchedReference::agrees(Other& other, const Item* item) {
  try {
    const Item* its = other.expander.next();
    ++other.items;
    if (item == nullptr || its == nullptr) return item == its;
    return reference::says_the_same(*item, *its);
  } catch (const exact::Undecided&) {
    return false;
  }
}

}  // namespace gonogo::oracle
