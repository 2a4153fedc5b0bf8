// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/advice.hpp"

namespace gonogo::oracle {

// J-ALM-01
Verdict advised(Verdict departure, const Tolerances& tolerances) {
  if (tolerances.strict || !reference::is_silent(departure.clause)) return departure;
  departure.departure = departure.kind;
  departure.kind = VerdictKind::advice;
  return departure;
}

}  // namespace gonogo::oracle
