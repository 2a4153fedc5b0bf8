// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the depth is divided, on the manual's three programs. Equal: n = ceil(D / R121) steps of D/n.
#include <gtest/gtest.h>

#include "s802_expanding.hpp"

namespace gonogo::reference::testing::sie {
namespace {

using Depths = std::vector<std::string>;

Profile divided(std::string_view infeed, std::string_view from) {
  return s802({{"sie.infeed", infeed}, {"sie.infeed-from", from}});
}

// Where the feeds along the depth axis alone end, of the cycle in one line.
Depths levels(std::string_view program, std::uint64_t block, const Profile& profile) {
  Depths depths;
  for (const Item& item : expand(program, profile)) {
    const auto* record = std::get_if<Record>(&item);
    if (record == nullptr || record->kind != RecordKind::feed || record->block != block) continue;
    for (const Axis axis : kLinearAxes) {
      if (record->axes == AxisSet{axis}) depths.push_back(record->to[axis].text());
    }
  }
  return depths;
}

// D = 17 to the floor at -17: 17/5 = 3.4; from 2 above 19/5 = 3.8.
TEST(Lcyc75Levels, OfTheRectangle) {
  const std::string program = rectangle_program();
  EXPECT_EQ(levels(program, 9, divided("equal", "reference")),
            (Depths{"-3.4", "-6.8", "-10.2", "-13.6", "-17"}));
  EXPECT_EQ(levels(program, 9, divided("equal", "clearance")),
            (Depths{"-1.8", "-5.6", "-9.4", "-13.2", "-17"}));
  EXPECT_EQ(levels(program, 9, divided("max-rest", "reference")),
            (Depths{"-4", "-8", "-12", "-16", "-17"}));
  EXPECT_EQ(levels(program, 9, divided("max-rest", "clearance")),
            (Depths{"-2", "-6", "-10", "-14", "-17"}));
}

TEST(Lcyc75Levels, ShownAreEqualOnesFromTheReferencePlane) {
  EXPECT_EQ(levels(rectangle_program(), 9, s802()),
            levels(rectangle_program(), 9, divided("equal", "reference")));
}

// 17.5/5 = 3.5 and 19.5/5 = 3.9.
TEST(Lcyc75Levels, OfFinishingAreDividedToTheDepth) {
  const std::string program = rectangle_program();
  EXPECT_EQ(levels(program, 12, divided("equal", "reference")),
            (Depths{"-3.5", "-7", "-10.5", "-14", "-17.5"}));
  EXPECT_EQ(levels(program, 12, divided("equal", "clearance")),
            (Depths{"-1.9", "-5.8", "-9.7", "-13.6", "-17.5"}));
}

// With a clearance of 0.5: (17 + 0.5)/5 = 3.5.
TEST(Lcyc75Levels, BeginHalfAMillimetreAbove) {
  const std::string program = rectangle_program("0", "0.5");
  EXPECT_EQ(levels(program, 9, divided("equal", "clearance")),
            (Depths{"-3", "-6.5", "-10", "-13.5", "-17"}));
  EXPECT_EQ(levels(program, 9, divided("max-rest", "clearance")),
            (Depths{"-3.5", "-7.5", "-11.5", "-15.5", "-17"}));
}

// R103 = 9 as printed, with a retract plane that admits it: 26/7 from 9, and exactly 7 x 4 from 11.
TEST(Lcyc75Levels, FromTheReferencePlaneAsPrinted) {
  const std::string program = pocket_program("R101=11 R103=9 R104=-17.5");
  EXPECT_EQ(levels(program, 6, divided("equal", "reference")),
            (Depths{"37/7", "11/7", "-15/7", "-41/7", "-67/7", "-93/7", "-17"}));
  EXPECT_EQ(levels(program, 6, divided("equal", "clearance")),
            (Depths{"7", "3", "-1", "-5", "-9", "-13", "-17"}));
}

TEST(Lcyc75Levels, OfTheCircle) {
  const std::string program = circle_program();
  EXPECT_EQ(levels(program, 6, divided("equal", "reference")),
            (Depths{"-4", "-8", "-12", "-16", "-20"}));
  EXPECT_EQ(levels(program, 6, divided("equal", "clearance")),
            (Depths{"-5/3", "-16/3", "-9", "-38/3", "-49/3", "-20"}));
  EXPECT_EQ(levels(program, 6, divided("max-rest", "clearance")),
            (Depths{"-2", "-6", "-10", "-14", "-18", "-20"}));
}

TEST(Lcyc75Levels, OfTheSlots) {
  const std::string program = slots_program();
  EXPECT_EQ(levels(program, 8, divided("equal", "reference")),
            (Depths{"-5.75", "-11.5", "-17.25", "-23"}));
  EXPECT_EQ(levels(program, 8, divided("equal", "clearance")), (Depths{"-5", "-11", "-17", "-23"}));
  EXPECT_EQ(levels(program, 14, divided("max-rest", "reference")),
            (Depths{"-6", "-12", "-18", "-23"}));
}

TEST(Lcyc75Levels, OneWhereTheInfeedIsTheDepth) {
  EXPECT_EQ(levels(pocket_program("R121=7.5"), 6, s802()), Depths{"-7.5"});
  EXPECT_EQ(levels(pocket_program("R121=7.499"), 6, s802()), (Depths{"-3.75", "-7.5"}));
}

TEST(Lcyc75Levels, TheJudgeIsToldTheRule) {
  const auto rule = [](const Profile& profile) {
    const PocketMilling pocket = pockets(pocket_program(), profile).at(0);
    return std::pair(pocket.levels, pocket.levels_from_clearance);
  };
  EXPECT_EQ(rule(s802()), std::pair(Levels::open, false));
  EXPECT_EQ(rule(divided("equal", "reference")), std::pair(Levels::equal, false));
  EXPECT_EQ(rule(divided("max-rest", "clearance")), std::pair(Levels::max_rest, true));
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
