// SPDX-License-Identifier: GPL-3.0-or-later
//
// The combinations of open readings under which the reference says different things of a program.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "oracle/steps/assignment_set.hpp"
#include "oracle/steps/program_input.hpp"

namespace gonogo::oracle {

// How many items of the reference are looked at.
inline constexpr std::size_t kAllItems = SIZE_MAX;

// The readings that a run of the reference under this profile asks for.
std::vector<reference::ReadingKey> touched_by(const reference::Profile& profile,
                                              const ProgramText& program,
                                              std::size_t most_items = kAllItems);

// The assignments under which the reference says different things of the program. Each stands for
// all that say the same; the first holds what `expand` shows. Nothing: there are more than
// kMaximumAssignments.
std::optional<std::vector<AssignmentSet>> different_assignments(const reference::Profile& profile,
                                                                const ProgramText& program,
                                                                std::size_t most_items = kAllItems);

// The same assignments one by one; readings that make no difference stay open.
struct Assignments {
  std::vector<reference::ReadingChoice> choices;  // at least one
  std::vector<reference::ReadingKey> open;        // that make a difference
  bool too_many = false;
};
Assignments assignments_of(const reference::Profile& profile, const ProgramText& program,
                           std::size_t most_items = kAllItems);

// The readings of the set that are lengths, open, and asked for.
std::vector<reference::ReadingKey> open_lengths(const AssignmentSet& set,
                                                const reference::ReadingsInUse& asked);

// Whether a reading of the set that is open was asked for.
bool asks_open(const AssignmentSet& set, const reference::ReadingsInUse& asked);

// Whether a control may do something else under a reading that the profile leaves open. `asked`:
// the readings that a run of the program under the profile asked for.
bool has_other_outcomes(const reference::Profile& profile, const ProgramText& program,
                        const reference::ReadingsInUse& asked);

// The profile with the readings under which a program is shown: its own, if the program ends
// without an alarm under them; else a combination of the open ones under which it does, if any.
reference::Profile profile_to_show(const reference::Profile& profile, const ProgramText& program);

reference::Profile with_readings(const reference::Profile& profile,
                                 reference::ReadingChoice choice);
reference::Profile with_reading(reference::Profile profile, reference::ReadingKey key,
                                std::string_view value);

// Appends the assignments of a set that say different things, first the one that a run of the set
// itself takes. False: there are too many.
bool add_different(const reference::Profile& profile, const ProgramText& program, AssignmentSet set,
                   std::vector<AssignmentSet>& different, std::size_t most_items = kAllItems);

}  // namespace gonogo::oracle
