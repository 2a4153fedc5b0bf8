// SPDX-License-Identifier: GPL-3.0-or-later
//
// Subroutines of rs274 in files of their own, as LinuxCNC finds them: o<name> call is answered by
// the file name.ngc beside the program (NGC-OWD-10).
#pragma once

#include <string>

namespace gonogo::cli {

// Larger programs are taken as they stand, bytes.
inline constexpr std::size_t kMostWithCalls = std::size_t{1} << 24;

// Puts what `program`, the text of the file `path`, calls and does not have itself behind it, and
// tells the user which files these are. Whether there were any; other dialects have none.
bool add_called_files(const std::string& dialect, const std::string& path, std::string& program);

}  // namespace gonogo::cli
