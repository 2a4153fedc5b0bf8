// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/edit.hpp"

#include <algorithm>

namespace gonogo::program {

std::optional<std::string> edited(const ProgramText& program, const WordEdit& edit) {
  std::string out;
  bool changed = false;
  for (const TextBlock& block : program.blocks) {
    for (const TextWord& word : block.words) {
      const auto text = is_word(word) ? edit(block, word) : std::nullopt;
      changed = changed || (text && *text != word.text);
      out += word.gap + text.value_or(word.text);
    }
    out += block.rest + block.end;
  }
  return changed ? std::optional(std::move(out)) : std::nullopt;
}

std::optional<std::string> without_words(const ProgramText& program, const WordTest& goes) {
  return edited(program, [&](const TextBlock& block, const TextWord& word) {
    return goes(block, word) ? std::optional<std::string>("") : std::nullopt;
  });
}

std::optional<std::string> edited_in_order(const ProgramText& program, const BlockEdit& add) {
  std::string out;
  bool changed = false;
  for (const TextBlock& block : program.blocks) {
    const auto behind = std::ranges::find_if(block.words.rbegin(), block.words.rend(), is_word);
    const std::string more = behind == block.words.rend() ? "" : add(block);
    changed = changed || !more.empty();
    for (auto word = block.words.begin(); word != block.words.end(); ++word) {
      if (word == behind.base()) out += more;
      out += word->gap + word->text;
    }
    if (behind.base() == block.words.end()) out += more;
    out += block.rest + block.end;
  }
  return changed ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace gonogo::program
