// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program in the other unit of length: every length and feed anew, by 1 inch = 127/5 mm.
#include <algorithm>

#include "fuzz/relations/related_lines.hpp"

namespace gonogo::relations {
namespace {

using reference::Units;

bool is_length(Role role) {
  return role <= Role::step || role == Role::polar_radius || role == Role::lead;
}

// What counts otherwise than its words say, or keeps lengths that are not followed here.
bool keeps_lengths(const Code& code) {
  return code.kind == Kind::rename || code.kind == Kind::reference_point ||
         code.group == Group::tool_length || code.treatment == reference::Treatment::outside;
}

bool is_cycle(const Code& code) {
  return code.kind == Kind::cycle;
}

// An arc's radii may differ by so much, which is another length in inches.
bool is_centre(Role role) {
  return role == Role::centre;
}

bool is_circle(const Code& code) {
  return code.kind == Kind::arc || code.kind == Kind::circle;
}

bool is_lead(Role role) {
  return role == Role::lead;
}

bool is_parameter(Role role) {
  return role == Role::parameter;
}

// A lead that is no length.
bool has_threads_to_the_inch(const ProgramText& text) {
  return std::ranges::any_of(text.blocks, [&](const TextBlock& block) {
    return std::ranges::any_of(block.words, [&](const TextWord& word) {
      const reference::CodeWord* const known = block.role_of(word, *text.table);
      return known != nullptr && is_lead(known->role) && known->address != "F";
    });
  });
}

// How far a cycle in pecks withdraws is a length of the control's. Clauses and readings leave open
// what a length or a feed is in inches.
bool has_open_lengths(const ProgramText& text, std::string_view dialect) {
  if (dialect == "rs274") return any_code(text, is_in_steps) || any_role(text, is_centre);
  if (dialect == "hnc21t") return any_role(text, is_lead);
  if (dialect == "gsk988ta") return has_threads_to_the_inch(text);
  return any_code(text, is_cycle) || any_role(text, is_parameter);
}

// The unit of all blocks that are run. Nothing: there are two, or a feed stands beside the code
// that changes it, where it may be either.
std::optional<bool> only_unit(const ProgramText& text, const Profile& profile) {
  std::optional<bool> inch;
  bool before = profile.units == Units::inch;
  for (const TextBlock& block : text.blocks) {
    if (!is_run(block, profile)) continue;
    const bool changes = block.modes.inch != before;
    if ((inch && *inch != block.modes.inch) || (changes && block.find("F") != nullptr)) {
      return std::nullopt;
    }
    inch = before = block.modes.inch;
  }
  return inch;
}

Number other_unit(const Number& number, bool from_inch) {
  const Number inch = Number(127) / 5;
  return from_inch ? number * inch : number / inch;
}

// Whether the dialect can write the number in a unit. RS274 counts no decimals; more than six are
// below what anybody can tell.
bool fits(const Number& number, bool inch, bool is_rs274) {
  if (!has_room(number)) return false;
  return is_rs274 ? (number * 1'000'000).to_int64().has_value() : is_writable(number, inch);
}

// False where the word cannot be written in the other unit.
bool convert(TextWord& word, bool from_inch, bool is_rs274) {
  const std::optional<Number> value = plain_value(word);
  if (!value || !fits(*value, from_inch, is_rs274)) return false;
  const Number other = other_unit(*value, from_inch);
  if (!fits(other, !from_inch, is_rs274)) return false;
  word.text = with_value(word, other);
  return true;
}

// Whether the number may stand under either unit.
bool is_of_both(const TextWord& word, bool is_rs274) {
  const std::optional<Number> value = plain_value(word);
  return value && fits(*value, false, is_rs274);
}

// Degrees; of feeds that turn, units are a matter of readings.
bool is_rotary(const TextWord& word) {
  const std::string name = name_of(word);
  return name == "A" || name == "C" || name == "H";
}

// The lengths of a machine for a part that is so much larger.
void rescale_machine(Profile& profile, const Number& scale) {
  for (const reference::Axis axis : reference::kLinearAxes) {
    profile.initial.at[axis] = profile.initial.at[axis] * scale;
    for (auto& [name, offset] : profile.offsets) offset[axis] = offset[axis] * scale;
  }
  profile.initial.feed = profile.initial.feed * scale;
}

// With the numbers converted, or the same ones.
std::optional<Related> rewritten(const GeneratedProgram& program, bool converts) {
  const Profile& profile = program.profile;
  ProgramText text(profile, program.text);
  const std::optional<bool> inch = only_unit(text, profile);
  if (!inch || has_unclear_words(text) || is_calculated(text) || has_open_path(text) ||
      any_code(text, keeps_lengths) || has_open_lengths(text, profile.dialect)) {
    return std::nullopt;
  }
  const Code* const other = text.table->find(*inch ? Setting::metric : Setting::inch);
  const Code* const own = text.table->find(*inch ? Setting::inch : Setting::metric);
  if (other == nullptr || own == nullptr) return std::nullopt;
  const bool is_rs274 = profile.dialect == "rs274";
  const bool has_feeds = !profile.dialect.starts_with("sinumerik");
  for (TextBlock& block : text.blocks) {
    if (!is_run(block, profile)) continue;
    for (TextWord& word : block.words) {
      const std::string& name = block.code_of(word);
      const Code* const code = text.table->find(name);
      const bool sets_unit =
          code != nullptr && (code->setting == Setting::inch || code->setting == Setting::metric);
      if (sets_unit && code->name != own->name) return std::nullopt;
      if (sets_unit) word.text = other->name;
      const reference::CodeWord* const known = block.role_of(word, *text.table);
      if (known == nullptr) continue;
      const Role role = known->role;
      const bool turns = is_rotary(word) && (role == Role::place || role == Role::way);
      if (turns) return std::nullopt;
      if (!is_length(role) && !(role == Role::feed && has_feeds)) continue;
      if (converts ? !convert(word, *inch, is_rs274) : !is_of_both(word, is_rs274)) {
        return std::nullopt;
      }
    }
  }
  std::optional<Related> related =
      with_block_before({profile, text.text()}, std::string(other->name));
  if (related) related->feeds = has_feeds ? Feeds::near : Feeds::any;
  return related;
}

}  // namespace

// J-PROP-11
std::optional<Related> in_other_unit(const GeneratedProgram& program) {
  return rewritten(program, true);
}

// Lengths of the machine's own would not be larger; arcs may be off by a length that is one.
std::optional<Related> same_numbers(const GeneratedProgram& program) {
  const Profile& profile = program.profile;
  const ProgramText text(profile, program.text);
  if (!profile.parameters.empty() || any_role(text, is_centre) || any_code(text, is_circle)) {
    return std::nullopt;
  }
  const std::optional<bool> inch = only_unit(text, profile);
  std::optional<Related> related = rewritten(program, false);
  if (!related) return std::nullopt;
  related->scale = other_unit(1, !*inch);
  rescale_machine(related->program.profile, related->scale);
  return related;
}

}  // namespace gonogo::relations
