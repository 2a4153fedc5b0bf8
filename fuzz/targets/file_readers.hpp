// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readers of files that others hand to the gauge, each as a function from a file to what it
// says.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gonogo::fuzz {

inline constexpr std::size_t kMostFileBytes = 8'192;

struct FileReader {
  std::string_view kind;
  // What was read, or the error that the reader declares. Throws what else the reader throws.
  std::string (*read)(std::string_view file);
};

// That of the letter, from 'a' on; any other byte chooses one of them, too.
const FileReader& file_reader(std::uint8_t choice);

}  // namespace gonogo::fuzz
