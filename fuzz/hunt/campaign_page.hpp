// SPDX-License-Identifier: GPL-3.0-or-later
//
// A long hunt as one page that opens offline: its progress, what was judged, and its findings by
// cause, each with a reduced program, its drawing sheet and the command that shows it again.
//   DIR/index.html
#pragma once

#include <functional>
#include <string>

#include "fuzz/hunt/hunt_summary.hpp"

namespace gonogo::hunt {

struct PageFolder {
  std::string path;
  // The command that shows the finding of a folder again.
  std::function<std::string(const std::string&)> again;
};
// The page needs no script and no network; programs and sheets are read below the folder, and
// one that cannot be read is left out.
std::string campaign_page(const PageFolder& folder, const HuntSummary& summary);
// Whole or not at all. Throws std::system_error.
void write_campaign_page(const PageFolder& folder, const HuntSummary& summary);

}  // namespace gonogo::hunt
