// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of a dialect's table (descriptor.hpp): a code, and the words that it takes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "reference/clause.hpp"

namespace gonogo::reference {

// Modal groups by what they govern, of G codes and of M functions; the codes of `once` hold for
// their block.
enum class Group : std::uint8_t {
  once,
  motion,
  cycle,
  plane,
  units,
  diameter,
  distance,
  arc_distance,
  feed_mode,
  speed,
  compensation,
  tool_length,
  offset,
  frame,
  scaling,
  path_mode,
  exact_stop,
  exact_window,
  approach,
  corner,
  retract,
  stroke,
  macro,
  language,
  program,
  tool,
  spindle,
  coolant,
  override_switches,
  signals,
  saved_modes,
};
inline constexpr std::size_t kGroups = 31;

// How the gauge treats a code: `outside` are codes of the control that it does not read.
enum class Treatment : std::uint8_t { read, without_effect, outside };

// What a code that is read does.
enum class Kind : std::uint8_t {
  mode,             // says how later words are meant
  traverse,         // along a straight line
  line,             // a straight feed
  thread,           // straight, with a lead
  arc,              // about a centre in a plane
  circle,           // through points of its own: CIP, CT
  cycle,            //
  off,              // ends a cycle; axis words are positioned, or have no motion
  dwell,            //
  reference_point,  // the way there
  rename,           // the position gets other coordinates
  pole,             //
  frame,            //
  machine,          // an M function, before the motion of its block
  stop,             // an M function behind it
  program_end,      //
};

// What a mode puts in force, where tools have to know.
enum class Setting : std::uint8_t {
  none,
  plane_xy,
  plane_zx,
  plane_yz,
  inch,
  metric,
  diameter,
  radius,
  absolute,
  incremental,
  absolute_centre,
  incremental_centre,
  inverse_time,  // F is of its own block
};

// What the value of a word is.
enum class Role : std::uint8_t {
  place,         // a coordinate of the end point; under an incremental mode the way to it
  way,           // always the way to the end point along its axis
  centre,        // along its axis, from the start to the centre
  middle,        // a coordinate of a point between start and end
  along_p,       // a length with a sign along the first axis of the plane
  along_q,       // along the second
  along_d,       // along the depth axis, or a coordinate of it
  radius,        //
  size,          // another length without direction
  step,          // a length by which a cycle goes on again and again
  turns,         // how many times round
  count,         // how many
  angle,         // degrees
  polar_angle,   // degrees about the pole
  polar_radius,  // from the pole
  lead,          // of a thread, mm
  feed,          //
  speed,         // of the spindle
  time,          //
  number,        // of a tool, of a function; a choice
  parameter,     // the value of a variable
};

// How long a word holds.
enum class Life : std::uint8_t { block, modal };

// A word that a code takes.
struct CodeWord {
  // "X", "CR", "R101"; "R<n>" with any number; "X Y Z": all of them in one block.
  std::string_view address;
  Role role = Role::place;
  std::string_view title;  // a noun phrase
  Life life = Life::block;
  std::string_view feature = {};  // that a program needs for it; empty: that of the code
};

// How a program may use a code so that it needs a feature beside that of the code.
enum class Use : std::uint8_t {
  repeated,     // by axis words alone
  incremental,  // under the mode that makes places ways
  outside_xy,   // in another plane
};
struct UseFeature {
  Use use;
  std::string_view feature;
};

// Words that a code ignores by a rule, except those that it takes.
struct IgnoredWords {
  std::string_view when;   // "with R"; empty: always
  std::string_view words;  // "K R E"
  ClauseId clause;
  std::string_view why;  // a sentence
};

// Addresses of one letter, @ or ^, a bit each.
using Letters = std::uint32_t;
constexpr Letters letter_bit(char address) {
  return address >= '@' && address <= '^' ? Letters{1} << static_cast<unsigned>(address - '@') : 0;
}
// Those of words between blanks.
constexpr Letters letters_of(std::string_view words) {
  Letters letters = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool is_whole =
        (i == 0 || words[i - 1] == ' ') && (i + 1 == words.size() || words[i + 1] == ' ');
    if (is_whole) letters |= letter_bit(words[i]);
  }
  return letters;
}

// The words of a row: one list, or several one after the other.
class WordLists {
 public:
  using List = std::span<const CodeWord>;
  constexpr WordLists() = default;
  // REQUIRES: at most kMost.
  constexpr WordLists(std::initializer_list<List> lists) {
    for (const List& list : lists) lists_[static_cast<std::size_t>(count_++)] = list;
  }
  constexpr auto begin() const { return lists_.begin(); }
  constexpr auto end() const { return lists_.begin() + count_; }

 private:
  static constexpr std::size_t kMost = 4;
  std::array<List, kMost> lists_ = {List(), List(), List()};
  std::ptrdiff_t count_ = 0;
};
constexpr Letters letters_of(const WordLists& lists) {
  Letters letters = 0;
  for (const WordLists::List& list : lists) {
    for (const CodeWord& word : list) letters |= letters_of(word.address);
  }
  return letters;
}

