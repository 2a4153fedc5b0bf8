// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the readers of records, of JSON and of the C interface, leave a record that is wrong.
#pragma once

#include <fmt/format.h>

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

}  // namespace gonogo::oracle
