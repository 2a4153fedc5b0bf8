// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "expanders/common/complaints.hpp"
#include "expanders/sinumerik/expression.hpp"
#include "expanders/sinumerik/names.hpp"

namespace gonogo::expanders::sinumerik {

class Machine;

/// A value and how it is to be taken.
struct Value {
  enum class Mode { kPlain, kAbsolute, kIncremental };  // as G90 or G91 say, AC( ), IC( )
  Decimal number;                                       ///< to the nearest count
  Real counts = 0;                                      ///< as it was computed
  Mode mode = Mode::kPlain;
};

/// An M word.
struct FunctionWord {
  Decimal number;
  Position position = 0;
};

/// A rule that the block breaks in any state of the machine.
struct Defect {
  Position position = kNowhere;
  char letter = 0;
  bool found() const { return position != kNowhere; }
  void note(Position place, char word) {
    if (!found()) *this = {place, word};
  }
};

/// One block, its words sorted by address. Reading one allocates nothing but room for M words,
/// which is kept.
class Block {
 public:
  enum class Reading {
    kWords,     // may be without any
    kTapeMark,  // `%`
    kSkipped,   // `/` with the block skip on
    kOutside,   // a construct that is not implemented: `outside()`
    kSyntax
  };

  /// Reckons the values with the parameters of the machine; assignments to them act at once.
  Reading read(std::string_view line, Machine& machine);

  bool has(Address address) const { return has_any(bit(address)); }
  bool has_any(Addresses addresses) const { return (words_ & addresses) != 0; }
  /// For a word that is there.
  const Value& value(Address address) const { return values_[index_of(address)]; }
  const Decimal& number(Address address) const { return value(address).number; }
  Position position(Address address) const {
    return has(address) ? positions_[index_of(address)] : kNowhere;
  }
  Addresses words() const { return words_; }
  const Code* code(Group group) const { return codes_[static_cast<std::size_t>(group)]; }
  /// In the order of the line.
  const std::vector<FunctionWord>& functions() const { return functions_; }
  /// For everything but N and the label.
  std::size_t items() const { return items_; }
  /// Whether the block consists of a code and of words of these addresses alone.
  bool has_only(Addresses addresses) const;

  /// The first thing that is not implemented; empty: none.
  std::string_view outside() const { return outside_; }
  const Defect& unknown() const { return unknown_; }
  const Defect& duplicate() const { return duplicate_; }
  /// A value that none can be, or an R parameter that there is not.
  const Defect& undefined() const { return undefined_; }

 private:
  friend class BlockReader;
  static std::size_t index_of(Address address) { return static_cast<std::size_t>(address); }

  Addresses words_ = 0;
  std::array<Value, kAddresses> values_;  // valid where words_ has the address
  std::array<Position, kAddresses> positions_{};
  std::array<const Code*, kMostGroups> codes_{};
  std::vector<FunctionWord> functions_;
  std::size_t items_ = 0;
  std::string outside_;
  Defect unknown_;
  Defect duplicate_;
  Defect undefined_;
};

}  // namespace gonogo::expanders::sinumerik
