// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program mirrored along an axis: places and ways along it change their sign, and arcs turn the
// other way in the planes that hold it.
#include <algorithm>

#include "fuzz/relations/related_lines.hpp"

namespace gonogo::relations {
namespace {

using program::NumberPlace;

// Whether arcs turn the other way. Nothing where they would in some planes only: G2 is modal.
std::optional<bool> swaps_arcs(const ProgramText& text, const Profile& profile, std::size_t axis) {
  std::optional<bool> swaps;
  for (const TextBlock& block : text.blocks) {
    if (block.words.empty() || is_left_out(block, profile)) continue;
    const bool holds_axis = index(axes_of(block.modes.plane).d) != axis;
    if (swaps && *swaps != holds_axis) return std::nullopt;
    swaps = holds_axis;
  }
  return swaps;
}

// Words that have no sign to change, or one that depends on more than is followed here.
bool is_not_followed(Role role) {
  return role == Role::polar_angle || role == Role::polar_radius || role == Role::along_d;
}

// Codes that say more of the place than their words do, or whose way is open.
bool says_more(const Code& code) {
  const bool turns_frame = code.kind == Kind::frame && code.find("X") == nullptr;
  return code.is_open_path || code.kind == Kind::reference_point || code.kind == Kind::rename ||
         code.kind == Kind::pole || turns_frame ||
         (code.kind == Kind::cycle && code.group == Group::once);
}

bool is_along_plane_axis(Role role) {
  return role == Role::along_p || role == Role::along_q;
}

// X5 as X-5, X=R1 as X=-(R1), X=IC(2) as X=IC(-(2)). False where it cannot be read.
bool change_sign(TextWord& word, std::size_t address) {
  std::string& text = word.text;
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    const std::vector<NumberPlace> places = numbers_of(word);
    if (places.size() != 1 || places.front().begin != address ||
        places.front().end != text.size()) {
      return false;
    }
    if (text[address] == '-') {
      text.erase(address, 1);
    } else if (text[address] == '+') {
      text[address] = '-';
    } else {
      text.insert(address, "-");
    }
    return true;
  }
  if (text.back() == '=' || text.find_first_of("\"[$<>;") != std::string::npos) return false;
  std::size_t value = equals + 1;
  const bool is_bracketed = text.size() > value + 2 && (text[value + 1] | 0x20) == 'c' &&
                            text[value + 2] == '(';  // AC(...), IC(...)
  if (!is_bracketed) {
    text.insert(value, "-(");
    text += ")";
    return true;
  }
  if (text.back() != ')') return false;
  text.insert(value + 3, "-(");
  text += ")";
  return true;
}

// SINUMERIK takes the plane of an arc from the axes that it names.
bool names_depth_axis(const TextBlock& block, const reference::Descriptor& table) {
  return std::ranges::any_of(block.words, [&](const TextWord& word) {
    const std::optional<AlongAxis> along = axis_of(word, block, table);
    return along && along->axis == index(axes_of(block.modes.plane).d);
  });
}

void mirror_machine(Profile& profile, std::size_t axis, bool swaps) {
  const auto turn = [&](reference::Position& position) { position.at[axis] = -position.at[axis]; };
  turn(profile.initial.at);
  turn(profile.reference_point);
  for (auto& [name, offset] : profile.offsets) turn(offset);
  const int motion = profile.initial.motion;
  if (swaps && (motion == 2 || motion == 3)) profile.initial.motion = 5 - motion;
}

// Such a code lies in ZX in any plane in force, so that the words along its axes do, too.
bool is_beside_its_plane(const TextBlock& block) {
  return block.modes.in_cycle() && names_own_axes(*block.modes.code()) &&
         block.modes.plane != reference::Plane::g18;
}

}  // namespace

std::optional<Related> mirrored(const GeneratedProgram& program, std::size_t axis) {
  const Profile& profile = program.profile;
  ProgramText text(profile, program.text);
  const reference::Descriptor& table = *text.table;
  const bool has_axis = table.find(Kind::line)->takes("XYZ"[axis]);
  if (!has_axis || has_unclear_words(text)) return std::nullopt;
  if (any_code(text, says_more) || any_role(text, is_not_followed)) return std::nullopt;
  // What a cycle keeps is along the axes of its plane.
  if (any_role(text, is_along_plane_axis) && !only_plane(text, profile)) return std::nullopt;
  const std::optional<bool> swaps = swaps_arcs(text, profile, axis);
  if (!swaps) return std::nullopt;
  const bool is_sinumerik = profile.dialect.starts_with("sinumerik");
  for (TextBlock& block : text.blocks) {
    if (is_left_out(block, profile)) continue;
    if (is_beside_its_plane(block)) return std::nullopt;
    const bool is_arc = block.modes.is_of(Kind::arc);
    if (is_sinumerik && is_arc && names_depth_axis(block, table)) return std::nullopt;
    for (TextWord& word : block.words) {
      const std::optional<AlongAxis> along = axis_of(word, block, table);
      const bool turns = along && along->axis == axis;
      if (turns && !change_sign(word, name_of(word).size())) return std::nullopt;
      const Code* const code = *swaps ? table.find(block.code_of(word)) : nullptr;
      const Code* const opposite = code == nullptr ? nullptr : opposite_of(table, *code);
      if (opposite != nullptr) word.text = opposite->name;
    }
  }
  Related related;
  related.program = {profile, text.text()};
  related.lines = same_lines(text.blocks.size());
  related.mirrored[axis] = true;
  mirror_machine(related.program.profile, axis, *swaps);
  return related;
}

}  // namespace gonogo::relations
