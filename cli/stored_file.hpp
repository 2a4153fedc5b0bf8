// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file that is read several times over, in no more memory than a piece of it takes.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "cli/program_file.hpp"

namespace gonogo::cli {

// A file named on the command line; "-" is standard input. What cannot be read twice, as a pipe, is
// copied into a temporary file first. Throws UsageError.
class StoredFile {
 public:
  explicit StoredFile(const std::string& path);

  // For grammar::FileSource.
  int descriptor() const { return descriptor_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  ProgramFile file_;
  int descriptor_ = -1;  // the file's or the copy's
  std::unique_ptr<std::FILE, Close> copy_;
};

}  // namespace gonogo::cli
