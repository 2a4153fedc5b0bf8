// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace gonogo::cli {

// Prints a report's page into a PDF file with an installed Chromium: GONOGO_CHROMIUM, or the first
// of chromium, chromium-browser, google-chrome that the path has. Throws UsageError where there is
// none, OutputError where it writes nothing.
void print_pdf(const std::string& page, const std::string& pdf);

}  // namespace gonogo::cli
