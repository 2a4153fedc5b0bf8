// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/enclosure.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gonogo::exact {
namespace {

std::uint64_t mix(std::uint64_t seed, std::uint64_t value) {
  const std::uint64_t x = (seed ^ value) * 0x9e3779b97f4a7c15U;
  return x ^ (x >> 29U);
}

std::uint64_t hash_of(const mpz_class& value) {
  return mix(low_word(value), mpz_size(value.get_mpz_t()) + (sgn(value) < 0 ? 7 : 0));
}

std::uint64_t hash_of(const mpq_class& value) {
  return mix(hash_of(value.get_num()), hash_of(value.get_den()));
}

}  // namespace

std::uint64_t hash_of(const Number& value) {
  if (const EnclosureNode* node = enclosure_node(value)) return node->hash;
  if (NumberAccess::node(value) == nullptr) {
    return mix(1, static_cast<std::uint64_t>(NumberAccess::millionths(value)));
  }
  const Root root = root_of(value);
  return mix(mix(hash_of(root.a), hash_of(root.b)), hash_of(root.c));
}

namespace {

std::uint32_t depth_of(const Number& value) {
  const EnclosureNode* node = enclosure_node(value);
  return node == nullptr ? 0 : node->depth;
}

Interval interval_of_leaf(const Number& value, mpfr_prec_t bits) {
  if (NumberAccess::node(value) == nullptr) {
    return interval_of_millionths(NumberAccess::millionths(value), bits);
  }
  if (value.is_rational()) {
    mpq_class scratch;
    const mpq_class& exact = rational_of(value, scratch);
    return interval_of(exact, exact, bits);
  }
  return interval_of(root_of(value), bits);
}

bool has_base(const Number& value, mpfr_prec_t bits) {
  const EnclosureNode* node = enclosure_node(value);
  return node == nullptr || bits <= kBaseBits;
}

using Memo = std::unordered_map<const EnclosureNode*, Interval>;

// The interval of an operand. That of an expression is there already, that of a leaf is made when
// it is asked for: an operation of one operand asks for one.
class Operand {
 public:
  // REQUIRES: `memo` has the value where its base is not enough.
  Operand(const Number& value, mpfr_prec_t bits, const Memo& memo) : value_(value), bits_(bits) {
    const EnclosureNode* node = enclosure_node(value);
    if (node != nullptr) known_ = bits <= kBaseBits ? &node->base : &memo.at(node);
  }
  const Interval& interval() {
    if (known_ == nullptr) known_ = &made_.emplace(interval_of_leaf(value_, bits_));
    return *known_;
  }

 private:
  const Number& value_;
  const mpfr_prec_t bits_;
  const Interval* known_ = nullptr;
  std::optional<Interval> made_;
};

Interval evaluate(Operation operation, Operand x, Operand y, mpfr_prec_t bits) {
  switch (operation) {
    case Operation::between: {
      Interval hull(bits);
      mpfr_set(hull.low(), x.interval().low(), MPFR_RNDD);
      mpfr_set(hull.high(), y.interval().high(), MPFR_RNDU);
      return hull;
    }
    case Operation::negate:
      return negate(x.interval(), bits);
    case Operation::add:
      return add(x.interval(), y.interval(), bits);
    case Operation::subtract:
      return subtract(x.interval(), y.interval(), bits);
    case Operation::multiply:
      return multiply(x.interval(), y.interval(), bits);
    case Operation::divide:
      return divide(x.interval(), y.interval(), bits);
    case Operation::sqrt:
      return sqrt_of(x.interval(), bits);
    case Operation::root:
      return root_of(x.interval(), mpfr_get_ui(y.interval().low(), MPFR_RNDD), bits);
    case Operation::cos_degrees:
      return cos_of_degrees(x.interval(), bits);
    case Operation::sin_degrees:
      return sin_of_degrees(x.interval(), bits);
    case Operation::atan_degrees:
      return atan_in_degrees(x.interval(), bits);
    case Operation::radians:
      return in_radians(x.interval(), bits);
  }
  __builtin_unreachable();
}

Interval base_of(Operation operation, const Number& left, const Number& right) {
  const Memo none;
  return evaluate(operation, Operand(left, kBaseBits, none), Operand(right, kBaseBits, none),
                  kBaseBits);
}

bool is_ready(const Number& value, mpfr_prec_t bits, const Memo& memo) {
  return has_base(value, bits) || memo.contains(enclosure_node(value));
}

[[noreturn]] void undecided(const char* what) {
  throw Undecided(std::string("exact: ") + what + " is not decided by the last refinement");
}

mpz_class floor_of_end(mpfr_srcptr end) {
  mpz_class floor;
  mpfr_get_z(floor.get_mpz_t(), end, MPFR_RNDD);
  return floor;
}

// The bits before the point, 0 for numbers below one.
mpfr_exp_t magnitude_bits(const Interval& interval) {
  mpfr_exp_t bits = 0;
  for (mpfr_srcptr end : {interval.low(), interval.high()}) {
    if (mpfr_regular_p(end) != 0) bits = std::max(bits, mpfr_get_exp(end));
  }
  return bits;
}

}  // namespace

