// SPDX-License-Identifier: GPL-3.0-or-later
//
// The verdict on one case, from its vector and a trace.
#pragma once

#include <string>
#include <vector>

#include "checker/match.hpp"

namespace gonogo::checker {

struct Derived {
  enum class Kind {
    go,
    no_go,
    gap,        // what is there agrees, and then the corpus does not cover the program
    undecided,  // `why` is the reason
  };
  Kind kind = Kind::undecided;
  std::string why;
  // One an expectation; undecided for those not admissible, not covered or doubtful.
  std::vector<Answer> answers;
};

// `header`: of the results. Throws Fault.
Derived derive(const Vector& vector, const Trace& trace, const Json& header);

}  // namespace gonogo::checker
