// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace gonogo::oracle {

// Case ids by the first 128 bits of their SHA-256: 16 bytes a place, for ids of any length.
class IdSet {
 public:
  // False when the id is there already.
  bool insert(std::string_view id);
  bool contains(std::string_view id) const;
  // All of the other's, too.
  void absorb(const IdSet& other);
  std::size_t size() const { return size_; }

 private:
  using Key = std::array<std::uint64_t, 2>;
  static Key key_of(std::string_view id);
  // Where the key is, or the empty place where it goes.
  std::size_t place_of(const Key& key) const;
  void grow();
  bool insert(const Key& key);

  std::vector<Key> places_;  // a power of two of them; {0, 0}: empty
  std::size_t size_ = 0;
};

}  // namespace gonogo::oracle
