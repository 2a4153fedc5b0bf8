// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs as a stream of lines. Memory is one chunk and one line of at most kMaximumLine bytes,
// for a program of any length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "grammar/ast.hpp"

namespace gonogo::grammar {

inline constexpr std::size_t kMaximumLine = std::size_t{1} << 20;

// Where bytes come from.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  // Fills up to `capacity` bytes; 0 at the end. Throws std::system_error when reading fails.
  virtual std::size_t read(char* data, std::size_t capacity) = 0;
};

// Bytes of an open file descriptor, which is not closed here.
class DescriptorSource : public ByteSource {
 public:
  explicit DescriptorSource(int descriptor) : descriptor_(descriptor) {}
  std::size_t read(char* data, std::size_t capacity) override;

 private:
  int descriptor_;
};

// Bytes in memory, which must outlive the source.
class MemorySource : public ByteSource {
 public:
  explicit MemorySource(std::string_view bytes) : rest_(bytes) {}
  std::size_t read(char* data, std::size_t capacity) override;

 private:
  std::string_view rest_;
};

struct Line {
  std::uint64_t number = 0;  // 1-based; blank lines count
  std::string_view text;     // without its end; valid until the next call of next()
  bool too_long = false;     // above kMaximumLine: text holds its beginning only
};

// Splits at LF, CRLF and CR. A last line without an end counts when it is not empty.
class LineSource {
 public:
  explicit LineSource(ByteSource& bytes);
  // False at the end of the program.
  bool next(Line& line);
  // From now on a CR without LF is a blank and ends no line.
  void take_cr_for_blank() { cr_is_blank_ = true; }
  // Whether there was a CR without LF before other text.
  bool has_lone_cr() const { return has_lone_cr_; }

 private:
  bool fill();
  std::size_t find_end(std::size_t from) const;
  void drop_line();
  void look_for_lone_cr(std::size_t size);
  std::size_t with_blanks(std::size_t size);

  ByteSource& bytes_;
  std::string buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::uint64_t number_ = 0;
  bool at_end_ = false;
  bool skip_line_feed_ = false;
  bool dropping_ = false;
  bool cr_is_blank_ = false;
  bool has_lone_cr_ = false;
};

// The line with blanks for its comments, and in rs274 for the names of parameters, also where it
// cannot be parsed.
std::string without_comments(Dialect dialect, std::string_view line);

}  // namespace gonogo::grammar
