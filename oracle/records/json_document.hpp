// SPDX-License-Identifier: GPL-3.0-or-later
//
// JSON as every message of a subject is read: bounded nesting, no key twice in any object.
#pragma once

#include <simdjson.h>

#include <string>
#include <string_view>
#include <variant>

namespace gonogo::oracle {

// What is wrong with a JSON text, a sentence.
struct JsonFault {
  std::string message;
};

// Objects nest no deeper than this: a message of the protocol has five levels.
inline constexpr std::size_t kJsonDepth = 64;

// A simdjson parser that keeps its buffers from one text to the next.
class JsonDocument {
 public:
  // Bytes that must be readable behind a text.
  static constexpr std::size_t kPadding = simdjson::SIMDJSON_PADDING;

  // Valid until the next call. REQUIRES: kPadding readable bytes behind `text`.
  std::variant<simdjson::dom::object, JsonFault> parse_padded(std::string_view text);
  // The same from a text without padding, which is copied.
  std::variant<simdjson::dom::object, JsonFault> parse(std::string_view text);

 private:
  simdjson::error_code reserve(std::size_t size);

  simdjson::dom::parser parser_;
  std::size_t capacity_ = 0;
  std::string copy_;
};

}  // namespace gonogo::oracle
