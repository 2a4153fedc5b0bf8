// SPDX-License-Identifier: GPL-3.0-or-later
// G80 and G81 by the worked tables of the maker's examples. Words X are diameters: X50 is x=25.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

// The motions after the first `count` records.
std::string after(const Outcome& outcome, std::ptrdiff_t count = 1) {
  return joined({outcome.records.begin() + count, outcome.records.end() - 1});
}

TEST(HncG80, TaperOfTheMakersExample) {
  // A (50, 4), I-8.5: B = C - 17 in diameters, at Z4: 23.5, 19, 14.5, 10, 8.
  const Outcome outcome = run_hnc(
      "G90 G00 X50 Z4\nG80 X40.5 Z-30I-8.5 F100\nX36 Z-30I-8.5\nX31.5 Z-30I-8.5\n"
      "X27 Z-30 I-8.5\nX25 Z-30I-8.5 F 40\nG00 X50 Z50\n");
  std::string expected;
  const char* passes[][3] = {{"11.75", "20.25", "100"},
                             {"9.5", "18", "100"},
                             {"7.25", "15.75", "100"},
                             {"5", "13.5", "100"},
                             {"4", "12.5", "40"}};
  for (const auto& [b, c, f] : passes) {
    expected += std::string("rapid x=") + b + "\nfeed x=" + c + " z=-30 f=" + f +
                "\nfeed x=25 f=" + f + "\nrapid z=4\n";
  }
  EXPECT_EQ(after(outcome), expected + "rapid x=25 z=50\n");
}

TEST(HncG80, BoreGoesOutwards) {
  EXPECT_EQ(after(run_hnc("G00 X28 Z2\nG80 X34 Z-25 F9\n")),
            "rapid x=17\nfeed x=17 z=-25 f=9\nfeed x=14 f=9\nrapid z=2\n");
}

TEST(HncG80, SmallTaper) {
  // A (90, 4): B_x = 61.125 - 1.88 = 59.245.
  EXPECT_EQ(after(run_hnc("G00 X90 Z4\nG80 X61.125 Z-30 I-0.94 F80\n")),
            "rapid x=29.6225\nfeed x=30.5625 z=-30 f=80\nfeed x=45 f=80\nrapid z=4\n");
}

TEST(HncG80, IncrementsCountFromTheSameStartInEveryBlock) {
  // A (0, 0), I-5.5: B at -5 - 5.5, then -6.5 - 5.5 as radii.
  EXPECT_EQ(run_hnc("G91 G80 X-10 Z-33 I-5.5 F100\nX-13 Z-33\n").motions(),
            "rapid x=-10.5\nfeed x=-5 z=-33 f=100\nfeed x=0 f=100\nrapid z=0\n"
            "rapid x=-12\nfeed x=-6.5 z=-33 f=100\nfeed x=0 f=100\nrapid z=0\n");
}

TEST(HncG80, AxesMayBeMixed) {
  const std::string wanted = "rapid x=20\nfeed x=20 z=-30 f=9\nfeed x=25 f=9\nrapid z=4\n";
  EXPECT_EQ(after(run_hnc("G00 X50 Z4\nG80 X40 W-34 F9\n")), wanted);
  EXPECT_EQ(after(run_hnc("G00 X50 Z4\nG80 U-10 Z-30 F9\n")), wanted);
}

TEST(HncG81, TaperFaceOfTheMakersExample) {
  // A (56, 45), K-6: B_z = C_z - 6: 31, 28, 25, 24.
  const Outcome outcome =
      run_hnc("G90 G00 X56 Z45\nG81 X20 Z37 K-6 F100\nX20 Z34 K-6\nX20 Z31 K-6\nX20 Z30 K-6 F40\n");
  std::string expected;
  const char* passes[][3] = {
      {"31", "37", "100"}, {"28", "34", "100"}, {"25", "31", "100"}, {"24", "30", "40"}};
  for (const auto& [b, c, f] : passes) {
    expected += std::string("rapid z=") + b + "\nfeed x=10 z=" + c + " f=" + f +
                "\nfeed z=45 f=" + f + "\nrapid x=28\n";
  }
  EXPECT_EQ(after(outcome), expected);
}

TEST(HncG81, RepeatsWithTheCodeWrittenAgain) {
  // A (60, 45), K-3.5: B_z 28, 26.
  EXPECT_EQ(after(run_hnc("G54 G90 G00 X60 Z45\nG81 X25 Z31.5 K-3.5 F100\nG81 X25 Z29.5\n")),
            "rapid z=28\nfeed x=12.5 z=31.5 f=100\nfeed z=45 f=100\nrapid x=30\n"
            "rapid z=26\nfeed x=12.5 z=29.5 f=100\nfeed z=45 f=100\nrapid x=30\n");
}

TEST(HncG81, StraightFaceByIncrements) {
  EXPECT_EQ(run_hnc("G91 G81 X-15 Z-8 F37\nX-15 Z-11\n").motions(),
            "rapid z=-8\nfeed x=-7.5 z=-8 f=37\nfeed z=0 f=37\nrapid x=0\n"
            "rapid z=-11\nfeed x=-7.5 z=-11 f=37\nfeed z=0 f=37\nrapid x=0\n");
}

}  // namespace
}  // namespace gonogo::expanders::testing
