// SPDX-License-Identifier: GPL-3.0-or-later
//
// The configuration that goes to a subject: {"dialect":...,"profile":{...}}.
#pragma once

#include <string>

#include "reference/profile.hpp"

namespace gonogo::oracle {

// The members without the braces, so that the pipe protocol can put its own key before them.
std::string configuration_members(const reference::Profile& profile);

}  // namespace gonogo::oracle
