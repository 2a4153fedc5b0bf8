// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/features.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <vector>

namespace gonogo::program {
namespace {

using reference::Code;
using reference::CodeWord;
using reference::WordLists;

// What asks for several words in one block: "X Y Z".
bool stands_in(const CodeWord& word, const TextBlock& block) {
  std::string_view names = word.address;
  while (!names.empty()) {
    const std::string_view name = names.substr(0, names.find(' '));
    if (block.find(name) == nullptr) return false;
    names.remove_prefix(std::min(name.size() + 1, names.size()));
  }
  return true;
}

bool names_place(const Code& code, const TextBlock& block) {
  return std::ranges::any_of(block.words, [&](const TextWord& word) {
    const CodeWord* const role = is_word(word) ? code.find(name_of(word)) : nullptr;
    return role != nullptr &&
           (role->role == reference::Role::place || role->role == reference::Role::centre);
  });
}

bool is_used(reference::Use use, bool is_repeated, const BlockModes& modes) {
  switch (use) {
    case reference::Use::repeated:
      return is_repeated;
    case reference::Use::incremental:
      return modes.incremental;
    case reference::Use::outside_xy:
      return modes.plane != reference::Plane::g17;
  }
  return false;
}

constexpr std::string_view kBasic = "basic";

// What stands around every cycle and path: straight motions, modes, the end of a cycle, M
// functions.
bool is_plain(const Code& code) {
  using reference::Kind;
  constexpr Kind kPlain[] = {Kind::mode,    Kind::traverse, Kind::line,       Kind::off,
                             Kind::machine, Kind::stop,     Kind::program_end};
  return code.feature == kBasic && std::ranges::find(kPlain, code.kind) != std::end(kPlain);
}

// O with more than a name (NGC-COM-06).
bool is_line_of_o_word(const TextBlock& block) {
  const auto is_o = [](const TextWord& word) { return address_of(word) == "O"; };
  const auto is_more = [&](const TextWord& word) {
    return !is_comment(word) && !is_o(word) && address_of(word) != "N" && word.text != "/";
  };
  const auto name = std::ranges::find_if(block.words, is_o);
  return name != block.words.end() &&
         (name->text.find('<') != std::string::npos || std::ranges::any_of(block.words, is_more));
}

// NGC-COM-10: in either case and with blanks.
bool ends_program(std::string_view comment) {
  std::string letters;
  for (const char byte : comment.substr(0, comment.find(','))) {
    if (byte != ' ' && byte != '\t') letters += static_cast<char>(byte | 0x20);
  }
  return letters == "(abort" && comment.find(',') != std::string_view::npos;
}

class Needs {
 public:
  explicit Needs(const reference::Descriptor& table) : table_(table) {}
  std::set<std::string> features() && { return std::move(features_); }
  void take(const TextBlock& block) {
    std::vector<const Code*> takers = {block.modes.own, block.modes.motion};
    for (const std::string& name : block.codes) {
      const Code* const code = table_.find(name);
      if (code == nullptr) continue;
      if (!is_plain(*code)) add(code->feature);
      takers.push_back(code);
    }
    for (const TextWord& word : block.words) {
      if (is_word(word)) take(word, takers);
      if (is_comment(word) && (word.text.starts_with(';') || ends_program(word.text))) {
        add_of_lines("linuxcnc");
      }
      if (!is_comment(word) && word.text.find_first_of("#[") != std::string::npos) {
        add_of_lines("parameters");
      }
    }
    if (is_line_of_o_word(block)) add_of_lines("o-words");
    if (block.modes.code() != nullptr) take_joint_words(*block.modes.code(), block);
    if (block.modes.motion != nullptr) take_uses(*block.modes.motion, block);
  }

