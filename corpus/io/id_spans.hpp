// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "corpus/io/id_set.hpp"

namespace gonogo::oracle {

// Whether an id stands in two files of a corpus, checked file by file. For a file whose ids lie before
// or behind those of every other one only the first and the last are kept: memory grows with the
// files, not the cases. The ids of files that interleave are kept, 16 bytes each.
class IdSpans {
 public:
  // `read` reads the ids of a file anew, by its number in the order of `add`.
  using Read = std::function<std::vector<std::string>(std::size_t file)>;
  explicit IdSpans(Read read) : read_(std::move(read)) {}

  // The ids of the next file, in order. The first one that stood in a file before; nothing: none
  // did.
  std::optional<std::string> add(std::span<const std::string> ids);
  // How many files have all their ids kept.
  std::size_t kept() const;

 private:
  // From the first id, its key, to the last: of one file, or of several that interleave.
  struct Span {
    std::string last;
    std::vector<std::size_t> files;
    std::optional<IdSet> ids;  // of several files
  };

  Read read_;
  std::map<std::string, Span, std::less<>> spans_;  // none touches another
  std::size_t files_ = 0;
};

}  // namespace gonogo::oracle
