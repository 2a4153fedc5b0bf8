// SPDX-License-Identifier: GPL-3.0-or-later
//
// Subroutines of rs274 in files of their own, as LinuxCNC finds them: o<name> call is answered by
// the file name.ngc beside the program (NGC-OWD-10).
#pragma once

#include <string>
#include <string_view>

namespace gonogo::cli {

// Larger programs are taken as they stand, bytes.
inline constexpr long long kMostWithCalls = 1LL << 24;

struct CalledFiles {
  std::string program;  // with the subroutines behind it; empty: it needs none, or none was found
  std::string notes;    // a line a file: where its lines stand
};

// What `program`, the text of the file `path`, calls and does not have itself.
CalledFiles with_called_files(const std::string& path, std::string_view program);
// The same, where it stands; the user is told which files.
void add_called_files(const std::string& path, std::string& program);

}  // namespace gonogo::cli
