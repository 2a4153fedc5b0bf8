// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/followed_readings.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gonogo::oracle {
namespace {

std::string said_of(const std::vector<std::string>& assignments) {
  return followed_readings(assignments);
}

// `gsk.x-depth` is `diameter` and `gsk.zero-depth` is `no-cut` where nobody says otherwise.
TEST(FollowedReadings, WhatIsTheDefaultIsCounted) {
  EXPECT_EQ(said_of({"gsk.x-depth=diameter"}), "the defaults of 1 reading");
  EXPECT_EQ(said_of({"gsk.x-depth=diameter gsk.zero-depth=no-cut"}), "the defaults of 2 readings");
}

TEST(FollowedReadings, WhatIsNotTheDefaultIsNamed) {
  EXPECT_EQ(said_of({"gsk.x-depth=radius gsk.zero-depth=no-cut"}),
            "the defaults of 1 reading, except gsk.x-depth=radius");
}

TEST(FollowedReadings, WhatNoCaseToldApartIsNamed) {
  EXPECT_EQ(said_of({"gsk.x-depth=diameter gsk.zero-depth=no-cut",
                     "gsk.x-depth=radius gsk.zero-depth=no-cut"}),
            "the defaults of 1 reading; cannot be told apart: gsk.x-depth=diameter or radius");
}

TEST(FollowedReadings, WhereNoReadingMatteredNothingIsSaid) {
  EXPECT_EQ(said_of({}), "");
}

}  // namespace
}  // namespace gonogo::oracle
