// SPDX-License-Identifier: GPL-3.0-or-later
//
// Departures from what no text states (docs/judging.md, Alarms and advices).
#pragma once

#include "oracle/judge/terms.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::oracle {

// J-ALM-03: the departure as an advice, where no text states its clause and the certifier is not
// strict; else as it is. REQUIRES: it is what the other answer to the clause's question would be.
// Nothing else is an advice, wherever it stands.
Verdict advised(Verdict departure, const JudgeTerms& terms);

}  // namespace gonogo::oracle
