// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/io/id_set.hpp"

#include <cstring>

#include "corpus/io/sha256.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::size_t kFirstPlaces = 1024;

}  // namespace

IdSet::Key IdSet::key_of(std::string_view id) {
  Sha256 hash;
  hash.update(id);
  const auto digest = hash.digest();
  Key key{};
  std::memcpy(key.data(), digest.data(), sizeof key);
  return key;
}

std::size_t IdSet::place_of(const Key& key) const {
  const std::size_t mask = places_.size() - 1;
  std::size_t place = key[0] & mask;
  while (places_[place] != Key{} && places_[place] != key) place = (place + 1) & mask;
  return place;
}

void IdSet::grow() {
  std::vector<Key> before(places_.empty() ? kFirstPlaces : 2 * places_.size());
  before.swap(places_);
  for (const Key& key : before) {
    if (key != Key{}) places_[place_of(key)] = key;
  }
}

bool IdSet::insert(std::string_view id) {
  return insert(key_of(id));
}

void IdSet::absorb(const IdSet& other) {
  for (const Key& key : other.places_) {
    if (key != Key{}) insert(key);
  }
}

bool IdSet::insert(const Key& key) {
  if (4 * (size_ + 1) > 3 * places_.size()) grow();
  Key& place = places_[place_of(key)];
  if (place == key) return false;
  place = key;
  ++size_;
  return true;
}

bool IdSet::contains(std::string_view id) const {
  if (size_ == 0) return false;
  const Key key = key_of(id);
  return places_[place_of(key)] == key;
}

}  // namespace gonogo::oracle
