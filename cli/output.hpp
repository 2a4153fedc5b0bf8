// SPDX-License-Identifier: GPL-3.0-or-later
//
// Standard output in large writes, with a full disk or a closed pipe noticed.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "oracle/records/text.hpp"

namespace gonogo::cli {

// Standard output cannot be written. A closed pipe is not worth a message; a full disk is.
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::string& message, bool quiet)
      : std::runtime_error(message), quiet_(quiet) {}
  bool quiet() const { return quiet_; }

 private:
  bool quiet_;
};

// The border of texts for people. What others wrote may stand in them: what would move the cursor,
// turn the writing or hide in it is written out, and no line of it is a command to the machine that
// keeps a log (::error::, ##[error]). `colour`: the gauge's own stays.
std::string people_text(std::string_view text, bool colour);
// The same of a message: lines after the first are indented, so that none of them looks like the
// gauge's own.
std::string message_text(std::string_view text);

// A message for people, on standard error. One that cannot be written there is lost, and nothing
// else: the exit code says what matters.
template <typename... Values>
void complain(fmt::format_string<Values...> text, Values&&... values) {
  const std::string words = message_text(fmt::format(text, std::forward<Values>(values)...));
  std::fwrite(words.data(), 1, words.size(), stderr);
}

// Several messages in one text, each of which begins a line: names of others in it must be visible()
// already.
void complain_each(std::string_view messages);

// The same for what moves the cursor of a terminal: texts of others in it must be visible()
// already.
template <typename... Values>
void draw(fmt::format_string<Values...> text, Values&&... values) {
  fmt::print(stderr, text, std::forward<Values>(values)...);
  std::fflush(stderr);
}

class Output {
 public:
  explicit Output(int descriptor = 1) : descriptor_(descriptor) {}
  // The text that waits to be written: append to it, then call flush_if_large.
  std::string& text() { return text_; }
  void flush_if_large() {
    if (text_.size() >= kChunk) flush();
  }
  // Throws OutputError.
  void flush();
  // The same for people: at a terminal in lines that fit it.
  void tell();

 private:
  static constexpr std::size_t kChunk = std::size_t{1} << 16;
  int descriptor_;
  std::string text_;
};

}  // namespace gonogo::cli