EnclosureNode::EnclosureNode(Operation its_operation, Number its_left, Number its_right)
    : Node(Number::Form::enclosure),
      operation(its_operation),
      refinable(its_operation != Operation::between && is_refinable(its_left) &&
                is_refinable(its_right)),
      depth(1 + std::max(depth_of(its_left), depth_of(its_right))),
      left(std::move(its_left)),
      right(std::move(its_right)),
      hash(mix(mix(static_cast<std::uint64_t>(its_operation) + 11, hash_of(left)), hash_of(right))),
      base(base_of(its_operation, left, right)) {}

Number enclosure(Operation operation, const Number& left, const Number& right) {
  if (auto simple = simplified(operation, left, right)) return *std::move(simple);
  return plain_enclosure(operation, left, right);
}

Number plain_enclosure(Operation operation, const Number& left, const Number& right) {
  return NumberAccess::adopt(new EnclosureNode(operation, left, right));
}

void destroy_enclosure(Node* node) noexcept {
  auto* pending = static_cast<EnclosureNode*>(node);
  while (pending != nullptr) {
    EnclosureNode* const first = pending;
    pending = first->next;
    for (Number* operand : {&first->left, &first->right}) {
      if (enclosure_node(*operand) == nullptr) continue;
      auto* const child = static_cast<EnclosureNode*>(NumberAccess::steal(*operand));
      if (child->count.fetch_sub(1, std::memory_order_acq_rel) != 1) continue;
      child->next = pending;
      pending = child;
    }
    delete first;
  }
}

Interval interval_of(const Number& value, mpfr_prec_t bits) {
  Memo memo;  // an operand that is used twice is evaluated once
  std::vector<const EnclosureNode*> path;
  if (!has_base(value, bits)) path.push_back(enclosure_node(value));
  while (!path.empty()) {
    const EnclosureNode* const node = path.back();
    const std::size_t depth = path.size();
    for (const Number* operand : {&node->left, &node->right}) {
      if (!is_ready(*operand, bits, memo)) path.push_back(enclosure_node(*operand));
    }
    if (path.size() != depth) continue;
    path.pop_back();
    if (memo.contains(node)) continue;
    memo.emplace(node, evaluate(node->operation, Operand(node->left, bits, memo),
                                Operand(node->right, bits, memo), bits));
  }
  return Operand(value, bits, memo).interval();
}

bool same_expression(const Number& x, const Number& y) {
  std::vector<std::pair<const Number*, const Number*>> pending{{&x, &y}};
  std::set<std::pair<const Node*, const Node*>> seen;
  while (!pending.empty()) {
    const auto [a, b] = pending.back();
    pending.pop_back();
    const EnclosureNode* const node_a = enclosure_node(*a);
    const EnclosureNode* const node_b = enclosure_node(*b);
    if ((node_a == nullptr) != (node_b == nullptr)) return false;
    if (node_a == nullptr) {
      if (Number::compare(*a, *b) != 0) return false;
      continue;
    }
    if (node_a == node_b) continue;
    // Two values of one interval need not be equal: a `between` is the same only as itself.
    if (node_a->hash != node_b->hash || node_a->operation != node_b->operation ||
        node_a->operation == Operation::between) {
      return false;
    }
    if (!seen.insert({node_a, node_b}).second) continue;
    pending.emplace_back(&node_a->left, &node_b->left);
    pending.emplace_back(&node_a->right, &node_b->right);
  }
  return true;
}

std::optional<int> try_sign_of_enclosure(const Number& x) {
  const auto interval = refine(x, kLastBits, [](const Interval& i) { return i.sign() != 2; });
  if (!interval) return std::nullopt;
  return interval->sign();
}

int sign_of_enclosure(const Number& x) {
  const auto sign = try_sign_of_enclosure(x);
  if (!sign) undecided("a sign");
  return *sign;
}

int compare_enclosures(const Number& x, const Number& y) {
  if (same_expression(x, y)) return 0;
  const bool refinable = is_refinable(x) && is_refinable(y);
  const mpfr_prec_t last = refinable ? kLastBits : kLastBitsOfBetween;
  for (mpfr_prec_t bits = kBaseBits; bits <= last; bits *= 2) {
    const int order = compare(interval_of(x, bits), interval_of(y, bits));
    if (order != 2) return order;
  }
  undecided("a comparison");
}

Number floor_of_enclosure(const Number& x) {
  const auto interval = refine(x, kLastBits, [](const Interval& i) {
    return i.bounded() && floor_of_end(i.low()) == floor_of_end(i.high());
  });
  if (!interval) undecided("the next lower integer");
  return number_of(floor_of_end(interval->low()));
}

std::array<Number, 2> bounds_of_enclosure(const Number& x, int bits) {
  const EnclosureNode* const node = enclosure_node(x);
  if (node->operation == Operation::between) return {node->left, node->right};
  mpfr_prec_t last = 4 * kLastBits + mpfr_prec_t{4} * std::max(bits, 0);
  if (node->base.bounded()) last += mpfr_prec_t{4} * magnitude_bits(node->base);
  const auto narrow = [&](const Interval& i) {
    Interval width(kBaseBits);
    mpfr_sub(width.high(), i.high(), i.low(), MPFR_RNDU);
    return i.bounded() && mpfr_cmp_ui_2exp(width.high(), 1, -mpfr_exp_t{bits}) <= 0;
  };
  auto interval = refine(x, last, narrow);
  if (!interval && !node->refinable) interval = interval_of(x, kLastBitsOfBetween);
  if (!interval || !interval->bounded()) undecided("a bound");
  return {number_of(rational_end(interval->low())), number_of(rational_end(interval->high()))};
}

}  // namespace gonogo::exact
