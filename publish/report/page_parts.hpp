// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the pages beside the report have in common: those of a site, and that of a hunt.
#pragma once

#include <string>
#include <string_view>

#include "publish/report/assets.hpp"

namespace gonogo::oracle::report {

// The file up to the brand at the head of its <body>. `title` is markup, `style` comes after the
// sheets of the report and the site; without `script` no script is allowed to run.
std::string page_head(std::string_view title, std::string_view style, const Asset* script);
// `title`: markup.
std::string section(std::string_view id, std::string_view title, const std::string& content);
// `head` and `rows`: cells and rows of the table; `tall`: it scrolls by itself.
std::string table(std::string_view id, const std::string& head, const std::string& rows,
                  bool tall = false);

}  // namespace gonogo::oracle::report
