// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "corpus/io/corpus.hpp"

namespace gonogo::oracle {

// Whether the reference still says what the case expects under every assignment it names; nothing
// when it does, else a sentence.
std::optional<std::string> recheck(const Case& test);

// The same of all cases of a vector file. Throws CorpusError for the first that differs; returns
// the number of cases.
std::size_t recheck_file(const std::string& path);

}  // namespace gonogo::oracle
