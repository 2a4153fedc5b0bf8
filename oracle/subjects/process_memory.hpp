// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstddef>

namespace gonogo::oracle {

// Resident bytes of a process and its descendants; 0 when it is gone.
std::size_t resident_bytes(pid_t process);

}  // namespace gonogo::oracle
