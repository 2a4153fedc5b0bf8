// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/in_force.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <vector>

#include "fuzz/program/modes.hpp"
#include "reference/descriptor.hpp"

namespace gonogo::program {
namespace {

using reference::Code;
using reference::Group;
using reference::Holds;
using reference::Kind;
using reference::Role;

std::string shown(reference::ClauseId clause) {
  return clause == reference::kNoClause ? std::string()
                                        : fmt::format(" ({})", reference::clause_name(clause));
}

class InForce {
 public:
  InForce(const reference::Profile& profile, const ProgramText& program, std::size_t at)
      : profile_(profile), program_(program), at_(at), block_(program.blocks[at]) {}

  std::string text() {
    add_motion();
    add_words();
    add_modes();
    return fmt::format("{}", fmt::join(parts_, "; "));
  }

 private:
  // The code that the block repeats, and where it was given.
  void add_motion() {
    const Code* const code = block_.modes.motion;
    const bool repeats = block_.modes.own == nullptr || block_.modes.moves_beside;
    if (!repeats || code == nullptr || !names_something()) return;
    for (std::size_t i = at_; i-- > 0;) {
      if (program_.blocks[i].modes.own != code) continue;
      add(std::string(code->name), i, shown(table().clause_of_holding(Holds::motion, *code)));
      return;
    }
  }

  const reference::Descriptor& table() const { return *program_.table; }

  bool names_something() const { return std::ranges::any_of(block_.words, is_word); }

  // Along an axis of the plane a hole has a place of its own.
  bool is_of_hole_place(const reference::CodeWord& word, const std::string& name) const {
    const Code& code = *block_.modes.moving();
    const reference::CodeWord* const level = code.find("R");
    const bool is_hole = level != nullptr && level->role == Role::along_d;
    constexpr std::string_view kDepths[] = {"Z", "Y", "X"};
    const std::string_view depth = kDepths[static_cast<std::size_t>(block_.modes.plane)];
    return is_hole && word.role == Role::place && name != depth;
  }

  // Words of the code in force that an earlier block of it gave and this one lacks.
  void add_words() {
    const Code* const code = block_.modes.moving();
    if (code == nullptr || code->kind != Kind::cycle || !names_something()) return;
    std::set<std::string> seen;
    for (const TextWord& word : block_.words) seen.insert(name_of(word));
    for (std::size_t i = at_; i-- > 0;) {
      const TextBlock& before = program_.blocks[i];
      if (before.modes.motion != code) break;
      if (before.modes.moving() != code) continue;
      std::vector<std::string> words;
      for (const TextWord& word : before.words) {
        const std::string name = name_of(word);
        const reference::CodeWord* const role = code->find(name);
        const bool holds = role != nullptr && role->life == reference::Life::modal &&
                           !is_of_hole_place(*role, name);
        if (holds && seen.insert(name).second) words.push_back(word.text);
      }
      if (words.empty()) continue;
      add(fmt::format("{}", fmt::join(words, " ")), i,
          shown(table().clause_of_holding(Holds::words, *code)));
    }
  }

  bool matters(Group group) const {
    const Code* const code = block_.modes.moving();
    if (group == Group::arc_distance) return code != nullptr && code->kind == Kind::arc;
    if (group == Group::retract) return code != nullptr && code->kind == Kind::cycle;
    return group == Group::units || group == Group::distance || group == Group::plane ||
           group == Group::diameter || group == Group::feed_mode;
  }

  bool is_of_power_on(const Code& code) const {
    const bool is_plane = code.setting >= reference::Setting::plane_xy &&
                          code.setting <= reference::Setting::plane_yz;
    if (!is_plane) return code.is_initial;
    const auto plane =
        static_cast<int>(code.setting) - static_cast<int>(reference::Setting::plane_xy);
    return plane == static_cast<int>(profile_.initial.plane);
  }

  // The last code of each group, where it is not that of power-on.
  void add_modes() {
    std::set<Group> seen;
    for (std::size_t i = at_ + 1; i-- > 0;) {
      for (const std::string& name : program_.blocks[i].codes) {
        const Code* const code = program_.table->find(name);
        if (code == nullptr || code->kind != Kind::mode || !matters(code->group)) continue;
        if (!seen.insert(code->group).second || i == at_ || is_of_power_on(*code)) continue;
        add(std::string(code->name), i, shown(table().clause_of_holding(Holds::mode, *code)));
      }
    }
  }

  void add(const std::string& what, std::size_t at, const std::string& clause) {
    parts_.push_back(fmt::format("{} of line {}{}", what, at + 1, clause));
  }

  const reference::Profile& profile_;
  const ProgramText& program_;
  std::size_t at_;
  const TextBlock& block_;
  std::vector<std::string> parts_;
};

}  // namespace

std::string in_force_text(const reference::Profile& profile, std::string_view program,
                          std::uint64_t line) {
  if (line == 0 || program.size() > kLongestShown) return {};
  const ProgramText text(profile, program);
  if (line > text.blocks.size()) return {};
  return InForce(profile, text, line - 1).text();
}

}  // namespace gonogo::program
