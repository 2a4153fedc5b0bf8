// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "expanders/common/complaints.hpp"
#include "expanders/sinumerik/codes.hpp"
#include "expanders/sinumerik/tokenizer.hpp"

namespace gonogo::expanders::sinumerik {

/// An M word.
struct FunctionWord {
  Value value;
  Position position = 0;
};

/// A rule that the block breaks whatever the state of the machine.
struct Defect {
  Position position = kNowhere;
  char letter = 0;
  bool found() const { return position != kNowhere; }
  void note(Position place, char word) {
    if (found()) return;
    position = place;
    letter = word;
  }
};

/// One block, its words sorted by address. Reading one allocates nothing but room for M words and
/// warnings, which is kept.
class Block {
 public:
  enum class Reading {
    kWords,    // may be without any
    kSkipped,  // `/` with the block skip on
    kOutside,  // a construct that is not implemented: `outside()`
    kSyntax
  };

  /// How lines are read, faults included.
  struct Manner {
    bool skips = false;
    bool assigns_late = false;
    Tokenizer::Manner tokens;
  };

  /// Assignments to R parameters act at once.
  Reading read(std::string_view line, const Manner& manner, Parameters& parameters);

  bool has(Address address) const { return (words_ & bit(address)) != 0; }
  bool has_any(Addresses addresses) const { return (words_ & addresses) != 0; }
  const Value& value(Address address) const { return values_[index_of(address)]; }
  Position position(Address address) const {
    return has(address) ? positions_[index_of(address)] : kNowhere;
  }
  Addresses words() const { return words_; }
  const Code* code(Group group) const { return codes_[static_cast<std::size_t>(group)]; }
  /// In the order of the line.
  const std::vector<FunctionWord>& functions() const { return functions_; }
  /// Names that are passed over.
  const std::vector<std::string_view>& warnings() const { return warnings_; }
  /// RPL stands without its `=`.
  bool has_loose_rotation() const { return loose_rotation_; }
  /// Of everything but N and the label.
  std::size_t items() const { return items_; }

  /// The first thing that is not implemented; empty: none.
  std::string_view outside() const { return outside_; }
  const Defect& unknown() const { return unknown_; }
  const Defect& duplicate() const { return duplicate_; }
  /// A value that none can be, or an R parameter that there is not.
  const Defect& undefined() const { return undefined_; }

 private:
  struct Late {
    std::size_t index;
    Real value;
  };

  static std::size_t index_of(Address address) { return static_cast<std::size_t>(address); }
  void clear();
  Reading read_items(Tokenizer& tokens, const Manner& manner, Parameters& parameters);
  bool take(const Item& item, const Manner& manner, Parameters& parameters);
  bool take_letter(const Item& item);
  bool take_indexed(const Item& item);
  bool take_name(const Item& item);
  bool take_word(Address address, const Item& item);
  void take_code(const Value& value);
  void put_code(const Code& code, char letter);
  void note_outside(std::string_view what);

  Addresses words_ = 0;
  std::array<Value, kAddresses> values_;  // valid where words_ has the address
  std::array<Position, kAddresses> positions_{};
  std::array<const Code*, kGroups> codes_{};
  std::vector<FunctionWord> functions_;
  std::vector<std::string_view> warnings_;
  std::vector<Late> late_;
  std::size_t items_ = 0;
  Control control_ = Control::k840D;
  bool loose_rotation_ = false;
  std::array<char, 24> text_{};
  std::string_view outside_;
  Defect unknown_;
  Defect duplicate_;
  Defect undefined_;
};

}  // namespace gonogo::expanders::sinumerik
