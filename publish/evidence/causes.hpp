// SPDX-License-Identifier: GPL-3.0-or-later
//
// causes.json beside results.jsonl: the likely causes of the findings of a run. It is no
// part of the results: no verdict depends on it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>

#include "oracle/records/finding.hpp"

namespace gonogo::oracle::evidence {

struct Causes {
  std::map<Finding::Key, Cause> of;
  std::size_t asked = 0;  // findings of which a cause was looked for
};

// The causes in the folder; none where the file is missing or of another format.
Causes read_causes(const std::filesystem::path& folder);
// Without causes the file is removed: it belongs to the run before. Throws std::system_error.
void write_causes(const std::filesystem::path& folder, const Causes& causes);

}  // namespace gonogo::oracle::evidence
