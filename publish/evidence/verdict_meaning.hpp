// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "oracle/records/verdict.hpp"

namespace gonogo::oracle::evidence {

// What a verdict means, a sentence for people who meet it for the first time.
std::string_view meaning_of(VerdictKind kind);

}  // namespace gonogo::oracle::evidence
