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

}  // namespace gonogo::reference
