// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spelling: a generated program, of any dialect, means the same in other spellings: as the grammar
// prints its blocks, with CR LF, with blanks between its words. The first byte chooses dialect and
// spelling, the others are the generator's decisions. Cost cap: 5,000 items, since a tiny Q over a
// great depth is a long program.
#include <set>

#include "fuzz/targets/decision_hooks.hpp"
#include "fuzz/targets/target.hpp"
#include "fuzz/generate/generator.hpp"
#include "grammar/parser.hpp"
#include "fuzz/program/text.hpp"
#include "reference/dialect.hpp"

namespace {

using namespace gonogo;

// A line that cannot be read stays as it is, and so does one of comments alone: empty lines may
// stand before the % of rs274, comments may not (NGC-COM-07).
std::string printed(grammar::Dialect dialect, std::string line) {
  grammar::Block block;
  if (grammar::parse_block(dialect, line, block)) return line;
  std::string text = grammar::print(dialect, block);
  return text.empty() ? line : text;
}

std::string spelled(grammar::Dialect dialect, std::string_view program, std::uint32_t spelling) {
  std::vector<program::TextLine> lines = program::lines_of(program);
  for (program::TextLine& line : lines) {
    if (spelling == 0) {
      line = {
          {{"", printed(dialect, program::line_text({line.words, line.rest, ""}))}}, "", line.end};
    } else if (spelling == 1 && !line.end.empty()) {
      line.end = "\r\n";
    } else if (spelling == 2) {
      for (program::TextWord& word : line.words) word.gap += " \t";
    }
  }
  return program::text_of(lines);
}

// All that a program means, as text. Words of an alarm may stand elsewhere; what they are may not.
std::string meaning(const reference::Profile& profile, std::string_view program) {
  constexpr std::size_t kMostItems = 5'000;
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::shown);
  std::string text;
  std::size_t items = 0;
  while (const reference::Item* item = expander.next()) {
    if (++items > kMostItems) break;
    if (auto* record = std::get_if<reference::Record>(item)) {
      append_json(*record, text);
    } else if (auto* report = std::get_if<reference::AlarmReport>(item)) {
      std::set<std::string_view> classes;
      for (const reference::Alarm& alarm : report->alarms) classes.insert(name(alarm.alarm));
      text += "alarm " + std::to_string(report->block);
      for (const std::string_view name : classes) text += " " + std::string(name);
    } else if (auto* end = std::get_if<reference::NotCovered>(item)) {
      text += "not covered " + std::to_string(end->block);
    }
    text += '\n';
  }
  return text;
}

struct Spelled {
  const generate::Generator& generator;
  std::uint32_t spelling;
  generate::GeneratedProgram program;
};

Spelled spelled_program(generate::Choices& choices) {
  const std::uint32_t choice = choices.below(256);
  const auto all = generate::generators();
  const auto dialects = static_cast<std::uint32_t>(all.size());
  const generate::Generator& generator = all[choice % dialects];
  return {generator, choice / dialects % 3, generator.generate(choices, nullptr)};
}

}  // namespace

void fuzz::decide(generate::Choices& choices) {
  spelled_program(choices);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  generate::Choices choices = fuzz::choices_of(data, size);
  const auto [generator, spelling, program] = spelled_program(choices);
  const grammar::Dialect dialect = reference::find_dialect(generator.dialect)->grammar;
  std::string other = spelled(dialect, program.text, spelling);
  if (fuzz::planted_fault() == "line-added") other.insert(0, "\n");
  if (meaning(program.profile, program.text) != meaning(program.profile, other)) {
    fuzz::fail("another spelling means something else: " + other, program.text);
  }
  return 0;
}
