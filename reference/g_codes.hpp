// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of a maker's G codes, and the G words of a block read by it.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/ast.hpp"
#include "reference/outcome.hpp"

namespace gonogo::reference {

// What the gauge makes of a code: `outside` are those that the control has and it does not read.
enum class Treatment : std::uint8_t { read, without_effect, outside };

// `Group` is the dialect's enumeration of its groups.
template <typename Group>
struct GCode {
  int tenths;  // 10 times the code: G7.1 is 71, G94 is 940
  Group group;
  Treatment treatment;
  std::string_view title;
};

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
std::string code_name(int tenths);
// Where a code that the control lacks stands, as an alarm.
Alarm undefined_code(const grammar::Word& word, ClauseId clause);
Alarm second_of_group(int tenths, const grammar::Word& word, ClauseId clause);
NotCovered code_outside(int tenths, std::string_view title, const grammar::Word& word);

// The G words of one block. Undefined codes and two codes of one group become alarms; a code that
// is not read ends the program for the gauge.
struct GCodeReading {
  std::array<int, 16> by_group{};  // the code of each group; -1: none
  std::vector<Alarm> alarms;
  std::optional<NotCovered> not_covered;
  std::uint32_t seen = 0;  // the groups

  // Whether the group was not there before.
  template <typename Group>
  bool is_first_of(Group group) {
    const std::uint32_t bit = std::uint32_t{1} << static_cast<unsigned>(group);
    const bool first = (seen & bit) == 0;
    seen |= bit;
    return first;
  }
  template <typename Group>
  int of(Group group) const {
    return by_group[static_cast<std::size_t>(group)];
  }
  // Keeps its memory, so that a stream of blocks allocates nothing.
  void clear() {
    by_group.fill(-1);
    alarms.clear();
    not_covered.reset();
    seen = 0;
  }
};

// Codes in ascending order, and the clauses of the rules about them.
template <typename Group>
class GCodeTable {
 public:
  constexpr GCodeTable(std::span<const GCode<Group>> codes, ClauseId undefined, ClauseId repeated)
      : codes_(codes), undefined_(undefined), repeated_(repeated) {}

  // The code, or nothing when the control lacks it.
  const GCode<Group>* find(const grammar::Decimal& value) const {
    const std::optional<int> tenths = tenths_of(value);
    return tenths ? find_tenths(*tenths) : nullptr;
  }
  const GCode<Group>* find_tenths(int tenths) const {
    std::size_t low = 0;
    std::size_t high = codes_.size();
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (codes_[middle].tenths < tenths) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low < codes_.size() && codes_[low].tenths == tenths ? &codes_[low] : nullptr;
  }

  // Whether two codes of one group stand in the block.
  bool repeats_group(const grammar::Block& block) const {
    std::uint32_t seen = 0;
    for (const grammar::Word& word : block.words) {
      const GCode<Group>* code = word.address == 'G' ? find(word.value) : nullptr;
      if (code == nullptr) continue;
      if ((seen & bit_of(*code)) != 0) return true;
      seen |= bit_of(*code);
    }
    return false;
  }

  // `last_wins`: the later of two codes of a group holds, and is no alarm.
  void read(const grammar::Block& block, bool last_wins, GCodeReading& reading) const {
    reading.clear();
    for (const grammar::Word& word : block.words) {
      if (word.address == 'G') read_word(word, last_wins, reading);
    }
  }

  // The same for one G word, after those before it.
  void read_word(const grammar::Word& word, bool last_wins, GCodeReading& reading) const {
    take(word, find(word.value), last_wins, reading);
  }

  // The same for a G word that stands for this code; null: for none that the control has.
  void take(const grammar::Word& word, const GCode<Group>* code, bool last_wins,
            GCodeReading& reading) const {
    if (code == nullptr) {
      reading.alarms.push_back(undefined_code(word, undefined_));
      return;
    }
    if (!reading.is_first_of(code->group) && !last_wins) {
      reading.alarms.push_back(second_of_group(code->tenths, word, repeated_));
    }
    if (code->treatment == Treatment::outside && !reading.not_covered) {
      reading.not_covered = code_outside(code->tenths, code->title, word);
    }
    reading.by_group[static_cast<std::size_t>(code->group)] = code->tenths / 10;
  }

  // The codes that the gauge does not read. The names live as long as the program.
  std::vector<OutsideCode> outside() const {
    static std::deque<std::string> names;
    std::vector<OutsideCode> found;
    for (const GCode<Group>& code : codes_) {
      if (code.treatment != Treatment::outside) continue;
      names.push_back(code_name(code.tenths));
      found.push_back({names.back(), code.title});
    }
    return found;
  }

 private:
  static std::uint32_t bit_of(const GCode<Group>& code) {
    return std::uint32_t{1} << static_cast<unsigned>(code.group);
  }

  std::span<const GCode<Group>> codes_;
  ClauseId undefined_;
  ClauseId repeated_;
};

}  // namespace gonogo::reference
