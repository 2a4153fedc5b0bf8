// SPDX-License-Identifier: GPL-3.0-or-later
//
// NGC-EXP-09: a OR b + c is a OR (b + c), or (a OR b) + c.
#include "reference/rs274/logic_order.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace gonogo::reference::rs274 {
namespace {

using grammar::TermKind;
using Places = std::vector<std::uint32_t>;

std::span<const grammar::Term> terms_of(const grammar::Block& block,
                                        const grammar::TermRange& range) {
  return std::span(block.terms).subspan(range.first, range.count);
}

bool is_comparison(TermKind kind) {
  return kind >= TermKind::equal && kind <= TermKind::not_greater;
}

bool is_logic(TermKind kind) {
  return kind >= TermKind::logic_and && kind <= TermKind::logic_xor;
}

bool is_value(TermKind kind) {
  return kind == TermKind::number || kind == TermKind::named || kind == TermKind::exists;
}

void append(Places& places, const Places& more) {
  places.insert(places.end(), more.begin(), more.end());
}

// What stands before the first + or - that follows a logical operator, and the rest.
struct Operand {
  Places head;
  Places rest;

  Places all() && {
    append(head, rest);
    return std::move(head);
  }
};

Operand joined(Operand left, Operand right, const grammar::Term& term, std::uint32_t place) {
  if (term.is_joined) {
    append(left.rest, std::move(right).all());
    left.rest.push_back(place);
    return left;
  }
  Places places = std::move(left).all();
  append(places, right.head);
  if (is_logic(term.kind)) {
    places.push_back(place);
    append(places, right.rest);
  } else {
    append(places, right.rest);
    places.push_back(place);
  }
  return {std::move(places), {}};
}

}  // namespace

bool takes_two(TermKind kind) {
  switch (kind) {
    case TermKind::add:
    case TermKind::subtract:
    case TermKind::multiply:
    case TermKind::divide:
    case TermKind::power:
    case TermKind::modulo:
    case TermKind::atan:
      return true;
    default:
      return is_comparison(kind) || is_logic(kind);
  }
}

bool has_logic_before_sum(const grammar::Block& block, const grammar::TermRange& range) {
  const std::span<const grammar::Term> terms = terms_of(block, range);
  return std::ranges::any_of(terms, &grammar::Term::is_joined) &&
         std::ranges::none_of(terms, is_comparison, &grammar::Term::kind);
}

Places logic_among_sums(const grammar::Block& block, const grammar::TermRange& range) {
  std::vector<Operand> stack;
  for (std::uint32_t place = range.first; place < range.first + range.count; ++place) {
    const grammar::Term& term = block.terms[place];
    if (is_value(term.kind)) {
      stack.push_back({{place}, {}});
      continue;
    }
    Operand last = std::move(stack.back());
    stack.pop_back();
    if (takes_two(term.kind)) {
      stack.back() = joined(std::move(stack.back()), std::move(last), term, place);
    } else {
      Places places = std::move(last).all();
      places.push_back(place);
      stack.push_back({std::move(places), {}});
    }
  }
  return std::move(stack.back()).all();
}

}  // namespace gonogo::reference::rs274
