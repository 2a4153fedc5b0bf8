// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/json_document.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <new>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "oracle/records/text.hpp"

namespace gonogo::oracle {
namespace {

using simdjson::dom::element;
using simdjson::dom::element_type;

// A document of one ordinary line; larger ones are given back after use.
constexpr std::size_t kSmall = std::size_t{1} << 20;

// Few keys are compared pair by pair; many are sorted, so that no object costs its square.
class KeySet {
 public:
  void add(std::string_view key) {
    if (count_ < few_.size()) {
      few_[count_] = key;
    } else {
      if (count_ == few_.size()) many_.assign(few_.begin(), few_.end());
      many_.push_back(key);
    }
    ++count_;
  }
  std::optional<std::string_view> twice() {
    if (count_ > few_.size()) {
      std::sort(many_.begin(), many_.end());
      auto found = std::adjacent_find(many_.begin(), many_.end());
      if (found == many_.end()) return std::nullopt;
      return *found;
    }
    for (std::size_t i = 1; i < count_; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (few_[i] == few_[j]) return few_[i];
      }
    }
    return std::nullopt;
  }

 private:
  std::array<std::string_view, 16> few_;
  std::vector<std::string_view> many_;
  std::size_t count_ = 0;
};

// Where memory is short, nothing is wrong with the text.
void need_memory(simdjson::error_code error) {
  if (error == simdjson::MEMALLOC) throw std::bad_alloc();
}

// Finds the first byte that is none of a JSON text; takes in nothing of it.
class ErrorPlace : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool key(string_t&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t byte, const std::string&,
                   const nlohmann::detail::exception&) override {
    byte_ = byte;
    return false;
  }
  std::size_t byte() const { return byte_; }  // from 1; 0: none

 private:
  std::size_t byte_ = 0;
};

std::string not_json(std::string_view text, simdjson::error_code error) {
  if (error == simdjson::DEPTH_ERROR) {
    return fmt::format("This JSON nests deeper than {} levels: {}", kJsonDepth, excerpt(text));
  }
  ErrorPlace place;
  nlohmann::json::sax_parse(text, &place);
  if (place.byte() == 0) return "This is not JSON: " + excerpt(text);
  if (place.byte() > text.size()) return "This JSON has no end: " + excerpt(text);
  return fmt::format("This is not JSON, from column {} on: {}", place.byte(),
                     excerpt(text.substr(place.byte() - 1)));
}

// A key that stands twice in one of the objects of `value`. Recursion is bounded: the parser
// refuses what nests deeper than kJsonDepth.
std::optional<std::string> duplicate_key(const element& value) {
  if (value.type() == element_type::OBJECT) {
    KeySet keys;
    const simdjson::dom::object object = value;
    for (auto field : object) {
      keys.add(field.key);
      if (auto found = duplicate_key(field.value)) return found;
    }
    if (auto key = keys.twice()) return std::string(*key);
  } else if (value.type() == element_type::ARRAY) {
    const simdjson::dom::array array = value;
    for (auto item : array) {
      if (auto found = duplicate_key(item)) return found;
    }
  }
  return std::nullopt;
}

}  // namespace

simdjson::error_code JsonDocument::reserve(std::size_t size) {
  const std::size_t wanted = std::bit_ceil(std::max<std::size_t>(size, 1024));
  const bool too_small = capacity_ < wanted;
  const bool far_too_large = capacity_ > kSmall && wanted <= kSmall;
  if (!too_small && !far_too_large) return simdjson::SUCCESS;
  if (far_too_large) parser_ = simdjson::dom::parser();
  capacity_ = 0;
  if (auto error = parser_.allocate(wanted, kJsonDepth)) return error;
  if (auto error = parser_.doc.allocate(wanted)) return error;
  capacity_ = wanted;
  return simdjson::SUCCESS;
}

std::variant<simdjson::dom::object, JsonFault> JsonDocument::parse_padded(std::string_view text) {
  simdjson::error_code error = reserve(text.size());
  need_memory(error);
  if (error != simdjson::SUCCESS) return JsonFault{simdjson::error_message(error)};
  element root;
  error = parser_.parse(text.data(), text.size(), false).get(root);
  need_memory(error);
  if (error != simdjson::SUCCESS) return JsonFault{not_json(text, error)};
  if (root.type() != element_type::OBJECT) {
    return JsonFault{"This is not a JSON object: " + excerpt(text)};
  }
  if (auto key = duplicate_key(root)) {
    return JsonFault{"The key \"" + excerpt(*key) + "\" stands twice in one object."};
  }
  return simdjson::dom::object(root);
}

std::variant<simdjson::dom::object, JsonFault> JsonDocument::parse(std::string_view text) {
  if (copy_.size() < text.size() + kPadding || copy_.size() > 2 * kSmall) {
    copy_.resize(std::max<std::size_t>(text.size() + kPadding, 4096));
  }
  std::copy(text.begin(), text.end(), copy_.begin());
  return parse_padded(std::string_view(copy_).substr(0, text.size()));
}

}  // namespace gonogo::oracle
