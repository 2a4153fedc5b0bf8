// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/print_rs274.hpp"

#include <cstdlib>
#include <string_view>
#include <utility>

#include "grammar/byte_set.hpp"
#include "grammar/parser.hpp"

namespace gonogo::grammar {
namespace {

std::string_view operator_of(TermKind kind) {
  switch (kind) {
    case TermKind::add:
      return "+";
    case TermKind::subtract:
      return "-";
    case TermKind::multiply:
      return "*";
    case TermKind::divide:
      return "/";
    case TermKind::power:
      return "**";
    case TermKind::modulo:
      return " MOD ";
    case TermKind::equal:
      return " EQ ";
    case TermKind::not_equal:
      return " NE ";
    case TermKind::greater:
      return " GT ";
    case TermKind::not_less:
      return " GE ";
    case TermKind::less:
      return " LT ";
    case TermKind::not_greater:
      return " LE ";
    case TermKind::logic_and:
      return " AND ";
    case TermKind::logic_or:
      return " OR ";
    case TermKind::logic_xor:
      return " XOR ";
    default:
      return {};
  }
}

std::string_view function_of(TermKind kind) {
  switch (kind) {
    case TermKind::abs:
      return "ABS";
    case TermKind::acos:
      return "ACOS";
    case TermKind::asin:
      return "ASIN";
    case TermKind::cos:
      return "COS";
    case TermKind::exp:
      return "EXP";
    case TermKind::fix:
      return "FIX";
    case TermKind::fup:
      return "FUP";
    case TermKind::ln:
      return "LN";
    case TermKind::round:
      return "ROUND";
    case TermKind::sin:
      return "SIN";
    case TermKind::sqrt:
      return "SQRT";
    case TermKind::tan:
      return "TAN";
    default:
      return {};
  }
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
  } else if (const std::string_view function = function_of(term.kind); !function.empty()) {
    stack.back() = std::string(function) + '[' + std::move(last) + ']';
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
