// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which column of a file of samples is what, and in which unit.
//
//   t=Time[ms],x=X_act:diameter,z=Z_act:in
//
// names columns as the machine's log does; what is not named is skipped. A unit stands behind a
// colon, or in brackets at the end of the column's own name: mm, in, deg, s, ms, us; `diameter` and
// `in-diameter` say that X is measured across.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/axis.hpp"

namespace gonogo::oracle {

enum class SampleField : std::uint8_t { time, x, y, z, a, c, feed, block, motion, alarm, other };

struct SampleColumn {
  SampleField field = SampleField::other;
  std::string name;  // as the file has it
  reference::Number scale = 1;
  int decimals = 0;  // that the scale adds to a time
};

// The field of that name: t or time, x y z a c, f, block or line, motion, alarm.
std::optional<SampleField> sample_field(std::string_view name);

// Applies a unit to the column; false when the field has no such unit.
bool set_unit(SampleColumn& column, std::string_view unit);

// The unit in brackets at the end of a column's name; empty: none.
std::string_view unit_in_brackets(std::string_view name);

using SampleColumns = std::vector<SampleColumn>;  // empty: the file names them as the gauge does

// Reads the text above; a sentence when it cannot be read.
std::optional<std::string> read_columns(const std::string& text, SampleColumns& columns);

}  // namespace gonogo::oracle
