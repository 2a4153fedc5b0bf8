// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program moved as a whole. Where the dialect has frames or work offsets, what stands in the
// blocks stays as it is; elsewhere the absolute words are written anew.
#include <algorithm>
#include <cctype>

#include "fuzz/relations/related_lines.hpp"
#include "reference/dialect.hpp"

namespace gonogo::relations {
namespace {

using program::NumberPlace;
using program::SmallDecimal;
using reference::Axis;
using reference::Units;

// How far, along X, Y, Z: whole inches, so that words in inches have no more decimals than before.
constexpr std::array<std::int64_t, 3> kInches = {1, -2, 3};
constexpr std::int64_t kTenthsAnInch = 254;

using Way = std::array<bool, 3>;  // the axes along which the program is moved

void move_places(const Way& way, Profile& profile, Related& related) {
  for (std::size_t axis = 0; axis < way.size(); ++axis) {
    if (!way[axis]) continue;
    related.shift[axis] = Number::millionths(kInches[axis] * kTenthsAnInch * 100'000);
    profile.initial.at.at[axis] += related.shift[axis];
  }
}

// The distance in the unit of the words: value / 10^scale.
SmallDecimal distance(std::size_t axis, bool inch) {
  return inch ? SmallDecimal{kInches[axis], 0} : SmallDecimal{kInches[axis] * kTenthsAnInch, 1};
}

// With all its decimals, which some controls count.
std::string full_text(const SmallDecimal& number, int scale) {
  std::string digits = std::to_string(number.value < 0 ? -number.value : number.value);
  const auto decimals = static_cast<std::size_t>(scale);
  while (digits.size() <= decimals) digits.insert(0, "0");
  if (decimals > 0) digits.insert(digits.size() - decimals, ".");
  return (number.value < 0 ? "-" : "") + digits;
}

// Adds to the number of a word. False where it cannot be read.
bool add(TextWord& word, const SmallDecimal& step) {
  // Words near the ends of their ranges have no room.
  constexpr std::int64_t kMost = 9'000;
  const std::vector<NumberPlace> places = numbers_of(word);
  if (places.size() != 1 || places.front().end != word.text.size()) return false;
  const SmallDecimal& number = places.front().number;
  const auto [value, added] = same_scale(number, step);
  const auto [most, size] = same_scale({kMost, 0}, number);
  if (size > most || size < -most) return false;
  const int scale = std::max(number.scale, step.scale);
  const SmallDecimal sum{value + added, scale};
  word.text.replace(places.front().begin, std::string::npos, full_text(sum, scale));
  return true;
}

// What stands behind the = of a word, in capitals; of a word without one all of it.
std::string value_text(const TextWord& word) {
  std::string value = word.text.substr(word.text.find('=') + 1);  // npos + 1 is 0
  std::ranges::transform(value, value.begin(), [](unsigned char c) { return std::toupper(c); });
  return value;
}

// Adds to the value of a word of SINUMERIK: X10, X=R1+2, X=AC(3). False where it cannot be read.
bool add_to_expression(TextWord& word, const SmallDecimal& step) {
  std::string& text = word.text;
  if (text.find('=') == std::string::npos) return add(word, step);
  const std::string added = "+(" + step.text() + ")";
  if (text.back() == '=' || text.find_first_of("\"[$<>") != std::string::npos) return false;
  const std::string value = value_text(word);
  const bool is_absolute = value.starts_with("AC(");
  if (value.starts_with("IC(") || (value.starts_with("AC") && !is_absolute)) return false;
  if (is_absolute && text.back() != ')') return false;
  text.insert(is_absolute ? text.size() - 1 : text.size(), added);
  return true;
}

Related moved_text(const GeneratedProgram& program, const Way& way, const ProgramText& text) {
  Related related;
  related.program = {program.profile, text.text()};
  related.lines = same_lines(text.blocks.size());
  move_places(way, related.program.profile, related);
  const auto refers = [](const Code& code) { return code.kind == Kind::reference_point; };
  if (!any_code(text, refers)) return related;
  for (std::size_t axis = 0; axis < way.size(); ++axis) {
    related.program.profile.reference_point.at[axis] += related.shift[axis];
  }
  return related;
}

// Whether the value of the word is a place, and not a way: by the mode in force, or by AC and IC.
bool is_place(const TextWord& word, Role role, const program::BlockModes& modes) {
  const std::string value = value_text(word);
  if (value.starts_with("AC")) return true;
  if (value.starts_with("IC") || role == Role::way) return false;
  return role == Role::centre ? modes.absolute_centre : !modes.incremental;
}

bool is_polar(Role role) {
  return role == Role::polar_angle || role == Role::polar_radius;
}

bool puts_pole(const Code& code) {
  return code.kind == Kind::pole;
}

// A tool length moves all places by the same.
bool renames(const Code& code) {
  return code.kind == Kind::rename && code.group != Group::tool_length;
}

bool is_along_depth(Role role) {
  return role == Role::along_d;
}

// The absolute words are written anew. In cycles with words along the depth axis that axis stays.
// Poles at the workpiece zero, as they are after a plane code, stay there: no polar words.
std::optional<Related> translated_words(const GeneratedProgram& program) {
  const Profile& profile = program.profile;
  ProgramText text(profile, program.text);
  if (has_unclear_words(text) || any_role(text, is_polar) || any_code(text, puts_pole) ||
      any_code(text, renames)) {
    return std::nullopt;
  }
  Way way = {true, true, true};
  if (any_role(text, is_along_depth)) {
    const auto plane = only_plane(text, profile);
    if (!plane) return std::nullopt;
    way[index(axes_of(*plane).d)] = false;
  }
  for (TextBlock& block : text.blocks) {
    if (is_left_out(block, profile)) continue;
    for (TextWord& word : block.words) {
      const std::optional<AlongAxis> along = axis_of(word, block, *text.table);
      const bool is_moved = along && along->role <= Role::middle && way[along->axis];
      if (!is_moved || !is_place(word, along->role, block.modes)) continue;
      SmallDecimal step = distance(along->axis, block.modes.inch);
      if (along->axis == 0 && profile.x_diameter && along->role == Role::place) step.value *= 2;
      if (!add_to_expression(word, step)) return std::nullopt;
    }
  }
  return moved_text(program, way, text);
}

// By the work offsets along X and Z; the first of them stands before the program, where it makes no
// difference otherwise.
std::optional<Related> translated_by_offset(const GeneratedProgram& program,
                                            const reference::Dialect& dialect) {
  const std::string first(dialect.offsets.front());
  const auto own = program.profile.offsets.find(first);
  if (own != program.profile.offsets.end() && own->second != reference::Position{}) {
    return std::nullopt;
  }
  std::optional<Related> related = with_block_before(program, first);
  if (!related) return std::nullopt;
  Profile& profile = related->program.profile;
  move_places({true, false, true}, profile, *related);
  for (const std::string_view name : dialect.offsets) {
    for (const Axis axis : {Axis::x, Axis::z}) {
      profile.offsets[std::string(name)][axis] += related->shift[index(axis)];
    }
  }
  return related;
}

bool moves_frame(const Code& code) {
  return code.kind == Kind::frame || code.group == Group::frame || code.group == Group::offset;
}

bool is_bare_g(const TextWord& word) {
  return word.text == "G" || word.text == "g";
}

// SIE-FRM-06: whether an increment goes the translation, too, is open.
bool has_increments(const ProgramText& text) {
  const auto adds = [](const TextWord& word) { return value_text(word).starts_with("IC"); };
  return std::ranges::any_of(text.blocks, [&](const TextBlock& block) {
    return block.modes.incremental || std::ranges::any_of(block.words, adds);
  });
}

std::optional<Related> translated_by_frame(const GeneratedProgram& program, const Code& frame) {
  const ProgramText text(program.profile, program.text);
  const bool has_bare_g = std::ranges::any_of(text.blocks, [](const TextBlock& block) {
    return std::ranges::any_of(block.words, is_bare_g);
  });
  if (has_bare_g || any_code(text, moves_frame)) return std::nullopt;
  const auto calls_cycle = [](const Code& code) { return code.kind == Kind::cycle; };
  if (has_increments(text)) {
    // The levels of a cycle are parameters, which stay.
    return any_code(text, calls_cycle) ? std::nullopt : translated_words(program);
  }
  std::string block(frame.name);
  for (std::size_t axis = 0; axis < kInches.size(); ++axis) {
    block += std::string(" ") + "XYZ"[axis] +
             distance(axis, program.profile.units == Units::inch).text();
  }
  std::optional<Related> related = with_block_before(program, block);
  if (related) move_places({true, true, true}, related->program.profile, *related);
  return related;
}

}  // namespace

std::optional<Related> translated(const GeneratedProgram& program) {
  const reference::Dialect& dialect = *reference::find_dialect(program.profile.dialect);
  const reference::Descriptor& table = *dialect.descriptor;
  const Code* const frame = table.find(Kind::frame);
  if (frame != nullptr) return translated_by_frame(program, *frame);
  const Code* const offset =
      dialect.offsets.empty() ? nullptr : table.find(dialect.offsets.front());
  // Not where a subject need not know more than the first of them.
  const Code* const second = dialect.offsets.size() < 2 ? nullptr : table.find(dialect.offsets[1]);
  if (offset != nullptr && offset->treatment == reference::Treatment::read && second != nullptr &&
      second->feature == offset->feature) {
    return translated_by_offset(program, dialect);
  }
  return translated_words(program);
}

}  // namespace gonogo::relations
