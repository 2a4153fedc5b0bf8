// SPDX-License-Identifier: GPL-3.0-or-later
//
// What cycles retain too long: past what ends them, under another cycle, along an axis that a later
// block does not name.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "fuzz/identify/variant.hpp"

namespace gonogo::identify {
namespace {

// What ends a cycle, and ought to clear what it retains.
struct Passed {
  std::string name;
  std::set<Kind> kinds;
};

std::vector<Passed> passed_by(const Descriptor& table) {
  const std::set<Kind> motions = {Kind::traverse, Kind::line, Kind::arc, Kind::circle};
  const std::set<Kind> others = {Kind::reference_point, Kind::rename};
  std::vector<Passed> all = {{"motions", motions},
                             {"straight motions", {Kind::traverse, Kind::line}},
                             {"reference points and coordinates", others}};
  if (const Code* off = table.find(Kind::off)) {
    std::set<Kind> both = motions;
    both.insert(Kind::off);
    all.push_back({std::string(off->name), {Kind::off}});
    all.push_back({fmt::format("motions and {}", off->name), std::move(both)});
  }
  return all;
}

bool names_something(const TextBlock& block) {
  return std::ranges::any_of(block.words, program::is_word);
}

// A cycle that lacks a word takes that of a cycle before it, across blocks of these kinds alone.
std::optional<std::string> retained_past(const ProgramText& program,
                                         const std::set<std::string>& addresses,
                                         const std::set<Kind>& passed) {
  std::map<std::string, std::string> given;  // since the last such block
  std::map<std::string, std::string> kept;   // before it
  return edited_in_order(program, [&](const TextBlock& block) {
    std::string more;
    if (!names_something(block) || block.modes.is_of(Kind::dwell)) return more;
    if (!block.modes.in_cycle()) {
      const bool is_passed =
          block.modes.code() != nullptr && passed.contains(block.modes.code()->kind);
      if (is_passed) {
        for (const auto& [address, word] : given) kept[address] = word;
      } else if (block.modes.code() != nullptr) {
        kept.clear();
      }
      given.clear();
      return more;
    }
    for (const std::string& address : addresses) {
      const CodeWord* const meant = block.modes.code()->find(address);
      const TextWord* const word = block.find(address);
      // The same letter may be a number of times to another cycle.
      if (meant != nullptr && meant->role == Role::count) continue;
      if (word != nullptr) {
        given[address] = word->text;
        kept.erase(address);
      } else if (meant != nullptr && kept.contains(address)) {
        more += " " + kept[address];
      }
    }
    return more;
  });
}

// The place along an axis and the way to it are one word to a cycle.
constexpr std::array<std::pair<const char*, const char*>, 3> kPlacesAndWays = {
    {{"X", "U"}, {"Y", "V"}, {"Z", "W"}}};

std::string counterpart_of(const std::string& name) {
  for (const auto& [place, way] : kPlacesAndWays) {
    if (name == place) return way;
    if (name == way) return place;
  }
  return {};
}

// Whether the cycle has a taper across its depth: such ones turn, others drill and mill.
bool has_taper(const Code& code) {
  return std::ranges::any_of(code.words, [](const auto& list) {
    return std::ranges::any_of(list, [](const CodeWord& word) {
      return word.role == Role::along_p || word.role == Role::along_q;
    });
  });
}

// What cycles have given since the last code that is none.
struct Held {
  const Code* code = nullptr;  // the last
  std::map<std::string, std::string> words;

