// SPDX-License-Identifier: GPL-3.0-or-later
//
// JSON values that know where they stand, so that whatever is wrong with them is told with file and
// JSON pointer. Private to oracle/corpus.
#pragma once

#include <simdjson.h>

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gonogo::oracle {

class JsonPlace {
 public:
  // The top of a document.
  JsonPlace(std::string file, simdjson::dom::object root)
      : file_(std::make_shared<const std::string>(std::move(file))), root_(root) {}

  // Throws CorpusError: "<file>: at <pointer>: <message>".
  [[noreturn]] void fail(std::string_view message) const;

  // The members of an object; every key must be one of `known`.
  void need_object(std::initializer_list<std::string_view> known) const;
  JsonPlace member(std::string_view key) const;  // must be there
  bool has(std::string_view key) const;
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
  JsonPlace(const JsonPlace& parent, std::string_view key, simdjson::dom::element value);

  simdjson::dom::object object() const;

  std::shared_ptr<const std::string> file_;
  std::string pointer_;
  std::optional<simdjson::dom::object> root_;  // the top; else `value_` counts
  simdjson::dom::element value_;
};

}  // namespace gonogo::oracle
