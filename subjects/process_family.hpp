// SPDX-License-Identifier: GPL-3.0-or-later
//
// The processes of a subject: the first one, its descendants, and those that have left it. This
// program becomes the parent of orphans, so that none escapes or outlives it.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <functional>

#include "subjects/control_group.hpp"

namespace gonogo::oracle {

// Starts the first process of a subject, the leader of a session of its own, which `spawn` puts
// into the group, if there is one.
pid_t begin_family(const std::function<pid_t(const ControlGroup&)>& spawn, ControlGroup group);

// The memory that it and all its descendants hold now, and how many processes they are. What has
// left both its parent and the session counts for every subject: its owner is unknown.
struct FamilySize {
  std::size_t resident_bytes = 0;
  std::size_t processes = 0;
};
FamilySize size_of_family(pid_t first);

// Ends all of them, also those that left their group, and reaps those that are this program's
// children. Processes of unknown owner end with the last subject.
// Returns the first one's status, as waitpid.
int end_family(pid_t first);

}  // namespace gonogo::oracle
