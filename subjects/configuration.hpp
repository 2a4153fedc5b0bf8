// SPDX-License-Identifier: GPL-3.0-or-later
//
// The machine that a subject is asked to be.
#pragma once

#include <optional>
#include <string>

#include "reference/profile.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::oracle {

struct Told {
  reference::Profile profile;    // without the readings that the subject does not know
  std::optional<RunEnd> silent;  // it takes no reading, and the certifier does not state it
};
Told told(const SubjectInfo& info, const reference::Profile& profile, const StatedMachine& stated);

// {"dialect":...,"profile":{...}}, the members without the braces, so that the pipe protocol can
// put its own key before them.
std::string configuration_members(const reference::Profile& profile);

}  // namespace gonogo::oracle
