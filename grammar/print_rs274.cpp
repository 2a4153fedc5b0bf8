// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/print_rs274.hpp"

#include <cstdlib>
#include <string_view>
#include <utility>

#include "grammar/byte_set.hpp"
#include "grammar/parser.hpp"
#include "grammar/rs274_words.hpp"

namespace gonogo::grammar {
namespace {

// The word of the kind; empty: no table has it.
template <typename... Tables>
std::string word_of(TermKind kind, const Tables&... tables) {
  std::string word;
  const auto look = [&](const auto& table) {
    for (const rs274::WordOfTerm& entry : table) {
      if (entry.kind == kind) word = entry.word;
    }
  };
  (look(tables), ...);
  return word;
}

std::string operator_of(TermKind kind) {
  using namespace rs274;
  std::string word = word_of(kind, kPowers, kProducts, kSums, kComparisons, kLogic);
  return !word.empty() && kLetter.contains(word.front()) ? ' ' + word + ' ' : word;
}

constexpr std::string_view kControlWords[] = {"sub",    "endsub", "return",    "call",  "if",
                                              "elseif", "else",   "endif",     "while", "endwhile",
                                              "do",     "repeat", "endrepeat", "break", "continue"};

bool is_number(const std::string& text) {
  const char first = text.front() == '-' && text.size() > 1 ? text[1] : text.front();
  return kDigit.contains(first);
}

std::string in_brackets(std::string text) {
  return text.front() == '[' ? text : '[' + std::move(text) + ']';
}

void apply(const Block& block, const Term& term, std::vector<std::string>& stack) {
  const auto named = [&] {
    return "#<" + block.names[static_cast<std::size_t>(term.number.magnitude)] + '>';
  };
  if (term.kind == TermKind::number) return print(term.number, stack.emplace_back());
  if (term.kind == TermKind::named) return static_cast<void>(stack.emplace_back(named()));
  if (term.kind == TermKind::exists) {
    return static_cast<void>(stack.emplace_back("EXISTS[" + named() + ']'));
  }
  std::string last = std::move(stack.back());
  if (term.kind == TermKind::numbered) {
    stack.back() = '#' + std::move(last);
  } else if (term.kind == TermKind::negate || term.kind == TermKind::plus) {
    if (is_number(last)) last = in_brackets(std::move(last));
    stack.back() = (term.kind == TermKind::negate ? '-' : '+') + std::move(last);
  } else if (std::string function = word_of(term.kind, rs274::kFunctionsOfOne); !function.empty()) {
    stack.back() = std::move(function) + '[' + std::move(last) + ']';
  } else {
    stack.pop_back();
    std::string before = std::move(stack.back());
    if (term.kind == TermKind::atan) {
      stack.back() = "ATAN[" + std::move(before) + "]/[" + std::move(last) + ']';
    } else {
      stack.back() = '[' + std::move(before);
      stack.back().append(operator_of(term.kind)).append(last).append("]");
    }
  }
}

std::string value_text(const Block& block, const TermRange& range) {
  std::vector<std::string> stack;
  for (std::uint32_t i = 0; i < range.count; ++i) {
    apply(block, block.terms[range.first + i], stack);
  }
  return std::move(stack.back());
}

}  // namespace

std::string text_of_terms(const Block& block, const TermRange& range) {
  std::string text = value_text(block, range);
  return is_number(text) ? in_brackets(std::move(text)) : text;
}

void print(const Assignment& assignment, const Block& block, std::string& out) {
  out.push_back('#');
  out +=
      assignment.name.empty() ? value_text(block, assignment.index) : '<' + assignment.name + '>';
  out.push_back('=');
  out += value_text(block, assignment.value);
}

void print(const Control& control, const Block& block, std::string& out) {
  out.push_back('O');
  out += control.label.empty() ? text_of_terms(block, control.number) : control.label;
  out.push_back(' ');
  out += kControlWords[static_cast<std::size_t>(control.kind)];
  for (const TermRange& value : control.values) {
    out.append(" ").append(in_brackets(value_text(block, value)));
  }
}

}  // namespace gonogo::grammar
