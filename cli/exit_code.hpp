// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gonogo::cli {

// What the exit code of the program means.
enum ExitCode : int {
  kGo = 0,         // or: done
  kNoGo = 1,       // a NO-GO; expand: the program alarms
  kWrongUse = 2,   // the command line, a file, a profile
  kUndecided = 3,  // incomplete, not covered, an oracle error, output that was not written in full
};

}  // namespace gonogo::cli
