// SPDX-License-Identifier: GPL-3.0-or-later
//
// A cycle that makes L holes, one step further each time, written as L blocks. Where R lies at or
// below the tool and the tool comes back to where it was, each block finds what the first one
// found, wherever R counts from.
#include <algorithm>

#include "fuzz/relations/related_lines.hpp"

namespace gonogo::relations {
namespace {

constexpr int kMostRepeats = 20;

bool is_feature_of_steps(const reference::CodeWord* word) {
  return word != nullptr && word->role == Role::count;
}

// How many holes the block makes, where it may be unrolled; nothing: it may not.
std::optional<std::int64_t> holes_of(const TextBlock& block, const reference::Descriptor& table,
                                     bool returns_to_start) {
  const Code* const own = block.modes.own;
  // NGC-G73-02: it ends at R, under G98 too.
  if (own == nullptr || is_in_steps(*own) || has_cut_words(block) || own->kind != Kind::cycle ||
      !block.modes.incremental || !returns_to_start || !is_feature_of_steps(own->find("L"))) {
    return std::nullopt;
  }
  const bool is_plain = std::ranges::all_of(block.words, [&](const TextWord& word) {
    if (!program::is_word(word)) return word.text != "/";
    const Code* const code = table.find(block.code_of(word));
    if (code != nullptr) return code == own || code->kind == Kind::mode;
    const std::string name = name_of(word);
    return name != "M" && name != "D" && plain_value(word).has_value();
  });
  const TextWord* const repeats = block.find("L");
  const TextWord* const r = block.find("R");
  if (!is_plain || repeats == nullptr || r == nullptr) return std::nullopt;
  const std::optional<std::int64_t> count = plain_value(*repeats)->to_int64();
  if (!count || *count < 2 || *count > kMostRepeats || plain_value(*r)->sign() > 0) {
    return std::nullopt;
  }
  return count;
}

// Whether the tool comes back to the initial level, as far as the program says so itself: by the
// first code of the group in the table.
class ReturnMode {
 public:
  explicit ReturnMode(const reference::Descriptor& table) : table_(table) {
    const auto first = std::ranges::find(table.codes, Group::retract, &Code::group);
    initial_level_ = first == table.codes.end() ? nullptr : &*first;
  }
  void take(const TextBlock& block) {
    for (const std::string& name : block.codes) {
      const Code* const code = table_.find(name);
      if (code != nullptr && code->group == Group::retract) returns_ = code == initial_level_;
    }
  }
  bool returns() const { return returns_; }

 private:
  const reference::Descriptor& table_;
  const Code* initial_level_ = nullptr;
  bool returns_ = false;
};

}  // namespace

// J-PROP-11
std::optional<Related> unrolled(const GeneratedProgram& program) {
  const ProgramText text(program.profile, program.text);
  if (has_unclear_order(text)) return std::nullopt;
  Related related;
  std::vector<TextLine> lines;
  ReturnMode mode(*text.table);
  bool in_series = false;  // the block before was a cycle, whose initial level may be another one
  bool changes = false;
  for (const TextBlock& block : text.blocks) {
    const bool runs = is_run(block, program.profile);
    if (runs) mode.take(block);
    const auto holes = runs && !in_series ? holes_of(block, *text.table, mode.returns())
                                          : std::optional<std::int64_t>();
    if (runs) in_series = block.modes.in_cycle();
    TextLine line = static_cast<const TextLine&>(block);
    if (holes) {
      changes = true;
      std::erase_if(line.words, [](const TextWord& word) { return name_of(word) == "L"; });
    }
    const std::uint64_t first = lines.size() + 1;
    related.lines.push_back(first);
    const std::int64_t count = holes.value_or(1);
    for (std::int64_t k = 1; k <= count; ++k) {
      lines.push_back(line);
      if (k < count && line.end.empty()) lines.back().end = "\n";
      related.counts_as.push_back(first);
    }
  }
  if (!changes) return std::nullopt;
  related.program = {program.profile, text_of(lines)};
  return related;
}

}  // namespace gonogo::relations
