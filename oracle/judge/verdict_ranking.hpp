// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which of the verdicts under several combinations of readings counts, and what is said of it.
#pragma once

#include <span>
#include <string>

#include "oracle/judge/sampled_outcome.hpp"

namespace gonogo::oracle {

// Whether the verdict under one assignment counts before that under another: the best pass; else a
// gap, for under that assignment the subject may be right; else the departure that comes last. An
// alarm that is missing or late counts behind another departure that comes equally far.
bool outranks(const SampledVerdict& one, const SampledVerdict& other);

// Whether it runs on over an alarm that no text states: with an alarm in a later block, or without.
bool runs_on(const Verdict& said);
// R7: the best departure runs on over an alarm that no text states. The departure that counts in
// its place is that of the alternative under which the block runs. Null: there is none.
const SampledVerdict* shown_way_to_run_on(const SampledVerdict& best,
                                          std::span<const SampledVerdict> departures);

// Says under which readings the verdict departs, where `expand` shows others: "k=v, k=v".
void name_readings(const std::string& told_under, Verdict& verdict);

}  // namespace gonogo::oracle