 private:
  void add(std::string_view feature) {
    if (!feature.empty()) features_.emplace(feature);
  }
  // What stands in lines and is no code's: NGC-PAR, NGC-EXP, NGC-OWD, NGC-COM.
  void add_of_lines(std::string_view feature) {
    const auto known =
        std::ranges::find(table_.features, feature, &reference::DialectFeature::name);
    if (known != table_.features.end()) add(feature);
  }
  void take(const TextWord& word, const std::vector<const Code*>& takers) {
    const std::string name = name_of(word);
    if (!take_from(takers, name) && !take_from_any(name)) {
      for (const CodeWord& other : table_.everywhere) {
        if (stands_for(other, name)) add(other.feature);
      }
    }
    if (word.text.find('=') != std::string::npos && !exact_value_of(word)) take_calculation();
  }
  // The first of the codes that takes the word; whether one does.
  bool take_from(const std::vector<const Code*>& codes, std::string_view name) {
    for (const Code* code : codes) {
      const CodeWord* const role = code == nullptr ? nullptr : code->find(name);
      if (role == nullptr) continue;
      add(role->feature);
      return true;
    }
    return false;
  }
  // A word that nothing in force takes may be that of any code but one of its own block.
  bool take_from_any(std::string_view name) {
    bool is_known = false;
    for (const Code& code : table_.codes) {
      if (code.treatment != reference::Treatment::without_effect) {
        is_known = take_from({&code}, name) || is_known;
      }
    }
    return is_known;
  }
  void take_calculation() {
    for (const CodeWord& word : table_.everywhere) {
      if (word.role == reference::Role::parameter) add(word.feature);
    }
  }
  void take_uses(const Code& code, const TextBlock& block) {
    const bool is_repeated = block.modes.own != &code;
    if (is_repeated && !names_place(code, block)) return;  // it does not run
    for (const reference::UseFeature& rule : code.uses) {
      if (is_used(rule.use, is_repeated, block.modes)) add(rule.feature);
    }
  }
  void take_joint_words(const Code& code, const TextBlock& block) {
    for (const WordLists::List& list : code.words) {
      for (const CodeWord& word : list) {
        const bool is_joint = word.address.find(' ') != std::string_view::npos;
        if (is_joint && stands_in(word, block)) add(word.feature);
      }
    }
  }

  const reference::Descriptor& table_;
  std::set<std::string> features_;
};

}  // namespace

std::set<std::string> features_of_part(const ProgramText& part) {
  Needs needs(*part.table);
  for (const TextBlock& block : part.blocks) needs.take(block);
  return std::move(needs).features();
}

std::set<std::string> features_of_part(const reference::Descriptor& table, const TextBlock& block) {
  Needs needs(table);
  needs.take(block);
  return std::move(needs).features();
}

std::set<std::string> features_needed(const ProgramText& program) {
  std::set<std::string> features = features_of_part(program);
  if (features.empty()) features.emplace(kBasic);
  return features;
}

std::vector<std::string> features_of_case(const ProgramText& program,
                                          const std::vector<std::string>& stated) {
  constexpr std::array<std::string_view, 4> kBesideAll = {"arc-distance", "rotary", "linuxcnc",
                                                          "polar-words"};
  const std::set<std::string> needed = features_of_part(program);
  // The machine alone may need others, as offsets.
  const auto is_of_path = [&](const std::string& name) {
    return std::ranges::any_of(program.table->codes, [&](const Code& code) {
      return (code.kind == reference::Kind::cycle || code.kind == reference::Kind::arc) &&
             code.feature == name;
    });
  };
  std::vector<std::string> features;
  std::ranges::copy_if(stated, std::back_inserter(features), [&](const std::string& name) {
    return !is_of_path(name) || needed.contains(name);
  });
  for (const std::string_view name : kBesideAll) {
    const bool is_new = std::ranges::find(features, name) == features.end();
    if (is_new && needed.contains(std::string(name))) features.emplace_back(name);
  }
  if (features.empty()) features.emplace_back(kBasic);
  return features;
}

}  // namespace gonogo::program
