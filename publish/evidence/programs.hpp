// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>

#include "publish/evidence/case_row.hpp"

namespace gonogo::oracle::evidence {

// The folder with the programs of the cases that are not GO, and beside each its verdict. A file of
// its own remembers which ones it wrote: it removes those of the run before, and leaves other files
// alone.
class ProgramFolder {
 public:
  // Throws std::system_error, as all others.
  explicit ProgramFolder(std::filesystem::path folder);
  void add(const CaseRow& facts);
  void finish();

 private:
  std::filesystem::path folder_;
  std::ofstream list_;
};

}  // namespace gonogo::oracle::evidence
