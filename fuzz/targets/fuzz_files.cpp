// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files: what others hand to the gauge ends in a value or in the reader's own error, and says the
// same when it is read again. The first byte chooses the reader, the others are the file. Any other
// exception is not caught, and so a finding. Cost cap: 8 KiB, since a longer file only has more of
// the same lines.
#include <string>

#include "fuzz/targets/file_readers.hpp"
#include "fuzz/targets/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gonogo;
  if (size == 0 || size > fuzz::kMostFileBytes) return 0;
  const fuzz::FileReader& reader = fuzz::file_reader(data[0]);
  const std::string_view file = fuzz::text_of(data, size).substr(1);
  const std::string first = reader.read(file);
  const bool is_cut = fuzz::planted_fault() == "file-cut" && !file.empty();
  const std::string second = reader.read(is_cut ? file.substr(0, file.size() / 2) : file);
  if (first != second) {
    fuzz::fail("a second reading of " + std::string(reader.kind) + " says " + second +
                   ", the first " + first,
               file);
  }
  return 0;
}