// A row of the table.
struct Code {
  std::string_view name;  // "G1", "G90.1", "M30", "LCYC75"; "CYCLE<n>" with any number
  Group group = Group::once;
  Treatment treatment = Treatment::read;
  Kind kind = Kind::mode;
  std::string_view title = {};  // a noun phrase
  ClauseId clause = kNoClause;  // that says what it does; none: the clause of the list of codes
  std::string_view feature = "basic";
  WordLists words = {};
  std::span<const IgnoredWords> passed = {};
  std::span<const UseFeature> uses = {};
  Setting setting = Setting::none;
  int sense = 0;              // of rotation: -1 clockwise, +1 counterclockwise
  bool is_initial = false;    // the reference takes it for in force at power-on
  bool is_open_path = false;  // the manual leaves the path open
  bool passes_m = false;      // it passes on M functions that no block names
  int last = 0;               // tenths of the last code of a family that the row stands for

  // 10 times the number of a G code or an M function: G7.1 is 71, M30 is 300; -1: a name.
  int tenths = -1;
  Letters letters = 0;         // of the words
  Letters passed_letters = 0;  // of the words that are always ignored

  bool is_g() const { return tenths >= 0 && name.front() == 'G'; }
  bool is_m() const { return tenths >= 0 && name.front() == 'M'; }
  // Whether the code takes the word, of one letter.
  constexpr bool takes(char address) const { return (letters & letter_bit(address)) != 0; }
  constexpr bool ignores(char address) const {
    return (passed_letters & letter_bit(address)) != 0;
  }
  // The word as this code takes it; null: it does not.
  const CodeWord* find(std::string_view address) const;
  // As it is printed, with two digits: "G01"; a family: "G505 to G599".
  std::string text() const;

  constexpr Code passing(std::span<const IgnoredWords> rules) const {
    Code code = *this;
    code.passed = rules;
    for (const IgnoredWords& rule : rules) {
      if (rule.when.empty()) code.passed_letters |= letters_of(rule.words);
    }
    return code;
  }
  constexpr Code needing(std::string_view other_feature) const {
    Code code = *this;
    code.feature = other_feature;
    return code;
  }
  constexpr Code used(std::span<const UseFeature> features) const {
    Code code = *this;
    code.uses = features;
    return code;
  }
  // The same under another name; `rotation` is its sense.
  constexpr Code named(std::string_view other_name, std::string_view other_title,
                       int rotation = 0) const;
  constexpr Code initial() const {
    Code code = *this;
    code.is_initial = true;
    return code;
  }
  constexpr Code open() const {
    Code code = *this;
    code.is_open_path = true;
    return code;
  }
  // For a family the row that stands for it.
  constexpr Code to(std::string_view last_name) const;
  constexpr Code with(const WordLists& own) const {
    Code code = *this;
    code.words = own;
    code.letters = letters_of(own);
    return code;
  }
  constexpr Code passing_m() const {
    Code code = *this;
    code.passes_m = true;
    return code;
  }
  constexpr Code putting(Setting mode) const {
    Code code = *this;
    code.setting = mode;
    return code;
  }
};

// 10 times the number behind G or M; -1: the name is no such code.
constexpr int tenths_of_name(std::string_view name) {
  constexpr int most_tenths = 1'000'000;  // no control numbers its codes so high
  if (name.size() < 2 || (name[0] != 'G' && name[0] != 'M')) return -1;
  int value = 0;
  bool is_tenth = false;
  for (const char c : name.substr(1)) {
    if (c == '.' && !is_tenth) {
      is_tenth = true;
    } else if (c >= '0' && c <= '9' && value < most_tenths) {
      value = value * 10 + (c - '0');
    } else {
      return -1;
    }
  }
  return is_tenth ? value : value * 10;
}

constexpr Code Code::named(std::string_view other_name, std::string_view other_title,
                           int rotation) const {
  Code code = *this;
  code.name = other_name;
  code.title = other_title;
  code.sense = rotation;
  code.tenths = tenths_of_name(other_name);
  return code;
}
constexpr Code Code::to(std::string_view last_name) const {
  Code code = *this;
  code.last = tenths_of_name(last_name);
  return code;
}

// What codes of one kind have in common: named(), each is a row.
constexpr Code does(Kind kind, Group group, ClauseId clause, std::string_view feature,
                    const WordLists& words) {
  return {.name = {},
          .group = group,
          .kind = kind,
          .clause = clause,
          .feature = feature,
          .words = words,
          .letters = letters_of(words)};
}
// Other rows.
constexpr Code sets(std::string_view name, Group group, Setting setting, std::string_view title) {
  return {.name = name,
          .group = group,
          .title = title,
          .setting = setting,
          .tenths = tenths_of_name(name)};
}
constexpr Code no_effect(std::string_view name, Group group, std::string_view title) {
  return {.name = name,
          .group = group,
          .treatment = Treatment::without_effect,
          .title = title,
          .tenths = tenths_of_name(name)};
}
constexpr Code m_function(std::string_view name, Kind kind, Group group, std::string_view title,
                          const WordLists& words = {}) {
  return {.name = name,
          .group = group,
          .kind = kind,
          .title = title,
          .words = words,
          .tenths = tenths_of_name(name),
          .letters = letters_of(words)};
}
constexpr Code outside(std::string_view name, Group group, std::string_view title) {
  return {.name = name,
          .group = group,
          .treatment = Treatment::outside,
          .title = title,
          .tenths = tenths_of_name(name)};
}

// The same words, which stay in force.
template <std::size_t Size>
consteval auto kept(std::array<CodeWord, Size> words) {
  for (CodeWord& word : words) word.life = Life::modal;
  return words;
}

}  // namespace gonogo::reference
