// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program in another plane: X, Y and Z, and what lies along them, changed in a cycle. A plane's
// axes and its depth axis stay a right-handed triple, so that arcs turn as they did.
#include <algorithm>

#include "fuzz/relations/related_lines.hpp"

namespace gonogo::relations {
namespace {

// Codes that know axes by their names, or places that are not in the program.
bool knows_axes(const Code& code) {
  const bool holds_once = code.kind == Kind::mode && code.group == Group::once;
  return holds_once || names_own_axes(code) || code.kind == Kind::rename ||
         code.kind == Kind::reference_point || code.group == Group::tool_length;
}

bool is_plane(Setting setting) {
  return setting >= Setting::plane_xy && setting <= Setting::plane_yz;
}

std::string code_of(reference::Plane plane) {
  return "G" + std::to_string(plane_code(plane));
}

// NGC-POL-01: @ and ^ say X and Y in every plane.
bool has_words_of_xy(const ProgramText& text) {
  return std::ranges::any_of(text.blocks, [](const TextBlock& block) {
    return block.find("@") != nullptr || block.find("^") != nullptr;
  });
}

// X of a lathe is a diameter; elsewhere the word is the same number. False where it cannot be read.
bool rescale(TextWord& word, const Number& factor, bool inch) {
  const std::optional<Number> value = plain_value(word);
  if (!value || !is_writable(*value, inch) || !has_room(*value)) return false;
  if (!is_writable(*value * factor, inch)) return false;
  word.text = with_value(word, *value * factor);
  return true;
}

// The word along the axis it is turned to. False where it cannot be written.
bool turn_word(TextWord& word, const AlongAxis& along, std::size_t turns, bool x_diameter,
               bool inch) {
  std::string_view letters = "XYZ";
  if (along.role == Role::way) letters = "UVW";
  if (along.role == Role::centre || along.role == Role::middle) letters = "IJK";
  const std::size_t to = (along.axis + turns) % 3;
  word.text.front() = letters[to];
  if (!x_diameter || (along.role != Role::place && along.role != Role::way)) return true;
  if (along.axis == 0) return rescale(word, Number(1) / 2, inch);
  return to != 0 || rescale(word, 2, inch);
}

bool is_of_axis(Role role) {
  return role <= Role::middle;
}

}  // namespace

reference::Position turned(const reference::Position& position, std::size_t turns) {
  reference::Position other = position;
  for (std::size_t axis = 0; axis < 3; ++axis) other.at[(axis + turns) % 3] = position.at[axis];
  return other;
}

reference::Plane turned(reference::Plane plane, std::size_t turns) {
  return static_cast<reference::Plane>((static_cast<std::size_t>(plane) + 2 * turns) % 3);
}

// J-PROP-11
std::optional<Related> in_other_plane(const GeneratedProgram& program, std::size_t turns) {
  const Profile& profile = program.profile;
  ProgramText text(profile, program.text);
  const reference::Descriptor& table = *text.table;
  const bool has_planes = table.find(Kind::line)->takes('Y');
  if (!has_planes || has_unclear_words(text) || is_calculated(text) || has_open_path(text) ||
      has_words_of_xy(text) || any_code(text, knows_axes)) {
    return std::nullopt;
  }
  for (TextBlock& block : text.blocks) {
    if (is_left_out(block, profile)) continue;
    for (TextWord& word : block.words) {
      const Code* const code = table.find(block.code_of(word));
      if (code != nullptr && is_plane(code->setting)) {
        word.text = code_of(turned(block.modes.plane, turns));
        continue;
      }
      const std::optional<AlongAxis> along = axis_of(word, block, table);
      if (!along || !is_of_axis(along->role)) continue;
      if (!turn_word(word, *along, turns, profile.x_diameter, block.modes.inch))
        return std::nullopt;
    }
  }
  std::optional<Related> related =
      with_block_before({profile, text.text()}, code_of(turned(profile.initial.plane, turns)));
  if (!related) return std::nullopt;
  related->turned = turns;
  Profile& other = related->program.profile;
  other.initial.at = turned(other.initial.at, turns);
  for (auto& [name, offset] : other.offsets) offset = turned(offset, turns);
  return related;
}

}  // namespace gonogo::relations
