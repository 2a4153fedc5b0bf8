// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace gonogo::oracle {

// The bytes of a file; throws CorpusError when it cannot be read.
std::string file_text(const std::string& path);

}  // namespace gonogo::oracle
