// SPDX-License-Identifier: GPL-3.0-or-later
//
// The values of parameters: numbered, and named.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/exact/number.hpp"

namespace gonogo::reference::rs274 {

using exact::Number;

inline constexpr std::int64_t kLastParameter = 5602;
inline constexpr std::int64_t kLastUserParameter = 5000;
inline constexpr std::int64_t kShowsMessages = 5599;
inline constexpr std::size_t kArguments = 30;  // #1 to #30 belong to a subroutine

// Whether a program sets the parameter, and the machine never does. NGC-PAR-04: one above the
// others says only whether messages are shown.
constexpr bool is_of_program(std::int64_t number) {
  return number <= kLastUserParameter || number == kShowsMessages;
}

// What was calculated. NGC-EXP-08: `is_rounded` where doubles do not have it exactly.
struct Value {
  Number number;
  bool is_rounded = false;
};

class Parameters {
 public:
  Parameters() : levels_(1) {}

  // NGC-PAR-01. REQUIRES: 1 <= number, which is_of_program.
  Value numbered(std::int64_t number) const;
  void set(std::int64_t number, Value value);
  // NGC-OWD-02: whether a call has left the parameter without a value, and nothing has set it
  // since.
  bool is_inherited(std::int64_t number) const;
  // NGC-PAR-03: nothing where it was never set, or in another subroutine alone.
  std::optional<Value> named(const std::string& name) const;
  void set(const std::string& name, Value value);

  // NGC-OWD-02: a subroutine has parameters of its own, the first of them its arguments.
  void enter(std::vector<Value> arguments);
  // NGC-OWD-13: a subprogram shares #1 to #30 with the lines that call it, and has its own names.
  void enter_sharing();
  // REQUIRES: one was entered and not left.
  void leave() { levels_.pop_back(); }

  // NGC-OWD-03: what the last subroutine returned.
  std::optional<Value> returned;

 private:
  struct Level {
    std::array<Value, kArguments> arguments;
    std::array<bool, kArguments> inherited = {};
    std::map<std::string, Value> named;
    std::size_t owner = 0;  // the level whose arguments it has
  };
  Level& owner() { return levels_[levels_.back().owner]; }
  const Level& owner() const { return levels_[levels_.back().owner]; }

  std::vector<Level> levels_;
  std::map<std::int64_t, Value> numbered_ = {{kShowsMessages, {1}}};
  std::map<std::string, Value> global_;
};

// NGC-PAR-04: whether the language gives the name a meaning of its own.
bool is_predefined(std::string_view name);

}  // namespace gonogo::reference::rs274
