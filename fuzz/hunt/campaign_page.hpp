// SPDX-License-Identifier: GPL-3.0-or-later
//
// A long hunt as one page that opens offline: its progress, what was judged, and its findings by
// cause, each with a reduced program and its two paths.
//   DIR/index.html
#pragma once

#include <string>

#include "fuzz/hunt/hunt_summary.hpp"

namespace gonogo::hunt {

// The page needs no script and no network; programs and traces are read below `folder`, and
// one that cannot be read is left out.
std::string campaign_page(const std::string& folder, const HuntSummary& summary);
// Whole or not at all. Throws std::system_error.
void write_campaign_page(const std::string& folder, const HuntSummary& summary);

}  // namespace gonogo::hunt
