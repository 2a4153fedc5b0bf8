// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/size.hpp"

#include "reference/exact/enclosure.hpp"
#include "reference/exact/rational.hpp"

namespace gonogo::exact {
namespace {

std::size_t bits_of(const mpz_class& value) {
  return mpz_sizeinbase(value.get_mpz_t(), 2);
}

std::size_t bits_of(const mpq_class& value) {
  return bits_of(value.get_num()) + bits_of(value.get_den());
}

}  // namespace

Size size_of(const Number& value) {
  if (NumberAccess::node(value) == nullptr) return {};
  if (const EnclosureNode* node = enclosure_node(value)) return {0, node->depth};
  if (value.is_rational()) return {bits_of(rational_of(value)), 0};
  const Root parts = root_of(value);
  return {bits_of(parts.a) + bits_of(parts.b) + bits_of(parts.c), 0};
}

}  // namespace gonogo::exact
