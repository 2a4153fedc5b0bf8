// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "expanders/common/fixed.hpp"

namespace gonogo::expanders::ngc {

/// How far a number that has to be whole may lie beside a whole one, in counts of the number as it
/// is written; nil is the standard machine. And the faults of it.
struct WholeRule {
  Fixed code = 0;      ///< G, whole in tenths
  Fixed function = 0;  ///< M
  Fixed turns = 0;     ///< P of an arc
  bool limit_refused = false;
  bool cut = false;
};

// NGC-COM-01: the whole number that is meant; of a G code, of tenths. Nothing when the number lies
// too far beside one or is too large.
std::optional<Fixed> whole_tenths(const Decimal& code, const WholeRule& rule);
std::optional<Fixed> whole_function(const Decimal& number, const WholeRule& rule);
std::optional<Fixed> whole_turns(const Decimal& number, const WholeRule& rule);

}  // namespace gonogo::expanders::ngc
