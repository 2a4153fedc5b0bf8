// SPDX-License-Identifier: GPL-3.0-or-later
//
// The drawing of one judged program: the reference's path, what was sent, and where they part.
#pragma once

#include <string>
#include <vector>

#include "oracle/records/verdict.hpp"
#include "reference/profile.hpp"
#include "reference/record.hpp"

namespace gonogo::hunt {

struct JudgedProgram {
  const reference::Profile& profile;
  std::string name;     // on the sheet
  std::string program;  // bytes
  const oracle::Verdict& verdict;
  const std::vector<reference::Record>& records;
};

struct JudgedSheet {
  std::string svg;   // empty where no path can be drawn
  std::string note;  // why
};

JudgedSheet judged_sheet(const JudgedProgram& judged);

}  // namespace gonogo::hunt
