// SPDX-License-Identifier: GPL-3.0-or-later
//
// JSON values that know where they stand, so that a mistake in them is reported with file and
// JSON pointer. Private to this folder.
#pragma once

#include <simdjson.h>

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gonogo::oracle {

class JsonPlace {
 public:
  // The top of a document, which must outlive the places in it, and so must `file`.
  JsonPlace(const std::string& file, simdjson::dom::object root) : file_(&file), root_(root) {}
  JsonPlace(std::string&&, simdjson::dom::object) = delete;

  // Throws CorpusError: "<file>: at <pointer>: <message>".
  [[noreturn]] void fail(std::string_view message) const;

  // The members of an object; every key must be one of `known`.
  void need_object(std::initializer_list<std::string_view> known) const;
  JsonPlace member(std::string_view key) const;  // must be there
  std::optional<JsonPlace> find(std::string_view key) const;
  std::vector<std::pair<std::string, JsonPlace>> members() const;
  std::vector<JsonPlace> items() const;  // of an array

  std::string text() const;
  std::vector<std::string> texts() const;
  std::int64_t integer() const;
  bool flag() const;
  bool is_text() const { return value_.is_string(); }
  // The value as JSON.
  std::string json() const;

 private:
  // A key, or the place in an array.
  struct Step {
    std::string_view key;
    std::size_t index = 0;
  };
  JsonPlace(const JsonPlace& parent, Step step, simdjson::dom::element value);

  simdjson::dom::object object() const;
  simdjson::dom::array array() const;
  std::string pointer() const;

  const std::string* file_;
  // Written out only where something is wrong: a corpus has millions of places. No format of the
  // corpus nests as deep; of steps beyond that the pointer says nothing.
  std::array<Step, 10> steps_;
  std::size_t depth_ = 0;
  std::optional<simdjson::dom::object> root_;  // the top; else `value_` counts
  simdjson::dom::element value_;
};

}  // namespace gonogo::oracle
