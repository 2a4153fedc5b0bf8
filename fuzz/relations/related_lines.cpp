// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/relations/related_lines.hpp"

#include <algorithm>
#include <numeric>

namespace gonogo::relations {
namespace {

// Whether it can stand before the head of a program.
bool is_before_blocks(const TextLine& line) {
  return line.words.empty() || line.words.front().text.find_first_of("%O(;") == 0;
}

}  // namespace

std::vector<std::uint64_t> same_lines(std::size_t count) {
  std::vector<std::uint64_t> lines(count);
  std::iota(lines.begin(), lines.end(), 1);
  return lines;
}

std::optional<Related> with_block_before(const GeneratedProgram& program, std::string block) {
  std::vector<TextLine> lines = program::lines_of(program.text);
  const auto first = std::ranges::find_if_not(lines, is_before_blocks);
  if (first == lines.end() || first->words.front().text.front() == '/') return std::nullopt;
  Related related;
  related.lines = same_lines(lines.size());
  for (std::size_t i = static_cast<std::size_t>(first - lines.begin()); i < lines.size(); ++i) {
    ++related.lines[i];
  }
  lines.insert(first, TextLine{{{"", std::move(block)}}, "", "\n"});
  related.program = {program.profile, text_of(lines)};
  return related;
}

namespace {

// G91.0001, which may count as G91 (ngc.whole).
bool is_nearly_a_code(const TextWord& word) {
  const std::string code = code_of(word);
  const std::size_t point = code.find('.');
  return point != std::string::npos && code.size() - point > 2;
}

// With blanks in it, or a part of a word that blanks have cut.
bool is_cut(const TextWord& word) {
  const std::string& text = word.text;
  if (program::is_comment(word)) return false;
  const bool goes_on = std::string_view("=+-*/").find(text.back()) != std::string_view::npos;
  const bool is_part_of_a_number = text[0] == '.' || (text[0] >= '0' && text[0] <= '9');
  return text == "G" || text == "g" || text.starts_with("=") || is_part_of_a_number ||
         text.find_first_of(" \t") != std::string::npos ||
         (goes_on && text != "/");  // a block that may be left out
}

}  // namespace

bool has_cut_words(const TextBlock& block) {
  return std::ranges::any_of(block.words, is_cut);
}

namespace {

// Modes under which a word is not the way or the feed that it says: F of inverse time hangs on the
// way of its block, X of a mill is a diameter, and saved modes come back unnamed.
bool has_modes_of_their_own(const ProgramText& text) {
  const bool is_mill = text.table->find(Kind::line)->takes('Y');
  const auto is_one = [](const Code& code) {
    return code.setting == Setting::inverse_time || code.group == Group::saved_modes;
  };
  const auto is_diameter = [](const Code& code) { return code.setting == Setting::diameter; };
  return any_code(text, is_one) || (is_mill && any_code(text, is_diameter));
}

}  // namespace

bool has_unclear_words(const ProgramText& text) {
  if (has_modes_of_their_own(text)) return true;
  const auto is_unknown = [&](const std::string& name) {
    const Code* const code = text.table->find(name);
    const bool is_undefined = name.starts_with('G') && code == nullptr;
    return is_undefined || (code != nullptr && code->treatment == reference::Treatment::outside);
  };
  return std::ranges::any_of(text.blocks, [&](const TextBlock& block) {
    return std::ranges::any_of(block.words, is_nearly_a_code) ||
           std::ranges::any_of(block.words, is_cut) || std::ranges::any_of(block.codes, is_unknown);
  });
}

bool any_code(const ProgramText& text, bool (*is_it)(const Code&)) {
  return std::ranges::any_of(text.blocks, [&](const TextBlock& block) {
    return std::ranges::any_of(block.codes, [&](const std::string& name) {
      const Code* const code = text.table->find(name);
      return code != nullptr && is_it(*code);
    });
  });
}

bool names_own_axes(const Code& code) {
  std::ptrdiff_t places = 0;
  for (const auto& list : code.words) {
    places += std::ranges::count_if(list, [](const reference::CodeWord& word) {
      const bool is_axis = word.address == "X" || word.address == "Y" || word.address == "Z";
      return is_axis && word.role == Role::place;
    });
  }
  return places == 1 || places == 2;
}

bool is_in_steps(const Code& code) {
  return code.kind == Kind::cycle && std::ranges::any_of(code.words, [](const auto& list) {
           return std::ranges::any_of(
               list, [](const reference::CodeWord& word) { return word.role == Role::step; });
         });
}

bool has_open_path(const ProgramText& text) {
  return any_code(text, [](const Code& code) { return code.is_open_path; });
}

bool any_role(const ProgramText& text, bool (*is_it)(Role)) {
  return std::ranges::any_of(text.blocks, [&](const TextBlock& block) {
    return std::ranges::any_of(block.words, [&](const TextWord& word) {
      const reference::CodeWord* const role = block.role_of(word, *text.table);
      return role != nullptr && is_it(role->role);
    });
  });
}

std::optional<reference::Plane> only_plane(const ProgramText& text, const Profile& profile) {
  std::optional<reference::Plane> plane;
  for (const TextBlock& block : text.blocks) {
    if (!is_run(block, profile)) continue;
    if (plane && *plane != block.modes.plane) return std::nullopt;
    plane = block.modes.plane;
  }
  return plane.value_or(profile.initial.plane);
}

bool has_unclear_order(const ProgramText& text) {
  if (has_modes_of_their_own(text)) return true;
  const auto is_g_word = [](const TextWord& word) {
    return word.text.front() == 'G' || word.text.front() == 'g';
  };
  return std::ranges::any_of(text.blocks, [&](const TextBlock& block) {
    const bool has_others = std::ranges::count_if(block.words, program::is_word) > 0;
    return std::ranges::any_of(block.words, [&](const TextWord& word) {
      const char first = word.text.front();
      const std::string& name = block.code_of(word);
      const Code* const code = text.table->find(name);
      const bool is_outside = code != nullptr && code->treatment == reference::Treatment::outside;
      const bool is_unclear_code =
          is_g_word(word) && (is_cut(word) || is_nearly_a_code(word) || code == nullptr);
      return is_unclear_code || is_outside || ((first == 'O' || first == 'o') && has_others);
    });
  });
}

bool is_calculated(const ProgramText& text) {
  return std::ranges::any_of(text.blocks, [](const TextBlock& block) {
    return std::ranges::any_of(block.words, [](const TextWord& word) {
      const char first = word.text.front();
      if (first == '(' || first == ';') return false;
      return first == 'O' || first == 'o' ||
             word.text.find_first_of("#[$<>\"") != std::string::npos;
    });
  });
}

bool is_run(const TextBlock& block, const Profile& profile) {
  return std::ranges::any_of(block.words, program::is_word) && !is_left_out(block, profile);
}

std::optional<Number> plain_value(const TextWord& word) {
  const std::vector<program::NumberPlace> places = numbers_of(word);
  std::size_t begin = name_of(word).size();
  if (begin < word.text.size() && word.text[begin] == '=') ++begin;
  const bool is_plain =
      places.size() == 1 && places.front().begin == begin && places.front().end == word.text.size();
  return is_plain ? exact_value_of(word) : std::nullopt;
}

bool is_writable(const Number& number, bool inch) {
  return (number * (inch ? 10'000 : 1'000)).to_int64().has_value();
}

bool has_room(const Number& number) {
  constexpr int kMost = 9'000;
  return abs(number) <= kMost;
}

std::optional<AlongAxis> axis_of(const TextWord& word, const TextBlock& block,
                                 const reference::Descriptor& table) {
  const reference::CodeWord* const known = block.role_of(word, table);
  if (known == nullptr) return std::nullopt;
  const reference::PlaneAxes plane = axes_of(block.modes.plane);
  const auto found = [&](std::size_t axis) -> std::optional<AlongAxis> {
    return axis < 3 ? std::optional(AlongAxis{axis, known->role}) : std::nullopt;
  };
  const char letter = known->address.front();
  switch (known->role) {
    case Role::place:
      return found(std::string_view("XYZ").find(letter));
    case Role::way:
      return found(std::string_view("UVW").find(letter));
    case Role::centre:
    case Role::middle:
      return found(std::string_view("IJK").find(letter));
    case Role::along_p:
      return found(index(plane.p));
    case Role::along_q:
      return found(index(plane.q));
    case Role::along_d:
      return found(index(plane.d));
    default:
      return std::nullopt;
  }
}

}  // namespace gonogo::relations
