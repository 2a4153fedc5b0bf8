// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "reference/expander.hpp"

namespace gonogo::reference::rs274 {

// `profile` and `readings` must outlive the interpreter.
std::unique_ptr<BlockInterpreter> make_interpreter(const Profile& profile,
                                                   const ReadingsInUse& readings,
                                                   OpenPaths open_paths);

}  // namespace gonogo::reference::rs274
