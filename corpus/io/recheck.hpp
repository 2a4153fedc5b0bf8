// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "corpus/io/corpus.hpp"

namespace gonogo::oracle {

// Whether the reference still says what the case expects under every assignment it names; nothing
// when it does, else a sentence.
std::optional<std::string> recheck(const Case& test);

}  // namespace gonogo::oracle
