// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace gonogo::expanders::sinumerik {

/// The controls: 802S has the path commands of 840D, and frames and cycles on top.
enum class Control : std::uint8_t { k840D, k802S };

/// R parameters of a control, from R0.
inline constexpr std::size_t parameter_count(Control control) {
  return control == Control::k802S ? 300 : 1000;
}

/// Words that a block holds at most one of.
enum class Address : std::uint8_t {
  kX,
  kY,
  kZ,
  kA,
  kC,
  kI,
  kJ,
  kK,
  kI1,
  kJ1,
  kK1,
  kRadius,        // CR
  kOpeningAngle,  // AR
  kPolarAngle,    // AP
  kPolarRadius,   // RP
  kTurn,          // TURN
  kFeed,          // F
  kSpindle,       // S
  kTool,          // T
  kCuttingEdge,   // D
  kRotation       // RPL, of 802S
};
inline constexpr std::size_t kAddresses = static_cast<std::size_t>(Address::kRotation) + 1;

/// Its letter; 0: a name of several.
char letter_of(Address address);

/// A set of addresses.
using Addresses = std::uint32_t;
inline constexpr Addresses bit(Address address) {
  return 1u << static_cast<unsigned>(address);
}
template <typename... More>
constexpr Addresses addresses(More... address) {
  return (bit(address) | ...);
}

inline constexpr Address axis_address(std::size_t axis) {
  return static_cast<Address>(axis);
}
/// Of the axes X, Y, Z.
inline constexpr Address centre_address(std::size_t axis) {
  return static_cast<Address>(static_cast<std::size_t>(Address::kI) + axis);
}
inline constexpr Address intermediate_address(std::size_t axis) {
  return static_cast<Address>(static_cast<std::size_t>(Address::kI1) + axis);
}

/// What a word of one letter is.
enum class LetterKind : std::uint8_t {
  kAddress,
  kCode,
  kFunction,
  kPassedOver,
  kOutside,
  kUnknown
};
struct Letter {
  LetterKind kind;
  Address address;
};
/// `letter`: 'A' to 'Z'; N and R are no words and unknown here.
Letter find_letter(char letter);

/// What a name of two letters or more is.
enum class NameKind : std::uint8_t {
  kAddress,
  kThroughPoint,  // CIP
  kTangent,       // CT
  kControl,       // the rest of the line is not read
  kCycle,         // LCYC75, LCYC82
  kPassedOver,    // with a warning
  kOutside,
  kUnknown
};
struct Name {
  std::string_view text;  ///< lives as long as the process; empty for kUnknown
  NameKind kind = NameKind::kUnknown;
  Address address = Address::kX;
};
/// `name` in capitals.
Name find_name(std::string_view name, Control control);

}  // namespace gonogo::expanders::sinumerik
