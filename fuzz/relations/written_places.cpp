// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/relations/written_places.hpp"

#include <algorithm>

namespace gonogo::relations {
namespace {

// Modes that leave coordinates what they are.
bool is_harmless(const Code& code) {
  switch (code.group) {
    case Group::plane:
    case Group::distance:
    case Group::arc_distance:
    case Group::feed_mode:
    case Group::speed:
    case Group::path_mode:
    case Group::exact_stop:
    case Group::retract:
    case Group::spindle:
    case Group::coolant:
      return code.treatment != reference::Treatment::outside;
    default:
      return false;
  }
}

bool moves_plainly(Kind kind) {
  return kind == Kind::traverse || kind == Kind::line || kind == Kind::arc;
}

// Words that a plain motion may have: what is beside them may say more of the end.
bool is_plain_word(const TextWord& word, const TextBlock& block,
                   const reference::Descriptor& table) {
  const reference::CodeWord* const known = block.role_of(word, table);
  if (known == nullptr || !plain_value(word)) return false;
  const Role role = known->role;
  const bool is_m = role == Role::number && known->address == "M";
  return axis_of(word, block, table) || role == Role::radius || role == Role::feed ||
         role == Role::speed || is_m;
}

}  // namespace

// Where no offset can be in force the machine's coordinates are those of the program.
WrittenPlaces::WrittenPlaces(const ProgramText& text, const Profile& profile)
    : text_(text), profile_(profile) {
  if (!profile.offsets.empty() || !profile.parameters.empty()) return;
  for (std::size_t axis = 0; axis < at_.size(); ++axis) {
    Number at = profile.initial.at.at[axis];
    if (profile.units == reference::Units::inch) at = at * 5 / 127;
    at_[axis] = axis == 0 && profile.x_diameter ? at * 2 : at;
  }
}

bool WrittenPlaces::is_plain_motion(const TextBlock& block) const {
  if (block.modes.code() == nullptr || !moves_plainly(block.modes.code()->kind) ||
      has_cut_words(block)) {
    return false;
  }
  std::array<std::size_t, 3> words_along = {};
  return std::ranges::all_of(block.words, [&](const TextWord& word) {
    if (!program::is_word(word)) return true;
    const std::string& name = block.code_of(word);
    const Code* const code = text_.table->find(name);
    if (code == nullptr) {
      const std::optional<EndWord> end = end_word(block, word);
      const bool comes_again = end && ++words_along[end->axis] > 1;
      return !comes_again && is_plain_word(word, block, *text_.table);
    }
    const bool is_motion = code->group == Group::motion && moves_plainly(code->kind);
    return is_motion || is_harmless(*code);
  });
}

// A block that moves nothing and changes no coordinate.
bool WrittenPlaces::is_still(const TextBlock& block) const {
  return std::ranges::all_of(block.words, [&](const TextWord& word) {
    if (!program::is_word(word)) return true;
    const std::string& name = block.code_of(word);
    const Code* const code = text_.table->find(name);
    if (code != nullptr) return code->kind == Kind::dwell || is_harmless(*code);
    const std::string address = address_of(word);
    return address == "F" || address == "S" || (address == "P" && block.modes.is_of(Kind::dwell));
  });
}

std::optional<WrittenPlaces::EndWord> WrittenPlaces::end_word(const TextBlock& block,
                                                              const TextWord& word) const {
  const std::optional<AlongAxis> along = axis_of(word, block, *text_.table);
  if (!along || (along->role != Role::place && along->role != Role::way)) return std::nullopt;
  return EndWord{along->axis, along->role == Role::place && !block.modes.incremental};
}

void WrittenPlaces::take(const TextBlock& block) {
  if (!is_run(block, profile_)) return;
  if (!is_plain_motion(block)) {
    if (!is_still(block)) at_ = {};
    return;
  }
  for (const TextWord& word : block.words) {
    const std::optional<EndWord> end = end_word(block, word);
    if (!end) continue;
    std::optional<Number>& at = at_[end->axis];
    const Number value = plain_value(word).value();
    if (end->is_absolute) {
      at = value;
    } else if (at) {
      at = *at + value;
    }
  }
}

}  // namespace gonogo::relations
