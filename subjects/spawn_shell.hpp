// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <string>

#include "subjects/control_group.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::oracle {

// Starts a shell command within its limits, in a session of its own and in the group, if there is
// one, with the descriptors as stdin, stdout and stderr. They must lie above these. Throws
// std::system_error.
pid_t spawn_shell(const std::string& command, const Limits& limits, const ControlGroup& group,
                  int in, int out, int err);

}  // namespace gonogo::oracle