  // Takes the words of the block that hold; returns what it lacks of those of another code.
  std::string take(const TextBlock& block) {
    std::map<std::string, std::string> own;
    for (const TextWord& word : block.words) {
      const CodeWord* const meant = block.modes.code()->find(name_of(word));
      const bool holds = meant != nullptr && meant->life == reference::Life::modal;
      if (holds) own[name_of(word)] = word.text;
    }
    if (own.empty()) return {};
    std::string more;
    for (const auto& [name, text] : words) {
      const bool is_given = own.contains(name) || own.contains(counterpart_of(name));
      const bool is_meant = block.modes.code()->find(name) != nullptr;
      if (block.modes.code() != code && is_meant && !is_given) more += " " + text;
    }
    code = block.modes.code();
    for (const auto& [name, text] : own) {
      words.erase(counterpart_of(name));
      words[name] = text;
    }
    return more;
  }
};

// The first block of one of these cycles behind one of another takes the words that it lacks.
std::optional<std::string> carried_over(const ProgramText& program, const Motions& cycles) {
  Held held;
  return edited_in_order(program, [&](const TextBlock& block) -> std::string {
    if (cycles.contains(block.modes.code_name())) return held.take(block);
    const bool clears = block.modes.code() != nullptr && !block.modes.is_of(Kind::cycle);
    if (clears && !block.modes.is_of(Kind::dwell)) held = {};
    return "";
  });
}

// Those that turn, or those that do not, as the code that departs.
Motions cycles_like(const Descriptor& table, const Code& code) {
  Motions cycles;
  for (const Code& other : table.codes) {
    const bool is_alike = other.kind == Kind::cycle && has_taper(other) == has_taper(code);
    if (is_alike) cycles.emplace(other.name);
  }
  return cycles;
}

void add_carried_over(const Observation& departure, const ProgramText& program, Variants& out) {
  const Code* const code = program.table->find(program.code_at(departure.verdict.block));
  if (code == nullptr || code->kind != Kind::cycle) return;
  const Motions cycles = cycles_like(*program.table, *code);
  if (cycles.size() < 2) return;
  add_text(
      fmt::format("what one of {} retains stays in force under another", names_of(cycles)),
      [cycles](const ProgramText& text) { return carried_over(text, cycles); }, out);
}

// A later block of a cycle names one axis: the others of the cycle do not move, where they have the
// last end point. A way of nothing says so; that of an axis outside the plane would be an alarm.
std::optional<std::string> standing_still(const ProgramText& program, const Motions& motions) {
  std::set<std::string> ways;  // along the axes that the cycle has named so far
  return edited_in_order(program, [&](const TextBlock& block) -> std::string {
    if (block.modes.is_of(Kind::dwell)) return "";
    if (!motions.contains(block.modes.code_name())) {
      ways.clear();
      return "";
    }
    std::string more;
    bool moves = false;
    for (const auto& [place, way] : kPlacesAndWays) {
      const CodeWord* const word = block.modes.code()->find(way);
      if (word == nullptr || word->role != Role::way) continue;
      const bool is_given = block.find(place) != nullptr || block.find(way) != nullptr;
      moves = moves || is_given;
      if (is_given) ways.insert(way);
      const char outside = reference::letter(reference::axes_of(block.modes.plane).d);
      const bool may_stand = std::tolower(place[0]) != outside;
      if (!is_given && may_stand && ways.contains(way)) more += fmt::format(" {}0", way);
    }
    return moves ? more : "";
  });
}

std::set<std::string> tapers_of(const Descriptor& table) {
  std::set<std::string> tapers;
  for (const Code& code : table.codes) {
    if (const CodeWord* const taper = taper_of(code)) tapers.emplace(taper->address);
  }
  return tapers;
}

// Words of cycles that stand in the program, each alone and all together.
void add_retained(const Descriptor& table, const std::set<std::string>& addresses, Variants& out) {
  std::set<std::string> all;
  for (const Code& code : table.codes) {
    if (code.kind != Kind::cycle) continue;
    std::ranges::copy_if(addresses, std::inserter(all, all.end()),
                         [&](const std::string& address) { return code.find(address) != nullptr; });
  }
  std::vector<std::pair<std::string, std::set<std::string>>> sets;
  for (const std::string& address : all) sets.push_back({address + " of a cycle", {address}});
  if (all.size() > 1) sets.push_back({"what a cycle retains", all});
  // The tapers of all cycles, where one variable keeps them.
  std::set<std::string> tapers = tapers_of(table);
  if (tapers.size() > 1) {
    const std::string names = fmt::format("{} of a cycle", fmt::join(tapers, " "));
    sets.push_back({names, std::move(tapers)});
  }
  for (const auto& [what, set] : sets) {
    for (const Passed& passed : passed_by(table)) {
      add_text(
          fmt::format("{} stays in force past {}", what, passed.name),
          [set, kinds = passed.kinds](const ProgramText& text) {
            return retained_past(text, set, kinds);
          },
          out);
    }
  }
}

}  // namespace

void add_retained_variants(const Observation& departure, Variants& out) {
  const ProgramText program(departure.profile, departure.program);
  add_retained(*program.table, addresses_in(program), out);
  add_carried_over(departure, program, out);
  for (const Motions& motions : motions_concerned(departure)) {
    add_text(
        fmt::format("an axis that a later block of {} does not name does not move",
                    names_of(motions)),
        [motions](const ProgramText& text) { return standing_still(text, motions); }, out);
  }
}

}  // namespace gonogo::identify
