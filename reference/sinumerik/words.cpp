// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/sinumerik/words.hpp"

#include <algorithm>
#include <string_view>

namespace gonogo::reference::sinumerik {
namespace {

using grammar::Dimension;

constexpr std::array<std::string_view, kAddresses> kAddressNames = {
    "X",  "Y",  "Z",    "A",   "C", "I", "J", "K", "I1", "J1", "K1", "CR", "AR",
    "AP", "RP", "TURN", "RPL", "F", "S", "D", "G", "H",  "M",  "R",  "T"};

// The letters from I to K with a 1: I1, J1, K1.
std::optional<Address> numbered(const grammar::NamedWord& word) {
  const char letter = word.name[0];
  if (letter == 'R') return Address::r;
  if (letter == 'H') return Address::h;
  if (letter < 'I' || letter > 'K' || *word.index != 1) return std::nullopt;
  return static_cast<Address>(index(Address::i1) + static_cast<std::size_t>(letter - 'I'));
}

// By letter; R alone is none.
constexpr std::array<std::optional<Address>, 26> kOfLetter = [] {
  std::array<std::optional<Address>, 26> addresses;
  for (std::size_t i = 0; i < kAddresses; ++i) {
    const std::string_view name = kAddressNames[i];
    if (name.size() == 1 && name != "R") {
      addresses[static_cast<std::size_t>(name[0] - 'A')] = static_cast<Address>(i);
    }
  }
  return addresses;
}();

}  // namespace

WordName name_of(Address address) {
  return WordName(kAddressNames[index(address)]);
}

std::optional<Address> address_of(const grammar::NamedWord& word) {
  if (word.is_call || word.terms == 0) return std::nullopt;
  if (word.index) return word.name.size() == 1 ? numbered(word) : std::nullopt;
  if (word.name.size() == 1) {
    const char letter = word.name[0];
    if (letter < 'A' || letter > 'Z') return std::nullopt;
    return kOfLetter[static_cast<std::size_t>(letter - 'A')];
  }
  const auto place = std::ranges::find(kAddressNames, word.name);
  if (place == kAddressNames.end()) return std::nullopt;
  return static_cast<Address>(place - kAddressNames.begin());
}

// SIE-MOD-04
Number BlockWords::length(Address address) const {
  return modes_.inch ? inches(written(address)) : written(address);
}

// SIE-ADDR-01, SIE-G1-03: AC and IC go before G90 and G91; degrees have no units.
AxisWord BlockWords::point_word(Address address, Axis axis) const {
  const Dimension how = dimension(address);
  const bool incremental =
      how == Dimension::as_in_force ? modes_.incremental : how == Dimension::incremental;
  if (!is_linear(axis)) return {incremental, written(address)};
  const bool is_diameter = address == Address::x && modes_.diameter;
  return {incremental, is_diameter ? length(address) / 2 : length(address)};
}

AxisWord BlockWords::centre_word(Axis axis) const {
  const Address address = centre_address(axis);
  return {dimension(address) != Dimension::absolute, length(address)};
}

std::optional<grammar::Span> BlockWords::place_of(const WordName& name) const {
  for (std::size_t i = 0; i < kAddresses; ++i) {
    if (words_[i].word != nullptr && name.text() == kAddressNames[i]) return words_[i].word->where;
  }
  return std::nullopt;
}

grammar::Span BlockWords::behind() const {
  if (block_.named.empty()) return {};
  const std::uint32_t end = block_.named.back().where.end;
  return {end, end};
}

}  // namespace gonogo::reference::sinumerik
