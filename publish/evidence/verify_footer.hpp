// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of verify that derives the footer: totals, decision and fresh programs.
#pragma once

#include "publish/evidence/results_facts.hpp"
#include "publish/evidence/verify_sums.hpp"

namespace gonogo::oracle::evidence {

void check_footer(const ResultsFacts& facts, Findings& findings);
// What no line shows without the subject.
void tell_fresh_programs(const ResultsFacts& facts, Findings& findings);

}  // namespace gonogo::oracle::evidence
