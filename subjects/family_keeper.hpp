// SPDX-License-Identifier: GPL-3.0-or-later
//
// What ends the subjects of a gauge that was killed: nothing else is left to do so where there is
// no sandbox.
#pragma once

#include <string>

namespace gonogo::oracle {

// Starts, once, a shell that waits until this program is gone and then ends every process whose
// environment has the mark. At an orderly end the shell goes first.
void start_family_keeper();

// The variable that subjects are given: "GONOGO_FAMILY=...", of this process alone.
const std::string& family_mark();

}  // namespace gonogo::oracle
