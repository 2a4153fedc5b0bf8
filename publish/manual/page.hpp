// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of a dialect: section by section of its manual the clauses, drawings of example programs
// under every reading, and the alarms. Markdown with SVG files beside it.
#pragma once

#include <string>
#include <vector>

#include "reference/dialect.hpp"

namespace gonogo::oracle::manual {

struct PageFile {
  std::string name;  // below the folder of the pages: "gsk988ta.md", "gsk988ta/g94.svg"
  std::string text;
};

// The page first, then its drawings in their order on it.
std::vector<PageFile> page_of(const reference::Dialect& dialect);

}  // namespace gonogo::oracle::manual
