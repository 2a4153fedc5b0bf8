// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which records of an expectation are one path of many.
#include "corpus/io/open_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "corpus_testing.hpp"

namespace gonogo::testing {
namespace {

using oracle::Expectation;
using oracle::OpenPart;
using reference::RecordKind;

Expectation expected(const std::string& dialect, const std::string& program) {
  auto profile = reference::profile_from_json("{\"dialect\":\"" + dialect + "\"}");
  return oracle::expectation_of(std::get<reference::Profile>(profile), program);
}

// The R plane is Y 50 - 5 = 45; layers of Q = 5 down to Y 20: 40, 35, 30, 25, 20. The pocket of
// radius 16 about Z 50, X 50 in diameter, with a tool of radius 4.
TEST(OpenParts, OfAPocketAreItsLayers) {
  const Expectation pocket = expected(
      "gsk988ta", "M3 S500\nG18 G0 X70 Z70 Y50\nG110 X50 Z50 Y20 R-5 I16 L3 Q5 P1 D4 F800\nM30\n");
  ASSERT_EQ(pocket.open.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    const OpenPart& layer = pocket.open[i];
    EXPECT_EQ(layer.path, "pocket-level");
    EXPECT_EQ(layer.conditions,
              R"({"plane":"G18","centre":{"z":"50","x":"25"},"depth":")" +
                  std::to_string(40 - 5 * static_cast<int>(i)) +
                  R"(","radius":"16","tool_radius":"4","step":"3","rot":-1,"f":"800"})");
    // A layer is cut in its plane: the infeed before it and the retract behind it are none of it.
    ASSERT_LT(layer.from, layer.to);
    for (std::size_t at = layer.from; at < layer.to; ++at) {
      EXPECT_EQ(pocket.records[at].kind, RecordKind::arc) << at;
    }
    EXPECT_EQ(pocket.records[layer.from - 1].kind, RecordKind::feed);
    EXPECT_EQ(pocket.records[layer.to].kind, RecordKind::rapid);
  }
}

TEST(OpenParts, OfAClosedPathAreNone) {
  EXPECT_TRUE(expected("gsk988ta", "M3 S500\nG00 X130 Z5\nG94 X0 Z0 F200\nM30\n").open.empty());
}

// The reading says the path: it is no example any more.
TEST(OpenParts, AreNoneWhereAReadingSaysThePath) {
  auto profile = reference::profile_from_json(
      R"({"dialect":"gsk988ta","readings":{"gsk.pocket.path":"semicircles"}})");
  ASSERT_TRUE(std::holds_alternative<reference::Profile>(profile))
      << std::get<reference::ProfileError>(profile).message;
  const Expectation pocket = oracle::expectation_of(
      std::get<reference::Profile>(profile),
      "M3 S500\nG18 G0 X70 Z70 Y50\nG110 X50 Z50 Y20 R-5 I16 L3 Q5 P1 D4 F800\n");
  EXPECT_TRUE(pocket.open.empty());
}

TEST(OpenParts, OfTheCheckedInCorpusLieBetweenClosedMotions) {
  std::size_t parts = 0;
  for (const auto& [id, test] : checked_in_cases()) {
    for (const Expectation& expectation : test.expect) {
      std::size_t before = 0;
      for (const OpenPart& part : expectation.open) {
        ++parts;
        EXPECT_LE(before, part.from) << id;
        EXPECT_LT(part.from, part.to) << id;
        EXPECT_GT(part.from, 0U) << id << ": something leads to it";
        before = part.to;
      }
    }
  }
  // Pockets, threads and helical pockets of GSK, LCYC75 of SINUMERIK.
  EXPECT_GE(parts, 1000U);
}

}  // namespace
}  // namespace gonogo::testing
