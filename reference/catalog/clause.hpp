// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace gonogo::reference {

// How firmly a clause stands: the text says so; it follows from the text; the text leaves it open.
enum class ClauseLevel : std::uint8_t { must, derived, open };

// What an expectation stands on: a text says it; it follows from a text; no text says anything and
// it is our judgement.
enum class Basis : std::uint8_t { text, derived, silent };

// One thing that a manual says.
struct Clause {
  std::string_view id;  // "GSK-G94-02"
  ClauseLevel level = ClauseLevel::must;
  std::string_view source;   // document and section that it stands in
  std::string_view text;     // our wording
  std::string_view carrier;  // the file that carries it, below reference/ or grammar/
  // What a departure from it departs from, where that is not what the level says.
  std::optional<Basis> stated_basis = std::nullopt;
  std::string_view derivation = {};  // of what is derived: from what, in one line
  // What a control says that answers the question of an unstated clause the other way, as names of
  // alarm classes with blanks between them: where the rule lets a block run on, the alarms of a
  // control that does not; where the rule is an alarm, those that it may be instead. (That such a
  // control runs on goes without saying.)
  std::string_view refusals = {};
  std::string_view other_names = {};

  constexpr Basis basis() const {
    if (stated_basis) return *stated_basis;
    switch (level) {
      case ClauseLevel::must:
        return Basis::text;
      case ClauseLevel::derived:
        return Basis::derived;
      case ClauseLevel::open:
        return Basis::silent;
    }
    return Basis::silent;
  }
};

// The clause with what a control says that does not run on.
constexpr Clause refused_by_some(Clause clause, std::string_view refusals) {
  clause.refusals = refusals;
  return clause;
}

// The clause with the alarms that its own may be instead.
constexpr Clause named_otherwise(Clause clause, std::string_view other_names) {
  clause.other_names = other_names;
  return clause;
}

// Whether names with blanks between them have this one.
constexpr bool has_name(std::string_view names, std::string_view name) {
  while (!names.empty()) {
    const std::size_t end = names.find(' ');
    if (names.substr(0, end) == name) return true;
    if (end == std::string_view::npos) return false;
    names.remove_prefix(end + 1);
  }
  return false;
}
constexpr bool share_a_name(std::string_view some, std::string_view others) {
  while (!some.empty()) {
    const std::size_t end = some.find(' ');
    if (has_name(others, some.substr(0, end))) return true;
    if (end == std::string_view::npos) return false;
    some.remove_prefix(end + 1);
  }
  return false;
}

}  // namespace gonogo::reference
