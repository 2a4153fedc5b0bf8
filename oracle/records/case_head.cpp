// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/case_head.hpp"

#include <array>
#include <utility>

#include "oracle/records/json_document.hpp"

namespace gonogo::oracle {
namespace {

using simdjson::dom::element;

void take_texts(const element& value, std::vector<std::string>& texts) {
  texts.clear();
  simdjson::dom::array list;
  if (value.get(list) != simdjson::SUCCESS) return;
  for (auto item : list) {
    std::string_view text;
    if (item.get(text) == simdjson::SUCCESS) texts.emplace_back(text);
  }
}

}  // namespace

bool read_case_head(std::string_view line, CaseHead& head) {
  static thread_local JsonDocument document;
  auto parsed = document.parse(line);
  auto* object = std::get_if<simdjson::dom::object>(&parsed);
  if (object == nullptr) return false;
  const std::array<std::pair<std::string_view, std::string*>, 8> texts = {{
      {"id", &head.id},
      {"dialect", &head.dialect},
      {"cycle", &head.cycle},
      {"verdict", &head.verdict},
      {"clause", &head.clause},
      {"departure", &head.departure},
      {"feature", &head.feature},
      {"message", &head.message},
  }};
  for (const auto& [key, text] : texts) text->clear();
  head.features.clear();
  head.clauses.clear();
  head.microseconds = 0;
  head.expected = false;
  for (auto field : *object) {
    if (field.key == "clauses") {
      take_texts(field.value, head.clauses);
    } else if (field.key == "features") {
      take_texts(field.value, head.features);
    } else if (field.key == "us") {
      if (field.value.get(head.microseconds) != simdjson::SUCCESS) head.microseconds = 0;
    } else if (field.key == "expected") {
      if (field.value.get(head.expected) != simdjson::SUCCESS) head.expected = false;
    }
    for (const auto& [key, text] : texts) {
      std::string_view value;
      if (field.key != key) continue;
      if (field.value.get(value) == simdjson::SUCCESS) *text = value;
      break;
    }
  }
  return true;
}

}  // namespace gonogo::oracle
