// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of hole cycles that were derived by hand, and what two machines made of them.
#pragma once

#include <span>
#include <string_view>

namespace gonogo::reference::testing::ngc {

struct WorkedHoles {
  std::string_view name;
  std::string_view title;
  std::string_view program;
  std::string_view want;      // by the documents, as `trace` has it
  std::string_view linuxcnc;  // LinuxCNC 2.9 as measured
  std::string_view nist;      // NIST's interpreter, version 3, as measured
};
inline constexpr std::string_view kSame = "same";    // as the documents say
inline constexpr std::string_view kOther = "other";  // a defect, or a code that it lacks

std::span<const WorkedHoles> worked_holes();

}  // namespace gonogo::reference::testing::ngc
