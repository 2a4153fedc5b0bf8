// SPDX-License-Identifier: GPL-3.0-or-later
//
// TOML that others wrote. The parser bounds how deep values nest, and not how many parts a key has;
// each of them is a table in a table, which the walk over the document pays for with its stack.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>

namespace gonogo::reference {

// Throws toml::parse_error.
toml::table parse_toml(std::string_view text, std::string_view path = {});

// What is wrong with the text and what to write, with its line and a caret:
// "line 1, column 11: This is no TOML. ...".
std::string toml_fault(std::string_view text, const toml::parse_error& error);

}  // namespace gonogo::reference
