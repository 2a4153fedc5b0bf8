// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traverses along one axis and straight feeds, each in two halves: the same path in pieces
// (R1).
#include <algorithm>

#include "fuzz/relations/written_places.hpp"

namespace gonogo::relations {
namespace {

struct Halves {
  TextLine first;
  TextLine second;
};

// What a block may have so that nothing but its motion comes twice.
bool has_only(const TextBlock& block, std::string_view letters) {
  return std::ranges::all_of(block.words, [&](const TextWord& word) {
    if (!program::is_word(word)) return word.text != "/";
    const std::string name = name_of(word);
    return !block.code_of(word).empty() ||
           (name.size() == 1 && letters.find(name.front()) != std::string_view::npos);
  });
}

// The middle of the motion as its word says it, and how far it goes. Nothing: it cannot be written.
struct Middle {
  Number word;
  Number way;
};
std::optional<Middle> middle_of(const Number& value, const std::optional<Number>& start,
                                bool is_absolute, bool inch) {
  if (is_absolute && !start) return std::nullopt;
  const Number from = is_absolute ? *start : Number(0);
  const Middle middle{(from + value) / 2, value - from};
  if (!is_writable(middle.word, inch)) return std::nullopt;
  return middle;
}

std::optional<Halves> halves_of(const TextBlock& block, const WrittenPlaces& places) {
  const bool is_traverse = block.modes.is_of(Kind::traverse);
  if ((!is_traverse && !block.modes.is_of(Kind::line)) || !has_only(block, "XYZUVWFS")) {
    return std::nullopt;
  }
  Halves halves{static_cast<const TextLine&>(block),
                {{{"", std::string(block.modes.code_name())}}, "", block.end}};
  std::size_t axes = 0;
  bool moves = false;
  for (std::size_t i = 0; i < block.words.size(); ++i) {
    const auto end = places.end_word(block, block.words[i]);
    if (!end) continue;
    ++axes;
    const Number value = plain_value(block.words[i]).value();
    const auto middle = middle_of(value, places.at(end->axis), end->is_absolute, block.modes.inch);
    if (!middle) return std::nullopt;
    // Less may be too small to be a motion.
    const Number least = Number::decimal(false, 1, 1);
    moves = moves || abs(middle->way) >= least;
    TextWord& first = halves.first.words[i];
    first.text = with_value(first, middle->word);
    TextWord second = end->is_absolute ? block.words[i] : first;
    second.gap = " ";
    halves.second.words.push_back(second);
  }
  if (!moves || (is_traverse && axes != 1)) return std::nullopt;
  if (halves.first.end.empty()) halves.first.end = "\n";
  return halves;
}

// Its records go on in other coordinates, so that they do not say where a motion begins.
bool names_anew(const Code& code) {
  return code.kind == Kind::rename;
}

}  // namespace

// J-PROP-11
std::optional<Related> in_halves(const GeneratedProgram& program) {
  const ProgramText text(program.profile, program.text);
  if (has_unclear_order(text) || has_open_path(text) || any_code(text, names_anew)) {
    return std::nullopt;
  }
  WrittenPlaces places(text, program.profile);
  Related related;
  std::vector<TextLine> lines;
  for (const TextBlock& block : text.blocks) {
    const bool may = is_run(block, program.profile) && places.is_plain_motion(block);
    const std::optional<Halves> halves = may ? halves_of(block, places) : std::nullopt;
    places.take(block);
    lines.push_back(halves ? halves->first : block);
    const std::uint64_t line = lines.size();
    related.lines.push_back(line);
    related.counts_as.push_back(line);
    if (!halves) continue;
    lines.push_back(halves->second);
    related.counts_as.push_back(line);
    related.halved.push_back(related.lines.size());
  }
  if (related.halved.empty()) return std::nullopt;
  related.program = {program.profile, text_of(lines)};
  return related;
}

}  // namespace gonogo::relations
