// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a program has to do, for the offline comparer: the exact pieces of the path with which
// samples are compared, under every combination of the readings that the program leaves open, and
// how it ends.
#pragma once

#include <string>
#include <string_view>

#include "reference/profile.hpp"

namespace gonogo::oracle {

// JSON: {"tolerance":T,"start":{..},"ways":[{"pieces":[..],"end":{..}}]}; "ways" is empty where too
// many readings are open. Docs: docs/formats.md, expected paths.
std::string expected_paths(const reference::Profile& profile, std::string_view program);

// The comparer, a script.
extern const std::string_view kComparer;

}  // namespace gonogo::oracle
