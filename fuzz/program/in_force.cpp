// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/in_force.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <span>
#include <vector>

#include "fuzz/program/modes.hpp"
#include "reference/clause_literal.hpp"

namespace gonogo::program {
namespace {

using reference::Code;
using reference::Group;
using reference::Kind;
using reference::Role;
using reference::operator""_clause;

constexpr std::size_t kLongestProgram = 100'000;  // bytes

// What says that words or a code hold.
struct Holding {
  std::string_view dialect;
  std::string_view what;  // what codes begin with; empty: every code
  reference::ClauseId clause;
};
constexpr Holding kWords[] = {
    {"rs274", "", "NGC-CYC-03"_clause},        {"gsk988ta", "G90", "GSK-G90-06"_clause},
    {"gsk988ta", "G92", "GSK-G92-06"_clause},  {"gsk988ta", "G94", "GSK-G94-06"_clause},
    {"gsk988ta", "G11", "GSK-G110-02"_clause}, {"hnc21t", "", "HNC-MOD-01"_clause}};
constexpr Holding kMotions[] = {
    {"rs274", "", "NGC-MOD-01"_clause},        {"gsk988ta", "G90", "GSK-G90-06"_clause},
    {"gsk988ta", "G92", "GSK-G92-06"_clause},  {"gsk988ta", "G94", "GSK-G94-06"_clause},
    {"hnc21t", "", "HNC-MOD-02"_clause},       {"sinumerik840d", "", "SIE-MOD-01"_clause},
    {"sinumerik802s", "", "SIE-MOD-01"_clause}};
struct ModeHolding {
  std::string_view dialect;
  Group group;
  reference::ClauseId clause;
};
constexpr ModeHolding kModes[] = {{"rs274", Group::distance, "NGC-DIS-01"_clause},
                                  {"rs274", Group::arc_distance, "NGC-DIS-01"_clause},
                                  {"rs274", Group::units, "NGC-UNI-01"_clause},
                                  {"sinumerik840d", Group::units, "SIE-MOD-04"_clause},
                                  {"sinumerik802s", Group::units, "SIE-MOD-04"_clause}};

std::string shown(reference::ClauseId clause) {
  return fmt::format(" ({})", reference::clause_name(clause));
}

std::string clause_of(std::span<const Holding> all, std::string_view dialect,
                      std::string_view code) {
  const auto found = std::ranges::find_if(all, [&](const Holding& one) {
    return one.dialect == dialect && code.starts_with(one.what);
  });
  return found == all.end() ? std::string() : shown(found->clause);
}

std::string clause_of_mode(std::string_view dialect, Group group) {
  const auto found = std::ranges::find_if(
      kModes, [&](const ModeHolding& one) { return one.dialect == dialect && one.group == group; });
  return found == std::end(kModes) ? std::string() : shown(found->clause);
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
    if (block_.modes.own != nullptr || code == nullptr || !names_something()) return;
    for (std::size_t i = at_; i-- > 0;) {
      if (program_.blocks[i].modes.own != code) continue;
      add(std::string(code->name), i, clause_of(kMotions, profile_.dialect, code->name));
      return;
    }
  }

  bool names_something() const { return std::ranges::any_of(block_.words, is_word); }

  // Along an axis of the plane a hole has a place of its own.
  bool is_of_hole_place(const reference::CodeWord& word, const std::string& name) const {
    const Code& code = *block_.modes.code();
    const reference::CodeWord* const level = code.find("R");
    const bool is_hole = level != nullptr && level->role == Role::along_d;
    constexpr std::string_view kDepths[] = {"Z", "Y", "X"};
    const std::string_view depth = kDepths[static_cast<std::size_t>(block_.modes.plane)];
    return is_hole && word.role == Role::place && name != depth;
  }

  // Words of the code in force that an earlier block of it gave and this one lacks.
  void add_words() {
    const Code* const code = block_.modes.code();
    if (code == nullptr || code->kind != Kind::cycle || !names_something()) return;
    std::set<std::string> seen;
    for (const TextWord& word : block_.words) seen.insert(name_of(word));
    for (std::size_t i = at_; i-- > 0 && program_.blocks[i].modes.motion == code;) {
      const TextBlock& before = program_.blocks[i];
      if (before.modes.code() != code) continue;
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
          clause_of(kWords, profile_.dialect, code->name));
    }
  }

  bool matters(Group group) const {
    const Code* const code = block_.modes.code();
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
        add(std::string(code->name), i, clause_of_mode(profile_.dialect, code->group));
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
  if (line == 0 || program.size() > kLongestProgram) return {};
  const ProgramText text(profile, program);
  if (line > text.blocks.size()) return {};
  return InForce(profile, text, line - 1).text();
}

}  // namespace gonogo::program
