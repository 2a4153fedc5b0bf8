// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether an area about the middle of the pocket lies within reach of the path: the one question
// behind the cover and the step rule.
#pragma once

#include <string>

#include "oracle/region/distance.hpp"
#include "oracle/region/target.hpp"

namespace gonogo::oracle::region {

struct Coverage {
  enum class Kind { covered, uncovered, undecided } kind = Kind::covered;
  PlanePoint witness;     // uncovered: checked exactly
  Number excess;          // uncovered: how much farther the witness lies than reach and margin
  bool by_filter = true;  // decided by certified subdivision alone
  std::string why;        // undecided
  GapReason reason = GapReason::none;
};

// exact_only leaves the filter out, so that the two ways can be compared.
enum class Method { filter_first, exact_only };

// `tolerance` says how finely spirals are cut: a part's radius changes by a fraction of it.
Coverage check_coverage(const Path& path, const Target& target, const Number& tolerance,
                        Method method);

}  // namespace gonogo::oracle::region
