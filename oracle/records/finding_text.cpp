// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/finding_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "oracle/records/point_text.hpp"
#include "reference/clause.hpp"

namespace gonogo::oracle {
namespace {

using Json = nlohmann::ordered_json;

// Whether it is a number that is no text, and no point: {"root":["0","1","2"]}.
bool is_written_apart(const Json& value) {
  return value.is_object() && (value.contains("root") || value.contains("enclosure"));
}

// Numbers are texts, except those of three kinds (docs/formats.md); what is no decimal is printed
// to nine places.
std::string plain(const Json& value) {
  const bool is_number =
      is_written_apart(value) ||
      (value.is_string() && value.get<std::string>().find('/') != std::string::npos);
  if (const auto number = is_number ? number_of(value) : std::nullopt) {
    return millimetres_text(*number) + "...";
  }
  return value.is_string() ? value.get<std::string>() : value.dump();
}

// " Z-7 X3" of {"z":"-7","x":"3"}
std::string words_of(const Json& values) {
  std::string text;
  if (!values.is_object()) return text;
  for (const auto& [axis, value] : values.items()) {
    std::string letter = axis;
    std::ranges::transform(letter, letter.begin(), [](char c) {
      return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    text += " " + letter + plain(value);
  }
  return text;
}

// " clockwise", " counterclockwise in 3 turns"
std::string turns_of(const Json& rot) {
  if (!rot.is_number_integer()) return rot == "-" ? " clockwise" : " counterclockwise";
  const auto turns = rot.get<std::int64_t>();
  const std::string sense = turns < 0 ? " clockwise" : " counterclockwise";
  return turns == 1 || turns == -1 ? sense : fmt::format("{} in {} turns", sense, std::abs(turns));
}

// One value of a step, behind its name; nothing of what all steps have.
std::string further_word(const std::string& key, const Json& value) {
  const bool is_told = key == "k" || key == "b" || key == "to";
  if (is_told || key == "clause" || key.starts_with("x-")) return {};
  if (key == "via") return " via" + words_of(value);
  if (key == "c" || key == "centre") return " about" + words_of(value);
  if (key == "rot") return turns_of(value);
  if (key == "fm") return value == "rev" ? " a revolution" : "";
  if (key == "plane") return " in " + plain(value);
  if (key == "f" || key == "m") return (key == "f" ? " F" : " M") + plain(value);
  std::string words = key;
  std::ranges::replace(words, '_', ' ');
  const bool is_point = value.is_object() && !is_written_apart(value);
  return is_point ? " " + words + words_of(value) : fmt::format(" {} {}", words, plain(value));
}

// What people call the step: those that leave the path to the control have names of formats.
std::string name_of(const Json& step) {
  constexpr std::pair<std::string_view, std::string_view> kNames[] = {
      {"level", "a layer"},
      {"thread-pass", "a pass of the thread"},
      {"helix-pocket", "a helix"},
      {"pocket-rough", "the roughing of a pocket"},
      {"pocket-finish", "the finishing of a pocket"}};
  const std::string kind = plain(step["k"]);
  const auto found = std::ranges::find(kNames, kind, [](const auto& one) { return one.first; });
  return found == std::end(kNames) ? kind : std::string(found->second);
}

// The values of a step that tell it from others, behind its name.
std::string further_words(const Json& step) {
  std::string text = words_of(step.value("to", Json::object()));
  for (const auto& [key, value] : step.items()) text += further_word(key, value);
  return text;
}

// "syntax or not-an-integer": what an alarm is called, or may be.
std::string alarm_classes(const Json& alarm) {
  if (!alarm.contains("any_of")) return plain(alarm["class"]);
  std::string text;
  for (const Json& one : alarm["any_of"]) text += (text.empty() ? "" : " or ") + plain(one);
  return text;
}

// The line of a record, where want and got name two.
std::string line_of(const Json& step, const Json& other) {
  const bool differs = step.is_object() && other.is_object() && step.contains("b") &&
                       other.contains("b") && step["b"] != other["b"] && !step.contains("class") &&
                       !step.contains("any_of");
  return differs ? fmt::format(" in line {}", plain(step["b"])) : std::string();
}

std::string shown(std::string_view line) {
  constexpr std::size_t kLongest = 100;
  std::string text(line.substr(0, kLongest));
  for (char& c : text) {
    if (c == '\t') c = ' ';
    if (c < ' ' || c > '~') c = '?';
  }
  return line.size() > kLongest ? text + " ..." : text;
}

// "units inch", "initial.feed 100": of each key its value, objects key by key.
void collect(const Json& profile, const std::string& prefix, std::vector<std::string>& out) {
  for (const auto& [key, value] : profile.items()) {
    if (value.is_object()) {
      collect(value, key == "readings" ? std::string() : prefix + key + ".", out);
    } else if (key != "dialect") {
      out.push_back(fmt::format("{}{} {}", prefix, key, plain(value)));
    }
  }
}

}  // namespace

std::string short_step(std::string_view json) {
  const Json step = Json::parse(json, nullptr, false);
  if (!step.is_object()) return std::string(json);
  if (step.contains("class") || step.contains("any_of")) {
    std::string text = "alarm " + alarm_classes(step);
    if (step.contains("word")) text += " of " + plain(step["word"]);
    return step.contains("b") ? text + " in line " + plain(step["b"]) : text;
  }
  if (!step.contains("k")) return std::string(json);
  const std::string words = further_words(step);
  return step["k"] == "m" && words.size() > 1 ? words.substr(1) : name_of(step) + words;
}

std::string want_and_got(std::string_view want, std::string_view got) {
  if (want.empty() && got.empty()) return {};
  const Json due = Json::parse(want, nullptr, false);
  const Json came = Json::parse(got, nullptr, false);
  const auto shown_step = [](std::string_view text, const Json& step, const Json& other) {
    return text.empty() ? "nothing" : short_step(text) + line_of(step, other);
  };
  return fmt::format("want {} / got {}", shown_step(want, due, came), shown_step(got, came, due));
}

namespace {

using Blocks = std::map<std::uint64_t, std::string>;

// With their numbers, and a caret below one of them.
std::string numbered(const Blocks& blocks, std::uint64_t line) {
  std::string text;
  const std::size_t width = blocks.empty() ? 0 : std::to_string(blocks.rbegin()->first).size();
  for (const auto& [number, block] : blocks) {
    text += fmt::format("{:>{}} | {}\n", number, width, block);
    if (number != line) continue;
    const std::size_t carets = std::max<std::size_t>(1, block.size());
    text += fmt::format("{:>{}} | {:^<{}}\n", "", width, "", carets);
  }
  return text;
}

Blocks blocks_from_to(grammar::ByteSource& program, std::uint64_t from, std::uint64_t to) {
  Blocks blocks;
  grammar::LineSource lines(program);
  for (grammar::Line one; lines.next(one) && one.number <= to;) {
    if (one.number >= from) blocks[one.number] = shown(one.text);
  }
  return blocks;
}

}  // namespace

std::string marked_blocks(std::string_view program, std::uint64_t line) {
  grammar::MemorySource bytes(program);
  return marked_blocks(bytes, line);
}

std::string marked_blocks(grammar::ByteSource& program, std::uint64_t line) {
  constexpr std::uint64_t kBefore = 3;
  constexpr std::uint64_t kBehind = 1;
  constexpr std::uint64_t kFirst = 5;
  if (line == 0) {
    Blocks blocks = blocks_from_to(program, 1, kFirst + 1);
    if (blocks.size() > kFirst) blocks.rbegin()->second = "...";
    return numbered(blocks, 0);
  }
  const Blocks blocks = blocks_from_to(program, line - std::min(kBefore, line), line + kBehind);
  return blocks.contains(line) ? numbered(blocks, line) : std::string();
}

std::string marked_program(std::string_view program, std::uint64_t line) {
  grammar::MemorySource bytes(program);
  return numbered(blocks_from_to(bytes, 1, std::numeric_limits<std::uint64_t>::max()), line);
}

std::string other_machine(std::string_view profile) {
  std::vector<std::string> parts;
  const Json own = Json::parse(profile, nullptr, false);
  if (own.is_object()) collect(own, "", parts);
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::optional<std::uint64_t> line_wanted(std::string_view want) {
  const Json step = Json::parse(want, nullptr, false);
  const bool has_line = step.is_object() && step.contains("b") && step["b"].is_number_unsigned();
  return has_line ? std::optional(step["b"].get<std::uint64_t>()) : std::nullopt;
}

FindingFacts finding_facts(const Verdict& verdict) {
  FindingFacts facts;
  facts.want = verdict.want;
  facts.got = verdict.got;
  facts.message = verdict.message;
  facts.known = verdict.known;
  if (verdict.departure) facts.departure = name(*verdict.departure);
  facts.rule = name(rule_of(verdict));
  facts.gap = name(verdict.gap);
  facts.clause = reference::clause_name(verdict.clause);
  if (verdict.block != 0) facts.block = verdict.block;
  if (!facts.block) facts.block = line_wanted(verdict.want);
  facts.record = verdict.record;
  facts.deviation_exact = verdict.deviation_exact;
  facts.deviation_mm = verdict.deviation_mm;
  facts.witness = point_for_people(verdict.witness);
  facts.reading = verdict.reading;
  return facts;
}

namespace {

// "GSK-G94-02: Traverse ... (document: section)"; an id that the catalog lacks alone.
std::string clause_with_sentence(const std::string& id) {
  const auto clauses = reference::clauses();
  const auto found = std::ranges::find(clauses, std::string_view(id), &reference::Clause::id);
  if (found == clauses.end()) return id;
  return fmt::format("{}: {} ({})", id, found->text, found->source);
}

}  // namespace

std::string record_number(const std::optional<std::uint64_t>& record) {
  return record ? std::to_string(*record + 1) : std::string();
}

std::string deviation_text(const FindingFacts& facts) {
  if (facts.deviation_exact.empty()) return {};
  // A long fraction or a root tells people nothing that the decimal does not.
  constexpr std::size_t kMostShown = 24;
  const bool is_readable =
      facts.deviation_exact.size() <= kMostShown && !facts.deviation_exact.starts_with('{');
  if (facts.deviation_exact == facts.deviation_mm || !is_readable)
    return facts.deviation_mm + " mm";
  return fmt::format("{} mm (exactly {})", facts.deviation_mm, facts.deviation_exact);
}

std::vector<FindingPart> finding_parts(const FindingFacts& facts) {
  using Form = FindingPart::Form;
  const auto place = [](const auto& number) {
    return number ? std::to_string(*number) : std::string();
  };
  std::vector<FindingPart> parts = {
      {Form::fact, "about", facts.comment},
      {Form::fact, "machine", other_machine(facts.profile)},
      {Form::lines, "", facts.blocks},
      {Form::fact, "in force", facts.in_force},
      {Form::sentence, "", want_and_got(facts.want, facts.got)},
      {Form::sentence, "", facts.message},
      {Form::fact, "known", facts.known},
      {Form::fact, facts.known.empty() ? "would be" : "fails with", facts.departure},
      {Form::fact, "rule", rule_text(facts.rule)},
      {Form::fact, "gap", facts.gap},
      {Form::fact, "clause", clause_with_sentence(facts.clause)},
      {Form::fact, "basis", facts.basis == "text" ? "" : facts.basis},
      {Form::fact, "line", facts.blocks.empty() ? place(facts.block) : std::string()},
      {Form::fact, "record", record_number(facts.record)},
      {Form::fact, "deviation", deviation_text(facts)},
      {Form::fact, "witness", facts.witness},
      {Form::fact, "GO under", facts.reading.empty() ? "" : "--reading " + facts.reading},
      {Form::sentence, "", facts.cause},
      {Form::command, "again", facts.next}};
  std::erase_if(parts, [](const FindingPart& part) { return part.text.empty(); });
  return parts;
}

std::string finding_text(const FindingFacts& facts, std::string_view indent) {
  std::string text;
  for (const auto& [form, what, part] : finding_parts(facts)) {
    const std::string head = what.empty() ? std::string() : fmt::format("{:<10} ", what);
    std::size_t begin = 0;
    do {  // most parts are one line
      const std::size_t end = std::min(part.find('\n', begin), part.size());
      text += fmt::format("{}{}{}\n", indent, head, part.substr(begin, end - begin));
      begin = end + 1;
    } while (begin < part.size());
  }
  return text;
}

}  // namespace gonogo::oracle
