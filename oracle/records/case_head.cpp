// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/case_head.hpp"

#include <array>
#include <utility>

#include "oracle/records/json_document.hpp"
#include "oracle/records/text.hpp"

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

std::size_t lines_not_blank(std::string_view text) {
  std::size_t lines = 0;
  bool blank = true;
  for (const char c : text) {
    if (c == '\n' || c == '\r') {
      blank = true;
    } else if (blank && c != ' ' && c != '\t') {
      blank = false;
      ++lines;
    }
  }
  return lines;
}

void take_program(const element& value, CaseHead& head) {
  std::string_view text;
  std::optional<std::string> bytes;
  if (value.get(text) != simdjson::SUCCESS) {
    if (value["base64"].get(text) != simdjson::SUCCESS) return;
    bytes = decode_base64(text);
    if (!bytes) return;
    text = *bytes;
  }
  head.program_blocks = lines_not_blank(text);
  head.program_bytes = text.size();
}

// What is no text of its own.
void take_other(std::string_view key, const simdjson::dom::element& value, CaseHead& head) {
  if (key == "clauses") {
    take_texts(value, head.clauses);
  } else if (key == "features") {
    take_texts(value, head.features);
  } else if (key == "program") {
    take_program(value, head);
  } else if (key == "us") {
    if (value.get(head.microseconds) != simdjson::SUCCESS) head.microseconds = 0;
  } else if (key == "attempts") {
    if (value.get(head.attempts) != simdjson::SUCCESS) head.attempts = 1;
  } else if (key == "b") {
    if (value.get(head.block) != simdjson::SUCCESS) head.block = 0;
  } else if (key == "deviation") {
    std::string_view exact;
    if (value["exact"].get(exact) == simdjson::SUCCESS) head.deviation = exact;
  } else if (key == "readings") {
    std::string_view against;
    if (value["against"].get(against) == simdjson::SUCCESS) head.against = against;
  } else if (key == "expected") {
    if (value.get(head.expected) != simdjson::SUCCESS) head.expected = false;
  }
}

}  // namespace

bool read_case_head(std::string_view line, CaseHead& head) {
  static thread_local JsonDocument document;
  auto parsed = document.parse(line);
  auto* object = std::get_if<simdjson::dom::object>(&parsed);
  if (object == nullptr) return false;
  const std::array<std::pair<std::string_view, std::string*>, 13> texts = {{
      {"id", &head.id},
      {"dialect", &head.dialect},
      {"cycle", &head.cycle},
      {"verdict", &head.verdict},
      {"clause", &head.clause},
      {"departure", &head.departure},
      {"rule", &head.rule},
      {"gap", &head.gap},
      {"known", &head.known},
      {"feature", &head.feature},
      {"message", &head.message},
      {"want", &head.want},
      {"got", &head.got},
  }};
  for (const auto& [key, text] : texts) text->clear();
  head.deviation.clear();
  head.against.clear();
  head.features.clear();
  head.clauses.clear();
  head.block = 0;
  head.microseconds = 0;
  head.attempts = 1;
  head.program_blocks = 0;
  head.program_bytes = 0;
  head.expected = false;
  for (auto field : *object) {
    take_other(field.key, field.value, head);
    for (const auto& [key, text] : texts) {
      std::string_view value;
      if (field.key != key) continue;
      if (field.value.get(value) != simdjson::SUCCESS) break;
      // Lines are in the order of their ids as they stand.
      *text = key == "id" ? std::string(value) : visible(value);
      break;
    }
  }
  if (head.verdict == "xfail" && head.known.empty()) {
    split_known_message(head.departure, head.known, head.message);
  }
  return true;
}

void split_known_message(std::string_view departure, std::string& known, std::string& message) {
  constexpr std::string_view kBegin = "Known: ";
  const std::string whole = std::exchange(message, {});
  known = whole;
  if (!whole.starts_with(kBegin)) return;
  const std::string_view rest = std::string_view(whole).substr(kBegin.size());
  known = rest;
  // Between them stands the verdict; a reason may have parentheses of its own.
  std::string middle = " (";
  if (!departure.empty()) middle.append(departure).append(": ");
  const std::size_t at = rest.find(middle);
  // Behind it a flaky one says in how many runs it failed so.
  const std::size_t end = rest.ends_with(')') ? rest.size() - 1 : rest.rfind("); ");
  const std::size_t from = at + middle.size();
  if (at == std::string_view::npos || end == std::string_view::npos || end < from) return;
  known = rest.substr(0, at);
  message = rest.substr(from, end - from);
}

}  // namespace gonogo::oracle
