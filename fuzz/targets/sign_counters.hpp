// SPDX-License-Identifier: GPL-3.0-or-later
//
// The signs of the reference's comparisons as counters of libFuzzer, beside those of the branches:
// an input on a limit is then new, though it takes the branch of one below it. The oracle of the
// differential targets is compiled without the engine's own counters.
#pragma once

#include "reference/predicate.hpp"

namespace gonogo::fuzz {

class SignCounters final : public reference::DecisionWatch {
 public:
  void note(const reference::Decision& decision) override;
};

}  // namespace gonogo::fuzz
