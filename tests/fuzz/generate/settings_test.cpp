// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "fuzz/generate/generator_settings.hpp"

namespace gonogo::generate {
namespace {

TEST(GeneratorSettings, AListChangesWhatItNames) {
  const auto read =
      read_settings("raw=3,tiny=2,near-invalid=0,blocks=4,readings=off,pockets=off,pecks=2");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->kinds.raw, 3U);
  EXPECT_EQ(read->kinds.tiny, 2U);
  EXPECT_EQ(read->kinds.near_invalid, 0U);
  EXPECT_EQ(read->most_blocks, 4);
  EXPECT_FALSE(read->machine.readings);
  EXPECT_TRUE(read->machine.offsets);
  EXPECT_FALSE(read->pockets);
  EXPECT_EQ(read->pecks, 2);
  EXPECT_EQ(read->layers, GeneratorSettings{}.layers);
}

TEST(GeneratorSettings, AnEmptyListChangesNothing) {
  const auto read = read_settings("", in_process_settings());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->kinds.boundary, in_process_settings().kinds.boundary);
  EXPECT_EQ(read->most_blocks, in_process_settings().most_blocks);
}

TEST(GeneratorSettings, WhatIsNoSettingIsRefused) {
  for (const char* text :
       {"blocks", "blocks=", "blocks=x", "blocks=0", "blocks=-1", "blocks=4x", "blocks=1001",
        "fault-one-in=0", "open-one-in=0", "readings=maybe", "readings=1", "colour=1",
        "near-invalid=0", "valid=1,near-invalid=4294967296"}) {
    EXPECT_FALSE(read_settings(text)) << text;
  }
}

}  // namespace
}  // namespace gonogo::generate
