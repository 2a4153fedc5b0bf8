// SPDX-License-Identifier: GPL-3.0-or-later
//
// report_page RESULTS DIRECTORY: writes the HTML report, for the test in the browser.
#include <cstdio>

#include "publish/report/html.hpp"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: report_page RESULTS DIRECTORY\n", stderr);
    return 2;
  }
  const auto error = gonogo::oracle::report::write_html_report(argv[1], argv[2]);
  if (error) std::fprintf(stderr, "%s\n", error->c_str());
  return error ? 1 : 0;
}
