// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "reference/expander.hpp"

namespace gonogo::reference::sinumerik {

// `profile` and `readings` must outlive the interpreter.
std::unique_ptr<BlockInterpreter> make_interpreter_840d(const Profile& profile,
                                                        const ReadingsInUse& readings,
                                                        OpenPaths open_paths);
std::unique_ptr<BlockInterpreter> make_interpreter_802s(const Profile& profile,
                                                        const ReadingsInUse& readings,
                                                        OpenPaths open_paths);

}  // namespace gonogo::reference::sinumerik
