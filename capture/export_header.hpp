// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lines that an export puts before a program, so that it can run on a machine that stands
// anywhere: the modes in force at power-on, then traverses to the case's initial position, Z
// first: up on a mill, along the part on a lathe. The tool must stand clear of the part before
// them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "reference/profile.hpp"

namespace gonogo::oracle {

struct ExportHeader {
  std::string text;  // whole lines
  std::uint64_t lines = 0;
  reference::AxisSet axes;  // that it leads to the start
};

// The first header of the dialect that leaves the program's meaning as it was: with it, from a
// machine that stands elsewhere, the reference expands the program to the same records and alarms
// under every reading that it leaves open, the line numbers apart. Nothing when there is none, as
// where the start is no decimal. `moved`: axes that the program moves.
std::optional<ExportHeader> export_header(const reference::Profile& profile,
                                          std::string_view program, reference::AxisSet moved);

}  // namespace gonogo::oracle
