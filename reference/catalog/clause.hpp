// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace gonogo::reference {

// How firmly a clause stands: the text says so; it follows from the text; the text leaves it open.
enum class ClauseLevel : std::uint8_t { must, derived, open };

// One thing that a manual says.
struct Clause {
  std::string_view id;  // "GSK-G94-02"
  ClauseLevel level = ClauseLevel::must;
  std::string_view source;   // document and section that it stands in
  std::string_view text;     // our wording
  std::string_view carrier;  // the file that carries it, below reference/ or grammar/
};

}  // namespace gonogo::reference
