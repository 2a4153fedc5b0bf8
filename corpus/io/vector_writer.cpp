// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vector files, canonical: groups and cases in the order of their ids, one record a line, so that a
// change of one case is a change of few lines.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "corpus/io/corpus.hpp"
#include "oracle/records/text.hpp"

namespace gonogo::oracle {
namespace {

using Cases = std::vector<const Case*>;

std::string json_string(std::string_view text) {
  std::string out;
  append_json_string(text, out);
  return out;
}

std::string text_list(const std::vector<std::string>& texts) {
  std::string out = "[";
  for (const std::string& text : texts) {
    if (out.size() > 1) out += ", ";
    append_json_string(text, out);
  }
  return out + "]";
}

// Lines joined by commas, indented, between brackets.
std::string block_list(const std::vector<std::string>& items, std::size_t indent) {
  if (items.empty()) return "[]";
  const std::string margin = "\n" + std::string(indent, ' ');
  std::string out = "[";
  for (const std::string& item : items) {
    if (out.size() > 1) out += ',';
    out += margin + " " + item;
  }
  return out + margin + "]";
}

std::string program_json(std::string_view program) {
  if (is_utf8(program)) return json_string(program);
  return fmt::format("{{\"base64\": \"{}\"}}", base64(program));
}

std::string alarm_json(const ExpectedAlarm& alarm) {
  std::string out = fmt::format(R"({{"class":"{}","b":{})", name(alarm.alarm), alarm.block);
  if (!alarm.word.empty()) out += fmt::format(R"(,"word":"{}")", alarm.word.text());
  return out + "}";
}

std::string case_json(const Case& test) {
  std::vector<std::string> expect;
  for (const Expectation& expectation : test.expect)
    expect.push_back(expectation_json(expectation));
  return fmt::format(R"({{
     "id": {},
     "comment": {},
     "program": {},
     "expect": {},
     "tags": {{"tway": {}, "sign": {}}},
     "provenance": {}
    }})",
                     json_string(test.id), json_string(test.comment), program_json(test.program),
                     block_list(expect, 5), text_list(test.tags_tway), text_list(test.tags_sign),
                     json_string(test.provenance));
}

std::string group_json(const Cases& cases) {
  const Case& first = *cases.front();
  std::vector<std::string> texts;
  for (const Case* test : cases) {
    if (test->features != first.features || test->clauses != first.clauses ||
        !(test->profile == first.profile)) {
      throw CorpusError(fmt::format(
          "{} and {} stand in the group {}, but differ in features, clauses or profile.", first.id,
          test->id, first.group));
    }
    texts.push_back(case_json(*test));
  }
  return fmt::format(R"({{
   "gid": {},
   "features": {},
   "clauses": {},
   "profile": {},
   "cases": {}
  }})",
                     json_string(first.group), text_list(first.features), text_list(first.clauses),
                     reference::profile_json(first.profile), block_list(texts, 3));
}

}  // namespace

std::string expectation_json(const Expectation& expectation) {
  std::string out = "{";
  if (!expectation.when.empty()) {
    out += "\"when\": {";
    bool first = true;
    for (const auto& [reading, value] : expectation.when) {
      out += fmt::format("{}{}: {}", first ? "" : ", ", json_string(reading), json_string(value));
      first = false;
    }
    out += "}, ";
  }
  if (expectation.basis) {
    out += fmt::format("\"basis\": {}, ", json_string(reference::name(*expectation.basis)));
  }
  std::vector<std::string> records;
  for (const reference::Record& record : expectation.records) {
    reference::append_json(record, records.emplace_back());
  }
  out += "\"records\": " + block_list(records, 6);
  if (!expectation.open.empty()) {
    std::vector<std::string> parts;
    for (const OpenPart& part : expectation.open) {
      parts.push_back(fmt::format(
          R"({{"from":{},"to":{},"clause":"{}","path":"{}","conditions":{}}})", part.from, part.to,
          reference::clause(part.clause).id, part.path, part.conditions));
    }
    out += ", \"open\": " + block_list(parts, 6);
  }
  if (!expectation.alarms.empty()) {
    std::vector<std::string> alarms;
    for (const auto* const part : {&expectation.alarms, &expectation.other_classes}) {
      for (const ExpectedAlarm& alarm : *part) alarms.push_back(alarm_json(alarm));
    }
    out += ", \"alarm\": {\"any_of\": " + block_list(alarms, 6) + "}";
  }
  if (expectation.not_covered) out += ", \"not_covered\": true";
  if (expectation.has_others) out += ", \"others\": true";
  return out + "}";
}

std::string vector_file_text(std::string_view corpus_version, const std::vector<Case>& cases) {
  if (cases.empty()) throw CorpusError("A vector file needs at least one case.");
  const Case& head = cases.front();
  std::map<std::string, Cases> groups;
  for (const Case& test : cases) {
    if (test.dialect != head.dialect || test.cycle != head.cycle) {
      throw CorpusError(fmt::format("{} and {} belong to different files.", head.id, test.id));
    }
    groups[test.group].push_back(&test);
  }
  std::vector<std::string> texts;
  for (auto& [gid, members] : groups) {
    std::ranges::sort(members, {}, [](const Case* test) { return test->id; });
    texts.push_back(group_json(members));
  }
  return fmt::format(R"({{
 "format": 2,
 "corpus": {},
 "dialect": {},
 "cycle": {},
 "groups": {}
}}
)",
                     json_string(corpus_version), json_string(head.dialect),
                     json_string(head.cycle), block_list(texts, 1));
}

}  // namespace gonogo::oracle
