// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words of one block by their address letter, and the rules about them that every dialect has.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/ast.hpp"
#include "reference/axis.hpp"
#include "reference/outcome.hpp"

namespace gonogo::reference {

// The exact value of a number as written.
inline Number to_number(const grammar::Decimal& value) {
  return value.long_digits.empty()
             ? Number::decimal(value.negative, value.magnitude, value.scale)
             : Number::decimal(value.negative, std::string_view(value.long_digits), value.scale);
}
inline Number inches(const Number& count) {
  return count * Number::millionths(25'400'000);
}
// A word as it is quoted in messages.
std::string text_of(const grammar::Word& word);

// An axis word, mm as a true length or degrees.
struct AxisWord {
  bool incremental = false;
  Number value;
};

// The letters of an axis: X and U, Y and V, Z and W, C and H.
struct AxisAddresses {
  Axis axis;
  char absolute;
  char increment;
};

// Where the words of a block stand on its line: what alarms need of them.
class WordPlaces {
 public:
  virtual std::optional<grammar::Span> place_of(const WordName& name) const = 0;
  // Behind the last word, where a missing one would stand.
  virtual grammar::Span behind() const = 0;

 protected:
  ~WordPlaces() = default;
};

// The values of words that no decimal expresses, in the order of the block's words.
using WordValues = std::vector<std::optional<Number>>;

// The last word of an address that stands several times.
class WordTable : public WordPlaces {
 public:
  // `values` may be null; it must outlive the table.
  explicit WordTable(const grammar::Block& block, const WordValues* values = nullptr)
      : block_(block), values_(values) {
    for (const grammar::Word& word : block.words) {
      by_address_[index_of(word.address)] = &word;
    }
  }

  bool any() const { return !block_.words.empty(); }
  bool has(char address) const { return word(address) != nullptr; }
  bool has(const AxisAddresses& axis) const { return has(axis.absolute) || has(axis.increment); }
  const grammar::Word* word(char address) const { return by_address_[index_of(address)]; }
  // The number as written. REQUIRES: has(address).
  Number written(char address) const {
    const grammar::Word* const found = word(address);
    if (values_ != nullptr) {
      const auto place = static_cast<std::size_t>(found - block_.words.data());
      if (const std::optional<Number>& value = (*values_)[place]) return *value;
    }
    return to_number(found->value);
  }
  const grammar::Block& block() const { return block_; }
  std::optional<grammar::Span> place_of(const WordName& name) const override;
  grammar::Span behind() const override;

 protected:
  ~WordTable() = default;

 private:
  // An address is a letter, or @ or ^ of rs274.
  static constexpr std::size_t index_of(char address) {
    return static_cast<std::size_t>(address - '@');
  }

  const grammar::Block& block_;
  const WordValues* values_;
  std::array<const grammar::Word*, '^' - '@' + 1> by_address_{};
};

// Whether an address stands twice, except those that may.
bool repeats_address(const grammar::Block& block, std::string_view may_repeat);
// An alarm for each word whose address stands before it, except those that may stand twice.
void check_repeated_addresses(const WordTable& words, ClauseId clause, std::vector<Alarm>& alarms,
                              std::string_view may_repeat = "G");
// An alarm where both letters of an axis stand in the block, at the later one.
void check_axis_letters(const WordTable& words, std::span<const AxisAddresses> axes,
                        ClauseId clause, std::vector<Alarm>& alarms);
// A negative F.
void check_feed_sign(const WordTable& words, ClauseId clause, std::vector<Alarm>& alarms);

// In the order of their words.
void sort_by_place(std::vector<Alarm>& alarms);

}  // namespace gonogo::reference
