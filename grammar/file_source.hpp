// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "grammar/line_source.hpp"

namespace gonogo::grammar {

// Bytes of a file from its beginning, wherever its descriptor stands, which is neither moved nor
// closed: a file can be read by several at once.
class FileSource : public ByteSource {
 public:
  explicit FileSource(int descriptor) : descriptor_(descriptor) {}
  std::size_t read(char* data, std::size_t capacity) override;

 private:
  int descriptor_;
  std::int64_t at_ = 0;
};

}  // namespace gonogo::grammar
