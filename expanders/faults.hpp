// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>

namespace gonogo::expanders {

/// A planted defect that can be selected by name. All texts live as long as the process.
struct FaultDescription {
  std::string_view name;         ///< as in `builtin:gsk+NAME`
  std::string_view what;         ///< what the expander does wrong
  std::string_view clause;       ///< the clause that it breaks
  std::string_view models;       ///< the mistake of real controllers that it stands for
  std::string_view report = {};  ///< address of a public report of such a one; empty: none
};

/// The place of a planted fault in its maker's table, from 1.
enum class Fault : std::uint16_t { kNone };

/// The fault of that name; the build fails where there is none. A maker's `"name"_fault`.
consteval Fault find_fault(std::span<const FaultDescription> table, std::string_view name) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].name == name) return static_cast<Fault>(i + 1);
  }
  throw std::invalid_argument("no planted fault has this name");
}

/// How often runs of this process have met a planted fault.
struct FaultCount {
  std::uint64_t reached = 0;               ///< its line ran
  std::optional<std::uint64_t> triggered;  ///< and answered wrongly; nothing: not given
};

}  // namespace gonogo::expanders
