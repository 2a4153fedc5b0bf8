// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/line_source.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace gonogo::grammar {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 16;
// Most programs of a campaign fit into this.
constexpr std::size_t kFirstChunk = std::size_t{1} << 11;

bool ends_line(char byte) {
  return byte == '\n' || byte == '\r';
}

}  // namespace

std::size_t DescriptorSource::read(char* data, std::size_t capacity) {
  for (;;) {
    const ssize_t count = ::read(descriptor_, data, capacity);
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) {
      throw std::system_error(errno, std::generic_category(), "reading the program");
    }
  }
}

std::size_t MemorySource::read(char* data, std::size_t capacity) {
  const std::size_t count = std::min(capacity, rest_.size());
  if (count != 0) std::memcpy(data, rest_.data(), count);
  rest_.remove_prefix(count);
  return count;
}

LineSource::LineSource(ByteSource& bytes) : bytes_(bytes) {
  buffer_.resize(kFirstChunk);
}

bool LineSource::fill() {
  if (at_end_) return false;
  if (begin_ != 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ == buffer_.size()) buffer_.resize(std::min(2 * buffer_.size(), kMaximumLine + kChunk));
  const std::size_t count = bytes_.read(buffer_.data() + end_, buffer_.size() - end_);
  at_end_ = count == 0;
  end_ += count;
  if (end_ == buffer_.size() && end_ < kChunk) buffer_.resize(kChunk);
  return !at_end_;
}

// Drops what is left of a line that was too long, one chunk after the other.
void LineSource::drop_line() {
  for (;;) {
    while (begin_ != end_ && !ends_line(buffer_[begin_])) ++begin_;
    if (begin_ != end_) {
      skip_line_feed_ = buffer_[begin_++] == '\r';
      return;
    }
    if (!fill()) return;
  }
}

bool LineSource::next(Line& line) {
  if (dropping_) drop_line();
  if (begin_ == end_ && !fill()) return false;
  if (skip_line_feed_) {
    skip_line_feed_ = false;
    if (buffer_[begin_] == '\n' && ++begin_ == end_ && !fill()) return false;
  }

  std::size_t size = 0;
  for (;;) {
    while (begin_ + size != end_ && !ends_line(buffer_[begin_ + size])) ++size;
    if (begin_ + size != end_ || size > kMaximumLine || !fill()) break;
  }
  ++number_;
  line.number = number_;
  line.too_long = size > kMaximumLine;
  line.text = std::string_view(buffer_).substr(begin_, std::min(size, kMaximumLine));
  dropping_ = line.too_long;
  begin_ += size;
  if (begin_ != end_ && !dropping_) skip_line_feed_ = buffer_[begin_++] == '\r';
  return true;
}

}  // namespace gonogo::grammar
