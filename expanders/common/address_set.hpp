// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace gonogo::expanders {

/// A set of addresses, from '@' to '^'.
class AddressSet {
 public:
  constexpr AddressSet() = default;
  explicit constexpr AddressSet(std::string_view addresses) {
    for (const char address : addresses) add(address);
  }
  constexpr void add(char address) { bits_ |= 1u << (address - kFirst); }
  constexpr bool has(char address) const { return (bits_ >> (address - kFirst) & 1u) != 0; }
  constexpr bool any_of(AddressSet other) const { return (bits_ & other.bits_) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  /// Calls `take` with each address, in the order of the alphabet.
  template <typename Take>
  void each(const Take& take) const {
    for (std::uint32_t bits = bits_; bits != 0; bits &= bits - 1) {
      take(static_cast<char>(kFirst + std::countr_zero(bits)));
    }
  }
  friend constexpr AddressSet operator&(AddressSet a, AddressSet b) {
    a.bits_ &= b.bits_;
    return a;
  }

 private:
  static constexpr char kFirst = '@';

  std::uint32_t bits_ = 0;
};

}  // namespace gonogo::expanders
