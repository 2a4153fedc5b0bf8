// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words of one block by their address: exact, in mm and degrees.
#pragma once

#include <array>
#include <optional>

#include "reference/words.hpp"

namespace gonogo::reference::sinumerik {

// The addresses that have a value. Axes first, in the order of Axis; then centres and intermediate
// points, in the order of X Y Z.
enum class Address : std::uint8_t {
  x,
  y,
  z,
  a,
  c,
  i,
  j,
  k,
  i1,
  j1,
  k1,
  cr,
  ar,
  ap,
  rp,
  turn,
  rpl,
  f,
  s,
  d,
  g,
  h,
  m,
  r,
  t,
};
inline constexpr std::size_t kAddresses = 25;
constexpr std::size_t index(Address address) {
  return static_cast<std::size_t>(address);
}
constexpr Address address_of(Axis axis) {
  return static_cast<Address>(axis);
}
// I, J or K. REQUIRES: is_linear(axis).
constexpr Address centre_address(Axis axis) {
  return static_cast<Address>(index(Address::i) + reference::index(axis));
}
// I1, J1 or K1. REQUIRES: is_linear(axis).
constexpr Address intermediate_address(Axis axis) {
  return static_cast<Address>(index(Address::i1) + reference::index(axis));
}
WordName name_of(Address address);
// The address of a word; nothing when its name is none, or it has not the form of a word.
std::optional<Address> address_of(const grammar::NamedWord& word);

// How words are meant: G70, G91; and X by a setting of the machine, DIAMON.
struct WordModes {
  bool inch = false;
  bool incremental = false;
  bool diameter = false;
};

// The last word of an address that stands several times.
class BlockWords final : public WordPlaces {
 public:
  // `modes` may change while the block is read.
  BlockWords(const grammar::Block& block, const WordModes& modes) : block_(block), modes_(modes) {}
  void take(Address address, const grammar::NamedWord& word, Number value) {
    words_[index(address)] = {&word, std::move(value)};
  }

  bool has(Address address) const { return words_[index(address)].word != nullptr; }
  const grammar::NamedWord* word(Address address) const { return words_[index(address)].word; }
  // The value as written. REQUIRES: has(address).
  const Number& written(Address address) const { return words_[index(address)].value; }
  // As a length in mm. REQUIRES: has(address).
  Number length(Address address) const;
  // The axis word in mm or degrees; absolute or incremental. REQUIRES: has(address_of(axis)).
  AxisWord axis_word(Axis axis) const { return point_word(address_of(axis), axis); }
  // The same of I1, J1, K1.
  AxisWord intermediate_word(Axis axis) const {
    return point_word(intermediate_address(axis), axis);
  }
  // For I, J, K: incremental unless it is AC().
  AxisWord centre_word(Axis axis) const;
  grammar::Dimension dimension(Address address) const {
    return words_[index(address)].word->dimension;
  }
  bool has_centre() const { return has(Address::i) || has(Address::j) || has(Address::k); }
  bool has_intermediate() const { return has(Address::i1) || has(Address::j1) || has(Address::k1); }
  bool is_polar() const { return has(Address::ap) || has(Address::rp); }
  const grammar::Block& block() const { return block_; }

  std::optional<grammar::Span> place_of(const WordName& name) const override;
  grammar::Span behind() const override;

 private:
  struct Value {
    const grammar::NamedWord* word = nullptr;
    Number value;
  };
  AxisWord point_word(Address address, Axis axis) const;

  const grammar::Block& block_;
  const WordModes& modes_;
  std::array<Value, kAddresses> words_{};
};

}  // namespace gonogo::reference::sinumerik
