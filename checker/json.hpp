// SPDX-License-Identifier: GPL-3.0-or-later
//
// A reader of JSON (RFC 8259) that keeps what the checker needs and other readers lose: numbers as
// they are written, and where in the text each value stands. A key twice in an object is refused.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace gonogo::checker {

// What is wrong with a text or a file: a whole sentence.
class Fault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct JsonMember;

class Json {
 public:
  enum class Kind { null, boolean, number, text, list, object };

  Kind kind = Kind::null;
  bool truth = false;
  std::string text;                 // of a text: its characters; of a number: as it is written
  std::vector<Json> items;          // of a list
  std::vector<JsonMember> members;  // of an object, in their order
  std::size_t begin = 0;            // in the text that was read
  std::size_t end = 0;

  bool is(Kind what) const { return kind == what; }
  // Null when there is none.
  const Json* find(std::string_view key) const;
  // These throw Fault, naming the key, when the member is missing or of another kind.
  const Json& member(std::string_view key, Kind what) const;
  const std::string& text_of(std::string_view key) const;
  long integer_of(std::string_view key) const;
  std::vector<std::string> texts_of(std::string_view key) const;
  // Empty when there is no such member, or, of a text, one of another kind.
  std::string text_at(std::string_view key) const;
  std::vector<std::string> texts_at(std::string_view key) const;

  // The value of an integer; throws Fault for what is none, or has more than 15 digits.
  long integer() const;
  // The texts of a list of texts; throws Fault.
  std::vector<std::string> texts() const;
  // The same value; the order of members and blanks do not count.
  bool same_as(const Json& other) const;
};

struct JsonMember {
  std::string key;
  Json value;
};

// Throws Fault with the byte at which the text cannot be read.
Json parse_json(std::string_view text);

}  // namespace gonogo::checker
