// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>

#include "capture/export_header.hpp"
#include "capture/exporter.hpp"
#include "tests/has.hpp"

namespace gonogo::oracle {
namespace {

using reference::Axis;

reference::Profile plain(const std::string& dialect) {
  return std::get<reference::Profile>(reference::default_profile(dialect));
}

// From (10, 0) clockwise about (0, 0) by three quarters to (0, 10): through y -10 and x -10.
TEST(Extents, AnArcReachesItsExtremePoints) {
  const auto extents = extents_of(plain("rs274"), "G0 X10\nG2 X0 Y10 I-10 F150\nM2\n");
  ASSERT_TRUE(extents);
  EXPECT_EQ(extents->low[Axis::x], Number(-10));
  EXPECT_EQ(extents->high[Axis::x], Number(10));
  EXPECT_EQ(extents->low[Axis::y], Number(-10));
  EXPECT_EQ(extents->high[Axis::y], Number(10));
  EXPECT_EQ(extents->largest_feed, Number(150));
}

// A quarter from (10, 0) to (0, -10) touches no other extreme point.
TEST(Extents, AQuarterStaysInItsQuadrant) {
  const auto extents = extents_of(plain("rs274"), "G0 X10\nG2 X0 Y-10 I-10 F150\nM2\n");
  ASSERT_TRUE(extents);
  EXPECT_EQ(extents->low[Axis::x], Number(0));
  EXPECT_EQ(extents->high[Axis::y], Number(0));
}

// The pocket of radius 6 about (10, 10): all of it may be cleared, down to z 7.
TEST(Extents, APocketReachesAsFarAsItMayBeCleared) {
  const auto extents =
      extents_of(plain("gsk988ta"), "G17 G00 X20 Y10 Z10\nG110 X20 Y10 W-2 R-1 I6 L4 Q2 D4 F200\n");
  ASSERT_TRUE(extents);
  EXPECT_EQ(extents->low[Axis::y], Number(0));
  EXPECT_EQ(extents->high[Axis::x], Number(16));
  EXPECT_EQ(extents->high[Axis::y], Number(16));
}

TEST(Extents, FeedsPerRevolutionAndAlarmsAreNamed) {
  const auto rev = extents_of(plain("sinumerik840d"), "G95 G1 X10 F0.2\n");
  EXPECT_TRUE(rev->per_revolution);
  EXPECT_TRUE(extents_of(plain("gsk988ta"), "G00 X100 Z5\nG94 X60 Z-5\n")->alarms);
}

TEST(ExportHeader, LeadsToTheInitialPositionZFirst) {
  reference::Profile profile = plain("gsk988ta");
  profile.initial.at[Axis::x] = 30;
  profile.initial.at[Axis::z] = 12;
  const auto header = export_header(profile, "G01 X50 F100\n", {Axis::x});
  ASSERT_TRUE(header);
  EXPECT_TRUE(has(header->text, "G0 Z12\nG0 X60\n"));
  const auto mill = export_header(plain("rs274"), "G1 X50 F100\n", {Axis::x});
  ASSERT_TRUE(mill);
  EXPECT_TRUE(has(mill->text, "G0 Z0\nG0 X0 Y0\n"));
}

// rs274 has no motion in force at the start: a first block "X1" is a fault, and must stay one.
TEST(ExportHeader, LeavesTheMotionOfPowerOnInForce) {
  const auto header = export_header(plain("rs274"), "X1 F100\nG1 X2\n", {Axis::x});
  ASSERT_TRUE(header);
  EXPECT_TRUE(header->text.ends_with("G80\n")) << header->text;
}

TEST(Envelope, IsThreeRangesOfDecimals) {
  const auto envelope = envelope_of("-1..2.5,0..0,-200..10");
  ASSERT_TRUE(envelope);
  EXPECT_EQ((*envelope)[0][1], *Number::parse("2.5"));
  for (const char* text :
       {"", "1..2", "1..2,3..4", "2..1,0..1,0..1", "1..2,3..4,5..6,7..8", "a..2,0..1,0..1"}) {
    EXPECT_FALSE(envelope_of(text)) << text;
  }
}

// The header of a lathe's program that starts at X0 would traverse to the spindle's axis.
TEST(Exporter, NoHeaderLeadsToTheSpindlesAxis) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "gonogo-export-lathe";
  Case turned;
  turned.id = "a.1";
  turned.dialect = "hnc21t";
  turned.profile = plain("hnc21t");
  turned.program = "G01 X50 F100\n";
  Case milled = turned;
  milled.id = "a.2";
  milled.dialect = "rs274";
  milled.profile = plain("rs274");
  const auto exported = [&](const std::optional<Number>& x_zero_at) {
    fs::remove_all(folder);
    ExportOptions options;
    options.x_zero_at = x_zero_at;
    options.expected = true;
    Exporter exporter(folder.string(), options, {});
    exporter.add(turned);
    exporter.add(milled);
    return exporter.finish();
  };
  const std::string left_out = exported(std::nullopt);
  EXPECT_TRUE(has(left_out, "1 of 2 cases"));
  EXPECT_TRUE(has(left_out, "start-on-spindle-axis"));
  const std::string all = exported(Number(100));
  EXPECT_TRUE(has(all, "2 of 2 cases"));
  EXPECT_TRUE(fs::exists(folder / "compare.py"));
  EXPECT_GT(fs::file_size(folder / "expected.jsonl"), 0U);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace gonogo::oracle
