// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/relations/relation.hpp"

#include <algorithm>

#include "fuzz/relations/related_lines.hpp"
#include "reference/power_on.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::relations {
namespace {

using program::lines_of;

// So many variants of every program.
template <std::size_t kCount>
std::size_t always(const GeneratedProgram&) {
  return kCount;
}
// The one variant of a relation that has no more.
template <std::optional<Related> (*kRelate)(const GeneratedProgram&)>
std::optional<Related> only(const GeneratedProgram& program, std::size_t) {
  return kRelate(program);
}

std::optional<Related> again(const GeneratedProgram& program) {
  Related related;
  related.program = program;
  related.lines = same_lines(lines_of(program.text).size());
  return related;
}

// Lines of the tape, names and numbers of programs and blocks have rules of their own.
bool is_head(const TextLine& line) {
  return line.words.empty() || line.words.front().text.find_first_of("%O:/") == 0;
}

// Words that are an address and a number. T0101 is not T101 everywhere, and names of programs,
// codes and R parameters have spellings of their own.
void add_zeros(TextWord& word, bool is_assigned_to) {
  const std::string address = address_of(word);
  const bool is_name = address == "T" || address == "L" || address == "N" || address == "R";
  if (address.empty() || is_name || is_assigned_to || !code_of(word).empty()) return;
  const std::vector<program::NumberPlace> places = numbers_of(word);
  if (places.size() != 1 || places.front().begin != address.size() ||
      places.front().end != word.text.size()) {
    return;
  }
  const bool has_sign = word.text[address.size()] == '-' || word.text[address.size()] == '+';
  word.text.insert(address.size() + (has_sign ? 1 : 0), "00");
}

void add_zeros(std::vector<TextWord>& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool is_assigned_to = i + 1 < words.size() && words[i + 1].text.starts_with("=");
    add_zeros(words[i], is_assigned_to);
  }
}

// CR LF, blanks, leading zeros, comments at the ends of lines.
std::optional<Related> spelled(const GeneratedProgram& program, std::size_t variant) {
  std::vector<TextLine> lines = lines_of(program.text);
  for (TextLine& line : lines) {
    if (variant == 0 && line.end == "\n") line.end = "\r\n";
    if (is_head(line)) continue;
    const bool has_comment = line.words.back().text.find_first_of(";(") != std::string::npos;
    if (variant == 1) {
      for (TextWord& word : line.words) word.gap += " \t";
    } else if (variant == 2) {
      add_zeros(line.words);
    } else if (variant == 3 && !has_comment) {
      line.rest += " ;X1 is no word here";
    }
  }
  Related related;
  related.program = {program.profile, text_of(lines)};
  related.lines = same_lines(lines.size());
  return related;
}

// A line without words and one with a comment alone, behind every line but the last, which may be
// the one that alarms where an end is missing.
std::optional<Related> spread(const GeneratedProgram& program) {
  const std::vector<TextLine> lines = lines_of(program.text);
  Related related;
  std::vector<TextLine> wide;
  for (const TextLine& line : lines) {
    wide.push_back(line);
    related.lines.push_back(wide.size());
    if (line.end.empty() || is_head(line) || related.lines.size() == lines.size()) continue;
    wide.push_back({{}, "", line.end});
    wide.push_back({{}, ";", line.end});
  }
  related.program = {program.profile, text_of(wide)};
  return related;
}

std::size_t cuts(const GeneratedProgram& program) {
  const std::size_t lines = lines_of(program.text).size();
  return lines < 2 ? 0 : lines - 1;
}

std::optional<Related> cut_short(const GeneratedProgram& program, std::size_t variant) {
  // Such a control reads the whole program before it moves.
  if (program.profile.alarm_timing == reference::AlarmTiming::program) return std::nullopt;
  std::vector<TextLine> lines = lines_of(program.text);
  Related related;
  related.lines = same_lines(variant + 1);
  related.lines.resize(lines.size(), 0);
  lines.resize(variant + 1);
  related.program = {program.profile, text_of(lines)};
  if (program.profile.dialect == "rs274") {
    // What is cut off is the end, without which some alarm.
    related.program.profile.readings.set("ngc.program-end=free"_reading);
  }
  related.is_beginning = true;
  return related;
}

// The modes of power-on, said again before the first block.
std::string modes_of(const Profile& profile) {
  std::string block;
  for (const Code* code : reference::power_on_codes(profile)) {
    if (code->kind != Kind::mode) continue;
    block += (block.empty() ? "" : " ") + std::string(code->name);
  }
  return block;
}

std::optional<Related> with_modes(const GeneratedProgram& program) {
  return with_block_before(program, modes_of(program.profile));
}

// J-PROP-11
std::optional<Related> converted(const GeneratedProgram& program, std::size_t variant) {
  return variant == 0 ? in_other_unit(program) : same_numbers(program);
}

// J-PROP-11
std::optional<Related> in_plane(const GeneratedProgram& program, std::size_t variant) {
  return in_other_plane(program, variant + 1);
}

constexpr auto kRelations = std::to_array<Relation>({
    {.name = "again",
     .sentence = "A program does the same when it is run once more.",
     .variants = &always<1>,
     .relate = &only<again>},
    {.name = "spelling",
     .sentence = "Ends of lines, blanks, leading zeros and comments change nothing.",
     .variants = &always<4>,
     .relate = &spelled},
    {.name = "empty-lines",
     .sentence = "Lines without words change nothing.",
     .variants = &always<1>,
     .relate = &only<spread>},
    {.name = "beginning",
     .sentence = "A block does the same, whichever blocks follow it.",
     .needs_lines = true,
     .variants = &cuts,
     .relate = &cut_short},
    {.name = "modes-again",
     .sentence = "The modes of power-on, written before the program, change nothing.",
     .variants = &always<1>,
     .relate = &only<with_modes>},
    {.name = "translation",
     .sentence = "A program that is moved as a whole does the same there.",
     .exact = false,
     .variants = &always<1>,
     .relate = &only<translated>},
    {.name = "mirror",
     .sentence = "A program that is mirrored along an axis does the same there.",
     .exact = false,
     .variants = &always<3>,
     .relate = &mirrored},
    {.name = "units",
     .sentence = "A program in the other unit of length does the same, and with the same "
                 "numbers 127/5 times as much.",
     .exact = false,
     .variants = &always<2>,
     .relate = &converted},
    {.name = "planes",
     .sentence = "A program with its axes and planes changed in a cycle does the same there.",
     .exact = false,
     .variants = &always<2>,
     .relate = &in_plane},
    {.name = "increments",
     .sentence = "End points do the same as the increments that lead to them.",
     .exact = false,
     .variants = &ways_of_increments,
     .relate = &by_increments},
    {.name = "halves",
     .sentence = "A straight motion does the same as its two halves.",
     .exact = false,
     .needs_lines = true,
     .variants = &always<1>,
     .relate = &only<in_halves>},
    {.name = "repeats",
     .sentence = "A block that makes several holes does the same as a block for each.",
     .exact = false,
     .variants = &always<1>,
     .relate = &only<unrolled>},
});

}  // namespace

std::span<const Relation> relations() {
  return kRelations;
}

const Relation* find_relation(std::string_view name) {
  const auto found = std::ranges::find(relations(), name, &Relation::name);
  return found == relations().end() ? nullptr : &*found;
}

}  // namespace gonogo::relations
