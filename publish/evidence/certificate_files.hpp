// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gonogo::oracle::evidence {

// Both throw ResultsError when the file cannot be read.
std::string file_text(const std::string& path);
std::string file_sha256(const std::string& path);
std::string sha256_of_text(std::string_view text);

// The reasons that a known-failures file gives, without repetition. Throws ResultsError when it is
// none.
std::vector<std::string> waiver_reasons(const std::string& path);

}  // namespace gonogo::oracle::evidence
