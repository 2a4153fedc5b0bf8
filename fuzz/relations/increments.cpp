// SPDX-License-Identifier: GPL-3.0-or-later
//
// Absolute end points as increments: U V W, or words under G91 between blocks of their own.
#include <algorithm>

#include "fuzz/relations/written_places.hpp"

namespace gonogo::relations {
namespace {

bool has_way_words(const ProgramText& text) {
  return text.table->find(Kind::line)->takes('U');
}

bool has_distance_code(const TextBlock& block, const reference::Descriptor& table) {
  return std::ranges::any_of(block.codes, [&](const std::string& name) {
    const Code* const code = table.find(name);
    return code != nullptr && code->group == Group::distance;
  });
}

// The block with increments for its end point; nothing where one of them is not known.
std::optional<TextBlock> with_increments(const TextBlock& block, const WrittenPlaces& places,
                                         bool by_words) {
  TextBlock other = block;
  bool changes = false;
  for (std::size_t i = 0; i < block.words.size(); ++i) {
    const auto end = places.end_word(block, block.words[i]);
    // A word that is always a way stays one.
    if (!end || !end->is_absolute) continue;
    const std::optional<Number>& at = places.at(end->axis);
    const std::optional<Number> value = plain_value(block.words[i]);
    if (!at || !value) return std::nullopt;
    const Number way = *value - *at;
    if (!is_writable(way, block.modes.inch) || !has_room(way) || !has_room(*value)) {
      return std::nullopt;
    }
    TextWord& word = other.words[i];
    word.text = with_value(word, way);
    if (by_words) word.text.front() = "UVW"[end->axis];
    changes = true;
  }
  if (!changes) return std::nullopt;
  return other;
}

}  // namespace

std::size_t ways_of_increments(const GeneratedProgram& program) {
  const ProgramText text(program.profile, program.text);
  const bool has_mode = text.table->find(Setting::incremental) != nullptr;
  return std::size_t{has_way_words(text)} + std::size_t{has_mode};
}

// J-PROP-11
std::optional<Related> by_increments(const GeneratedProgram& program, std::size_t way) {
  const ProgramText text(program.profile, program.text);
  if (has_unclear_order(text) || has_open_path(text)) return std::nullopt;
  const bool by_words = way == 0 && has_way_words(text);
  const auto code_line = [&](Setting setting) {
    return TextLine{{{"", std::string(text.table->find(setting)->name)}}, "", "\n"};
  };
  WrittenPlaces places(text, program.profile);
  std::vector<TextLine> lines;
  Related related;
  bool changes = false;
  for (const TextBlock& block : text.blocks) {
    const bool may = is_run(block, program.profile) && places.is_plain_motion(block) &&
                     !block.words.front().text.starts_with("/") &&
                     !has_distance_code(block, *text.table);
    const std::optional<TextBlock> other =
        may ? with_increments(block, places, by_words) : std::nullopt;
    places.take(block);
    changes = changes || other.has_value();
    if (other && !by_words) lines.push_back(code_line(Setting::incremental));
    lines.push_back(other ? static_cast<const TextLine&>(*other) : block);
    related.lines.push_back(lines.size());
    // Behind the last line it would be another last line, which an alarm may name.
    if (!other || by_words || &block == &text.blocks.back()) continue;
    lines.push_back(code_line(Setting::absolute));
  }
  if (!changes) return std::nullopt;
  related.program = {program.profile, text_of(lines)};
  return related;
}

}  // namespace gonogo::relations
