// SPDX-License-Identifier: GPL-3.0-or-later
// The G codes of a maker, by groups.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "expanders/common/fixed.hpp"

namespace gonogo::expanders {

enum class Support : std::uint8_t {
  kFull,
  kNoEffect,  ///< accepted, changes no path
  kOutside    ///< the control has it, this expander does not
};

/// Number of a group of codes: a maker's enumeration. A block has at most one code of each.
using GroupNumber = std::uint8_t;
inline constexpr std::size_t kMostGroups = 16;

/// A code that the control has. `tenths` is ten times its number: 911 is G91.1.
struct Code {
  std::uint16_t tenths = 0;
  GroupNumber group = 0;
  Support support = Support::kFull;
};

/// The G or M code of this number, for a message: "G7.1".
inline std::string code_name(char letter, Fixed tenths) {
  const std::string name = letter + std::to_string(tenths / 10);
  return tenths % 10 == 0 ? name : name + '.' + std::to_string(tenths % 10);
}

/// Codes of one group: "54 55 59.3".
struct CodeRow {
  template <typename Group>
  consteval CodeRow(Group its_group, Support its_support, std::string_view its_codes)
      : group(static_cast<GroupNumber>(its_group)), support(its_support), codes(its_codes) {}
  GroupNumber group;
  Support support;
  std::string_view codes;
};

/// The codes of a maker.
class CodeTable {
 public:
  consteval explicit CodeTable(std::span<const CodeRow> rows) {
    for (const CodeRow& row : rows) {
      unsigned tenths = 0;
      bool behind_point = false;
      bool any = false;
      for (const char c : row.codes) {
        if (c == ' ') {
          add(row, behind_point ? tenths : tenths * 10);
          tenths = 0;
          behind_point = any = false;
        } else if (c == '.') {
          behind_point = true;
        } else {
          tenths = tenths * 10 + static_cast<unsigned>(c - '0');
          any = true;
        }
      }
      if (any) add(row, behind_point ? tenths : tenths * 10);
    }
  }

  /// Null: the control has no such code. `tenths` is ten times the value of the G word.
  constexpr const Code* find(Fixed tenths) const {
    if (tenths < 0 || tenths >= static_cast<Fixed>(places_.size())) return nullptr;
    const std::uint8_t place = places_[static_cast<std::size_t>(tenths)];
    return place == 0 ? nullptr : &codes_[place - 1u];
  }
  /// By the value of the G word; null also where that is finer than a tenth.
  const Code* find(const Decimal& number) const {
    constexpr Fixed kTenth = kOne / 10;
    const bool whole = !number.overflow && !number.finer && number.value % kTenth == 0;
    return whole ? find(number.value / kTenth) : nullptr;
  }

 private:
  consteval void add(const CodeRow& row, unsigned tenths) {
    if (places_[tenths] != 0) throw std::invalid_argument("a code stands twice");
    codes_[size_++] = {static_cast<std::uint16_t>(tenths), row.group, row.support};
    places_[tenths] = static_cast<std::uint8_t>(size_);
  }

  std::array<Code, 128> codes_{};
  std::array<std::uint8_t, 10'000> places_{};  // 1 + that in codes_; 0: none
  std::size_t size_ = 0;
};

}  // namespace gonogo::expanders
