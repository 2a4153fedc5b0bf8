// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/writers.hpp"

#include <variant>

#include "fuzz/program/mutator/dictionary.hpp"

namespace gonogo::generate {
namespace {

constexpr int kMostBlocks = 10;
constexpr std::uint32_t kMostWords = 7;

std::string digits(Choices& choices, std::uint32_t most) {
  std::string text;
  for (std::uint32_t i = choices.below(most + 1); i > 0; --i) {
    text += static_cast<char>('0' + choices.below(10));
  }
  return text;
}

// "12", "-.5", "+007.", "-", "".
std::string any_number(Choices& choices) {
  std::string text = choices.pick({"", "", "", "-", "-", "+"});
  text += digits(choices, choices.one_in(8) ? 20 : 3);
  if (choices.one_in(2)) text += "." + digits(choices, choices.one_in(8) ? 12 : 3);
  return text;
}

std::string any_word(const program::Dictionary& dictionary, Choices& choices) {
  if (choices.one_in(50)) {
    const char byte = static_cast<char>(choices.below(256));
    return {byte == '\n' ? ' ' : byte};  // which would be one more block
  }
  if (choices.below(3) != 0) {
    return dictionary.entries[choices.below(static_cast<std::uint32_t>(dictionary.entries.size()))];
  }
  return static_cast<char>('A' + choices.below(26)) + any_number(choices);
}

}  // namespace

GeneratedProgram raw_program(std::string_view dialect, Choices& choices,
                             const GeneratorSettings& settings) {
  GeneratedProgram program;
  program.profile = std::get<reference::Profile>(reference::default_profile(dialect));
  if (settings.machine.readings && choices.one_in(2)) choose_reading(choices, program.profile);
  const program::Dictionary& dictionary = *program::find_dictionary(dialect);
  const std::int64_t blocks = choices.between(1, settings.most_blocks.value_or(kMostBlocks));
  for (std::int64_t i = 0; i < blocks && !choices.exhausted(); ++i) {
    for (std::uint32_t words = choices.below(kMostWords + 1); words > 0; --words) {
      program.text += any_word(dictionary, choices);
      if (choices.below(4) != 0) program.text += ' ';
    }
    program.text += choices.one_in(10) ? "\r\n" : "\n";
  }
  return program;
}

}  // namespace gonogo::generate
