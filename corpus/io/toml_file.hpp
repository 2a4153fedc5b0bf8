// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <string>

namespace gonogo::oracle {

// A TOML file by the bounds of reference::parse_toml. Throws CorpusError with the file and the
// line.
toml::table read_toml_file(const std::string& path);

}  // namespace gonogo::oracle
