// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a covering array is made over: parameters, the classes of their values, and the rules that
// keep classes apart.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace gonogo::cover {

// One class of a parameter. `value` is what a program is written with; several `alarms` are classes
// of which the reference must find exactly these.
struct Class {
  std::string name;
  std::string value;
  std::vector<std::string> alarms;  // empty: a valid class
  bool is_unsaid = false;           // the alarm stands on no text
  bool is_fault() const { return !alarms.empty(); }
};

struct Parameter {
  std::string name;
  std::vector<Class> classes;
};

// No row holds, of each parameter named, one of the classes named.
struct Rule {
  struct Member {
    std::size_t parameter;
    std::vector<bool> classes;
  };
  std::vector<Member> members;
};

struct Parameters {
  std::vector<Parameter> list;
  std::vector<Rule> rules;

  // Throws ModelError where there is none of that name.
  std::size_t find(std::string_view name) const;
  std::size_t find_class(std::size_t parameter, std::string_view name) const;
};

// A model that contradicts itself or the reference: a sentence.
class ModelError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Reads parameters from lines:
//   NAME: CLASS[=VALUE] ...             a valid class; its value is its name where none is given
//   NAME: !CLASS[=VALUE]@ALARM[+ALARM]  a class that must alarm, the one fault of its row
//   NAME: !?CLASS[=VALUE]@ALARM         the same by a rule that no text states: its rows are not
//   made,
//                                       for cases of such a rule are few and written by hand
//   no: NAME=CLASS[,CLASS] ...          a rule
// A value has & for a blank. Empty lines and those that begin with # are skipped. Throws
// ModelError.
Parameters parse_parameters(std::string_view text);

// The number of a class for each parameter; kOpen where none is chosen yet.
using Row = std::vector<std::uint8_t>;
inline constexpr std::uint8_t kOpen = 0xFF;

}  // namespace gonogo::cover
