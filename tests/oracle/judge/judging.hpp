// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "oracle/judge/judge_session.hpp"

namespace gonogo::oracle {

// A trace in JSON lines, judged under the default profile with one reading changed ("k=v") or none.
// An alarm record closes it.
Verdict judge_trace(std::string_view program, std::string_view trace,
                    std::string_view reading = {});

}  // namespace gonogo::oracle
