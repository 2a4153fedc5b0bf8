// SPDX-License-Identifier: GPL-3.0-or-later
//
// The domain in which an expander in the style of production is held to the reference
// (docs/domain.md). It follows from the program and the reference alone.
#pragma once

#include <string_view>

#include "oracle/records/verdict.hpp"
#include "reference/profile.hpp"

namespace gonogo::oracle {

// Whether every number of the text, wherever it stands, has at most nine digits before the point
// and seven behind it, zeros at its ends not counted (D-DOM-01).
bool has_short_numbers(std::string_view text);

// The rule by which the program lies outside of the domain, "D-DOM-03"; empty: it lies inside. Of
// a program with more than `most_items` of the reference the first ones are looked at.
std::string_view outside_domain(const reference::Profile& profile, std::string_view program,
                                std::size_t most_items = 100'000);

// The same of a program on which a subject came to this: what the gauge cannot decide is outside,
// too (D-DOM-09).
std::string_view outside_domain(const reference::Profile& profile, std::string_view program,
                                const oracle::Verdict& verdict);

}  // namespace gonogo::oracle
