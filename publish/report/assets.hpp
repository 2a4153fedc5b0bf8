// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files of the report's page, compiled in.
#pragma once

#include <string_view>

namespace gonogo::oracle::report {

struct Asset {
  std::string_view text;
  std::string_view sha256;  // hexadecimal digits
};

extern const Asset kReportHtml;  // the skeleton, with {{marks}} for the rest
extern const Asset kReportCss;
extern const Asset kReportJs;
extern const Asset kSiteCss;  // after kReportCss, for a site of many results
extern const Asset kSiteJs;

}  // namespace gonogo::oracle::report
