// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks of one code each, and what the reference says of them with one word more.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reference/dialect.hpp"

namespace gonogo::reference::testing {

// What the reference says of a program: its records as text, and how it ends.
struct Said {
  std::string records;
  std::optional<Alarm> alarm;
  std::optional<NotCovered> not_covered;

  std::string ending() const;
  friend bool operator==(const Said& a, const Said& b) {
    return a.records == b.records && a.ending() == b.ending();
  }
};
Said said_of(const std::string& program, const Profile& profile);

// A block of one code: its words, and what stands before and behind it.
struct Bench {
  std::string before;
  std::map<std::string, std::string> words;  // by address, with its sign of equality
  std::string behind;                        // uses what the block leaves in force

  std::string program(const Code& code) const;
};
Bench bench_of(const Dialect& dialect, const Code& code);
// On which no word of a cycle that the gauge reads is left open.
Profile bench_profile(const Dialect& dialect);

// The codes that do something to the words of their block.
std::vector<const Code*> codes_with_words(const Dialect& dialect);
// Words that a block of the dialect may have, and values for them.
std::vector<std::string> candidate_words(const Dialect& dialect);
inline constexpr const char* kValues[] = {"2", "0.5", "30"};

// What became of a word.
enum class Fate {
  used,     // the block does something else
  idle,     // nothing is different
  refused,  // it cannot stand beside the code
  wrong,    // another alarm, or a value that is not read
};
Fate fate_of(const Profile& profile, const Bench& bench, const Code& code,
             const std::string& address, const std::string& value);

}  // namespace gonogo::reference::testing
