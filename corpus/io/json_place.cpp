// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/io/json_place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "corpus/io/corpus.hpp"

namespace gonogo::oracle {

JsonPlace::JsonPlace(const JsonPlace& parent, Step step, simdjson::dom::element value)
    : file_(parent.file_), depth_(parent.depth_), value_(value) {
  std::copy_n(parent.steps_.begin(), depth_, steps_.begin());
  if (depth_ < steps_.size()) steps_[depth_++] = step;
}

// RFC 6901
std::string JsonPlace::pointer() const {
  std::string text;
  for (const Step& step : std::span(steps_).first(depth_)) {
    text += '/';
    if (step.key.data() == nullptr) text += std::to_string(step.index);
    for (const char byte : step.key) {
      if (byte == '~') {
        text += "~0";
      } else if (byte == '/') {
        text += "~1";
      } else {
        text += byte;
      }
    }
  }
  return text;
}

void JsonPlace::fail(std::string_view message) const {
  throw CorpusError(
      fmt::format("{}: at {}: {}", *file_, depth_ == 0 ? "the top" : pointer(), message));
}

void JsonPlace::need_object(std::initializer_list<std::string_view> known) const {
  for (const auto field : object()) {
    if (std::ranges::find(known, field.key) == known.end()) {
      JsonPlace(*this, {field.key}, field.value).fail("There is no such key in the format.");
    }
  }
}

simdjson::dom::object JsonPlace::object() const {
  if (root_) return *root_;
  simdjson::dom::object object;
  if (value_.get_object().get(object) != simdjson::SUCCESS) fail("An object must stand here.");
  return object;
}

simdjson::dom::array JsonPlace::array() const {
  simdjson::dom::array array;
  if (value_.get_array().get(array) != simdjson::SUCCESS) fail("An array must stand here.");
  return array;
}

std::optional<JsonPlace> JsonPlace::find(std::string_view key) const {
  simdjson::dom::element value;
  if (object()[key].get(value) != simdjson::SUCCESS) return std::nullopt;
  return JsonPlace(*this, {key}, value);
}

JsonPlace JsonPlace::member(std::string_view key) const {
  if (const auto found = find(key)) return *found;
  fail(fmt::format("The key \"{}\" is missing.", key));
}

std::vector<std::pair<std::string, JsonPlace>> JsonPlace::members() const {
  std::vector<std::pair<std::string, JsonPlace>> list;
  for (const auto field : object()) {
    list.emplace_back(std::string(field.key), JsonPlace(*this, {field.key}, field.value));
  }
  return list;
}

std::vector<JsonPlace> JsonPlace::items() const {
  const simdjson::dom::array all = array();
  std::vector<JsonPlace> list;
  list.reserve(all.size());
  for (const simdjson::dom::element item : all) {
    list.push_back({*this, {{}, list.size()}, item});
  }
  return list;
}

std::string JsonPlace::text() const {
  std::string_view text;
  if (value_.get_string().get(text) != simdjson::SUCCESS) fail("A string must stand here.");
  return std::string(text);
}

std::vector<std::string> JsonPlace::texts() const {
  std::vector<std::string> list;
  for (const simdjson::dom::element item : array()) {
    list.push_back(JsonPlace(*this, {{}, list.size()}, item).text());
  }
  return list;
}

std::int64_t JsonPlace::integer() const {
  std::int64_t value = 0;
  if (value_.get_int64().get(value) != simdjson::SUCCESS) fail("A whole number must stand here.");
  return value;
}

bool JsonPlace::flag() const {
  bool value = false;
  if (value_.get_bool().get(value) != simdjson::SUCCESS) fail("true or false must stand here.");
  return value;
}

std::string JsonPlace::json() const {
  return simdjson::minify(value_);
}

}  // namespace gonogo::oracle
