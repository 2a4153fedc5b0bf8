// SPDX-License-Identifier: GPL-3.0-or-later
//
// The drawing of one judged program: the reference's path, what was sent, and where they part.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "oracle/records/verdict.hpp"
#include "reference/profile.hpp"
#include "reference/record.hpp"

namespace gonogo::cli {

struct JudgedProgram {
  const reference::Profile& profile;
  std::string name;     // on the sheet
  std::string program;  // bytes
  const oracle::Verdict& verdict;
  std::vector<reference::Record> records;
};
// Writes an SVG file. Throws UsageError where no path can be drawn, and what write_file() throws.
void write_judged_sheet(const std::string& path, const JudgedProgram& judged);

}  // namespace gonogo::cli
