// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/print_sinumerik.hpp"

#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

#include "grammar/parser.hpp"

namespace gonogo::grammar {
namespace {

// How tightly a text holds together: what may stand where without brackets.
enum class Binding { sum, product, signed_operand, operand };

struct Piece {
  std::string text;
  Binding binding = Binding::operand;
};

Piece bracketed(Piece piece, Binding least) {
  if (piece.binding >= least) return piece;
  return {"(" + std::move(piece.text) + ")", Binding::operand};
}

std::string_view function_name(TermKind kind) {
  switch (kind) {
    case TermKind::sin:
      return "SIN(";
    case TermKind::cos:
      return "COS(";
    case TermKind::tan:
      return "TAN(";
    case TermKind::sqrt:
      return "SQRT(";
    case TermKind::abs:
      return "ABS(";
    default:
      return {};
  }
}

char operator_sign(TermKind kind) {
  switch (kind) {
    case TermKind::add:
      return '+';
    case TermKind::subtract:
      return '-';
    case TermKind::multiply:
      return '*';
    case TermKind::divide:
      return '/';
    default:
      std::abort();  // the other kinds have been handled
  }
}

// The infix text of terms in postfix order.
class Infix {
 public:
  void add(const Term& term) {
    if (term.kind == TermKind::number || term.kind == TermKind::parameter) return push_leaf(term);
    if (term.kind == TermKind::negate) return negate();
    if (const std::string_view name = function_name(term.kind); !name.empty()) {
      Piece& last = pieces_.back();
      last = {std::string(name) + last.text + ")", Binding::operand};
      return;
    }
    join(term.kind);
  }
  std::string take() { return std::move(pieces_.back().text); }

 private:
  void push_leaf(const Term& term) {
    Piece piece;
    if (term.kind == TermKind::parameter) piece.text = "R";
    print(term.number, piece.text);
    // A sign before a number is part of it: it is written in brackets before another.
    if (term.kind == TermKind::number) piece.binding = Binding::signed_operand;
    pieces_.push_back(std::move(piece));
  }

  void negate() {
    Piece& last = pieces_.back();
    last = {"-" + bracketed(std::move(last), Binding::operand).text, Binding::signed_operand};
  }

  // The left side is extended in place, so that a long sum takes no more than linear time.
  void join(TermKind kind) {
    const bool is_sum = kind == TermKind::add || kind == TermKind::subtract;
    const Binding here = is_sum ? Binding::sum : Binding::product;
    const Binding right_least = is_sum ? Binding::product : Binding::signed_operand;
    Piece right = bracketed(std::move(pieces_.back()), right_least);
    pieces_.pop_back();
    Piece left = bracketed(std::move(pieces_.back()), here);
    left.text.push_back(operator_sign(kind));
    left.text += right.text;
    left.binding = here;
    pieces_.back() = std::move(left);
  }

  std::vector<Piece> pieces_;
};

std::string value_of(const NamedWord& word, const Block& block) {
  Infix infix;
  for (std::size_t i = 0; i < word.terms; ++i) infix.add(block.terms[word.first_term + i]);
  return infix.take();
}

}  // namespace

void print(const NamedWord& word, const Block& block, std::string& out) {
  out += word.name;
  if (word.index) out += std::to_string(*word.index);
  if (word.is_call) out += "()";
  if (word.has_equals) out.push_back('=');
  if (word.terms == 0) return;
  const std::string value = value_of(word, block);
  if (word.dimension == Dimension::as_in_force) {
    out += value;
  } else {
    out += word.dimension == Dimension::absolute ? "AC(" : "IC(";
    out.append(value).append(")");
  }
}

}  // namespace gonogo::grammar
