// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program that is judged; the judge reads it several times.
#pragma once

#include <concepts>
#include <memory>
#include <string_view>

#include "grammar/file_source.hpp"

namespace gonogo::oracle {

// A program in memory, or in an open file that is read anew from its beginning each time: of any
// length. What it names must outlive it.
class ProgramText {
 public:
  template <std::convertible_to<std::string_view> Text>
  ProgramText(const Text& bytes) : bytes_(bytes) {}
  static ProgramText of_file(int descriptor) {
    ProgramText text{std::string_view()};
    text.descriptor_ = descriptor;
    return text;
  }

  std::unique_ptr<grammar::ByteSource> open() const {
    if (descriptor_ >= 0) return std::make_unique<grammar::FileSource>(descriptor_);
    return std::make_unique<grammar::MemorySource>(bytes_);
  }

 private:
  std::string_view bytes_;
  int descriptor_ = -1;
};

// A program as lines.
struct ProgramInput {
  explicit ProgramInput(const ProgramText& program) : bytes(program.open()), lines(*bytes) {}
  std::unique_ptr<grammar::ByteSource> bytes;
  grammar::LineSource lines;
};

}  // namespace gonogo::oracle
