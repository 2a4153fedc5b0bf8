// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "expanders/common/codes.hpp"

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

/// Its letter, in the order of Address; 0: a name of several.
inline constexpr char letter_of(Address address) {
  return "XYZACIJKIJK\0\0\0\0\0FSTD"[static_cast<std::size_t>(address)];
}

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
/// For the axes X, Y, Z.
inline constexpr Address centre_address(std::size_t axis) {
  return static_cast<Address>(static_cast<std::size_t>(Address::kI) + axis);
}
inline constexpr Address intermediate_address(std::size_t axis) {
  return static_cast<Address>(static_cast<std::size_t>(Address::kI1) + axis);
}

/// Codes of one group exclude each other.
enum class Group : GroupNumber {
  kMotion,  // G0 to G3, CIP, CT
  kOnce,    // G4, G110 to G112
  kPlane,
  kUnits,
  kDimension,  // G90, G91
  kFeedMode,
  kExactStop,  // G9
  kCutter,
  kSuppress,
  kFrame,
  kControl,
  kWindow,
  kCorner,
  kProgrammedFrame,  // G158, G258, G259
  kCycle             // LCYC75, LCYC82
};

// Codes that have names; no G code is as high.
inline constexpr Code kThroughPointCode{10'001, static_cast<GroupNumber>(Group::kMotion)};  // CIP
inline constexpr Code kTangentCode{10'002, static_cast<GroupNumber>(Group::kMotion)};       // CT
inline constexpr Code kPocketCode{10'075, static_cast<GroupNumber>(Group::kCycle)};    // LCYC75
inline constexpr Code kDrillingCode{10'082, static_cast<GroupNumber>(Group::kCycle)};  // LCYC82

/// Null: the control lacks it.
const Code* find_code(const Decimal& number, Control control);

/// What a letter or a name is.
enum class NameKind : std::uint8_t {
  kAddress,
  kGCode,
  kFunction,  // M
  kCode,      // CIP, CT, LCYC75, LCYC82
  kControl,   // the rest of the line is not read
  kIgnored,   // a name: with a warning
  kOutside,
  kUnknown
};
struct Name {
  NameKind kind = NameKind::kUnknown;
  Address address = Address::kX;
  const Code* code = nullptr;  ///< of kCode
};
/// `letter`: 'A' to 'Z'; N and R are no words and unknown here.
Name find_letter(char letter);
/// `name`, of two letters or more, in capitals.
Name find_name(std::string_view name, Control control);

}  // namespace gonogo::expanders::sinumerik
