// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a sheet shows besides its paths: pockets, names, motions side by side, small departures.
#include <gtest/gtest.h>

#include <regex>

#include "publish/report/case_detail.hpp"
#include "publish/report/deflate.hpp"
#include "publish/report/page_paths.hpp"
#include "publish/report/pocket_area.hpp"
#include "publish/report/sheet.hpp"
#include "publish/report/unfolded.hpp"
#include "tests/publish/report/report_testing.hpp"

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

// Levels from Z0 down to the floor at Z-5: a departure elsewhere says nothing of any of them.
TEST(SheetExtras, the_area_of_a_pocket_is_drawn_at_the_depth_of_the_departure_or_not_at_all) {
  const auto profile = case_profile("sinumerik802s", {{"tools", {{"1", {{"radius", "5"}}}}}});
  const auto limits = limits_of_program(
      std::get<reference::Profile>(profile),
      "T1 D1 M3 S100\nR101=5 R102=2 R103=0 R104=-5 R116=0 R117=0 R118=60 R119=40 R120=8 R121=4\n"
      "R122=100 R123=200 R124=0 R125=0 R126=2 R127=1\nG0 X0 Y0 Z20\nLCYC75\nM2\n");
  ASSERT_FALSE(limits.empty());
  const auto depth_at = [&](double z) -> std::optional<double> {
    const auto level = level_shown(limits, 5, Point3{0, 0, z});
    return level ? std::optional(level->level->depth) : std::nullopt;
  };
  EXPECT_EQ(depth_at(-5), -5);
  EXPECT_EQ(depth_at(-2), -2);
  for (const double outside : {0.0, 0.25, 5.0, -5.5}) EXPECT_FALSE(depth_at(outside)) << outside;
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

struct Labelled {
  const char* dialect;
  const char* program;
  std::uint64_t line;  // of the cycle
  char axis;
  std::vector<std::pair<const char*, double>> planes;
};

// Depths are those of the words: R of the GSK counts from the initial plane, as its own examples
// have it; those of the 802S are coordinates.
std::vector<Labelled> labelled() {
  std::vector<Labelled> all;
  static std::vector<std::string> programs;
  programs.reserve(32);
  const auto add = [&](const char* dialect, std::string program, std::uint64_t line, char axis,
                       std::vector<std::pair<const char*, double>> planes) {
    all.push_back({dialect, programs.emplace_back(std::move(program)).c_str(), line, axis,
                   std::move(planes)});
  };
  for (const char* const code : {"G110", "G111"}) {
    add("gsk988ta",
        std::string("M3 S100\nG18 G0 X70 Z70 Y50\n") + code +
            " X50 Z50 Y20 R-5 I16 L3 Q5 P1 D4 F800\n",
        3, 'Y', {{"R plane", 45}, {"initial plane", 50}});
  }
  for (const char* const code : {"G112", "G113"}) {
    add("gsk988ta",
        std::string("M3 S100\nG18 G0 X70 Z70 Y50\n") + code + " X50 Z50 Y20 R-5 I16 L3 D4 F800\n",
        3, 'Y', {{"R plane", 45}, {"initial plane", 50}});
  }
  for (const char* const code : {"G114", "G115", "G116", "G117"}) {
    add("gsk988ta",
        std::string("M3 S100\nG17 G0 X0 Y0 Z30\n") + code +
            " X0 Y0 Z-12 R-25 I2 P1 D3 E30 J1 K90 F100\n",
        3, 'Z', {{"R plane", 5}, {"initial plane", 30}});
  }
  for (const char* const words :
       {"G73 Q2", "G74", "G81", "G82 P0", "G83 Q2", "G84", "G85", "G86 P0", "G89 P0"}) {
    const std::string spindle = std::string(words) == "G74" ? "M4" : "M3";
    add("rs274", spindle + " S100 F100\nG0 Z5\n" + words + " X10 Z-6 R1.5\nM2\n", 3, 'Z',
        {{"R plane", 1.5}});
  }
  // The origin of G55 lies 4 mm down.
  add("rs274", "M3 S100 F100\nG10 L2 P2 Z-4\nG55 G0 Z5\nG81 X10 Z-6 R1.5\nM2\n", 4, 'Z',
      {{"R plane", -2.5}});
  add("sinumerik802s",
      "M3 S100 F100\nR101=9 R102=2 R103=1 R104=-10 R105=0\nG0 X0 Y0 Z20\nLCYC82\nM2\n", 4, 'Z',
      {{"R101", 9}, {"R103 + R102", 3}, {"R104", -10}});
  add("sinumerik802s",
      "T1 D1 M3 S100\nR101=9 R102=2 R103=1 R104=-10 R116=0 R117=0 R118=60 R119=40 R120=8 R121=4\n"
      "R122=100 R123=200 R124=0 R125=0 R126=2 R127=1\nG0 X0 Y0 Z20\nLCYC75\nM2\n",
      5, 'Z', {{"R101", 9}, {"R103 + R102", 3}, {"R104", -10}});
  return all;
}

TEST(SheetExtras, planes_lie_at_the_values_of_their_parameters_in_every_cycle) {
  for (const Labelled& cycle : labelled()) {
    const auto profile = case_profile(cycle.dialect, {{"tools", {{"1", {{"radius", "5"}}}}}});
    const DrawnPath drawn = reference_path(std::get<reference::Profile>(profile), cycle.program);
    const Names names = names_in(drawn.path, cycle.line);
    ASSERT_EQ(names.planes.size(), cycle.planes.size()) << cycle.program << drawn.note;
    for (std::size_t i = 0; i < cycle.planes.size(); ++i) {
      EXPECT_EQ(names.planes[i].name, cycle.planes[i].first) << cycle.program;
      EXPECT_EQ(names.planes[i].axis, cycle.axis) << cycle.program;
      EXPECT_DOUBLE_EQ(names.planes[i].at, cycle.planes[i].second) << cycle.program;
    }
  }
}

// Where a plane is seen as a line, and its name: "M70 60h500", "v90" of an upright line.
struct SeenPlane {
  double x, y, way;
  bool level;
  SheetBox name;
};

// Letters of names are at least 6 pixels wide and 8 high.
std::vector<SeenPlane> seen_planes(const std::string& view) {
  static const std::regex kPlane(
      R"re(gs-plane" d="M(\S+) ([^hv]+)([hv])([^"]+)"/><text x="(\S+)" y="(\S+)" class="gs-point" ([^>]*)>([^<]+)<)re");
  std::vector<SeenPlane> planes;
  for (std::sregex_iterator at(view.begin(), view.end(), kPlane), end; at != end; ++at) {
    const auto number = [&](std::size_t part) { return std::stod((*at)[part]); };
    const std::string how = (*at)[7];
    const double width = 6 * static_cast<double>((*at)[8].length());
    const bool ends = how.find("anchor=\"end\"") != std::string::npos;
    const SheetBox lying{number(5) - (ends ? width : 0), number(6) - 8, width, 8};
    const SheetBox upright{number(5) - 8, number(6) - (ends ? 0 : width), 8, width};
    planes.push_back({number(1), number(2), number(4), (*at)[3] == "h",
                      how.find("rotate") != std::string::npos ? upright : lying});
  }
  return planes;
}

