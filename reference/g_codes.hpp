// SPDX-License-Identifier: GPL-3.0-or-later
//
// The G words of a block, read by a dialect's table.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "grammar/ast.hpp"
#include "reference/code.hpp"
#include "reference/outcome.hpp"

namespace gonogo::reference {

// The same where there are more than 18 digits, zeros at the end.
std::optional<int> tenths_of_long(const grammar::Decimal& value);

// 10 times the value, when that is a whole number below 10,000.
inline std::optional<int> tenths_of(const grammar::Decimal& value) {
  if (!value.long_digits.empty()) return tenths_of_long(value);
  if (value.negative && value.magnitude != 0) return std::nullopt;
  std::uint64_t scaled = value.magnitude;
  if (value.scale == 0) {
    if (scaled > 1000) return std::nullopt;
    return static_cast<int>(scaled * 10);
  }
  for (std::uint32_t place = 1; place < value.scale; ++place) {
    if (scaled % 10 != 0) return std::nullopt;
    scaled /= 10;
  }
  return scaled > 10'000 ? std::nullopt : std::optional<int>(static_cast<int>(scaled));
}
// Where a code that the control lacks stands, as an alarm.
Alarm undefined_code(const grammar::Word& word, ClauseId clause);
Alarm second_of_group(const Code& code, const grammar::Word& word, ClauseId clause);
NotCovered code_outside(const Code& code, const grammar::Word& word);

// The G words of one block. Undefined codes and two codes of one group become alarms; a code that
// is not read ends the program for the gauge.
struct GCodeReading {
  std::array<int, kGroups> by_group{};  // the code of each group; -1: none
  std::vector<Alarm> alarms;
  std::optional<NotCovered> not_covered;
  std::uint32_t seen = 0;  // the groups
  Letters letters = 0;     // of the words that its codes take, except those of the motion group

  // Whether the group was not there before.
  bool is_first_of(Group group) {
    const std::uint32_t bit = std::uint32_t{1} << static_cast<unsigned>(group);
    const bool first = (seen & bit) == 0;
    seen |= bit;
    return first;
  }
  int of(Group group) const { return by_group[static_cast<std::size_t>(group)]; }
  // Keeps its memory, so that a stream of blocks allocates nothing.
  void clear() {
    by_group.fill(-1);
    alarms.clear();
    not_covered.reset();
    seen = 0;
    letters = 0;
  }
};

// The G codes of a table, and the clauses of the rules about them.
class GCodeTable {
 public:
  // REQUIRES: the G codes stand first, by their numbers.
  constexpr GCodeTable(std::span<const Code> codes, ClauseId undefined, ClauseId repeated)
      : codes_(codes), undefined_(undefined), repeated_(repeated) {
    std::size_t count = 0;
    while (count < codes.size() && codes[count].name.front() == 'G' && codes[count].tenths >= 0) {
      ++count;
    }
    codes_ = codes.first(count);
  }

  // The code, or nothing when the control lacks it.
  const Code* find(const grammar::Decimal& value) const {
    const std::optional<int> tenths = tenths_of(value);
    return tenths ? find_tenths(*tenths) : nullptr;
  }
  const Code* find_tenths(int tenths) const {
    std::size_t low = 0;
    std::size_t high = codes_.size();
    // The last one that is not above it.
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (codes_[middle].tenths <= tenths) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    if (low == 0) return nullptr;
    const Code& code = codes_[low - 1];
    const bool is_of_family = tenths <= code.last && tenths % 10 == 0;
    return code.tenths == tenths || is_of_family ? &code : nullptr;
  }
  int last_tenths() const { return codes_.back().tenths; }

  // Whether two codes of one group stand in the block.
  bool repeats_group(const grammar::Block& block) const;
  // `last_wins`: the later of two codes of a group holds, and is no alarm.
  void read(const grammar::Block& block, bool last_wins, GCodeReading& reading) const;
  // The same for one G word, after those before it.
  void read_word(const grammar::Word& word, bool last_wins, GCodeReading& reading) const {
    take(word, find(word.value), last_wins, reading);
  }
  // The same for a G word that stands for this code; null: for none that the control has.
  void take(const grammar::Word& word, const Code* code, bool last_wins,
            GCodeReading& reading) const;

 private:
  static std::uint32_t bit_of(const Code& code) {
    return std::uint32_t{1} << static_cast<unsigned>(code.group);
  }

  std::span<const Code> codes_;
  ClauseId undefined_;
  ClauseId repeated_;
};

}  // namespace gonogo::reference
