// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/cover/covering_array.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "fuzz/generate/cover/tuple_count.hpp"

namespace gonogo::cover {
namespace {

// Up to six parameters of up to four classes, some of which must alarm, and up to five rules of two
// or three classes that leave the row of first classes.
Parameters some_parameters() {
  const int parameters = *rc::gen::inRange(1, 7);
  std::vector<int> classes;
  std::string text;
  for (int p = 0; p < parameters; ++p) {
    classes.push_back(*rc::gen::inRange(1, 5));
    text += fmt::format("p{}: 0", p);
    for (int c = 1; c < classes.back(); ++c) {
      const bool fault = *rc::gen::inRange(0, 4) == 0;
      text += fmt::format(" {}{}{}", fault ? "!" : "", c, fault ? "@syntax" : "");
    }
    text += '\n';
  }
  const int rules = *rc::gen::inRange(0, 6);
  for (int r = 0; r < rules && parameters > 2; ++r) {
    const int first = *rc::gen::inRange(0, parameters - 1);
    if (classes[static_cast<std::size_t>(first)] == 1) continue;
    const int own = *rc::gen::inRange(1, classes[static_cast<std::size_t>(first)]);
    const int second = *rc::gen::inRange(first + 1, parameters);
    const int other = *rc::gen::inRange(0, classes[static_cast<std::size_t>(second)]);
    text += fmt::format("no: p{}={} p{}={}\n", first, own, second, other);
  }
  return parse_parameters(text);
}

RC_GTEST_PROP(CoveringArray, HoldsEveryTupleThatTheRulesAllow, ()) {
  const Parameters parameters = some_parameters();
  const Strength strength{*rc::gen::inRange(1U, 5U), *rc::gen::inRange(1U, 4U)};
  const CoveringArray array =
      covering_array(parameters, strength, *rc::gen::arbitrary<std::uint64_t>());
  const TupleCount count = count_tuples(parameters, strength, array.rows);
  RC_ASSERT(count.missing.empty());
  RC_ASSERT(count.invalid.empty());
  RC_ASSERT(count.allowed == array.tuples);
  RC_ASSERT(count.excluded == array.excluded);
}

RC_GTEST_PROP(CoveringArray, IsAFunctionOfParametersStrengthAndSeed, (std::uint64_t seed)) {
  const Parameters parameters = some_parameters();
  RC_ASSERT(covering_array(parameters, {2, 2}, seed).rows ==
            covering_array(parameters, {2, 2}, seed).rows);
}

TEST(CoveringArray, IsFarSmallerThanTheProduct) {
  // Ten parameters of three classes: 59,049 rows in all, at least 27 for the triples.
  std::string text;
  for (int p = 0; p < 10; ++p) text += fmt::format("p{}: 0 1 2\n", p);
  const std::size_t rows = covering_array(parse_parameters(text), {3, 3}, 1).rows.size();
  EXPECT_GE(rows, 27U);
  EXPECT_LE(rows, 90U);
}

TEST(CoveringArray, RefusesRulesThatLeaveNothing) {
  EXPECT_THROW(covering_array(parse_parameters("a: 0\nb: 0\nno: a=0 b=0\n"), {2, 2}, 1),
               ModelError);
}

TEST(CoveringArray, PutsRowsWithoutAFaultFirst) {
  const Parameters parameters = parse_parameters("a: 0 1 !bad@syntax\nb: 0 1\n");
  const CoveringArray array = covering_array(parameters, {2, 2}, 1);
  ASSERT_EQ(array.rows.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(array.rows[i][0] == 2, i >= 4) << i;
}

}  // namespace
}  // namespace gonogo::cover
