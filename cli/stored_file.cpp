// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/stored_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace gonogo::cli {
namespace {

// What never ends would fill the disk.
constexpr std::size_t kMostCopied = std::size_t{1} << 30;

}  // namespace

StoredFile::StoredFile(const std::string& path) : file_(path), descriptor_(file_.descriptor()) {
  if (file_.size() >= 0) return;
  copy_.reset(std::tmpfile());
  std::array<char, 1 << 16> chunk;
  bool stored = copy_ != nullptr;
  std::size_t copied = 0;
  while (std::size_t count = stored ? file_.bytes().read(chunk.data(), chunk.size()) : 0) {
    copied += count;
    if (copied > kMostCopied) {
      throw UsageError(fmt::format("{} does not end within {} bytes. Name a file instead.",
                                   file_.name(), kMostCopied));
    }
    stored = std::fwrite(chunk.data(), 1, count, copy_.get()) == count;
  }
  if (!stored || std::fflush(copy_.get()) != 0) {
    throw UsageError(fmt::format("{} cannot be kept in a temporary file: {}. Name a file instead.",
                                 file_.name(), std::strerror(errno)));
  }
  descriptor_ = ::fileno(copy_.get());
}

}  // namespace gonogo::cli
