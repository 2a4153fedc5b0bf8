// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/modes.hpp"

#include <algorithm>

#include "fuzz/program/lines.hpp"
#include "reference/dialect.hpp"
#include "reference/rs274/whole.hpp"

namespace gonogo::program {
namespace {

using reference::Code;
using reference::Group;
using reference::Kind;
using reference::Plane;
using reference::Setting;

// Codes of RS274 that are nearly whole are those that they count as (ngc.whole).
std::string whole_code(const TextWord& word, const reference::ReadingsInUse& readings) {
  using reference::rs274::NearWhole;
  using reference::rs274::Whole;
  const std::string code = code_of(word);
  const std::string address = address_of(word);
  if (code.empty() || (address != "G" && address != "M")) return code;
  const bool is_g = address == "G";
  const exact::Number parts = is_g ? 10 : 1;
  const auto value = exact_value_of(word);
  if (!value) return code;
  const NearWhole number(*value * parts);
  const Whole what = is_g ? Whole::g_tenths : Whole::m_function;
  if (number.is_whole() || !number.counts_as_whole(what, readings)) return code;
  return address + (number.nearest() / parts).text();
}

// The modes as the blocks change them.
class Modes {
 public:
  Modes(const reference::Profile& profile, const reference::Descriptor& table) {
    const int motion = profile.initial.motion;
    if (motion != reference::kNoMotion) now_.motion = table.find("G" + std::to_string(motion));
    now_.plane = profile.initial.plane;
    now_.inch = profile.units == reference::Units::inch;
    now_.x_radius = !profile.x_diameter;
  }
  BlockModes take(const TextBlock& block, const reference::Descriptor& table);

 private:
  void take(const Code& code);
  BlockModes now_;
};

void Modes::take(const Code& code) {
  switch (code.setting) {
    case Setting::plane_xy:
    case Setting::plane_zx:
    case Setting::plane_yz:
      now_.plane =
          static_cast<Plane>(static_cast<int>(code.setting) - static_cast<int>(Setting::plane_xy));
      break;
    case Setting::inch:
    case Setting::metric:
      now_.inch = code.setting == Setting::inch;
      break;
    case Setting::diameter:
    case Setting::radius:
      now_.x_radius = code.setting == Setting::radius;
      break;
    case Setting::absolute:
    case Setting::incremental:
      now_.incremental = code.setting == Setting::incremental;
      break;
    case Setting::absolute_centre:
    case Setting::incremental_centre:
      now_.absolute_centre = code.setting == Setting::absolute_centre;
      break;
    case Setting::inverse_time:
    case Setting::none:
      break;
  }
  if (code.group == reference::Group::feed_mode) {
    now_.inverse_time = code.setting == Setting::inverse_time;
  }
}

BlockModes Modes::take(const TextBlock& block, const reference::Descriptor& table) {
  now_.own = nullptr;
  for (const std::string& name : block.codes) {
    const Code* const code = table.find(name);
    if (code == nullptr || code->treatment == reference::Treatment::outside) continue;
    take(*code);
    // Beside a motion the end of a cycle is no more than that.
    const bool is_beside = code->kind == Kind::off && now_.own != nullptr;
    if (code->kind == Kind::mode || code->is_m() || is_beside) continue;
    now_.own = code;
    if (code->group != Group::once) now_.motion = code;
  }
  const auto is_of_motion = [&](const TextWord& word) {
    const std::string name = name_of(word);
    const reference::CodeWord* const role = now_.motion->find(name);
    return role != nullptr && role->role == reference::Role::place && !now_.own->find(name);
  };
  now_.moves_beside = now_.own != nullptr && now_.own->kind == Kind::dwell &&
                      now_.motion != nullptr && std::ranges::any_of(block.words, is_of_motion);
  return now_;
}

}  // namespace

bool BlockModes::in_thread() const {
  const reference::CodeWord* const feed = code() == nullptr ? nullptr : code()->find("F");
  return feed != nullptr && feed->role == reference::Role::lead;
}

const TextWord* TextBlock::find(std::string_view name) const {
  const auto found =
      std::ranges::find_if(words, [&](const TextWord& word) { return name_of(word) == name; });
  return found == words.end() ? nullptr : &*found;
}

bool TextBlock::has_code(std::string_view code) const {
  return std::ranges::find(codes, code) != codes.end();
}

const reference::CodeWord* TextBlock::role_of(const TextWord& word,
                                              const reference::Descriptor& table) const {
  const std::string name = name_of(word);
  if (modes.own != nullptr) {
    if (const auto* const role = modes.own->find(name)) return role;
  }
  return table.find_word(modes.motion == nullptr ? table.find(Kind::line) : modes.motion, name);
}

ProgramText::ProgramText(const reference::Profile& profile, std::string_view program)
    : table(reference::find_dialect(profile.dialect)->descriptor) {
  const reference::ReadingsInUse readings(profile.readings);
  const bool has_near_codes = profile.dialect == "rs274";
  Modes modes(profile, *table);
  for (TextLine& line : lines_of(program)) {
    TextBlock& block = blocks.emplace_back();
    static_cast<TextLine&>(block) = std::move(line);
    const bool is_unread = is_left_out(block, profile);
    for (const TextWord& word : block.words) {
      block.codes.push_back(is_unread        ? std::string()
                            : has_near_codes ? whole_code(word, readings)
                                             : program::code_of(word));
    }
    block.modes = modes.take(block, *table);
  }
}

std::string ProgramText::text() const {
  std::string text;
  for (const TextBlock& block : blocks) text += line_text(block);
  return text;
}

bool is_left_out(const TextLine& line, const reference::Profile& profile) {
  return profile.block_skip && !line.words.empty() && line.words.front().text.front() == '/';
}

}  // namespace gonogo::program
