// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traces of cycles and threads as one line of text, and the readings that known machines follow.
#pragma once

#include "ngc_expanding.hpp"

namespace gonogo::reference::testing::ngc {

// One thing that a program does: R a traverse, F a feed, T a thread, D a dwell, M an M function, !
// an alarm, ? what is not covered; where the tool stands then, along X Y Z.
struct TraceStep {
  char kind = 0;
  std::array<Number, 3> at;
  Number value;      // of F the feed, of T the lead, of D the time, of M its number
  std::string text;  // of ! and ?
  friend bool operator==(const TraceStep&, const TraceStep&) = default;
};
std::vector<TraceStep> trace_steps(std::string_view program, const Profile& profile = ngc());

// Everything that a program does, each with its place where it ends:
//   R1,2,3 a traverse to X1 Y2 Z3 | F1,2,3 a feed | T1,2,3@2 a thread of lead 2
//   D0.5 a dwell | M3 an M function | !b4:missing-word,value-sign the alarm of block 4
//   ?b4:G87 what is not covered
// Left out is what moves nothing, and M2.
std::string trace(std::string_view program, const Profile& profile = ngc());

// What a machine follows, of examples/profiles: linuxcnc, nist, grblhal, camotics, freecad.
Profile column(std::string_view machine);

}  // namespace gonogo::reference::testing::ngc
