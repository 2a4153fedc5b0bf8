// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace gonogo::expanders {

/// A set of addresses.
class AddressSet {
 public:
  constexpr AddressSet() = default;
  explicit constexpr AddressSet(std::string_view addresses) {
    for (const char address : addresses) add(address);
  }
  constexpr void add(char address) { bits_ |= 1u << (address - 'A'); }
  constexpr bool has(char address) const { return (bits_ >> (address - 'A') & 1u) != 0; }
  constexpr bool any_of(AddressSet other) const { return (bits_ & other.bits_) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr std::uint32_t bits() const { return bits_; }

 private:
  std::uint32_t bits_ = 0;
};

}  // namespace gonogo::expanders
