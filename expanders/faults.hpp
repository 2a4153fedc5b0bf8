// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace gonogo::expanders {

/// A planted defect that can be selected by name. All texts live as long as the process.
struct FaultDescription {
  std::string_view name;    ///< as in `builtin:gsk+NAME`
  std::string_view what;    ///< what the expander does wrong
  std::string_view clause;  ///< the clause that it breaks
  std::string_view models;  ///< the mistake of real controllers that it stands for
};

/// How often runs of this process have met a planted fault.
struct FaultCount {
  std::uint64_t reached = 0;               ///< its line ran
  std::optional<std::uint64_t> triggered;  ///< and answered wrongly; nothing: not told
};

}  // namespace gonogo::expanders
