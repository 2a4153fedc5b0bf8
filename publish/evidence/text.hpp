// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts of a results file, which are not to be trusted, for the formats that they are written in.
#pragma once

#include <string>
#include <string_view>

#include "oracle/records/run_scope.hpp"

namespace gonogo::oracle::evidence {

// For an XML attribute in double quotes: line ends and tabs survive the reader.
std::string xml_attribute(std::string_view text);
// For running text and table cells of Markdown: nothing in it is markup, line ends become blanks.
std::string markdown_text(std::string_view text);
// One line in the type of code; not for a table.
std::string markdown_code(std::string_view text);
// Lines of code in a fence that they cannot close.
std::string markdown_fence(std::string_view text);
// A case id as the name of a file without ending: itself where that is safe, else what can be kept
// of it and a part of its hash.
std::string file_stem(std::string_view id);
using oracle::grouped;

}  // namespace gonogo::oracle::evidence
