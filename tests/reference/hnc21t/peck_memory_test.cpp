// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block of a million pecks comes out one motion at a time.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "hnc_expanding.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

long peak_kib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

// The motions of a program, counted; `last` are the last three.
std::size_t count_motions(std::string_view program, const Profile& profile, Lines& last) {
  grammar::MemorySource bytes(program);
  grammar::LineSource source(bytes);
  Expander expander(profile, source, OpenPaths::shown);
  std::array<Item, 4> ring;
  std::size_t count = 0;
  while (const Item* item = expander.next()) ring[count++ % 4] = *item;
  for (std::size_t i = count - 4; i + 1 < count; ++i) last.push_back(line_of(ring[i % 4]));
  return count - 1;  // without `end`
}

// 1,000 mm in pecks of 0.001: a million pecks, all but the last with a withdrawal, and the way out.
TEST(PeckMemory, AMillionPecksTakeTheMemoryOfOne) {
  const Profile profile = hnc();
  Lines last;
  count_motions("G74 Z-1 R0.0005 Q0.001 F100", profile, last);
  const long before = peak_kib();
  last.clear();
  EXPECT_EQ(count_motions("G74 Z-1000 R0.0005 Q0.001 F100", profile, last), 2'000'000U);
  EXPECT_EQ(last, (Lines{"rapid z-999.9985", "feed z-1000 f100", "rapid z0"}));
  EXPECT_LT(peak_kib() - before, 4096);
}

// 1 mm of radius in pecks of 0.001, 101 times.
TEST(PeckMemory, AWideGrooveIsNoLonger) {
  const Profile profile = hnc();
  Lines last;
  count_motions("G75 X-2 Z-1 I1 R0.0005 Q0.001 F100", profile, last);
  const long before = peak_kib();
  last.clear();
  // 2,000 motions a plunge; between and after them 101 traverses along Z.
  EXPECT_EQ(count_motions("G75 X-2 Z-1 I100 R0.0005 Q0.001 F100", profile, last),
            101U * 2000U + 101U);
  EXPECT_EQ(last, (Lines{"feed x-1 f100", "rapid x0", "rapid z0"}));
  EXPECT_LT(peak_kib() - before, 4096);
}

TEST(PeckMemory, AThousandStartsAreAThousandPasses) {
  const Profile profile = hnc();
  Lines last;
  EXPECT_EQ(count_motions("G82 X20 Z-10 C1000 P0.36 F3", profile, last), 4000U);
  // Pass 999 starts at 359.64 degrees.
  EXPECT_EQ(last, (Lines{"thread x10 z-10 lead3 start359.64", "rapid x0", "rapid z0"}));
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
