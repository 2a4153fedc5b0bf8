// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gonogo::cli {

// What `gonogo` does with its arguments, and its exit code. No exception leaves it: each is a sentence on
// standard error.
int run(int argc, char** argv);

}  // namespace gonogo::cli
