// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ends the subjects of a gauge that was killed: without a sandbox nothing else does.
#pragma once

#include <string>

namespace gonogo::oracle {

// Starts, once, a shell that waits until this program is gone and then ends every process whose
// environment has the mark. At an orderly end the shell goes first.
void start_family_keeper();

// The variable that subjects are given: "GONOGO_FAMILY=...", of this process alone.
const std::string& family_mark();

}  // namespace gonogo::oracle
