// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <string>

#include "grammar/parser.hpp"
#include "grammar/print_rs274.hpp"
#include "grammar/print_sinumerik.hpp"

namespace gonogo::grammar {
namespace {

struct StandIn {
  std::string_view name;
  std::string_view text;
};

// The text of an outside construct is not in the tree; any text of the same name stands for it.
constexpr StandIn kStandIns[] = {
    {"variable", "X#1"},    {"expression", "X[1]"}, {"control-statement", "GOTO 1"},
    {"file-name", "P[T1]"}, {"o-word", "O1 X1"},    {"comma-word", ",C1"},
    {"RL=", "RL=1"},        {"RC=", "RC=1"},        {"spindle-word", "$1"}};
constexpr StandIn kSinumerikStandIns[] = {{"variable", "X=$A"},
                                          {"expression", "X=POT(1)"},
                                          {"control-statement", "GOTOF A"},
                                          {"string", "T=\"A\""}};

template <std::size_t size>
std::string_view stand_in(std::string_view name, const StandIn (&list)[size]) {
  for (const StandIn& entry : list) {
    if (entry.name == name) return entry.text;
  }
  std::abort();  // a name that no grammar gives
}

// Separates what follows from what is there.
void blank(std::string& out) {
  if (!out.empty() && out != "/") out.push_back(' ');
}

}  // namespace

void print(const Decimal& value, std::string& out) {
  if (value.negative) out.push_back('-');
  const std::string digits =
      value.long_digits.empty() ? std::to_string(value.magnitude) : value.long_digits;
  if (value.scale == 0) {
    out += digits;
  } else if (digits.size() > value.scale) {
    const std::size_t whole = digits.size() - value.scale;
    out.append(digits, 0, whole).append(1, '.').append(digits, whole);
  } else {
    out.append("0.").append(value.scale - digits.size(), '0').append(digits);
  }
}

std::string print(Dialect dialect, const Block& block) {
  std::string out;
  if (block.tape_mark) out.push_back('%');
  if (block.skip) out.push_back('/');
  if (block.sequence_number) {
    out.push_back('N');
    print(*block.sequence_number, out);
  }
  if (block.program_number) {
    out.push_back('O');
    print(*block.program_number, out);
  }
  auto assignment = block.assignments.begin();
  const auto print_assignments = [&](std::uint32_t before) {
    for (; assignment != block.assignments.end() && assignment->where.begin < before;
         ++assignment) {
      blank(out);
      print(*assignment, block, out);
    }
  };
  for (const Word& word : block.words) {
    print_assignments(word.where.begin);
    blank(out);
    out.push_back(word.address);
    if (word.terms.count == 0) {
      print(word.value, out);
    } else {
      out += text_of_terms(block, word.terms);
    }
  }
  print_assignments(UINT32_MAX);
  if (block.control) {
    blank(out);
    print(*block.control, block, out);
  }
  for (const NamedWord& word : block.named) {
    blank(out);
    print(word, block, out);
  }
  for (const Comment& comment : block.comments) {
    if (comment.to_end_of_line) continue;
    blank(out);
    out.append("(").append(comment.text).append(")");
  }
  if (block.outside) {
    blank(out);
    const std::string_view name = block.outside->name;
    out += dialect == Dialect::sinumerik ? stand_in(name, kSinumerikStandIns)
                                         : stand_in(name, kStandIns);
  }
  for (const Comment& comment : block.comments) {
    if (comment.to_end_of_line) out.append(";").append(comment.text);
  }
  return out;
}

}  // namespace gonogo::grammar
