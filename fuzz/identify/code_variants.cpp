// SPDX-License-Identifier: GPL-3.0-or-later
//
// A code taken for another one or ignored.
#include <fmt/format.h>

#include <set>

#include "fuzz/identify/variant.hpp"

namespace gonogo::identify {
namespace {

// Codes that one may be taken for another.
bool is_confusable(const Code& code) {
  switch (code.kind) {
    case Kind::traverse:
    case Kind::line:
    case Kind::thread:
    case Kind::arc:
    case Kind::cycle:
    case Kind::reference_point:
    case Kind::pole:
    case Kind::frame:
      return code.is_g() && code.treatment == reference::Treatment::read;
    default:
      return false;
  }
}

using CodeMap = std::function<std::optional<std::string>(const TextBlock&, const std::string&)>;

void add_codes(std::string name, const CodeMap& map, Variants& out) {
  add_edit(
      std::move(name),
      [map](const TextBlock& block, const TextWord& word) {
        const std::string& code = block.code_of(word);
        return code.empty() ? std::nullopt : map(block, code);
      },
      out);
}

void add_taken_for(const std::string& code, const std::string& other, Variants& out) {
  add_codes(
      fmt::format("{} does what {} does", code, other),
      [=](const TextBlock&, const std::string& word) -> std::optional<std::string> {
        return word == code ? std::optional(other) : std::nullopt;
      },
      out);
}

// Sense: the two codes change places, in every plane or in one.
void add_exchanged(std::string_view a, std::string_view b, std::optional<Plane> plane,
                   Variants& out) {
  add_codes(
      fmt::format("{} and {} change places{}", a, b,
                  plane ? fmt::format(" in G{}", plane_code(*plane)) : ""),
      [=](const TextBlock& block, const std::string& word) -> std::optional<std::string> {
        if (plane && block.modes.plane != *plane) return std::nullopt;
        if (word == a) return std::string(b);
        if (word == b) return std::string(a);
        return std::nullopt;
      },
      out);
}

// Two pairs of codes, the second of each as the first.
void add_second_as_first(std::string_view first, std::string_view second,
                         std::string_view other_first, std::string_view other_second,
                         Variants& out) {
  add_codes(
      fmt::format("{} and {} do what {} and {} do", second, other_second, first, other_first),
      [=](const TextBlock&, const std::string& word) -> std::optional<std::string> {
        if (word == second) return std::string(first);
        if (word == other_second) return std::string(other_first);
        return std::nullopt;
      },
      out);
}

// Codes that turn, exchanged with those that turn the other way; of cycles with the same words each
// read as the other, senses alike or not.
void add_senses(const Descriptor& table, const std::set<std::string>& present, Variants& out) {
  for (const Code& code : table.codes) {
    if (code.sense >= 0) continue;
    const std::string_view opposite = opposite_of(table, code)->name;
    const bool stands =
        present.contains(std::string(code.name)) || present.contains(std::string(opposite));
    if (code.kind == Kind::arc || stands) add_exchanged(code.name, opposite, std::nullopt, out);
    if (code.kind == Kind::arc) {
      for (const Plane plane : {Plane::g17, Plane::g18, Plane::g19}) {
        add_exchanged(code.name, opposite, plane, out);
      }
    }
    for (const Code& other : table.codes) {
      if (&other <= &code || other.sense >= 0 || !has_same_words(code, other)) continue;
      if (other.feature == code.feature) continue;
      const std::string_view other_opposite = opposite_of(table, other)->name;
      add_second_as_first(code.name, opposite, other.name, other_opposite, out);
      add_second_as_first(code.name, other.name, opposite, other_opposite, out);
      add_exchanged(code.name, other.name, std::nullopt, out);
    }
  }
}

void add_facing(const Code& code, const Code& other, Variants& out) {
  const std::string taper(taper_of(code)->address);
  const std::string other_taper(taper_of(other)->address);
  add_edit(
      fmt::format("{} does what {} does, {} as {}", code.name, other.name, taper, other_taper),
      [=, &code, &other](const TextBlock& block,
                         const TextWord& word) -> std::optional<std::string> {
        if (block.modes.code_name() != code.name) return std::nullopt;
        if (block.code_of(word) == code.name) return std::string(other.name);
        if (name_of(word) != taper) return std::nullopt;
        return other_taper + word.text.substr(taper.size());
      },
      out);
}

// Two cycles whose tapers have different words, each read as the other.
void add_all_facing(const Descriptor& table, Variants& out) {
  for (const Code& code : table.codes) {
    for (const Code& other : table.codes) {
      const bool have_tapers = taper_of(code) != nullptr && taper_of(other) != nullptr;
      if (have_tapers && taper_of(code)->address != taper_of(other)->address) {
        add_facing(code, other, out);
      }
    }
  }
}

// The other code of a mode that has two; null: it has more, or is none.
const Code* other_of_two(const Descriptor& table, const Code& code) {
  const auto is_of_mode = [&](const Code& one) {
    return one.group == code.group && one.kind == Kind::mode &&
           one.treatment == reference::Treatment::read;
  };
  if (code.group == reference::Group::once || !is_of_mode(code)) return nullptr;
  const Code* other = nullptr;
  for (const Code& one : table.codes) {
    if (&one == &code || !is_of_mode(one)) continue;
    if (other != nullptr) return nullptr;
    other = &one;
  }
  return other;
}

// An M function that is passed on, but not where it stands beside one of the codes.
void add_lost_function(const Code& function, const Motions& motions, Variants& out) {
  add_without(
      fmt::format("{} of {} is ignored", function.name, names_of(motions)),
      [name = function.name, motions](const TextBlock& block, const TextWord& word) {
        return block.code_of(word) == name && motions.contains(block.modes.code_name());
      },
      out);
}

}  // namespace

const CodeWord* taper_of(const Code& code) {
  const CodeWord* taper = nullptr;
  if (code.kind != Kind::cycle) return nullptr;
  for (const auto& list : code.words) {
    for (const CodeWord& word : list) {
      if (word.role < Role::along_p || word.role > Role::along_d) continue;
      if (taper != nullptr) return nullptr;
      taper = &word;
    }
  }
  return taper;
}

void add_code_variants(const Observation& departure, Variants& out) {
  const ProgramText program(departure.profile, departure.program);
  const Descriptor& table = *program.table;
  std::set<std::string> codes;
  for (const TextBlock& block : program.blocks)
    codes.insert(block.codes.begin(), block.codes.end());
  codes.erase("");
  add_senses(table, codes, out);
  for (const Code& code : table.codes) {
    const Code* const other = other_of_two(table, code);
    if (other != nullptr && other > &code) add_exchanged(code.name, other->name, std::nullopt, out);
  }
  add_all_facing(table, out);
  const std::vector<Motions> concerned = motions_concerned(departure);
  for (const std::string& code : codes) {
    // The simplest goes first.
    add_without(
        fmt::format("{} is ignored", code),
        [=](const TextBlock& block, const TextWord& word) { return block.code_of(word) == code; },
        out);
    const std::string whole = code.substr(0, code.find('.'));
    if (whole != code) add_taken_for(code, whole, out);
    // A code that ends or sets something is not taken for a motion.
    const Code* const own = table.find(code);
    const bool moves = own != nullptr && is_confusable(*own);
    for (const Code& other : table.codes) {
      const bool is_tried = other.name == code || other.name == whole;
      const bool can_be = moves && is_confusable(other) && !is_tried;
      if (can_be) add_taken_for(code, std::string(other.name), out);
    }
    if (own == nullptr || !own->is_m()) continue;
    for (const Motions& motions : concerned) add_lost_function(*own, motions, out);
  }
}

}  // namespace gonogo::identify
