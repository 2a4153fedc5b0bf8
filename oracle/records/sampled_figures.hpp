// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is reported of a case that was judged from sampled positions. Lengths are decimals in mm.
#pragma once

#include <string>
#include <vector>

namespace gonogo::oracle {

struct SampledFigures {
  std::size_t samples = 0;
  std::string tolerance;  // that was in force, an axis
  std::string noise;      // estimated from the samples
  std::string following;  // ... how far from the path at constant speed
  std::string go_from;    // the least tolerance at which it would be GO, to 1e-4; empty: none up to
                          // 1 mm, or it is GO
  std::string worst;      // of a GO: how far off the path at most, to 1e-4 upward; empty: not GO
  std::string worst_at;   // the sample, JSON; empty: none was off
  std::uint64_t worst_block = 0;
  std::string longest;  // s, between two samples of the program
  std::string unseen;   // how far away and back the machine may have been between them, upward
  std::vector<std::string> drawn;  // the way of the machine as records, thinned; of a NO-GO
};

}  // namespace gonogo::oracle
