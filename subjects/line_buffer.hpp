// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines out of a stream of bytes, in place: a line is read where it was received.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace gonogo::oracle {

class LineBuffer {
 public:
  explicit LineBuffer(std::size_t longest_line) : longest_(longest_line) {}

  // Where the next bytes go. Ends the life of lines given out before.
  std::span<char> room();
  void commit(std::size_t bytes) { end_ += bytes; }

  // The next whole line without its end, with room behind it for a parser's padding.
  std::optional<std::string_view> next();
  // After `next` gave nothing: the line that is coming is longer than allowed.
  bool too_long() const { return too_long_ || (searched_ == end_ && end_ - begin_ > longest_); }
  // How many whole lines can be taken.
  std::size_t whole_lines() const;
  // What came after the last whole line that was taken.
  std::string_view rest() const { return {bytes_.data() + begin_, end_ - begin_}; }
  bool empty() const { return begin_ == end_; }
  void clear() { begin_ = searched_ = end_ = 0; }

 private:
  std::vector<char> bytes_;
  std::size_t longest_;
  std::size_t begin_ = 0;
  std::size_t searched_ = 0;  // no line end in [begin_, searched_)
  std::size_t end_ = 0;
  bool too_long_ = false;
};

}  // namespace gonogo::oracle
