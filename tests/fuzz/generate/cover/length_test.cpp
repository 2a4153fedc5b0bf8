// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/cover/length.hpp"

#include <gtest/gtest.h>

#include "fuzz/generate/cover/parameters.hpp"

namespace gonogo::cover {
namespace {

TEST(Length, IsThousandthsAndIncrements) {
  EXPECT_EQ(Length::parse("12.5"), (Length{12'500, 0}));
  EXPECT_EQ(Length::parse("10+e"), (Length{10'000, 1}));
  EXPECT_EQ(Length::parse("10-e"), (Length{10'000, -1}));
  EXPECT_EQ(Length::parse("-e"), (Length{0, -1}));
  EXPECT_EQ(Length::parse("999e"), (Length{0, 999}));
  EXPECT_EQ(Length::parse("0.01-2e"), (Length{10, -2}));
}

TEST(Length, IsWrittenInLeastIncrements) {
  EXPECT_EQ(Length::parse("10-e").text(3), "9.999");
  EXPECT_EQ(Length::parse("10-e").text(5), "9.99999");
  EXPECT_EQ(Length::parse("e").text(4), "0.0001");
  EXPECT_EQ(Length::parse("-2.50").text(3), "-2.5");
  EXPECT_EQ(Length::parse("0").text(3), "0");
}

TEST(Length, HasTheSignOfItsMillimetres) {
  EXPECT_EQ(Length::parse("-10+e").sign(), -1);
  EXPECT_EQ(Length::parse("-e").sign(), -1);
  EXPECT_EQ(Length::parse("0").sign(), 0);
}

TEST(Length, RefusesWhatIsNone) {
  EXPECT_THROW(Length::parse("ten"), ModelError);
  EXPECT_THROW(Length::parse("0.0001"), ModelError);
}

}  // namespace
}  // namespace gonogo::cover
