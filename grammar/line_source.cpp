// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/line_source.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "grammar/file_source.hpp"

namespace gonogo::grammar {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 16;
// Most programs of a campaign fit into this.
constexpr std::size_t kFirstChunk = std::size_t{1} << 11;
// Bytes of a line that is too long; the source of more has no end.
constexpr std::size_t kMostDropped = std::size_t{1} << 28;

// The first byte of [first, last) that ends a line, or `last`. Looked for in short stretches, so
// that lines that end in CR do not make a search for LF run on.
const char* find_line_end(const char* first, const char* last) {
  constexpr std::ptrdiff_t kStretch = 256;
  while (first != last) {
    const char* const end = last - first > kStretch ? first + kStretch : last;
    const auto find = [first](char byte, const char* before) {
      return static_cast<const char*>(
          std::memchr(first, byte, static_cast<std::size_t>(before - first)));
    };
    const char* const feed = find('\n', end);
    const char* const carriage_return = find('\r', feed != nullptr ? feed : end);
    if (carriage_return != nullptr) return carriage_return;
    if (feed != nullptr) return feed;
    first = end;
  }
  return last;
}

// Calls `read` until no signal comes between.
template <typename Read>
std::size_t read_again(const Read& read) {
  for (;;) {
    const ssize_t count = read();
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) {
      throw std::system_error(errno, std::generic_category(), "reading the program");
    }
  }
}

}  // namespace

std::size_t DescriptorSource::read(char* data, std::size_t capacity) {
  return read_again([&] { return ::read(descriptor_, data, capacity); });
}

std::size_t FileSource::read(char* data, std::size_t capacity) {
  const std::size_t count = read_again([&] { return ::pread(descriptor_, data, capacity, at_); });
  at_ += static_cast<std::int64_t>(count);
  return count;
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

// The end of the line that goes on at `from`; of the bytes, where it is not among them.
std::size_t LineSource::find_end(std::size_t from) const {
  const char* const first = buffer_.data() + from;
  const char* const last = buffer_.data() + end_;
  const char* const found =
      cr_is_blank_ ? std::find(first, last, '\n') : find_line_end(first, last);
  return static_cast<std::size_t>(found - buffer_.data());
}

// Drops what is left of a line that was too long, one chunk after the other. The text ends with a
// line that does not.
void LineSource::drop_line() {
  for (std::size_t dropped = 0; dropped < kMostDropped;) {
    const std::size_t end = find_end(begin_);
    dropped += end - begin_;
    begin_ = end;
    if (begin_ != end_) {
      skip_line_feed_ = buffer_[begin_++] == '\r';
      return;
    }
    if (!fill()) return;
  }
  begin_ = end_;
  at_end_ = true;
}

// Whether the line, of so many bytes, ends in one. Looks at the byte behind it.
void LineSource::look_for_lone_cr(std::size_t size) {
  if (has_lone_cr_ || begin_ + size == end_ || buffer_[begin_ + size] != '\r') return;
  if (begin_ + size + 1 == end_ && !fill()) return;
  has_lone_cr_ = buffer_[begin_ + size + 1] != '\n';
}

// The line, of so many bytes, with blanks for CR: how many bytes it has without one at its end.
std::size_t LineSource::with_blanks(std::size_t size) {
  if (size != 0 && buffer_[begin_ + size - 1] == '\r') --size;
  const auto first = buffer_.begin() + static_cast<std::ptrdiff_t>(begin_);
  const auto last = first + static_cast<std::ptrdiff_t>(size);
  has_lone_cr_ = has_lone_cr_ || std::find(first, last, '\r') != last;
  std::replace(first, last, '\r', ' ');
  return size;
}

bool LineSource::next(Line& line) {
  if (dropping_) drop_line();
  if (begin_ == end_ && !fill()) return false;
  if (skip_line_feed_) {
    skip_line_feed_ = false;
    if (buffer_[begin_] == '\n') {
      ++begin_;
      if (begin_ == end_ && !fill()) return false;
    }
  }

  std::size_t size = 0;
  for (;;) {
    size = find_end(begin_ + size) - begin_;
    if (begin_ + size != end_ || size > kMaximumLine || !fill()) break;
  }
  ++number_;
  line.number = number_;
  line.too_long = size > kMaximumLine;
  if (!line.too_long && !cr_is_blank_) look_for_lone_cr(size);
  const std::size_t shown = cr_is_blank_ ? with_blanks(size) : size;
  line.text = std::string_view(buffer_).substr(begin_, std::min(shown, kMaximumLine));
  dropping_ = line.too_long;
  begin_ += size;
  if (begin_ != end_ && !dropping_) skip_line_feed_ = buffer_[begin_++] == '\r';
  return true;
}

std::string without_comments(Dialect dialect, std::string_view line) {
  std::string text(line);
  char end = 0;  // of what is left out
  for (char& c : text) {
    if (end == 0 && c == ';') end = '\n';
    if (end == 0 && c == '(' && dialect != Dialect::sinumerik) end = ')';
    if (end == 0 && c == '<' && dialect == Dialect::rs274) end = '>';
    const bool is_last = c == end;
    if (end != 0) c = ' ';
    if (is_last) end = 0;
  }
  return text;
}

}  // namespace gonogo::grammar
