// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>

namespace gonogo::oracle {

// A file for reading, failed where there is none: what is no regular file, as a FIFO or a device,
// may never begin or never end.
inline std::ifstream open_regular(const std::filesystem::path& path) {
  std::ifstream file;
  std::error_code ignored;
  if (std::filesystem::is_regular_file(path, ignored)) {
    file.open(path, std::ios::binary);
  } else {
    file.setstate(std::ios::failbit);
  }
  return file;
}

}  // namespace gonogo::oracle