TEST(SheetExtras, the_name_of_a_plane_lies_on_the_line_of_no_plane) {
  std::size_t names = 0;
  for (const Labelled& cycle : labelled()) {
    const auto profile = case_profile(cycle.dialect, {{"tools", {{"1", {{"radius", "5"}}}}}});
    const DrawnPath drawn = reference_path(std::get<reference::Profile>(profile), cycle.program);
    Sheet sheet;
    sheet.reference = &drawn.path;
    sheet.block = cycle.line;
    sheet.lathe = is_lathe(cycle.dialect);
    const std::string svg = svg_sheet(sheet);
    for (std::size_t from = svg.find("<g data-view"); from != std::string::npos;) {
      const std::size_t next = svg.find("<g data-view", from + 1);
      const std::vector<SeenPlane> planes = seen_planes(svg.substr(from, next - from));
      names += planes.size();
      for (const SeenPlane& named : planes) {
        for (const SeenPlane& line : planes) {
          const SheetBox& box = named.name;
          const bool crosses = line.level ? box.y < line.y && line.y < box.y + box.height
                                          : box.x < line.x && line.x < box.x + box.width;
          EXPECT_FALSE(crosses) << cycle.program << line.x << ' ' << line.y;
        }
      }
      from = next;
    }
  }
  EXPECT_GT(names, 2 * labelled().size());
}

// A at (X30, Z5), C at (X20, Z-30), the taper 4: on X for the cycles that cut along Z, on Z for
// those that cut along X. All are radii; programs have diameters.
TEST(SheetExtras, corners_lie_where_the_words_put_them_in_every_cutting_cycle) {
  struct Cutting {
    const char* dialect;
    const char* code;
    const char* words;
    bool along_x;
  };
  for (const Cutting& cycle :
       {Cutting{"gsk988ta", "G90", "R-4", false}, Cutting{"gsk988ta", "G92", "R-4 J0 K0", false},
        Cutting{"gsk988ta", "G94", "R-4", true}, Cutting{"hnc21t", "G80", "I-4", false},
        Cutting{"hnc21t", "G81", "K-4", true}, Cutting{"hnc21t", "G82", "I-4", false}}) {
    const std::string program = std::string("M3 S100\nG00 X60 Z5\n") + cycle.code + " X40 Z-30 " +
                                cycle.words + " F2\nM30\n";
    const Names names = names_in(reference_of(cycle.dialect, program.c_str()), 3);
    ASSERT_EQ(names.points.size(), 4U) << program;
    EXPECT_EQ(names.points[0].at, (Point3{30, 0, 5})) << program;
    EXPECT_EQ(names.points[1].at, (cycle.along_x ? Point3{30, 0, -34} : Point3{16, 0, 5}))
        << program;
    EXPECT_EQ(names.points[2].at, (Point3{20, 0, -30})) << program;
    EXPECT_EQ(names.points[3].at, (cycle.along_x ? Point3{20, 0, 5} : Point3{30, 0, -30}))
        << program;
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

// A negligible motion takes no column, and the one that departs stands beside the one that
// was due.
TEST(SheetExtras, what_departs_stands_in_the_column_of_what_was_due) {
  const Path reference = pecks(3);
  Path subject = pecks(3);
  subject.motions.insert(subject.motions.begin() + 1, line({0, 0, -5}, {0, 0, -5}));
  const Unfolding how = *unfolding_of(reference, 0);
  const Path flat = unfolded(reference, how);
  Path beside = unfolded(subject, how);
  EXPECT_EQ(beside.motions[2].points.front().x, 1);
  align(beside, 5, flat, 2);  // it departs in its last cut, where the second was due
  EXPECT_EQ(beside.motions[5].points.front().x, 2);
  EXPECT_EQ(beside.motions[0].points.back().x, 0.5);
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
  path.motions.push_back(line({0, 0, 1}, {0, 0, 3}));
  path.motions.back().kind = "thread";
  EXPECT_EQ(moves_json(path, 16), (Json{{3, 10000, 0, 0, 0, 20000, 0},
                                        {0, 0, 0, -5000},
                                        Json::array(),
                                        {2, 0, 0, 0, 0, 0, 10000},
                                        {4, 0, 0, 20000}}));
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
