// SPDX-License-Identifier: GPL-3.0-or-later
//
// Departures from what no text states (docs/judging.md, Alarms and advices).
#pragma once

#include "oracle/motion/tolerances.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::oracle {

// J-ALM-03: makes the departure an advice where no text states its clause and the certifier is not
// strict; else leaves it. REQUIRES: it is the other answer to the clause's question. Nothing else
// is an advice.
Verdict advised(Verdict departure, const Tolerances& tolerances);

}  // namespace gonogo::oracle
