// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a sheet shows besides its paths: pockets, names, motions side by side, small departures.
#include <gtest/gtest.h>

#include "oracle/report/case_detail.hpp"
#include "oracle/report/deflate.hpp"
#include "oracle/report/named_points.hpp"
#include "oracle/report/page_paths.hpp"
#include "oracle/report/sheet.hpp"
#include "oracle/report/unfolded.hpp"
#include "tests/oracle/report/report_testing.hpp"

namespace gonogo::oracle::report {
namespace {

Path reference_of(const char* dialect, const char* program) {
  const auto profile = case_profile(dialect, Json::object());
  return reference_path(std::get<reference::Profile>(profile), program).path;
}

std::vector<Limit> limits_of_text(const char* dialect, const char* program) {
  const auto profile = case_profile(dialect, Json::object());
  return limits_of_program(std::get<reference::Profile>(profile), program);
}

constexpr const char* kPocket =
    "N100 G18 G0 X70 Z70 Y50\nN110 G110 X50 Z50 Y20 R-5 I16 L3 Q5 P1 D4 F800\n";

// I 16 less D 4: the tool's centre may go to 12; the disc drawn has the radius 4.
TEST(SheetExtras, a_pocket_shows_its_wall_and_what_the_tool_cuts_leaves_and_gouges) {
  const Path path = reference_of("gsk988ta", kPocket);
  Sheet sheet;
  sheet.reference = &path;
  sheet.limits = limits_of_text("gsk988ta", kPocket);
  ASSERT_FALSE(sheet.limits.empty());
  sheet.lathe = true;
  const std::string svg = svg_sheet(sheet);
  for (const char* part : {"gs-swept gs-cut", "gs-swept gs-gouged", "gs-uncut\"", "clipPath"}) {
    EXPECT_GE(occurrences(svg, part), 1U) << part;
  }
  // In one view only, the one along the depth.
  EXPECT_EQ(occurrences(svg, "<clipPath"), 1U);
  EXPECT_NE(svg.find("tool \xC3\x98 8"), std::string::npos);
}

// The taper of the manual: A at the start, B at Z -40 = C + R, C at Z -30, D back on Z of A.
TEST(SheetExtras, points_have_the_names_that_the_clauses_give_them) {
  const Path path =
      reference_of("gsk988ta", "G00 X130 Z5 M3 S500;\nG00 X120 Z0;\nG94 X108 Z-30 R-10 F300;\n");
  const Names names = names_in(path, 3);
  ASSERT_EQ(names.points.size(), 4U);
  EXPECT_EQ(names.points[0].name, "A");
  EXPECT_EQ(names.points[0].at, (Point3{60, 0, 0}));
  EXPECT_EQ(names.points[1].name, "B");
  EXPECT_EQ(names.points[1].at, (Point3{60, 0, -40}));
  EXPECT_EQ(names.points[2].name, "C");
  EXPECT_EQ(names.points[2].at, (Point3{54, 0, -30}));
  EXPECT_EQ(names.points[3].name, "D");
  EXPECT_EQ(names.points[3].at, (Point3{54, 0, 0}));
  EXPECT_EQ(names.axes, (std::map<char, char>{{'p', 'Z'}}));
}

// R -5 from the initial plane Y 50.
TEST(SheetExtras, the_r_plane_is_named_where_the_tool_stops_for_it) {
  const Names names = names_in(reference_of("gsk988ta", kPocket), 2);
  ASSERT_FALSE(names.planes.empty());
  EXPECT_EQ(names.planes[0].name, "R plane");
  EXPECT_EQ(names.planes[0].axis, 'Y');
  EXPECT_DOUBLE_EQ(names.planes[0].at, 45);
}

// Down to R at Z1 in line 2. Line 3 begins at R with an initial level of Z5, and under the reading
// of LinuxCNC goes to that level first, by a motion of the same clause.
TEST(SheetExtras, the_r_plane_of_a_hole_is_where_the_cut_begins) {
  for (const char* reading : {"current-level", "initial-level"}) {
    auto profile = std::get<reference::Profile>(case_profile("rs274", Json::object()));
    ASSERT_FALSE(reference::set_reading(profile, "ngc.cycle.approach", reading)) << reading;
    const Path path = reference_path(profile, "G0 Z5\nG99 G81 X10 Z-6 R1 F100\nG98 X20\nM2\n").path;
    for (const std::uint64_t block : {2U, 3U}) {
      const Names names = names_in(path, block);
      for (const NamedPlane& plane : names.planes) {
        EXPECT_EQ(plane.axis, 'Z') << reading;
        EXPECT_DOUBLE_EQ(plane.at, 1) << reading;
      }
      const std::size_t named = names.planes.size();
      EXPECT_TRUE(block == 3 || named == 1) << reading;
    }
  }
}

Path pecks(int count) {
  Path path;
  double at = 0;
  for (int i = 1; i <= count; ++i) {
    path.motions.push_back(line({0, 0, at}, {0, 0, -5.0 * i}));
    path.motions.push_back(line({0, 0, -5.0 * i}, {0, 0, 0}, true));
    at = 0;
  }
  return path;
}

TEST(SheetExtras, pecks_are_shown_motion_beside_motion) {
  const Path path = pecks(3);
  Sheet sheet;
  sheet.reference = &path;
  EXPECT_EQ(occurrences(svg_sheet(sheet), "data-view=\"unfolded\""), 1U);
  const Path single = pecks(1);
  sheet.reference = &single;
  EXPECT_EQ(occurrences(svg_sheet(sheet), "data-view=\"unfolded\""), 0U);
}

TEST(SheetExtras, an_unfolded_path_keeps_its_records_and_its_coordinate) {
  const Path path = pecks(3);
  const auto how = unfolding_of(path, 0);
  ASSERT_TRUE(how);
  EXPECT_EQ(how->axis, 'Z');
  const Path flat = unfolded(path, *how);
  ASSERT_EQ(flat.motions.size(), 6U);
  EXPECT_EQ(flat.motions[2].points.front(), (Point3{2, 0, 0}));
  EXPECT_EQ(flat.motions[2].points.back(), (Point3{3, 0, -10}));
}

TEST(SheetExtras, a_departure_below_a_pixel_is_drawn_large) {
  const Path path{{line({0, 0, 0}, {100, 0, 0}), line({100, 0, 0}, {100, 0, 80})}};
  Sheet sheet;
  sheet.reference = &path;
  sheet.departing = &path;
  sheet.witness = Point3{100, 0, 80.001};
  EXPECT_EQ(occurrences(svg_sheet(sheet), "gs-inset"), 1U);
  sheet.witness = Point3{100, 0, 90};  // can be seen
  EXPECT_EQ(occurrences(svg_sheet(sheet), "gs-inset"), 0U);
  // On the path, but not where the motion had to end.
  sheet.witness = Point3{99.999, 0, 0};
  EXPECT_EQ(occurrences(svg_sheet(sheet), "gs-inset"), 0U);
  sheet.expected = Point3{100, 0, 0};
  EXPECT_EQ(occurrences(svg_sheet(sheet), "gs-inset"), 1U);
}

TEST(PagePaths, are_steps_in_a_tenth_of_a_micrometre) {
  Path path{{line({1, 0, 0}, {1, 2, 0}, true), line({1, 2, 0}, {1, 2, -0.5})}};
  path.motions.push_back(Motion{});
  path.motions.back().points = {{1, 2, -0.5}};
  path.motions.push_back(line({0, 0, 0}, {0, 0, 1}));  // after a renaming
  EXPECT_EQ(moves_json(path, 16), (Json{{3, 10000, 0, 0, 0, 20000, 0},
                                        {0, 0, 0, -5000},
                                        Json::array(),
                                        {2, 0, 0, 0, 0, 0, 10000}}));
}

TEST(PassDetail, has_program_path_and_the_clause_of_each_motion) {
  const Json detail =
      pass_detail({"rs274", "two feeds", Json::object(), "G0 X1\nG1 X2 F100\nM2\n"});
  EXPECT_EQ(detail["program"], "G0 X1\nG1 X2 F100\nM2\n");
  EXPECT_EQ(detail["motions"][1], (Json{"feed", 2, "NGC-G0-01"}));
  EXPECT_EQ(detail["moves"]["r"][1], (Json{0, 10000, 0, 0}));
}

TEST(Deflate, what_is_packed_comes_out_again) {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "line " + std::to_string(i * 7919 % 1000) + "</script>";
  EXPECT_EQ(unpacked(packed(text)), text);
  EXPECT_EQ(packed(text).find('<'), std::string::npos);
  EXPECT_EQ(unpacked(packed("")), "");
}

}  // namespace
}  // namespace gonogo::oracle::report
