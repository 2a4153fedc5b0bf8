// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/line_buffer.hpp"

#include <algorithm>
#include <cstring>

namespace gonogo::oracle {
namespace {

constexpr std::size_t kChunk = std::size_t{64} << 10;
constexpr std::size_t kPadding = 64;
constexpr std::size_t kKept = std::size_t{4} << 20;  // a larger buffer is given back

}  // namespace

std::span<char> LineBuffer::room() {
  if (begin_ == end_) {
    begin_ = searched_ = end_ = 0;
    if (bytes_.size() > kKept) bytes_ = std::vector<char>();
  }
  if (bytes_.size() < end_ + kChunk + kPadding && begin_ > 0) {
    std::memmove(bytes_.data(), bytes_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    searched_ -= begin_;
    begin_ = 0;
  }
  if (bytes_.size() < end_ + kChunk + kPadding) {
    bytes_.resize(std::max(2 * bytes_.size(), end_ + kChunk + kPadding));
  }
  return {bytes_.data() + end_, bytes_.size() - end_ - kPadding};
}

std::size_t LineBuffer::whole_lines() const {
  const auto from = bytes_.begin() + static_cast<std::ptrdiff_t>(searched_);
  const auto to = bytes_.begin() + static_cast<std::ptrdiff_t>(end_);
  return static_cast<std::size_t>(std::count(from, to, '\n'));
}

std::optional<std::string_view> LineBuffer::next() {
  if (searched_ == end_) return std::nullopt;
  const void* found = std::memchr(bytes_.data() + searched_, '\n', end_ - searched_);
  if (found == nullptr) {
    searched_ = end_;
    return std::nullopt;
  }
  const auto at = static_cast<std::size_t>(static_cast<const char*>(found) - bytes_.data());
  if (at - begin_ > longest_) {
    too_long_ = true;
    return std::nullopt;
  }
  const std::string_view line(bytes_.data() + begin_, at - begin_);
  begin_ = searched_ = at + 1;
  return line;
}

}  // namespace gonogo::oracle
