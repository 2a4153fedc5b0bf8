// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the reference shows of a program, as the outcome of a subject that computes exactly.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "oracle/judge/judge_session.hpp"

namespace gonogo::oracle {

struct OwnOutcome {
  std::vector<Record> records;
  RunEnd end;  // ok, or the alarm that `expand` prints
};

using ReadingValues = std::initializer_list<std::pair<std::string_view, std::string_view>>;
// The default profile of a dialect with these readings; others that it leaves open are as `expand`
// shows them.
reference::Profile profile_of(std::string_view dialect, ReadingValues readings = {});

// Throws where the program holds what the gauge does not read.
OwnOutcome own_outcome(std::string_view program, const reference::Profile& profile);

// The tolerances of an exact subject with line numbers. A resolution (mm) is declared; empty: none.
Tolerances exact_terms(const reference::Profile& profile, std::string_view resolution = {});

Verdict judge_own(std::string_view program, const reference::Profile& profile,
                  std::string_view resolution = {});

}  // namespace gonogo::oracle
