// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readings of RS274/NGC: where its interpreters differ. In the order of ReadingKey.
#pragma once

#include <vector>

#include "reference/reading.hpp"

namespace gonogo::reference::catalog {

inline std::vector<Reading> rs274_readings() {
  return {
      {ReadingKey::ngc_arc_tolerance,
       "ngc.arc-tolerance",
       "rs274",
       {"nist", "linuxcnc"},
       "nist",
       false,
       false,
       "NGC-ARC-03"_clause,
       "how far an arc's end may miss its circle: as NIST's interpreter has it, or as LinuxCNC's"},
      {ReadingKey::ngc_full_circle_words,
       "ngc.full-circle-words",
       "rs274",
       {"free", "needed"},
       "free",
       false,
       false,
       "NGC-ARC-04"_clause,
       "an arc by its centre without an axis word of the plane: a full circle, or an alarm"},
      {ReadingKey::ngc_whole,
       "ngc.whole",
       "rs274",
       {"exact", "nist", "linuxcnc"},
       "exact",
       false,
       false,
       "NGC-COM-01"_clause,
       "how far an M function, ten times a G code, or P of an arc may be from a whole number and "
       "count as it: not at all; by 0.0001, as NIST's report says; or, as LinuxCNC has it, by "
       "0.0001 for M and 0.001 for the others"},
  };
}

}  // namespace gonogo::reference::catalog
