// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the readers of records, of JSON and of the C interface, leave a record that is wrong.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "reference/record.hpp"

namespace gonogo::oracle {

// Thrown inside a reader only; each of its entry points turns it into a TraceFault.
struct RecordFault {
  std::string message;
};

template <class... Arguments>
[[noreturn]] void fail_record(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  throw RecordFault{fmt::format(text, std::forward<Arguments>(arguments)...)};
}

inline void require_axes(std::string_view key, reference::AxisSet named,
                         std::initializer_list<reference::Axis> needed) {
  for (const reference::Axis axis : needed) {
    if (!named.has(axis)) {
      fail_record("\"{}\" lacks the axis {}.", key, reference::letter(axis));
    }
  }
}

// The classes that an alarm's text stands for, between blanks. Whoever names many names none.
inline constexpr std::ptrdiff_t kMostClasses = 3;
inline void require_few_classes(std::string_view classes) {
  if (std::ranges::count(classes, ' ') >= kMostClasses) {
    fail_record("An alarm stands for {} classes at most.", kMostClasses);
  }
}

}  // namespace gonogo::oracle
