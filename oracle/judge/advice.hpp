// SPDX-License-Identifier: GPL-3.0-or-later
//
// Departures from what no text states (docs/judging.md, Alarms and advices).
#pragma once

#include "oracle/judge/terms.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::oracle {

// J-ALM-01, J-ALM-03: whether a departure is an advice on these terms: from a clause that no text
// states, in what the program means and not in how the subject runs.
bool is_advice(const Verdict& departure, const JudgeTerms& terms);
// The departure, as an advice where it is one.
Verdict advised(Verdict departure, const JudgeTerms& terms);

}  // namespace gonogo::oracle
